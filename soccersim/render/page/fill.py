"""Puts a recording and the page's own files together to one HTML file.

Nothing that a team or a scenario wrote stands in the HTML as it is, save for the escaped title:
all else is deflated and spelt in letters, and the page's scripts write it as text. A policy in the
head lets the browser run and load nothing but what is here.
"""

from functools import cache
from html import escape

from soccersim.problems import InputError, Problem
from soccersim.record.recording import Recording
from soccersim.render.page.channels import COARSE, FINE, FINEST, Finesse, channels, frames, late
from soccersim.render.page.document import document
from soccersim.render.page.pack import spelt
from soccersim.render.page.shared import DRAWING, digest, part, script, style
from soccersim.render.story import Story

# in this order they are one script
SCRIPTS = ("unpack", "recording", *DRAWING, "player", "timeline", "panels", "controls", "main")
SHORT = 6_000  # poses up to which the finest steps are taken: four minutes of one robot
ROOM = 735_000  # bytes of packed numbers; a page has 16 letters for 13 of them, and its own files


def page(recording: Recording, title: str = "") -> str:
    """The HTML of a page that plays the recording; title: its name in the browser."""
    if len(recording.tick) == 0:
        raise InputError(Problem("the recording is empty: there is nothing to show"))
    story = Story(recording) if recording.match else None
    title = (title or _title(recording, story)).encode(errors="replace").decode()
    poses = len(frames(recording, FINE.hz)) * recording.body.shape[1]
    if poses <= SHORT:
        data = _packed(recording, story, title, FINEST)
    else:
        data = _packed(recording, story, title, FINE)
        if len(data) > ROOM:
            data = _packed(recording, story, title, COARSE)
    return _filled(title, data)


def _packed(recording: Recording, story: Story | None, title: str, fine: Finesse) -> bytes:
    shown = frames(recording, fine.hz)
    told = document(recording, story, title, shown) | {"late": late(recording, fine)}
    return channels(recording, story, fine, shown).packed(told)


def _title(recording: Recording, story: Story | None) -> str:
    if story is None:
        return recording.scenario.name
    home, away = story.final
    return f"{story.names[0]} {home} : {away} {story.names[1]}"


def _filled(title: str, data: bytes) -> str:
    """The template with everything in its place."""
    return (
        part("page.html")
        .replace("{{style-hash}}", digest(style()))
        .replace("{{script-hash}}", digest(_script()))
        .replace("{{style}}", style())
        .replace("{{script}}", _script())
        .replace("{{buttons}}", part("buttons.html"))
        .replace("{{title}}", escape(title).replace("{", "&#123;"))
        .replace("{{data}}", spelt(data))
    )


@cache
def _script() -> str:
    return script(part(f"{name}.js") for name in SCRIPTS)
