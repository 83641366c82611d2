"""`soccersim tune` as a user meets it."""

import json

import pytest

from soccersim.cli.main import VERBS

LOOP = {
    *("loop", "unit", "push_unit", "step", "ultimate", "relay", "sweep", "present", "rules"),
    *("best_rule", "keep_present", "recommended", "why"),
}
ROW = {
    *("rule", "controller", "printed", "kp", "ki", "kd", "rise_time", "overshoot"),
    *("settling_time", "iae", "final_error", "ripple", "sound"),
}


@pytest.fixture
def tune(soccersim, monkeypatch, tmp_path):
    monkeypatch.setitem(VERBS, "tune", "Find gains.")
    monkeypatch.chdir(tmp_path)
    return lambda *words: soccersim("tune", *words)


def test_json_is_one_document_with_every_loop(tune):
    ended = tune("defender", "--json", "--seed", 4)
    found = json.loads(ended.out)
    assert ended.code == 0
    assert {"scenario", "robot", "seed", "loops", "yaml", "notes"} == set(found)
    assert (found["scenario"], found["robot"], found["seed"]) == ("defender", "defender", 4)
    assert [loop["loop"] for loop in found["loops"]] == ["x", "y", "heading"]
    for loop in found["loops"]:
        assert set(loop) == LOOP
        assert set(loop["ultimate"]) == {"gain", "period", "from"}
        assert all(set(row) == ROW for row in [loop["present"], *loop["rules"]])
        assert {row["rule"] for row in loop["rules"]} == {
            "ziegler-nichols", "tyreus-luyben", "some-overshoot", "no-overshoot"
        }  # fmt: skip


def test_people_get_tables_that_fit_and_yaml_to_paste(tune):
    ended = tune("idris-table7")
    assert ended.code == 0
    assert "just oscillates" in ended.out
    assert "ziegler-nichols" in ended.out
    block = ended.out[ended.out.index("control:\n") :].splitlines()[:5]
    assert [line.split(":")[0].strip() for line in block] == [
        "control",
        "x",
        "y",
        "heading",
        "wheel",
    ]
    tables = ended.out[: ended.out.index("control:")]
    assert max(map(len, tables.splitlines())) <= 80


def test_out_gets_two_files_and_is_not_overwritten(tune, tmp_path):
    assert tune("defender", "--out", "results").code == 0
    assert sorted(p.name for p in (tmp_path / "results").iterdir()) == ["tune.json", "tune.png"]
    assert (tmp_path / "results" / "tune.png").read_bytes()[:4] == b"\x89PNG"
    assert json.loads((tmp_path / "results" / "tune.json").read_text())["robot"] == "defender"
    again = tune("defender", "--out", "results")
    assert again.code == 2
    assert "--force" in again.err
    assert len(again.lines) == 1


def test_without_out_nothing_is_written(tune, tmp_path):
    assert tune("defender", "--json").code == 0
    assert list(tmp_path.iterdir()) == []


def test_a_robot_is_chosen_by_name(tune):
    found = json.loads(tune("positioning", "--robot", "striker", "--json").out)
    assert found["robot"] == "striker"


def test_a_setting_changes_the_robot(tune):
    light, heavy = (
        json.loads(tune("defender", "--json", "--set", f"robots.0.model.mass={mass}").out)
        for mass in (15, 30)
    )
    gains = [found["loops"][0]["ultimate"]["gain"] for found in (light, heavy)]
    assert gains[0] < gains[1]  # a heavier robot filters more


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["defenderr"], "did you mean `defender`?"),
        (["positioning", "--robot", "strikr"], "--robot: no robot `strikr` in positioning: did "),
        (["positioning", "--robot", "x"], "there are defender, midfielder, striker"),
        (["defender", "--set", "robots.0.model.mass=heavy"], "must be a number"),
        (["./nowhere.yaml"], "nowhere.yaml"),
    ],
)
def test_bad_input_is_told_in_one_line(tune, words, said):
    ended = tune(*words)
    assert (ended.code, ended.out) == (2, "")
    assert len(ended.lines) == 1
    assert said in ended.err


def test_an_unknown_option_is_refused(tune):
    assert tune("defender", "--gentle").code == 2
    assert tune().code == 2


def test_a_scenario_without_robots_has_nothing_to_tune(soccersim):
    ended = soccersim("tune", "arm-table2")
    assert (ended.code, ended.err) == (2, "arm-table2 has no robot to tune\n")
