"""The table, read with python's csv and held against the recording number by number."""

import csv

import numpy as np
import pytest
from factory import bundled, player, simulate
from tape import tape

from soccersim import Simulation, load_scenario
from soccersim.export.table import save_csv
from soccersim.problems import MachineError
from soccersim.record import Recording


def read(path):
    """The header, and each column by its title."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], dict(zip(rows[0], zip(*rows[1:], strict=True), strict=True))


def saved(recording, folder, **part):
    save_csv(recording, folder / "run.csv", **part)
    return read(folder / "run.csv")


def numbers(cells):
    return np.array([float(cell) if cell else np.nan for cell in cells])


@pytest.fixture(scope="module")
def everything():
    return Simulation(load_scenario("one-of-everything", settings=["duration=0.5"])).run()


def test_every_array_of_a_run_stands_in_it_bit_by_bit(everything, tmp_path):
    header, table = saved(everything, tmp_path)
    assert len(header) == len(set(header))
    assert np.array_equal(numbers(table["time [s]"]), everything.time)
    assert np.array_equal(numbers(table["tick"]), everything.tick)
    motion = ("x [m]", "y [m]", "heading [rad]", "vx [m/s]", "vy [m/s]", "omega [rad/s]")
    arrays, of_wheels = (
        everything.arrays,
        {
            "wheel_speed": "speed [rad/s]",
            "wheel_angle": "angle [rad]",
            "wheel_setpoint": "set-point [rad/s]",
            "slip": "slip [m/s]",
            "load": "load [N]",
            "counts": "encoder [counts]",
            "pwm": "pwm [of 255]",
        },
    )
    for robot, player_ in enumerate(everything.scenario.robots):
        name = player_.name
        for k, title in enumerate(motion):
            shown = numbers(table[f"{name} {title}"])
            assert np.array_equal(shown, everything.body[:, robot, k])
        for k, title in enumerate(motion[:3]):
            shown = numbers(table[f"{name} believed {title}"])
            assert np.array_equal(shown, everything.estimate[:, robot, k])
            shown = numbers(table[f"{name} set-point {title}"])
            assert np.array_equal(shown, everything.reference[:, robot, k], equal_nan=True)
            shown = numbers(table[f"{name} command {motion[3 + k]}"])
            assert np.array_equal(shown, arrays["command"][:, robot, k])
        wheels = [title for title in header if title.startswith(f"{name} wheel ")]
        assert len(wheels) % len(of_wheels) == 0
        for wheel in range(len(wheels) // len(of_wheels)):
            for key, title in of_wheels.items():
                shown = numbers(table[f"{name} wheel {wheel + 1} {title}"])
                assert np.array_equal(shown, arrays[key][:, robot, wheel])
    for k, title in enumerate(motion):
        assert np.array_equal(numbers(table[f"ball {title}"]), everything.ball[:, k])


def test_what_was_not_recorded_has_no_column(tmp_path):
    run = simulate(player(bundled("garcia")), duration=0.1, record=[])
    header, _ = saved(run, tmp_path)
    assert not any("wheel" in title or "command" in title or "gyro" in title for title in header)
    assert "r believed x [m]" in header


def test_a_match_tells_its_phase_its_orders_and_what_teams_believe(tmp_path):
    robots = np.zeros((8, 10, 3))
    robots[..., 0] = np.arange(10)
    orders = np.zeros((4, 10, 5))
    orders[2:, 4] = 0.5, -0.25, 1.0, 8.0, 1.0
    seen = np.zeros((4, 2, 5))
    seen[2:, 1] = np.nan
    phase = ["stop", "throw_in", "play", "play"]
    match = tape(
        robots,
        np.zeros((8, 2)),
        orders=orders,
        ball_believed=seen,
        phase=phase,
        whose=[-1, 1, -1, -1],
        labels=[[1, 4, "a, b"], [3, 4, ""]],
    )
    sighted = np.full((4, 10, 2), np.nan, np.float32)
    sighted[1, 4] = 1.5, -2.0
    _, table = saved(Recording(match.meta, {**match.arrays, "ball_sighted": sighted}), tmp_path)
    assert table["home-5 sees ball y [m]"] == ("", "", "-2.0", "", "", "", "", "")
    assert table["phase"] == ("stop",) * 2 + ("throw_in",) * 2 + ("play",) * 4
    assert table["restart of"] == ("", "", "away", "away", "", "", "", "")
    assert table["home-5 command kick [m/s]"] == ("0.0",) * 4 + ("8.0",) * 4
    assert table["home-5 command vy [m/s]"][-1] == "-0.25"
    assert table["home-5 label"] == ("",) * 2 + ("a, b",) * 4 + ("",) * 2
    assert table["away believes ball x [m]"] == ("0.0",) * 4 + ("",) * 4
    assert numbers(table["away-5 x [m]"]).tolist() == [9.0] * 8
    assert set(table["home goals"]) == {"0"}


def test_a_part_has_its_rows_alone(tmp_path):
    run = simulate(player(bundled("garcia")), duration=1.0)
    _, table = saved(run, tmp_path, start=0.5, end=0.6)
    assert numbers(table["time [s]"]) == pytest.approx([0.5, 0.52, 0.54, 0.56, 0.58, 0.6])


def test_names_with_commas_and_quotes_come_back_whole(tmp_path):
    run = simulate(player(bundled("garcia"), name='a, "b"'), duration=0.1)
    header, _ = saved(run, tmp_path)
    assert 'a, "b" x [m]' in header


def test_a_table_that_cannot_be_written_is_named(tmp_path):
    run = simulate(player(bundled("garcia")), duration=0.02)
    with pytest.raises(MachineError, match="nowhere"):
        save_csv(run, tmp_path / "nowhere" / "run.csv")
