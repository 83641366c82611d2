"""From a name or a file to a scenario: what is put together, changed, and refused."""

import json
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.bundled import PLACES, find, names, root
from soccersim.problems import InputError
from soccersim.spec.load import load_scenario
from soccersim.spec.scenario import Scenario
from soccersim.spec.yaml12 import read

ROBOT = {
    "drive": {"azimuth_deg": [0, 120, 240], "distance": 0.1, "radius": 0.05, "encoder": {}},
    "odometry": {"heading": "wheels"},
}


@pytest.fixture
def write(tmp_path):
    """Writes a scenario of one robot, as JSON, which YAML contains; gives its path."""

    def write(model="garcia", folder="", **more):
        robot = {"name": "r", "model": model, "start": [0, 0, 0]}
        text = {"version": 1, "name": "s", "field": "msl", "robots": [robot], **more}
        path = tmp_path / folder / "s.yaml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(json.dumps(text))
        return path

    return write


def test_a_scenario_is_named_or_a_path_with_a_robot_named_or_a_path_or_written_out(write, tmp_path):
    (tmp_path / "mine.yaml").write_text(json.dumps(ROBOT))
    inline, beside = load_scenario(write(ROBOT)), load_scenario(write("./mine.yaml"))
    absolute = load_scenario(str(write(str(tmp_path / "mine.yaml"))))
    assert inline == beside == absolute
    assert load_scenario("defender") == load_scenario(root() / "scenarios" / "defender.yaml")


def test_settings_come_to_the_same_as_editing_the_file(write):
    edited = write(ROBOT | {"mass": 25}, seed=7, duration=3, timing={"physics_hz": 1000})
    edited = load_scenario(edited)
    words = ["robots.0.model.mass=25", "seed=7", "duration=3.0", "timing.physics_hz=1000"]
    assert load_scenario(write(ROBOT), settings=words) == edited
    assert load_scenario(write(ROBOT), settings=words, seed=8).seed == 8


def test_the_last_setting_of_a_value_counts_and_a_robot_may_be_exchanged_and_then_changed(write):
    words = ["robots.0.model=msl", "robots.0.name=x", "robots.0.name=y"]
    scenario = load_scenario(write(), settings=words)
    assert scenario.robots[0].name == "y"
    assert scenario.robots[0].model == load_scenario("kickabout").robots[0].model


def test_a_path_in_a_file_counts_from_the_file_and_one_in_a_setting_from_here(
    write, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    path = write("./mine.yaml", folder="deeper")
    (tmp_path / "mine.yaml").write_text(json.dumps(ROBOT | {"mass": 1}))
    (tmp_path / "deeper" / "mine.yaml").write_text(json.dumps(ROBOT | {"mass": 2}))
    assert load_scenario(path).robots[0].model.mass == 2
    setting = "robots.0.model=./mine.yaml"
    assert load_scenario(path, settings=[setting]).robots[0].model.mass == 1
    assert load_scenario("linear", settings=[setting]).robots[0].model.mass == 1


def test_a_name_of_odd_characters_is_told_in_one_line():
    with pytest.raises(InputError) as caught:
        load_scenario("\x1f\n" + "x" * 99)
    assert str(caught.value).startswith("no scenario `\\x1f\\nxxx")
    assert str(caught.value).isprintable()


def test_all_that_is_bundled_is_found_by_its_name():
    assert {kind for kind in PLACES if names(kind)} >= {"scenario", "robot", "field"}
    for kind in PLACES:
        for name in names(kind):
            assert find(kind, name).is_file()


ODD = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-(2**70), 2**70),
    st.integers(-3, 3),
    st.floats(allow_nan=False, allow_infinity=False),
    st.text(max_size=5),
    st.sampled_from(["garcia", "./", "deg", "none", "1", "\x00", "../x.yaml"]),
    st.just([]),
    st.just({}),
    st.lists(st.integers(-9, 9), max_size=4),
    st.dictionaries(st.text(max_size=3), st.integers(), max_size=2),
)


@cache
def everything():
    """one-of-everything and its places, as (path of the parent, key)."""
    data = load_scenario("one-of-everything").model_dump(mode="json")
    places = []

    def walk(value, path):
        items = value.items() if isinstance(value, dict) else enumerate(value)
        for key, entry in items:
            places.append((path, key))
            if isinstance(entry, dict | list):
                walk(entry, (*path, key))

    walk(data, ())
    return json.dumps(data), places


def mutate(data, place, change, odd):
    """Change, delete or add an entry at a place, if it is still there."""
    path, key = place
    try:
        parent = data
        for step in path:
            parent = parent[step]
        if change == "delete":
            del parent[key]
        elif change == "add":
            parent["more" if isinstance(parent, dict) else 0] = odd
        elif change == "twice" and isinstance(parent, list):
            parent.append(parent[key])
        else:
            parent[key] = odd
    except (KeyError, IndexError, TypeError):
        pass


CHANGES = ("replace", "replace", "replace", "delete", "add", "twice")


@settings(max_examples=100)
@given(data=st.data())
def test_a_changed_scenario_is_valid_or_refused_at_a_place_and_nothing_else(data, tmp_path_factory):
    text, places = everything()
    value = json.loads(text)
    for _ in range(data.draw(st.integers(1, 3))):
        place, change = data.draw(st.sampled_from(places)), data.draw(st.sampled_from(CHANGES))
        mutate(value, place, change, data.draw(ODD))
    path = Path(tmp_path_factory.getbasetemp()) / "changed.yaml"
    path.write_text(json.dumps(value))
    scenario, problems = loaded(path)
    if scenario:
        assert Scenario.model_validate_json(scenario.model_dump_json()) == scenario
    else:
        assert problems
        for problem in problems:
            assert problem.line == 1 or problem.message.startswith("and ")
            assert str(problem).isprintable()


def loaded(path):
    """The scenario, or what is wrong with it."""
    try:
        return load_scenario(path), ()
    except InputError as error:
        return None, error.problems


def test_the_mutations_reach_every_key_of_the_format():
    _, places = everything()
    tree = read(find("scenario", "one-of-everything"))
    assert len(places) > len(tree.keys)
