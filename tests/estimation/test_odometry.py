"""Odometry: what the wheels turned, put together to a pose."""

from math import cos, degrees, pi, radians, sin

import numpy as np
import pytest
from factory import NO_SLIP, far, merged, player, robot, simulate
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from soccersim.estimation.odometry import advance, build_odometry, reckon
from soccersim.sensing.encoder import build_encoders
from soccersim.state import new_estimate, new_readings

HZ = 500
DEAD = {
    "azimuth_deg": [180, 300, 60],
    "direction_deg": [90, 210, -30],
    "distance": 0.08,
    "radius": 0.025,
    "encoder": {"perfect": True},
}
speeds = st.floats(-3, 3)
SQUARE_AND_TURN = ((1, 0, 0), (1, 1, 90), (-0.5, 1, 200), (0, 0, 0))


class Reckoner:
    """One robot's odometry, fed with what its wheels would tell."""

    def __init__(self, model):
        wheels = sum(len(some.azimuth_deg) for some in (model.drive, model.dead) if some)
        self.model = model
        _, self.per_count = build_encoders([model], wheels, HZ, 0)
        self.odometry = build_odometry([model], self.per_count, HZ)
        self.readings, self.estimate = new_readings(1, wheels), new_estimate(1, wheels)
        self.tick = 0

    def roll(self, dx, dy, turn, gyro=None):
        """The pose believed after a displacement in the body frame that the wheels felt."""
        bases = [self.model.drive.base, *([self.model.dead.base] if self.model.dead else [])]
        angles = np.concatenate([base.wheel_speeds((dx, dy, turn)) for base in bases])
        self.readings.counts[0] += angles / self.per_count[0]
        self.readings.gyro_angle[0] += turn if gyro is None else gyro
        reckon(self.odometry, self.estimate, self.readings, self.tick, 1 / HZ)
        self.tick += int(self.odometry.every[0])
        return self.estimate.pose[0].copy()


def after(twist, steps, seconds, midpoint=False, start=(0.0, 0.0, 0.0)):
    """The pose after a constant twist that is taken in so many steps."""
    pose = np.array([start])
    for _ in range(steps):
        advance(pose, 0, *(rate * seconds / steps for rate in twist), midpoint)
    return pose[0]


def euler(twist, steps, seconds):
    x = y = heading = 0.0
    for _ in range(steps):
        x += (twist[0] * cos(heading) - twist[1] * sin(heading)) * seconds / steps
        y += (twist[0] * sin(heading) + twist[1] * cos(heading)) * seconds / steps
        heading += twist[2] * seconds / steps
    return x, y


def test_a_quarter_arc_in_steps_of_10_ms():
    """model.md, check 6: v = 1, w = 1 for a quarter turn, at (1, 1) and 90 degrees then."""
    steps = round(pi / 2 / 0.01)
    where = (1.0, 1.0)
    assert far(after((1, 0, 1), steps, pi / 2), where) < 1e-12
    assert far(after((1, 0, 1), steps, pi / 2, midpoint=True), where) < 2e-5
    assert far(euler((1, 0, 1), steps, pi / 2), where) == pytest.approx(7.07e-3, rel=0.01)


@given(st.tuples(speeds, speeds, speeds), st.integers(1, 40))
def test_an_arc_is_exact_in_however_many_steps(twist, steps):
    vx, vy, omega = twist
    assume(abs(omega) > 1e-3)
    once = after(twist, 1, 2.0, start=(0.3, -0.7, 1.1))
    assert after(twist, steps, 2.0, start=(0.3, -0.7, 1.1)) == pytest.approx(once, abs=1e-9)
    # round the instantaneous centre, at (-vy, vx) / omega in the body's frame
    x = (vx * sin(2 * omega) - vy * (1 - cos(2 * omega))) / omega
    y = (vx * (1 - cos(2 * omega)) + vy * sin(2 * omega)) / omega
    assert after(twist, 1, 2.0)[:2] == pytest.approx((x, y), abs=1e-9)


def test_the_midpoint_is_of_second_order():
    twist, right = (1.0, 0.5, 2.0), after((1.0, 0.5, 2.0), 1, 1.0)
    errors = [far(after(twist, steps, 1.0, midpoint=True), right) for steps in (10, 20, 40)]
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.02)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.02)


@given(st.tuples(speeds, speeds, speeds), st.sampled_from(["gyro", "wheels"]), st.booleans())
@settings(max_examples=50)
def test_rolling_wheels_tell_the_displacement(moved, heading, dead):
    used = {"wheels": "dead" if dead else "drive", "heading": heading}
    reckoner = Reckoner(robot(dead=DEAD, odometry=used))
    pose = reckoner.roll(*moved)
    assert pose == pytest.approx(after(moved, 1, 1.0), abs=1e-9)
    span = reckoner.odometry.every[0] / HZ
    assert reckoner.estimate.twist[0] * span == pytest.approx(np.array(moved), abs=1e-9)


