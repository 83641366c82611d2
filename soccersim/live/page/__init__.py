"""The page of the base station: its own scripts, and the drawing of the replay page."""

from functools import cache
from importlib.resources import files

from soccersim.render.page.shared import DRAWING, digest, part, script, style

# in this order they are one script; `panels` of the replay page brings clock, number and table
SCRIPTS = ("link", "moments", "plots", "actions", "field", "numbers", "boxes", "keys", "app")


@cache
def page() -> str:
    """The whole page, which asks for nothing but its WebSocket."""
    text = _part("live.html").replace("{{buttons}}", part("buttons.html"))
    return text.replace("{{style}}", _style()).replace("{{script}}", _script())


@cache
def policy() -> str:
    """What the browser may run and load: what stands in the page, and the WebSocket."""
    return (
        "default-src 'none'; img-src data:; connect-src 'self'; base-uri 'none'; "
        "form-action 'none'; frame-ancestors 'none'; "
        f"style-src 'sha256-{digest(_style())}'; script-src 'sha256-{digest(_script())}'"
    )


def _style() -> str:
    """The replay page's look, and ours."""
    return style() + _part("live.css")


def _script() -> str:
    """All scripts as one."""
    shared = (part(f"{name}.js") for name in (*DRAWING, "panels"))
    return script([*shared, *(_part(f"{name}.js") for name in SCRIPTS)])


@cache
def _part(name: str) -> str:
    return (files("soccersim.live.page") / name).read_text(encoding="utf-8")
