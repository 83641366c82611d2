"""HTML and SVG, put together so that nothing that a team or a traceback says becomes markup."""

from html import escape

ALONE = {"meta", "br"}  # elements that hold nothing and are not closed


class Html(str):
    """Text that is markup already. Every other text is escaped on its way into a page."""


def shown(text: str) -> str:
    """A stranger's text, with what is not seen in it made visible.

    Control characters, lone surrogates of odd file names, and marks that turn writing round, which
    would make a page show something else than it holds.
    """
    return "".join(
        c if c.isprintable() or c in "\n\t" else c.encode("unicode_escape").decode() for c in text
    )


def text(inside: object) -> Html:
    """Markup as it is, anything else escaped."""
    return inside if isinstance(inside, Html) else Html(escape(shown(str(inside))))


def join(*inside: object) -> Html:
    """Several after one another."""
    return Html("".join(map(text, inside)))


def tag(name: str, /, *inside: object, **attributes: object) -> Html:
    """An element. class_ is class, stroke_width is stroke-width; None leaves an attribute out."""
    told = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{text(value)}"'
        for key, value in attributes.items()
        if value is not None
    )
    return Html(f"<{name}{told}>" if name in ALONE else f"<{name}{told}>{join(*inside)}</{name}>")


def table(head: Html, rows: Html, **attributes: object) -> Html:
    """A table that scrolls by itself where it is wider than the page."""
    inner = tag("table", tag("thead", head), tag("tbody", rows), **attributes)
    return tag("div", inner, class_="wide")


def row(*cells: object, cell: str = "td", **attributes: object) -> Html:
    """A row of a table. A cell that is markup of a cell already stays as it is."""
    made = (
        c if isinstance(c, Html) and c.startswith(("<td", "<th")) else tag(cell, c) for c in cells
    )
    return tag("tr", *made, **attributes)
