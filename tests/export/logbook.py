"""Logs as the mcap library's own reader reads them."""

import io
import json

from mcap.reader import make_reader

from soccersim.export.mcap import save_mcap


def saved(recording, folder, **part):
    """The log of a recording as bytes."""
    save_mcap(recording, folder / "run.mcap", **part)
    return (folder / "run.mcap").read_bytes()


def messages(data, topic=None):
    """Topic, nanoseconds and content of each message, in order of time."""
    reader = make_reader(io.BytesIO(data), validate_crcs=True)
    for schema, channel, message in reader.iter_messages(topics=topic and [topic]):
        yield schema, channel, message, json.loads(message.data)
