"""docs/rules.md tells the figures that the bundled rules have, and the events there are."""

from pathlib import Path

import pytest
from test_fuzz import KINDS

from soccersim.bundled import find, names
from soccersim.spec.rules import Rules
from soccersim.spec.validate import validate
from soccersim.spec.yaml12 import read

PAGE = (Path(__file__).parents[2] / "docs" / "rules.md").read_text(encoding="utf-8")


def rows(first):
    """The rows of the table whose heading begins so, as cells without backquotes."""
    table = PAGE[PAGE.index(first) :].split("\n\n")[0].splitlines()[2:]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table]


def said(value):
    return f"`{value:g}`" if isinstance(value, float) else f"`{str(value).lower()}`"


@pytest.mark.parametrize(("column", "name"), [(1, "msl"), (2, "krsbi"), (3, "friendly")])
def test_every_figure_of_a_bundled_set_is_told(column, name):
    rules = validate(Rules, read(find("rules", name)))
    told = {row[0].strip("`"): row[column] for row in rows("| Key |")}
    written = {key: getattr(rules, key) for key in Rules.model_fields if key != "about"}
    want = {key: "`null`" if value is None else said(value) for key, value in written.items()}
    assert told == want


def test_every_bundled_set_is_told_and_writes_out_every_key():
    assert set(names("rules")) == {"msl", "krsbi", "friendly"}
    for name in names("rules"):
        assert set(read(find("rules", name)).value) == set(Rules.model_fields)


def test_every_kind_of_event_is_told():
    told = {kind.strip(" `") for row in rows("| `kind` |") for kind in row[0].split(",")}
    assert told == KINDS