@pytest.mark.parametrize("heading", ["gyro", "wheels"])
def test_wheels_that_stand_anyhow_tell_the_displacement(heading):
    """Where the levers differ, a turn on the spot looks like a move unless it is taken off."""
    crooked = {"azimuth_deg": [20, 150, 270], "distance": [0.1, 0.19, 0.3], "radius": 0.04}
    pose = Reckoner(robot(drive=crooked, odometry={"heading": heading})).roll(0.3, -0.2, 0.1)
    assert pose == pytest.approx(after((0.3, -0.2, 0.1), 1, 1.0))


@pytest.mark.parametrize("heading", ["gyro", "wheels"])
def test_mecanum_wheels_tell_the_displacement(heading):
    mecanum = {
        "azimuth_deg": [40, 140, 220, 320],
        "direction_deg": [0, 0, 0, 0],
        "roller_deg": [-45, 45, -45, 45],
    }
    pose = Reckoner(robot(drive=mecanum, odometry={"heading": heading})).roll(0.3, -0.2, 0.1)
    assert pose == pytest.approx(after((0.3, -0.2, 0.1), 1, 1.0))


def test_the_heading_is_the_gyro_s_or_the_wheels():
    """The gyro tells 2 % more than the wheels felt."""
    moved = (0.2, 0.1, 0.5)
    by_gyro = Reckoner(robot(odometry={"heading": "gyro"})).roll(*moved, gyro=0.51)
    by_wheels = Reckoner(robot(odometry={"heading": "wheels"})).roll(*moved, gyro=0.51)
    assert by_gyro[2] == pytest.approx(0.51)
    assert by_wheels[2] == pytest.approx(0.5)
    assert by_wheels[:2] == pytest.approx(after(moved, 1, 1.0)[:2])


def test_three_wheels_that_turn_alike_are_a_turn_whatever_the_gyro_says():
    """Known not to turn, a kiwi base takes the same pulses of all wheels for slip."""
    pose = Reckoner(robot(odometry={"heading": "gyro"})).roll(0, 0, 0.5, gyro=0.0)
    assert pose == pytest.approx(np.zeros(3), abs=1e-12)


def test_dead_wheels_know_nothing_of_the_driven_ones():
    reckoner = Reckoner(robot(dead=DEAD, odometry={"wheels": "dead"}))
    reckoner.readings.counts[0, :3] = 1e4  # the driven wheels spin on the spot
    reckon(reckoner.odometry, reckoner.estimate, reckoner.readings, 0, 1 / HZ)
    assert reckoner.estimate.pose[0] == pytest.approx(np.zeros(3))


def test_steps_come_at_the_control_rate_and_lose_nothing_between():
    reckoner = Reckoner(robot(control={"rate_hz": 50}, odometry={"heading": "wheels"}))
    base, poses = reckoner.model.drive.base, []
    for tick in range(21):
        angles = base.wheel_speeds((0.001 * tick, 0, 0))
        reckoner.readings.counts[0] = angles / reckoner.per_count[0]
        reckon(reckoner.odometry, reckoner.estimate, reckoner.readings, tick, 1 / HZ)
        poses.append(reckoner.estimate.pose[0, 0])
    assert poses == pytest.approx([0.001 * (tick // 10 * 10) for tick in range(21)])
    assert reckoner.estimate.twist[0, 0] == pytest.approx(0.001 * HZ)


@pytest.mark.parametrize("heading", ["gyro", "wheels"])
@pytest.mark.parametrize("wheels", ["drive", "dead"])
def test_perfect_sensors_without_slip_err_by_the_tick_alone(wheels, heading):
    """A body that turns while it moves goes straight on for a tick; its wheels already turn."""
    model = robot(
        drive={"grip": NO_SLIP},
        dead=merged(DEAD, {"grip": NO_SLIP}),
        odometry={"wheels": wheels, "heading": heading},
        control={"limits": {"acceleration": 0.5, "turn_acceleration": 1.0}},
    )
    way, errors = player(model, *SQUARE_AND_TURN, start=(0.5, 0.5, 30)), []
    for hz in (500, 1000, 2000):
        run = simulate(way, timing={"physics_hz": hz})
        error = abs(run.estimate[:, 0] - run.body[:, 0, :3])
        assert len(run.legs[0]) == 4
        assert degrees(error[:, 2].max()) < 1e-3
        errors.append(error[:, :2].max())
    assert errors[0] < 1.5e-3
    assert errors[1] < 0.6 * errors[0]
    assert errors[2] < 0.6 * errors[1]


def test_whole_pulses_leave_the_odometry_within_a_few_of_them():
    pulse = 2 * pi * 0.05 / 270
    model = robot(
        drive={"grip": NO_SLIP, "encoder": {"perfect": False, "pulses_per_turn": 270}},
        control={"limits": {"acceleration": 0.5, "turn_acceleration": 1.0}},
    )
    run = simulate(player(model, *SQUARE_AND_TURN))
    error = run.estimate[:, 0] - run.body[:, 0, :3]
    assert 0.1 * pulse < abs(error[:, :2]).max() < 4 * pulse


def test_headings_are_not_wrapped():
    reckoner = Reckoner(robot())
    for _ in range(30):
        pose = reckoner.roll(0, 0, radians(100))
    assert degrees(pose[2]) == pytest.approx(3000)
