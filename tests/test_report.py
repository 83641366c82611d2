"""report.json: the legs of each robot beside the paper's, in metres, radians, counter-clockwise."""

import json
from math import hypot, pi, radians

import pytest

from soccersim import Recording, Simulation, load_scenario
from soccersim.bundled import names
from soccersim.report import bands, errors, report

KEYS = {"scenario", "seed", "digest", "duration", "frame", "robots", "arms", "shots"}
LEG = {
    *("target", "odometry", "truth", "odometry_error", "truth_error", "drift"),
    *("odometry_heading_error", "truth_heading_error", "heading_drift", "time", "reached", "paper"),
}
# mm, from the points the paper prints: sensor from target, real from target, real from sensor
UTAMA = {
    "defender": [(20.4, 35.5, 24.1), (44.4, 205.2, 168.3)],
    "midfielder": [(27.4, 121.0, 139.5), (48.6, 322.3, 310.4)],
    "striker": [(372.0, 837.7, 640.9)],
}


def run(name, *settings, seed=None):
    return Simulation(load_scenario(name, seed=seed, settings=settings)).run()


@pytest.fixture(scope="module")
def defender():
    return run("defender")


def test_a_report_has_these_keys_and_no_others(defender):
    told = report(defender)
    assert set(told) == KEYS
    assert [set(robot) for robot in told["robots"]] == [{"name", "legs"}]
    assert all(set(leg) == LEG for leg in told["robots"][0]["legs"])
    assert (told["scenario"], told["seed"], told["duration"]) == ("defender", 1, defender.duration)
    assert told["digest"] == defender.digest
    assert len(told["digest"]) == 64


def test_targets_are_the_scenarios_own_in_metres_and_radians_counter_clockwise():
    legs = report(run("idris-table6", "duration=0.1"))["robots"][0]["legs"]
    assert legs[0]["target"] == [0.0, 0.1, 0.0]
    legs = report(run("idris-table7", "duration=240"))["robots"][0]["legs"]
    assert [leg["target"] for leg in legs][12] == [0.0, 4.5, pytest.approx(-1.5 * pi)]
    assert len(legs) == 16


def test_headings_are_unwrapped_and_their_errors_are_not_whole_turns():
    legs = report(run("idris-table6"))["robots"][0]["legs"]
    ninth = legs[8]  # 360 degrees clockwise
    assert ninth["target"][2] == pytest.approx(-2 * pi)
    for pose in ("odometry", "truth"):
        assert ninth[pose][2] == pytest.approx(-2 * pi, abs=0.2)
        assert ninth[f"{pose}_heading_error"] < 0.2
    assert ninth["paper"]["odometry"] == pytest.approx([0.4203, 0.5419, radians(-358.99)])
    assert ninth["paper"]["odometry_heading_error"] == pytest.approx(radians(1.01))


def test_an_error_of_heading_is_the_shortest_turn_whatever_the_turns_before():
    poses = {"target": [3, 4, 1.5 * pi], "odometry": [0, 0, -0.5 * pi + 0.1], "truth": [0, 0, pi]}
    told = errors(poses)
    assert told["odometry_heading_error"] == pytest.approx(0.1)
    assert told["truth_heading_error"] == pytest.approx(0.5 * pi)
    assert (told["odometry_error"], told["drift"]) == (5.0, 0.0)
    unknown = errors({"target": None, "odometry": [0, 0, 0], "truth": [0, 1, None]})
    assert [unknown[key] for key in ("odometry_error", "heading_drift", "drift")] == [None, None, 1]


def test_errors_are_distances_between_the_poses_shown(defender):
    for leg in report(defender)["robots"][0]["legs"]:
        target, odometry, truth = leg["target"], leg["odometry"], leg["truth"]
        for key, (a, b) in {
            "odometry_error": (odometry, target),
            "truth_error": (truth, target),
            "drift": (truth, odometry),
        }.items():
            assert leg[key] == pytest.approx(hypot(a[0] - b[0], a[1] - b[1]))
        assert leg["heading_drift"] == pytest.approx(abs(truth[2] - odometry[2]))


def test_poses_are_those_of_the_recording_turned_into_the_scenarios_frame():
    recording = run("defender", "timing.record_hz=500")
    first = report(recording)["robots"][0]["legs"][0]
    record = round(first["time"] * 500)
    # Utama's frame: its origin at (-3.5, -0.5), its x axis to the field's right (-90 degrees)
    for pose, (x, y, heading) in {
        "truth": recording.body[record, 0, :3],
        "odometry": recording.estimate[record, 0],
    }.items():
        assert first[pose] == pytest.approx([-(y + 0.5), x + 3.5, heading + pi / 2])


