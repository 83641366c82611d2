"""What the pages say is so: keys and defaults, arrays, commands, examples, outputs, links."""

import json
import re
from collections.abc import Iterator
from typing import Any, get_args

import click
import pytest
from pages import PAGES, ROOT, anchors, blocks, commands, headings, printed, prose, rows, shown
from pydantic import BaseModel

from soccersim import Recording, Simulation, load_scenario
from soccersim.cli.main import VERBS, soccersim
from soccersim.record.recording import GROUPS
from soccersim.report import report
from soccersim.spec.annotations import alternatives, is_model
from soccersim.spec.field import Field
from soccersim.spec.player import Player
from soccersim.spec.robot import DeadWheels, DriveWheels, Robot
from soccersim.spec.scenario import Scenario
from soccersim.spec.validate import validate
from soccersim.spec.yaml12 import parse

DOCS = ROOT / "docs"
EXAMPLE = DOCS / "examples" / "my-scenario.yaml"
REFRESH = "is out of date: run `python tests/pages.py` and read what it changed"
TOLERANCE = 0.002  # of a number shown: other platforms may round the last digit otherwise

SECTIONS = {  # where docs/scenario.md tells the keys of a model, if not under its own name
    "Player": ("A robot in a scenario",),
    "Robot": ("Robot model",),
    "DriveWheels": ("Wheels", "Driven wheels"),
    "DeadWheels": ("Wheels", "Dead wheels"),
    "PwmTable": ("PWM table",),
    "Pid": ("Gains",),
    "Pi": ("Wheel gains",),
}


def models(kind: Any, seen: list[type[BaseModel]]) -> list[type[BaseModel]]:
    """All models that may stand in a value of this type, each once."""
    for each in alternatives(kind):
        if is_model(each) and each not in seen:
            seen.append(each)
            for field in each.model_fields.values():
                models(field.annotation, seen)
        for argument in () if is_model(each) else get_args(each):
            models(argument, seen)
    return seen


MODELS = models(Scenario, [])


def keys_told(model: type[BaseModel]) -> dict[str, list[str]]:
    """The rows of docs/scenario.md about a model."""
    told: dict[str, list[str]] = {}
    for heading in SECTIONS.get(model.__name__, (model.__name__,)):
        told |= rows(DOCS / "scenario.md", heading)
    return told


def test_walk_over_the_models_finds_all_of_them():
    assert {Scenario, Field, Player, Robot, DriveWheels, DeadWheels} <= set(MODELS)
    assert len(MODELS) >= 27


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_scenario_page_tells_every_key_with_its_default(model):
    told = keys_told(model)
    assert list(told) == list(model.model_fields)
    for key, field in model.model_fields.items():
        _, cell, _ = told[key]
        assert (cell == "required") == field.is_required(), key
        if not field.is_required():
            default = field.get_default(call_default_factory=True)
            said = parse(cell.strip("`"), key).value
            if isinstance(default, BaseModel):
                said = type(default).model_validate(said)
            elif isinstance(default, tuple):
                said = tuple(said)
            elif isinstance(default, float):
                default = pytest.approx(default, rel=1e-6)
            assert said == default, key


def test_every_section_of_keys_is_of_a_model():
    page = headings(DOCS / "scenario.md")
    ours = {name for model in MODELS for name in SECTIONS.get(model.__name__, (model.__name__,))}
    assert set(page[page.index("Every key") + 1 :]) == ours


@pytest.fixture(scope="module")
def everything() -> Recording:
    return Simulation(load_scenario("one-of-everything", settings=["duration=1.3"])).run()


def test_recording_page_tells_every_array_with_its_shape(everything):
    told = rows(DOCS / "recording.md", "The arrays")
    arrays = {key: told[key] for group in GROUPS.values() for key in group}
    records, bodies, _ = everything.body.shape
    _, robots, wheels = everything.arrays["pwm"].shape
    _, arms, _ = everything.arrays["joint"].shape
    sizes = {"T": records, "B": bodies, "R": robots, "W": wheels, "A": arms}
    assert len(set(sizes.values())) == 5
    assert set(arrays) == set(everything.arrays)
    for key, (shape, kind, *_) in arrays.items():
        letters = re.findall(r"\w+", shape)
        expected = tuple(sizes[each] if each in sizes else int(each) for each in letters)
        assert everything.arrays[key].shape == expected, key
        assert everything.arrays[key].dtype == kind, key
    for group, names in GROUPS.items():
        if group != "poses":
            assert re.findall(r"\w+", told[group][0]) == list(names)
    assert set(told) == {*everything.arrays, *GROUPS} - {"poses"}


