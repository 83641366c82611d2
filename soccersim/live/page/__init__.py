"""The page of the base station: its own scripts, and the drawing of the replay page."""

from base64 import b64encode
from functools import cache
from hashlib import sha256
from importlib.resources import files

from soccersim.render import look
from soccersim.render.page.document import css
from soccersim.render.page.fill import DRAWING, PALETTE

# in this order they are one script; `panels` of the replay page brings clock, number and table
SCRIPTS = ("link", "moments", "plots", "actions", "field", "numbers", "boxes", "keys", "app")


@cache
def page() -> str:
    """The whole page, which asks for nothing but its WebSocket."""
    text = _part("live.html")
    return text.replace("{{style}}", _style()).replace("{{script}}", _script())


@cache
def policy() -> str:
    """What the browser may run and load: what stands in the page, and the WebSocket."""
    return (
        "default-src 'none'; img-src data:; connect-src 'self'; base-uri 'none'; "
        "form-action 'none'; frame-ancestors 'none'; "
        f"style-src 'sha256-{_digest(_style())}'; script-src 'sha256-{_digest(_script())}'"
    )


def _style() -> str:
    """The replay page's look, and ours."""
    colours = {name: css(getattr(look, name.upper())) for name in PALETTE}
    for team, colour in look.TEAMS.items():
        colours |= {team: css(colour), f"{team}-tint": css(look.tint(team))}
    variables = "".join(f"--{name}:{value};" for name, value in colours.items())
    return f":root {{{variables}}}\n{_shared('page.css')}{_part('live.css')}"


def _script() -> str:
    """All scripts as one, in strict mode."""
    shared = [_shared(f"{name}.js") for name in (*DRAWING, "panels")]
    own = [_part(f"{name}.js") for name in SCRIPTS]
    parts = "\n".join([*shared, *own])
    return f'"use strict";\n(() => {{\n{parts}}})();\n'


@cache
def _part(name: str) -> str:
    return (files("soccersim.live.page") / name).read_text(encoding="utf-8")


def _shared(name: str) -> str:
    return (files("soccersim.render.page") / name).read_text(encoding="utf-8")


def _digest(text: str) -> str:
    return b64encode(sha256(text.encode()).digest()).decode()