def test_time_counts_from_the_start_of_a_leg_to_the_end_of_its_dwell(defender):
    first, second = report(defender)["robots"][0]["legs"]
    assert first["reached"]
    assert second["reached"]
    assert first["time"] + second["time"] == pytest.approx(defender.duration)
    control = defender.scenario.robots[0].model.control
    poses = defender.estimate[:, 0, :2][defender.leg[:, 0] == 0]
    near = [
        hypot(*gap) <= control.arrival.distance for gap in poses - defender.reference[10, 0, :2]
    ]
    dwell = int(control.arrival.dwell * defender.scenario.timing.record_hz)
    assert all(near[-dwell:])  # within the bounds for all of it


@pytest.mark.parametrize("name", UTAMA)
def test_papers_errors_are_those_recomputed_from_its_points(name):
    legs = report(run(name, "duration=40"))["robots"][0]["legs"]
    for leg, printed in zip(legs, UTAMA[name], strict=True):
        paper = leg["paper"]
        told = [paper[key] * 1000 for key in ("odometry_error", "truth_error", "drift")]
        assert told == pytest.approx(printed, abs=0.06)


def test_papers_numbers_are_converted_and_what_it_does_not_print_is_null(defender):
    first, second = (leg["paper"] for leg in report(defender)["robots"][0]["legs"])
    assert first["truth"] == [0.030, 1.981, None]
    assert first["odometry"] == [0.02017, 2.002989, pytest.approx(radians(0.35))]
    assert second["odometry"][2] == pytest.approx(radians(-7.41))  # the compass turns clockwise
    assert second["odometry_heading_error"] == pytest.approx(radians(7.41))
    assert [first[key] for key in ("truth_heading_error", "heading_drift", "time")] == [None] * 3
    assert first["source"] == "Utama, p. 4: point B"
    times = [leg["paper"]["time"] for leg in report(run("idris-table7"))["robots"][0]["legs"]]
    assert times[:3] == [4.2, 4.0, 4.8]


def test_an_open_loop_has_no_target_and_its_phases_end_with_the_run():
    legs = report(run("linear"))["robots"][0]["legs"]
    assert [leg["time"] for leg in legs] == [5.0, 1.0]
    for leg in legs:
        assert leg["reached"]
        assert leg["target"] is leg["odometry_error"] is leg["truth_heading_error"] is None
        assert leg["drift"] >= 0
        assert leg["paper"] is None
    assert 0.5 < legs[0]["truth"][0] + 1.5 < 4


def test_a_leg_that_the_end_of_the_run_cuts_short_is_told_and_not_reached():
    legs = report(run("defender", "duration=1"))["robots"][0]["legs"]
    assert [(leg["reached"], leg["time"]) for leg in legs] == [(False, 1.0)]
    phases = report(run("linear", "duration=2"))["robots"][0]["legs"]
    assert [(leg["reached"], leg["time"]) for leg in phases] == [(False, 2.0)]


def test_each_leg_of_a_repeated_path_is_told_once():
    scenario = load_scenario("kickabout", settings=["duration=30"])
    for robot in report(Simulation(scenario).run())["robots"]:
        assert len(robot["legs"]) == 8


@pytest.mark.parametrize("name", names("scenario"))
def test_a_report_is_json_and_the_same_from_the_file_of_its_recording(name, tmp_path):
    recording = run(name, "duration=1")
    recording.save(tmp_path / "recording.npz")
    told = report(recording)
    assert report(Recording.load(tmp_path / "recording.npz")) == told
    text = json.dumps(told, allow_nan=False)
    assert json.loads(text) == json.loads(json.dumps(told))


def test_bands_are_percentiles_over_the_runs_that_have_the_leg():
    def robot(*drifts):
        keys = ("odometry_error", "truth_error", "odometry_heading_error", "truth_heading_error")
        empty = dict.fromkeys(keys)
        legs = [empty | {"drift": d, "heading_drift": d, "time": 1.0} for d in drifts]
        return [{"name": "r", "legs": [leg | {"reached": leg["drift"] < 3} for leg in legs]}]

    first, second = bands([robot(1, 1), robot(2), robot(3)])[0]["legs"]
    assert first["drift"] == pytest.approx([1.1, 2.0, 2.9])
    assert second["drift"] == [1.0, 1.0, 1.0]
    assert "truth_error" not in first
    assert (first["reached"], second["reached"]) == (pytest.approx(2 / 3), pytest.approx(1 / 3))
