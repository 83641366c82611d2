"""The Markdown pages as tests see them: sections, tables, code blocks, and what commands print.

`python tests/pages.py` writes the output of every console block, and every file that a page shows,
into the pages anew.
"""

import re
import shlex
from contextlib import redirect_stdout
from io import StringIO
from os import chdir, environ
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
FENCE = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
WIDTH = "80"  # columns of the tables shown


class Block(NamedTuple):
    """A fenced block of code: where it stands, what the fence says, what is in it."""

    page: Path
    line: int
    info: str
    text: str

    @property
    def place(self) -> str:
        """Where it stands, for messages and names of tests."""
        return f"{self.page.relative_to(ROOT)}:{self.line}"


def blocks(*languages: str) -> list[Block]:
    """The blocks of all pages whose fence starts with one of these words."""
    found = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for match in FENCE.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            if match[1].split()[:1] and match[1].split()[0] in languages:
                found.append(Block(page, line, match[1], match[2]))
    return found


def prose(page: Path) -> str:
    """A page without its blocks of code."""
    return FENCE.sub("", page.read_text(encoding="utf-8"))


def headings(page: Path) -> list[str]:
    """The headings of a page, as they are written."""
    return re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """What links within a page may point to, by GitHub's rule."""
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings(page)}


def rows(page: Path, heading: str) -> dict[str, list[str]]:
    """The rows of all tables right under a heading, by their first cell without its backquotes."""
    parts = re.split(r"^#+ (.+)$", prose(page), flags=re.MULTILINE)
    below = dict(zip(parts[1::2], parts[2::2], strict=True))[heading]
    table = {}
    for line in re.findall(r"^\|(.*)\|$", below, re.MULTILINE):
        first, *others = (cell.strip() for cell in line.split("|"))
        if first.startswith("`"):
            table[first.strip("`")] = others
    return table


def commands() -> list[tuple[str, list[str]]]:
    """Every soccersim command of a block, with its place, as a list of words."""
    found = []
    for block in blocks("sh", "console"):
        lines = block.text.splitlines()
        for line in lines[:1] if block.info == "console" else lines:
            for part in line.removeprefix("$ ").split("&&"):
                words = shlex.split(part, comments=True)
                words = words[2:] if words[:2] == ["uv", "run"] else words
                if words[:1] == ["soccersim"]:
                    end = words.index(">") if ">" in words else len(words)
                    found.append((block.place, words[1:end]))
    return found


def printed(words: list[str]) -> str:
    """What soccersim prints to these words, run from the top of the checkout."""
    from soccersim.cli.main import soccersim

    before, width = Path.cwd(), environ.get("COLUMNS")
    out = StringIO()
    try:
        chdir(ROOT)
        environ["COLUMNS"] = WIDTH
        with redirect_stdout(out):
            soccersim.main(list(words), "soccersim", standalone_mode=False)
    finally:
        chdir(before)
        environ.pop("COLUMNS")
        if width is not None:
            environ["COLUMNS"] = width
    return "\n".join(line.rstrip() for line in out.getvalue().splitlines()).strip() + "\n"


def shown(block: Block) -> str:
    """What should stand in a block that shows a command's output or a file; else what does."""
    file = re.search(r"file=(\S+)", block.info)
    if file:
        return (block.page.parent / file[1]).read_text(encoding="utf-8")
    if block.info == "console":
        first = block.text.splitlines()[0]
        return f"{first}\n{printed(shlex.split(first)[2:])}"
    return block.text


def refresh() -> None:
    """Write every shown output and file into the pages."""
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        new = FENCE.sub(lambda m: f"```{m[1]}\n{shown(Block(page, 0, m[1], m[2]))}```", text)  # noqa: B023
        if new != text:
            page.write_text(new, encoding="utf-8")
            print(f"wrote {page.relative_to(ROOT)}")


if __name__ == "__main__":
    refresh()
