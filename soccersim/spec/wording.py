"""How messages speak of what stands in a file, in one line: values, paths, near misses."""

import re
from collections.abc import Iterable

import yaml

from soccersim.problems import LONGEST, one_line

MAX_CHOICES = 12  # more are not listed
MAX_COMPARED = 200  # nor are more compared with a misspelt key

NO_ALIAS = "anchors (&) and aliases (*) are not allowed: write the value out, or quote the text"
NO_TAG = "tags (!) are not allowed: delete it, or put the text in quotes"
# what PyYAML says, what we say, and whether to point to where the construct starts
RETOLD = (
    (r"an alias|an anchor|'<(alias|anchor)>'", NO_ALIAS, False),
    (r"a tag;|tag handle|URI|'<tag>'", NO_TAG, False),
    (r"a directive|directive$|^;.*incompatible", "only %YAML 1.2 may start with %", False),
    (r"character '\\t'", "a tab stands here: use spaces", False),
    (r"character [\"'](.)[\"'] that", r"a text starts with `\1`: put it in quotes", False),
    (r"expected ':'", "a colon and a space are needed between a key and its value", True),
    (
        r"mapping values are",
        "`: ` may not stand here: see the line above, or quote the text",
        False,
    ),
    (r"sequence entries are", "`- ` may not stand here: start a new line", False),
    (r"mapping keys are", "`? ` may not stand here: write `key: value`", False),
    (r"quoted scalar;.*unexpected", "this quote is never closed", True),
    (r"escape character", r"unknown escape: write \\\\ for a backslash, or single quotes", False),
    (r"escape sequence of (\d)", r"this escape needs \1 hexadecimal digits", False),
    (r"a block scalar", "after | or > only -, + or a digit from 1 to 9 may stand", False),
    (r"<block end>.*'<scalar>'", "the value ends before this: put the whole text in quotes", False),
    (r"expected <block end>", "this does not line up with what stands above: indent alike", False),
    (r"'(.)', but got '<stream end>'", r"this bracket is never closed: `\1` is missing", True),
    (r"expected ',' or '(.)'", r"a comma or `\1` is missing before this", False),
    (r"document start.*<stream end>", "--- is missing after the lines that start with %", False),
    (r"document start", "the document ends before this: one value is a whole file", False),
    (r"found '<stream end>'", "the text ends here, but a bracket is still open", False),
    (r"node content, but found '<", "this may not stand here: a value is needed", False),
    (r"node content, but found '(.)'", r"a value is missing before `\1`", False),
)


def show(value: object) -> str:
    """A value as a message names it: 3, `the text "abc"`, a list, nothing (null)."""
    if value is None:
        return "nothing (null)"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return f'the text "{one_line(value)}"'
    if isinstance(value, list | tuple):
        return "a list"
    if isinstance(value, dict):
        return "a mapping"
    return one_line(repr(value))


def dotted(path: Iterable[str | int]) -> str:
    """A path as it is written on the command line: robots.0.model.mass."""
    return ".".join(one_line(str(step)) for step in path)


def near(word: str, choices: Iterable[str]) -> str:
    """What to add about a wrong word: the choice that was meant, if one is near."""
    from difflib import get_close_matches

    found = get_close_matches(word[:LONGEST], [choice for choice in choices if choice], n=1)
    return f"; did you mean `{one_line(found[0])}`?" if found else ""


def instead_of(word: str, choices: Iterable[str]) -> str:
    """What to add about a key that is not there: the nearest one, or all when they are few."""
    known = list(choices)
    few = 0 < len(known) <= MAX_CHOICES
    return near(word, known[:MAX_COMPARED]) or (f"; known: {listed(known)}" if few else "")


def listed(words: Iterable[object]) -> str:
    """`a`, `b`, `c`."""
    return ", ".join(f"`{one_line(str(word))}`" for word in words)


def retold(error: yaml.MarkedYAMLError) -> tuple[str, yaml.Mark | None]:
    """PyYAML's complaint in our words, in one line, and its place."""
    said = f"{error.context or ''}; {error.problem or ''}"
    for pattern, message, at_start in RETOLD:
        if match := re.search(pattern, said):
            mark = error.context_mark if at_start else error.problem_mark
            return match.expand(message), mark or error.problem_mark
    return one_line(error.problem or said, 200), error.problem_mark
