"""Whatever a user calls a scenario: one line a fault, exit code 2, nothing written."""

import re
from pathlib import Path

import pytest

BAD_MODEL = """\
mass: heavy
radius: 0.2
spoon: 1
drive: {azimuth_deg: [0, 120, 240], distance: 0.1, radius: 0.05}
"""
ROBOT = "  - {{name: r{}, model: garcia, start: [0, 0, 0]}}\n"
PARALLEL = "{azimuth_deg: [0, 0, 180], distance: 0.1, radius: 0.05}"


def refused(ended, *lines):
    """These lines on standard error, nothing else anywhere."""
    assert (ended.code, ended.out, ended.lines) == (2, "", list(lines))
    assert not Path("results").exists()


FAULTS = {  # what is wrong: the change of two.yaml, what is said
    "unknown key": (
        ("duration:", "durration:"),
        "4:1: durration: unknown key; did you mean `duration`?",
    ),
    "wrong type": (
        ("duration: 0.1", "duration: fast"),
        '4:11: duration: must be a number, not the text "fast"',
    ),
    "a number in quotes": (
        ("duration: 0.1", 'duration: "1"'),
        '4:11: duration: must be a number, not the text "1"',
    ),
    "nan": (("duration: 0.1", "duration: .nan"), "4:11: a finite number is needed, not .nan"),
    "infinity": (("duration: 0.1", "duration: .inf"), "4:11: a finite number is needed, not .inf"),
    "a number beyond all numbers": (
        ("duration: 0.1", "duration: 1e999"),
        "4:11: 1e999 is too large for a number",
    ),
    "a day too long": (
        ("duration: 0.1", "duration: 36001"),
        "4:11: duration: must be at most 36000, not 36001",
    ),
    "duplicate key": (
        ("name: two\nfield", "name: two\nname: again\nfield"),
        "3:1: the key `name` stands on line 2 already: keep one",
    ),
    "another version": (("version: 1", "version: 2"), "1:10: version: must be `1`, not 2"),
    "a key unlike any": (
        ("ball:", "frame: {x: 1}\nball:"),
        "5:9: frame.x: unknown key; known: `origin`, `rotation_deg`, `mirror_y`, `heading`",
    ),
    "two robots in one place": (
        ("[-2, 0, 0]", "[0.1, 0, 0]"),
        "13:12: robots.1.start: two and one are in one place: keep 0.46 m between their centres",
    ),
    "two robots of one name": (
        ("- name: two", "- name: one"),
        "11:11: robots.1.name: `one` is taken by robots.0",
    ),
    "a start off the floor": (
        ("[-2, 0, 0]", "[-20, 0, 0]"),
        "13:12: robots.1.start: two is off the floor: at (-20.00, 0.00) m on the field, "
        "inside is |x| < 5.26, |y| < 3.76",
    ),
    "a robot in the net": (
        ("[-2, 0, 0]", "[-5, 0, 0]"),
        "13:12: robots.1.start: two stands in a goal's net: keep 0.26 m from it",
    ),
    "a ball in the wall": (
        ("[2, 2]", "[2, 4]"),
        "5:12: ball.at: the ball is off the floor: at (2.00, 4.00) m on the field, "
        "inside is |x| < 5.39, |y| < 3.89",
    ),
    "a ball in a robot": (
        ("[2, 2]", "[0.2, 0]"),
        "5:12: ball.at: the ball and one are in one place: keep 0.33 m between their centres",
    ),
    "a ball in a post": (
        ("[2, 2]", "[4.5, -1]"),
        "5:12: ball.at: the ball stands in a goal post: keep 0.17 m from |x|, |y| = (4.50, 1.06) m",
    ),
    "a ball in the side net": (
        ("[2, 2]", "[4.8, 1.1]"),
        "5:12: ball.at: the ball stands in a goal's net: keep 0.13 m from it",
    ),
    "a shot from outside": (
        ("[2, 2]}", "[2, 2], shots: [{time: 1, at: [9, 0], velocity: [0, 0]}]}"),
        "5:42: ball.shots.0.at: the ball is off the floor: at (9.00, 0.00) m on the field, "
        "inside is |x| < 5.39, |y| < 3.89",
    ),
    "a ball like a bullet": (
        ("[2, 2]}", "[2, 2], velocity: [300, 400]}"),
        "5:30: ball.velocity: the ball moves at 500 m/s: at most 30",
    ),
    "one bad entry of a list": (
        ("[{to: [1, 0, 0]}]", "[7]"),
        "10:12: robots.0.path.0: must be a mapping (key: value), not 7",
    ),
    "a path of no legs": (
        ("[{to: [1, 0, 0]}]", "[]"),
        "10:11: robots.0.path: must have at least 1 entry, not 0",
    ),
    "too few wheels' PWM": (
        ("[10, 10, 10, 10]", "[10, 10, 10]"),
        "14:35: robots.1.open_loop.0.pwm: needs 4 entries, one a driven wheel",
    ),
    "a PWM beyond 255": (
        ("[10, 10, 10, 10]", "[10, 256, 10, 10]"),
        "14:40: robots.1.open_loop.0.pwm.1: must be at most 255, not 256",
    ),
    "nothing to do in a phase": (
        ("{seconds: 1, pwm: [10, 10, 10, 10]}", "{seconds: 1}"),
        "14:17: robots.1.open_loop.0: needs exactly one of pwm, wheel_speeds, twist",
    ),
    "no such model": (
        ("model: garcia", "model: gracia"),
        "8:12: robots.0.model: no robot `gracia` is bundled: did you mean `garcia`?",
    ),
    "no such model file": (
        ("model: garcia", "model: ./mine.yaml"),
        "8:12: robots.0.model: mine.yaml: cannot be read: No such file or directory",
    ),
    "a model file that is a folder": (
        ("model: garcia", "model: ./"),
        "8:12: robots.0.model: .: is not a file: a YAML file is needed",
    ),
    "no such field": (
        ("field: krsbi-2017", "field: krsbi-2027"),
        "3:8: field: no field `krsbi-2027` is bundled: did you mean `krsbi-2017`?",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_told_in_one_line_at_its_place(soccersim, scenario, fault):
    change, said = FAULTS[fault]
    scenario(change)
    refused(soccersim("run", "./two.yaml", "--out", "results"), f"two.yaml:{said}")


MODEL_FAULTS = {  # what is wrong with a robot written out
    "negative mass": ("mass: -1", "mass: must be at least 0.01, not -1"),
    "zero radius": ("radius: 0", "radius: must be at least 0.01, not 0"),
    "more inertia than a ring": (
        "inertia: 2",
        "inertia: is more than a ring of this mass and radius has: at most 1.25",
    ),
    "wheels of rank 2": (
        f"drive: {PARALLEL}",
        "drive.azimuth_deg: all wheels push along parallel lines (rank < 3): turn the direction "
        "of one of them",
    ),
    "an unreachable control rate": (
        "control: {rate_hz: 60}",
        "control.rate_hz: must divide physics_hz = 500: 10, 20, 25, 50, 100, 125, 250, 500",
    ),
    "a window of a year": (
        "drive: {azimuth_deg: [0, 120, 240], distance: .1, radius: .05, encoder: {window: 3e7}}",
        "drive.encoder.window: must be at most 1, not 30000000.0",
    ),
    "a rim at 524 m/s": (
        "drive: {azimuth_deg: [0, 120, 240], distance: .1, radius: .05, encoder: {}, "
        "motor: {no_load_speed_rpm: 1e5}}",
        "drive.motor.no_load_speed_rpm: turns the rim at 524 m/s: at most 30",
    ),
    "springs that lift the robot": (
        "mass: 1\n    dead: {azimuth_deg: [0, 120, 240], distance: .1, radius: .05, load: 4}",
        "dead.load: lifts the robot off its driven wheels: it weighs 9.81 N in all",
    ),
}


@pytest.mark.parametrize("fault", MODEL_FAULTS)
def test_a_fault_of_a_robot_is_told_in_one_line(soccersim, scenario, fault):
    text, said = MODEL_FAULTS[fault]
    drive = "drive: {azimuth_deg: [0, 120, 240], distance: .1, radius: .05, encoder: {}}"
    rest = "odometry: {heading: wheels}" + ("" if "drive:" in text else f"\n      {drive}")
    text = text.replace("\n    ", "\n      ")
    scenario(("model: garcia", f"model:\n      {text}\n      {rest}"))
    ended = soccersim("run", "./two.yaml", "--out", "results")
    assert ended.code == 2
    assert len(ended.lines) == 1
    assert re.sub(r"two.yaml:\d+:\d+: robots.0.model.", "", ended.err) == said + "\n"


def test_all_faults_of_a_file_are_told_at_once_in_its_order(soccersim, scenario):
    scenario(("duration: 0.1", "duration: -1"), ("name: two\nfield", "nme: two\nfield"))
    refused(
        soccersim("run", "./two.yaml"),
        "two.yaml:1:1: the key `name` is missing",
        "two.yaml:2:1: nme: unknown key; did you mean `name`?",
        "two.yaml:4:11: duration: must be greater than 0, not -1",
    )


def test_a_fault_in_a_models_own_file_is_told_at_its_place_there(soccersim, scenario, tmp_path):
    scenario(("model: garcia", "model: ./mine.yaml"))
    (tmp_path / "mine.yaml").write_text(BAD_MODEL)
    refused(
        soccersim("run", "./two.yaml"),
        'mine.yaml:1:7: robots.0.model.mass: must be a number, not the text "heavy"',
        "mine.yaml:3:1: robots.0.model.spoon: unknown key",  # too many to list what is known
    )
    (tmp_path / "mine.yaml").write_text("mass: [\n")
    refused(
        soccersim("run", "./two.yaml"),
        "mine.yaml:2:1: the text ends here, but a bracket is still open",
    )


def test_a_model_file_lies_beside_the_scenario_wherever_one_is(soccersim, scenario, tmp_path):
    text = scenario(("model: garcia", "model: ./mine.yaml"))
    (tmp_path / "deeper").mkdir()
    (tmp_path / "deeper" / "two.yaml").write_text(text)
    (tmp_path / "deeper" / "mine.yaml").write_text(BAD_MODEL)
    ended = soccersim("run", "deeper/two.yaml")
    assert ended.lines[0].startswith("deeper/mine.yaml:1:7: robots.0.model.mass: must be a number")


def test_robots_beyond_the_team_sheet_are_refused(soccersim, scenario):
    head = scenario().split("robots:")[0]
    scenario((scenario(), head), add="robots:\n" + "".join(ROBOT.format(i) for i in range(23)))
    ended = soccersim("run", "./two.yaml")
    refused(ended, "two.yaml:7:3: robots: must have at most 22 entries, not 23")
    scenario((scenario(), head), add="robots: 1000000000\n")
    ended = soccersim("run", "./two.yaml")
    refused(ended, "two.yaml:6:9: robots: must be a list, not 1000000000")


def test_a_recording_that_no_memory_holds_is_refused(soccersim, scenario):
    scenario(("duration: 0.1", "duration: 36000\ntiming: {record_hz: 500, frames_hz: 25}"))
    refused(
        soccersim("run", "./two.yaml", "--out", "results"),
        "two.yaml:4:11: duration: makes a recording of 13 GiB: at most 0.5; shorten it, "
        "lower timing.record_hz, or take words out of `record`",
    )


SETTINGS = {
    "duration": "--set duration: write it as key.path=value",
    "=3": "--set =3: write it as key.path=value",
    "duration=": "--set duration=: duration: must be a number, not nothing (null)",
    "duration=[": "--set duration=[: the text ends here, but a bracket is still open",
    "robots.7.name=x": "--set robots.7.name=x: robots: there is no entry `7`: "
    "the list has the entries 0 to 1",
    "robots.0.modle.mass=3": "--set robots.0.modle.mass=3: robots.0.modle: unknown key; "
    "did you mean `model`?",
    "robots.0.model.mass=-3": "--set robots.0.model.mass=-3: robots.0.model.mass: "
    "must be at least 0.01, not -3",
    "robots.0.model=./none.yaml": "--set robots.0.model=./none.yaml: robots.0.model: none.yaml: "
    "cannot be read: No such file or directory",
    "robots.0.model.control={y: {kd: 1}}": "--set robots.0.model.control={y: {kd: 1}}: "
    "robots.0.model.control.y: the key `kp` is missing",
}


@pytest.mark.parametrize("setting", SETTINGS)
def test_a_bad_setting_is_told_by_its_own_words(soccersim, scenario, setting):
    scenario()
    ended = soccersim("run", "./two.yaml", "--set", setting, "--out", "results")
    refused(ended, SETTINGS[setting])


def test_a_seed_beyond_63_bits_is_refused(soccersim, scenario):
    scenario()
    wrong = f"{2**63} is too large for an integer (at most {2**63 - 1})"
    refused(soccersim("run", "./two.yaml", "--seed", 2**63), f"--seed seed={2**63}: {wrong}")
    refused(
        soccersim("run", "./two.yaml", "--seed", 2**63 - 2, "--runs", 3),
        f"--runs 3 leads from seed {2**63 - 2} beyond 2^63 - 1",
    )


def test_names_are_looked_up_and_what_has_a_suffix_is_a_path(soccersim, scenario):
    scenario()
    refused(
        soccersim("run", "defnder"),
        "no scenario `defnder` is bundled: did you mean `defender`?",
    )
    refused(
        soccersim("run", "two"),
        "no scenario `two` is bundled: for the file here write `./two.yaml`",
    )
    refused(
        soccersim("run", "defender.yaml"),
        "defender.yaml: cannot be read: No such file or directory",
    )
    assert "no scenario `` is bundled: there are " in soccersim("run", "").err
