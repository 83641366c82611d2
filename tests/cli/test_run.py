"""`soccersim run`: what it prints, what it writes, and that it means the same in all its ways."""

import json

import pytest

from soccersim import Recording, Simulation, load_scenario
from soccersim.report import report

FAST = ("--set", "duration=0.1")


def document(ended):
    """The one JSON document on standard output."""
    assert (ended.code, ended.out.count("\n")) == (0, 1)
    return json.loads(ended.out)


def test_json_is_one_document_and_notes_go_to_standard_error(soccersim, scenario, tmp_path):
    scenario()
    ended = soccersim("run", "./two.yaml", "--json", "--out", "r", "--frames", "--video")
    assert document(ended) == json.loads((tmp_path / "r" / "report.json").read_text())
    files = ("report.json", "recording.npz", "trajectory.png", "frames", "video.mp4")
    assert ended.lines == [f"wrote r/{name}" for name in files]


def test_json_stands_alone_even_while_the_first_run_compiles(soccersim, scenario, monkeypatch):
    scenario()
    monkeypatch.setattr("soccersim.kernel.will_compile", lambda: True)
    ended = soccersim("run", "./two.yaml", "--json")
    assert document(ended)["scenario"] == "two"
    assert ended.lines == ["first run here: compiling the simulator, once, about 20 s ..."]


def test_a_process_of_its_own_prints_the_same_json_and_nothing_else(process, soccersim, scenario):
    scenario()
    ended = process("run", "./two.yaml", "--json", "--out", "r", "--frames")
    assert document(ended) == document(soccersim("run", "./two.yaml", "--json"))


def test_the_report_is_that_of_the_python_interface(soccersim):
    recording = Simulation(load_scenario("defender", seed=3, settings=["duration=0.5"])).run()
    told = document(soccersim("run", "defender", "--seed", 3, "--set", "duration=0.5", "--json"))
    assert told == json.loads(json.dumps(report(recording)))


def test_without_out_nothing_is_written(soccersim, scenario, tmp_path):
    scenario()
    assert soccersim("run", "./two.yaml").code == 0
    assert [path.name for path in tmp_path.iterdir()] == ["two.yaml"]


def test_the_table_shows_each_leg_and_names_as_they_are_written(soccersim, scenario):
    scenario(("- name: one", '- name: "[bold]one[0] $x_{"'), ("name: two\nf", 'name: "[b]"\nf'))
    shown = soccersim("run", "./two.yaml", "--runs", 2).out
    assert "[b] seed 0: 0.10 s simulated, digest " in shown
    assert shown.count("[bold]one[0] $x_{ 1") == 2  # of the legs, and of the bands
    assert "two 1" in shown
    assert "out of time" in shown
    assert "over 2 seeds" in shown


def test_pictures_show_names_as_they_are_written(soccersim, scenario):
    scenario(("- name: one", '- name: "$x_{ é→😀"'))
    assert soccersim("run", "./two.yaml", "--out", "r", "--frames").code == 0


def test_settings_and_seed_come_to_the_same_as_editing_the_file(soccersim, scenario):
    scenario(("duration: 0.1", "duration: 0.2\nseed: 5"), name="edited.yaml")
    scenario()
    words = ("--set", "duration=0.2", "--json")
    edited = soccersim("run", "./edited.yaml", "--json").out
    assert soccersim("run", "./two.yaml", *words, "--seed", 5).out == edited
    assert soccersim("run", "./two.yaml", *words, "--set", "seed=5").out == edited


def test_it_runs_the_same_from_another_folder(soccersim, scenario, tmp_path, monkeypatch):
    scenario()
    here = soccersim("run", "./two.yaml", "--json").out
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert soccersim("run", "../two.yaml", "--json").out == here
    assert soccersim("run", tmp_path / "two.yaml", "--json").out == here


def test_a_leg_out_of_time_is_not_reached_and_no_error(soccersim):
    words = ("--set", "robots.0.path.0.timeout=0.3", "--set", "duration=0.5", "--json")
    first, second = document(soccersim("run", "defender", *words))["robots"][0]["legs"]
    assert (first["reached"], first["time"]) == (False, 0.3)
    # the second began where the first was given up, and the end of the run cut it short
    assert (second["reached"], second["time"]) == (False, pytest.approx(0.2))


def test_seeds_repeat_in_order_and_alike_in_one_process_or_two(soccersim, scenario):
    scenario()
    words = ("run", "./two.yaml", "--seed", 7, "--runs", 4, "--json")
    alone, together = soccersim(*words), soccersim(*words, "--jobs", 2)
    assert alone.out == together.out
    told = document(alone)
    assert [run["seed"] for run in told["runs"]] == [7, 8, 9, 10]
    assert len({run["digest"] for run in told["runs"]}) == 4
    for run in told["runs"]:
        single = document(soccersim("run", "./two.yaml", "--seed", run["seed"], "--json"))
        assert {key: single[key] for key in run} == run
    assert {k: v for k, v in told.items() if k not in ("runs", "bands")} == document(
        soccersim("run", "./two.yaml", "--seed", 7, "--json")
    )


def test_files_of_several_seeds_are_of_the_first(soccersim, scenario, tmp_path):
    scenario()
    words = ("run", "./two.yaml", "--seed", 7, "--json", "--no-plot")
    soccersim(*words, "--runs", 2, "--out", "several")
    told = json.loads((tmp_path / "several" / "report.json").read_text())
    assert [run["seed"] for run in told["runs"]] == [7, 8]
    assert Recording.load(tmp_path / "several" / "recording.npz").meta["seed"] == 7


def test_bands_hold_the_middle_of_all_seeds(soccersim, scenario):
    scenario(("duration: 0.1", "duration: 0.3"))
    told = document(soccersim("run", "./two.yaml", "--runs", 3, "--json"))
    drifts = sorted(run["robots"][0]["legs"][0]["drift"] for run in told["runs"])
    low, middle, high = told["bands"][0]["legs"][0]["drift"]
    assert middle == drifts[1]
    assert drifts[0] <= low <= middle <= high <= drifts[2]
    assert told["bands"][0]["legs"][0]["reached"] == 0.0


def test_a_run_that_stops_being_finite_ends_with_exit_code_4_in_one_line(
    soccersim, scenario, monkeypatch, tmp_path
):
    scenario()
    original = Simulation.advance

    def spoil(self, ticks, pieces=None):
        original(self, 20)
        self.machine.truth.body[0, 3] = float("nan")
        original(self, ticks, pieces)

    monkeypatch.setattr(Simulation, "advance", spoil)
    ended = soccersim("run", "./two.yaml", "--out", "r", "--json")
    assert (ended.code, ended.out) == (4, "")
    assert ended.lines == ["two: the state stopped being a number at tick 20 (0.040 s)"]
    assert not (tmp_path / "r").exists()
