"""Trees put together: one file grafted into another, and single values set by their path."""

import contextlib
import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.problems import InputError
from soccersim.spec.yaml12 import Mark, Tree, parse, parse_setting


def refusal(call, *arguments):
    """The one line that a user reads."""
    with pytest.raises(InputError) as caught:
        call(*arguments)
    line = str(caught.value)
    assert line.isprintable()
    return line


def test_a_grafted_tree_keeps_its_places_and_its_own_data():
    scenario = parse("field: [old, data]\nrobots:\n- {name: a}\n- {name: b}\n", "s.yaml")
    field = parse("\nlength: 9\nwidth: 6\n", "field.yaml")
    for path in (("field",), ("robots", 0, "home")):
        scenario.graft(path, field)
    assert scenario.value == {
        "field": {"length": 9, "width": 6},
        "robots": [{"name": "a", "home": {"length": 9, "width": 6}}, {"name": "b"}],
    }
    assert scenario.place(("field", "width")) == Mark("field.yaml", 3, 8)
    assert scenario.keys["field",] == Mark("s.yaml", 1, 1)
    assert scenario.keys["field", "length"] == Mark("field.yaml", 2, 1)
    assert scenario.keys["robots", 0, "home"] == Mark("field.yaml", 2, 1)
    assert ("field", 0) not in scenario.marks
    scenario.set("field.width", "7")
    assert scenario.value["robots"][0]["home"]["width"] == field.value["width"] == 6


def test_a_tree_grafted_at_the_top_replaces_everything():
    tree = parse("a: 1", "s.yaml")
    tree.graft((), parse("b: 2", "t.yaml"))
    assert tree == parse("b: 2", "t.yaml")


@pytest.fixture
def match() -> Tree:
    return parse("robots:\n- name: a\n  model: {mass: 20}\n- name: b\nnotes: []\nball:\n", "s.yaml")


def test_a_setting_changes_one_value_and_says_where_it_came_from(match):
    match.set("robots.0.model.mass", "25")
    match.set("robots.1.model", "{mass: 1e1, name: no}")
    match.set("robots.1.name", "")
    assert match.value["robots"] == [
        {"name": "a", "model": {"mass": 25}},
        {"name": None, "model": {"mass": 10.0, "name": "no"}},
    ]
    assert match.place(("robots", 0, "model", "mass")) == ("--set robots.0.model.mass=25", 0, 0)
    assert match.place(("robots", 0, "name")) == ("s.yaml", 2, 9)
    whole = Mark("--set robots.1.model={mass: 1e1, name: no}")
    assert match.keys["robots", 1, "model", "mass"] == whole
    assert match.marks["robots", 1, "model", "name"] == whole


def test_keys_on_the_way_that_are_not_there_are_made(match):
    match.set("timing.record_hz", "25")
    match.set("ball.at.0", "1")
    match.set("robots.0.model.control.x.kp", "2")
    assert match.value["timing"] == {"record_hz": 25}
    assert match.value["ball"] == {"at": {"0": 1}}  # not a list: validation says so
    assert match.value["robots"][0]["model"] == {"mass": 20, "control": {"x": {"kp": 2}}}
    mark = Mark("--set robots.0.model.control.x.kp=2")
    for size in (4, 5, 6):
        path = ("robots", 0, "model", "control", "x", "kp")[:size]
        assert match.marks[path] == match.keys[path] == mark


@pytest.mark.parametrize(
    ("path", "text", "line"),
    [
        ("robots.2.name", "x", "robots: there is no entry `2`: the list has the entries 0 to 1"),
        ("robots.-1.name", "x", "robots: there is no entry `-1`: the list has the entries 0 to 1"),
        ("robots.first", "x", "robots: there is no entry `first`: the list has the entries 0 to 1"),
        ("robots." + "9" * 5000, "x", "the list has the entries 0 to 1"),
        ("robots.²", "x", "there is no entry `²`"),
        ("notes.0", "x", "notes: there is no entry `0`: the list is empty"),
        ("robots.0.name.x", "1", 'robots.0.name: there is no `x` in the text "a"'),
        ("deep" + ".er" * 32, "1", "there is no key `deep`; known: `robots`, `notes`, `ball`"),
        ("robots..name", "1", "robots: there is no entry ``"),
        ("", "1", "there is no key ``"),
        ("robots.0.name", "[1", "--set robots.0.name=[1: this bracket is never closed"),
        ("robots.0.name", "*x", "anchors (&) and aliases (*) are not allowed"),
        ("robots.0.name", "\x1b", "--set robots.0.name=\\x1b: a YAML text may not hold"),
    ],
)
def test_a_setting_that_leads_nowhere_is_refused_with_what_there_is(match, path, text, line):
    before = json.dumps(match.value)
    assert line in refusal(match.set, path, text)
    assert json.dumps(match.value) == before


@settings(deadline=None)
@given(path=st.text("ab.01robts", max_size=12) | st.text(), text=st.text())
def test_no_setting_does_worse_than_a_refusal(path, text):
    tree = parse("robots: [{a: 1}, {b: [2]}]", "s.yaml")
    with contextlib.suppress(InputError):
        tree.set(path, text)
    json.dumps(tree.value, allow_nan=False, ensure_ascii=False)


def test_a_setting_is_split_at_its_first_equals_sign():
    assert parse_setting("a.b=c=d") == ("a.b", "c=d")
    assert parse_setting(" a.0 = [1, 2] ") == ("a.0", "[1, 2]")
    assert parse_setting("a=") == ("a", "")


@pytest.mark.parametrize("text", ["a.b", "", "=1", "a..b=1", ".a=1", "a.=1", "a.b: 1\n"])
def test_a_setting_that_is_not_key_and_value_is_refused(text):
    assert "write it as key.path=value" in refusal(parse_setting, text)
