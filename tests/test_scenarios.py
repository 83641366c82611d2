"""The contract of scenario files, held over every file that comes with soccersim."""

import json
from typing import Any, get_args

import jsonschema
import numpy as np
import pytest
from pydantic import BaseModel

from soccersim import Simulation, load_scenario
from soccersim.bundled import find, names
from soccersim.cli.schema import schema
from soccersim.spec.annotations import alternatives, is_model
from soccersim.spec.field import Field
from soccersim.spec.robot import Robot
from soccersim.spec.scenario import Scenario
from soccersim.spec.validate import validate
from soccersim.spec.yaml12 import read

SCENARIOS, ROBOTS, FIELDS = (names(kind) for kind in ("scenario", "robot", "field"))
MATCHES = {"msl-match", "krsbi-match", "friendly-match"}
PROMISED = {
    *("square", "defender", "midfielder", "striker", "idris-table6", "idris-table7", "linear"),
    *("rotation", "four-wheel-path", "positioning", "kickabout", "one-of-everything"),
    *MATCHES,
}


def written(kind, name):
    """What a bundled file says, as plain data."""
    return read(find(kind, name)).value


def test_what_was_promised_is_bundled():
    assert set(SCENARIOS) >= PROMISED
    assert set(ROBOTS) >= {"idris", "utama", "garcia", "four-wheel", "msl"}
    assert set(FIELDS) >= {"krsbi-2017", "krsbi", "msl"}


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_scenario_has_the_name_of_its_file_and_says_what_it_is(name):
    scenario = load_scenario(name)
    assert scenario.name == name
    assert len(scenario.about) > 30


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_scenario_is_the_same_after_a_trip_through_json(name, tmp_path):
    scenario = load_scenario(name)
    text = scenario.model_dump_json()
    assert Scenario.model_validate_json(text) == scenario
    assert Scenario.model_validate(json.loads(text)) == scenario
    (tmp_path / "again.yaml").write_text(text)  # JSON is YAML
    assert load_scenario(tmp_path / "again.yaml") == scenario


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_scenario_runs_without_fault(name):
    scenario = load_scenario(name, settings=["duration=1.5"])
    recording = Simulation(scenario).run()
    assert recording.duration == 1.5
    body = recording.body
    assert np.isfinite(body).all()
    if scenario.match:
        return  # its robots wait for orders; tests/match plays it
    assert np.abs(body[:, :, 0]).max() < scenario.field.half_length + scenario.field.border
    assert np.abs(body[:, :, 1]).max() < scenario.field.half_width + scenario.field.border
    moved = np.abs(body[-1, :, :3] - body[0, :, :3]).max(axis=1)
    # arms move by themselves; their keeper may stand
    assert (moved > 0.01).any() if scenario.arms else (moved[: len(scenario.robots)] > 0.01).all()


def test_every_robot_and_field_is_used_by_a_scenario():
    used = [written("scenario", name) for name in SCENARIOS]
    assert {s["field"] for s in used if isinstance(s["field"], str)} == set(FIELDS)
    players = [robot for s in used for robot in s.get("robots", ())]
    models = {robot["model"] for robot in players if str(robot["model"])[0] != "{"}
    assert models == set(ROBOTS)
    matches = [scenario["match"] for scenario in used if "match" in scenario]
    assert {m["rules"] for m in matches if isinstance(m["rules"], str)} == set(names("rules"))
    senses = {s["senses"] for s in used if isinstance(s.get("senses"), str)}
    assert senses <= set(names("senses")) == {"ideal", "friendly", "realistic"}


@pytest.mark.parametrize("name", ROBOTS)
def test_a_robot_says_where_its_figures_come_from_and_can_be_anywhere(name):
    robot = validate(Robot, read(find("robot", name)))
    assert len(robot.about) > 30
    scenario = load_scenario(
        "linear", settings=[f"robots.0.model={name}", "robots.0.open_loop=null"]
    )
    still = Simulation(scenario.model_copy(update={"duration": 1.0})).run()
    assert (
        np.abs(still.body[:, 0, :2] - still.body[0, 0, :2]).max() < 1e-6
    )  # nobody told it to move


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_says_where_its_dimensions_come_from_and_has_all_lines(name):
    field = validate(Field, read(find("field", name)))
    assert len(field.about) > 30
    for key in ("penalty_area", "goal_area", "penalty_mark", "centre_circle", "corner_arc"):
        assert getattr(field, key), key


def models(kind: Any, found: dict[type[BaseModel], set[str]]) -> dict[type[BaseModel], set[str]]:
    """All models that may stand in a value of this type, with their keys."""
    for each in alternatives(kind):
        if is_model(each) and each not in found:
            found[each] = set(each.model_fields)
            for field in each.model_fields.values():
                models(field.annotation, found)
        for argument in () if is_model(each) else get_args(each):
            models(argument, found)
    return found


def used(value: Any, named: Any, found: dict[type[BaseModel], set[str]]) -> None:
    """Note the keys that were written, by model; what is named stands in another file."""
    if isinstance(value, BaseModel) and isinstance(named, dict):
        found.setdefault(type(value), set()).update(value.model_fields_set)
        for key in value.model_fields_set:
            used(getattr(value, key), named.get(key), found)
    elif isinstance(value, tuple) and isinstance(named, list):
        for entry, name in zip(value, named, strict=True):
            used(entry, name, found)


def test_one_of_everything_uses_every_key_of_the_format():
    found: dict[type[BaseModel], set[str]] = {}
    for name in ("one-of-everything", "one-of-every-rule"):
        used(load_scenario(name), written("scenario", name), found)
    missing = {
        model.__name__: sorted(keys - found.get(model, set()))
        for model, keys in models(Scenario, {}).items()
        if keys - found.get(model, set())
    }
    assert missing == {}


SCHEMA = schema()
checker = jsonschema.Draft202012Validator(SCHEMA)


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_schema_for_editors_takes_every_bundled_scenario_as_written_and_expanded(name):
    checker.validate(written("scenario", name))
    checker.validate(json.loads(load_scenario(name).model_dump_json()))


def test_the_schema_is_a_schema_and_describes_every_key():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    for title, model in {"Scenario": SCHEMA, **SCHEMA["$defs"]}.items():
        assert model["additionalProperties"] is False, title
        assert model["description"], title


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("spoon",), 1),
        (("robots", 0, "model", "drive", "spoon"), 1),
        (("robots", 0, "path", 0, "spoon"), 1),
        (("duration",), "fast"),
        (("duration",), -1),
        (("robots", 0, "model", "mass"), -1),
        (("robots", 0, "model", "drive", "encoder", "decoding"), 3),
        (("robots", 0, "start"), [0, 0]),
        (("arms", 0, "lengths"), [0.1, 0.2]),
        (("units", "length"), "inch"),
        (("version",), 2),
    ],
)
def test_the_schema_refuses_what_loading_refuses(path, value):
    data = json.loads(load_scenario("one-of-everything").model_dump_json())
    checker.validate(data)
    holder = data
    for step in path[:-1]:
        holder = holder[step]
    holder[path[-1]] = value
    assert not checker.is_valid(data)


def test_the_schema_knows_what_may_be_named():
    model = SCHEMA["$defs"]["Player"]["properties"]["model"]
    assert model["anyOf"][0]["examples"] == ROBOTS
    assert SCHEMA["properties"]["field"]["anyOf"][0]["examples"] == FIELDS
    assert model["description"]