def test_recording_page_tells_the_meta_document_and_the_report(everything):
    legs = [leg for robot in everything.legs for leg in robot]
    meta = rows(DOCS / "recording.md", "The meta document")
    assert set(meta) == {*everything.meta, *legs[0]}
    document = report(everything)
    leg = next(robot["legs"][0] for robot in document["robots"] if robot["legs"])
    told = rows(DOCS / "recording.md", "`report.json`")
    assert set(told) == {*document, "runs", "bands", *leg}
    for key in document["frame"]:
        assert f"`{key}`" in told["frame"][0]


@pytest.mark.parametrize(("place", "words"), commands(), ids=lambda value: str(value))
def test_every_command_shown_parses(place, words):
    verb = soccersim.get_command(click.Context(soccersim), words[0])
    assert verb is not None, place
    verb.make_context(words[0], words[1:])


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_verbs_and_options_named_in_the_text_exist(page):
    verbs = {name: soccersim.get_command(click.Context(soccersim), name) for name in VERBS}
    known = {option for verb in verbs.values() for p in verb.params for option in p.opts}
    known |= {"--help", "--version", "--debug"}
    for code in re.findall(r"`([^`\n]+)`", prose(page)):
        words = code.split()
        if words[0] == "soccersim" and len(words) > 1:
            assert words[1] in {*verbs, *known}, code
        if words[0] == "soccersim" or words[0].startswith("--"):
            for option in re.findall(r"--[a-z]+[a-z-]*", code):
                assert option in known, code


def test_readme_names_every_verb():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert [verb for verb in VERBS if f"soccersim {verb}" not in text] == []


def numbers(text: str) -> Iterator[str | float]:
    """The words of an output, numbers as numbers, digests left out."""
    for word in re.sub(r"digest [0-9a-f]+", "digest", text).split():
        yield float(word) if re.fullmatch(r"-?\d+(\.\d+)?", word) else word


@pytest.mark.parametrize("block", blocks("console", "yaml"), ids=lambda block: block.place)
def test_outputs_and_files_shown_are_the_real_ones(block):
    if block.info.startswith("yaml"):
        assert block.text == shown(block), f"{block.place} {REFRESH}"
        return
    said, is_so = list(numbers(block.text)), list(numbers(shown(block)))
    same = [
        abs(a - b) <= TOLERANCE if isinstance(a, float) and isinstance(b, float) else a == b
        for a, b in zip(said, is_so, strict=False)
    ]
    assert len(said) == len(is_so), f"{block.place} {REFRESH}"
    assert all(same), f"{block.place} {REFRESH}"


@pytest.mark.parametrize("block", blocks("yaml"), ids=lambda block: block.place)
def test_every_whole_scenario_shown_is_valid(block, tmp_path):
    if "version: 1\n" in block.text and "file=" not in block.info:
        (tmp_path / "shown.yaml").write_text(block.text, encoding="utf-8")
        load_scenario(tmp_path / "shown.yaml")


def test_example_runs_and_reaches_its_targets():
    recording = Simulation(load_scenario(EXAMPLE)).run()
    assert [leg["reached"] for leg in recording.legs[0]] == [True, True, True]
    robot = parse((DOCS / "examples" / "my-robot.yaml").read_text(encoding="utf-8"), "robot")
    assert recording.scenario.robots[0].model == validate(Robot, robot)


@pytest.mark.parametrize("page", sorted({block.page for block in blocks("python")}))
def test_python_shown_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for block in blocks("python"):
        if block.page == page:
            assert block.info == "python run", block.place
            exec(compile(block.text, block.place, "exec"), names)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_link_leads_somewhere(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        if target.startswith("https://"):
            continue
        file, _, anchor = target.partition("#")
        place = page.parent / file if file else page
        assert place.exists(), target
        if anchor:
            assert anchor in anchors(place), target


def test_report_of_the_json_option_is_the_one_described():
    document = json.loads(printed(["run", str(EXAMPLE), "--json"]))
    assert document["robots"][0]["name"] == "mine"
    assert document["frame"]["heading"] == "ccw"
