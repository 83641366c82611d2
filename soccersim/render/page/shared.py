"""What the replay page and the page of the base station share."""

from base64 import b64encode
from collections.abc import Iterable
from functools import cache
from hashlib import sha256
from importlib.resources import files

from soccersim.render import look
from soccersim.render.page.document import css

DRAWING = ("view", "pitch", "robots", "marks", "picture")  # scripts that know no recordings
PALETTE = ("page", "card", "ink", "faint", "believed", "target")


@cache
def part(name: str) -> str:
    """A file of the replay page's folder."""
    return (files("soccersim.render.page") / name).read_text(encoding="utf-8")


@cache
def style() -> str:
    """The colours of the frames as variables, then the look of both pages."""
    colours = {name: css(getattr(look, name.upper())) for name in PALETTE}
    for team, colour in look.TEAMS.items():
        colours |= {team: css(colour), f"{team}-tint": css(look.tint(team))}
    variables = "".join(f"--{name}:{value};" for name, value in colours.items())
    return f":root {{{variables}}}\n{part('page.css')}"


def script(parts: Iterable[str]) -> str:
    """All as one, in strict mode, with no names on the window but those they put there."""
    text = "\n".join(parts)
    return f'"use strict";\n(() => {{\n{text}}})();\n'


def digest(text: str) -> str:
    """As a content security policy names what may run."""
    return b64encode(sha256(text.encode()).digest()).decode()
