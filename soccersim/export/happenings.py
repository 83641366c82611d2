"""What a log says in words: the referee's decisions, shots and forfeits, or how legs ended."""

from typing import Any

from soccersim.export.frames import stamp
from soccersim.export.schemas import LEVELS
from soccersim.record.recording import Recording
from soccersim.render.page.telling import HUM, match_events, run_events
from soccersim.render.story import Story

BAD = {"missed": "WARNING", "fault": "ERROR"}


def happenings(recording: Recording) -> list[tuple[int, dict[str, Any]]]:
    """Tick and content of each line of the log, in order of time."""
    hz = int(recording.meta["physics_hz"])
    if recording.match:
        events, name = match_events(recording, Story(recording)), "match"
    else:
        events, name = run_events(recording), "plan"
    told = []
    for event in events:
        tick, kind = round(event["time"] * hz), event["kind"]
        level = LEVELS[BAD.get(kind, "DEBUG" if kind in HUM else "INFO")]
        content = {"timestamp": stamp(tick, hz), "level": level, "message": event["text"]}
        told.append((tick, {**content, "name": f"{name}.{kind}", "file": "", "line": 0}))
    return told
