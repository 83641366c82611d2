"""From the drawing to the robot as built: geometry, loads, tables, and tolerances by seed."""

from math import pi, sqrt

import numpy as np
import pytest
from factory import bundled, changed, player, robot
from hypothesis import given
from hypothesis import strategies as st
from rig import FOUR, KIWI, MECANUM, Rig

from soccersim.kinematics import OmniBase
from soccersim.plant.build import build_drive, loads, wheel_count
from soccersim.spec.field import Field, Goal

G = 9.81
FIELD = Field(length=18.0, width=12.0, goal=Goal(width=2.0))
SIX = {
    "drive": {**KIWI, "build": {"radius_sd": 0.01, "distance_sd": 0.01, "motor_sd": 0.02}},
    "dead": {
        "azimuth_deg": [0, 120, 240],
        "distance": 0.08,
        "radius": 0.025,
        "build": {"radius_bias": -0.03, "radius_sd": 0.01},
    },
}


@pytest.mark.parametrize("layout", [KIWI, FOUR, MECANUM])
def test_wheels_as_drawn_have_the_bases_matrices(layout):
    model = robot({"drive": layout})
    drive = build_drive([model], FIELD, seed=1)
    base = model.drive.base
    np.testing.assert_array_equal(drive.forward[0], base.jacobian)
    np.testing.assert_array_equal(drive.sideways[0], base.transverse)
    np.testing.assert_array_equal(drive.radius[0], base.rolling_radius)
    assert drive.mass[0] == 20
    assert drive.inertia[0] == pytest.approx(0.5 * 20 * 0.25**2)
    for wheel, row in enumerate(base.jacobian):
        moved = np.array([row[0] / 20, row[1] / 20, row[2] / drive.inertia[0]])
        assert drive.mobility[0, wheel] == pytest.approx(row @ moved)


def test_robots_of_few_wheels_leave_their_columns_empty():
    drive = build_drive([robot({"drive": FOUR}), robot(SIX), robot()], FIELD, seed=1)
    assert drive.wheels.tolist() == [4, 6, 3]
    assert drive.radius.shape == (3, 6)
    for array in drive[3:]:
        assert not array[0, 4:].any()
        assert not array[2, 3:].any()
    assert not drive.stall_torque[1, 3:].any()
    assert (drive.load[1, 3:] == 5.0).all()


@given(st.lists(st.floats(0, 360), min_size=3, max_size=6, unique=True), st.floats(0.05, 1))
def test_loads_carry_the_weight_and_balance_its_moments(azimuths, distance):
    if max(np.diff(sorted([*azimuths, min(azimuths) + 360]))) > 170:
        return  # it would fall over
    base = OmniBase.tangential(azimuths, distance, 0.05)
    load, shift = loads(base, 200.0, 3.0)
    assert load.sum() == pytest.approx(200)
    assert load @ base.contact == pytest.approx([0, 0], abs=1e-8)
    assert shift.sum(axis=0) == pytest.approx([0, 0], abs=1e-7)
    assert base.contact.T @ shift == pytest.approx(-3.0 * np.eye(2), abs=1e-7)


def test_a_kiwis_loads_are_the_textbooks():
    """mg/3 each, and (2/3) (m h / L) a cos of the angle between: none is left at g L / (2 h)."""
    base = OmniBase.tangential((30, 150, 270), 0.19, 0.05)
    load, shift = loads(base, 20 * G, 20 * 0.15)
    assert load == pytest.approx([20 * G / 3] * 3)
    rows = [(sqrt(3) / 2, 0.5), (-sqrt(3) / 2, 0.5), (0, -1)]
    assert shift == pytest.approx(-(2 / 3) * 20 * 0.15 / 0.19 * np.array(rows))
    lifts_off = G * 0.19 / (2 * 0.15)
    assert load[2] + shift[2] @ (0, -lifts_off) == pytest.approx(0, abs=1e-9)


def test_a_robot_without_load_transfer_never_leans():
    drive = build_drive([robot(mass_height=0.3, load_transfer=False)], FIELD, seed=1)
    assert not drive.load_shift.any()


def test_springs_carry_their_share_of_the_weight():
    drive = build_drive([robot(SIX)], FIELD, seed=1)
    assert drive.load[0].sum() == pytest.approx(20 * G)
    heavy = build_drive([robot(SIX, dead={"load": 60.0})], FIELD, seed=1)
    assert heavy.load[0, :3].sum() == pytest.approx(20 * G - 180)


def test_a_dusty_floor_takes_grip_from_every_wheel():
    dusty = FIELD.model_copy(update={"grip": 0.6})
    clean, dust = (build_drive([robot(SIX)], floor, seed=1) for floor in (FIELD, dusty))
    assert dust.static == pytest.approx(0.6 * clean.static)
    assert dust.kinetic == pytest.approx(0.6 * clean.kinetic)


def test_tolerances_belong_to_seed_robot_and_wheels():
    """Adding robots or dead wheels, or another seed elsewhere, changes nobody else's wheels."""
    model = robot(SIX)
    bare = robot({"drive": SIX["drive"]})
    one = build_drive([model], FIELD, seed=1)
    two = build_drive([model, model], FIELD, seed=1)
    for key in ("radius", "forward", "duty"):
        np.testing.assert_array_equal(getattr(one, key)[0], getattr(two, key)[0])
        without = getattr(build_drive([bare], FIELD, seed=1), key)[0, :3]
        np.testing.assert_array_equal(getattr(one, key)[0, :3], without)
        assert (getattr(two, key)[0] != getattr(two, key)[1]).any()
        other = getattr(build_drive([model], FIELD, seed=2), key)[0]
        assert (getattr(one, key)[0] != other).any()


def test_tolerances_scatter_as_said():
    """Of 600 wheels: mean and standard deviation of radius, distance and motors' speed."""
    model = robot(SIX)
    built = [build_drive([model] * 20, FIELD, seed) for seed in range(10)]
    radius = np.concatenate([drive.radius[:, :3] for drive in built]).ravel() / 0.05
    reach = np.concatenate([drive.forward[:, :3, 2] for drive in built]).ravel() / 0.19
    motor = np.concatenate([drive.duty[:, :3, -1] for drive in built]).ravel()
    dead = np.concatenate([drive.radius[:, 3:] for drive in built]).ravel() / 0.025
    for scatter, mean, deviation in (
        (radius, 1, 0.01),
        (reach, 1, 0.01),
        (motor, 1, 0.02),
        (dead, 0.97, 0.01),
    ):
        assert scatter.mean() == pytest.approx(mean, abs=4 * deviation / sqrt(600))
        assert scatter.std() == pytest.approx(deviation, rel=0.15)


def test_without_tolerances_all_wheels_are_as_drawn():
    drive = build_drive([robot({"drive": KIWI})] * 5, FIELD, seed=9)
    assert (drive.radius == 0.05).all()
    assert (drive.duty == drive.duty[0, 0]).all()


def test_duty_is_odd_rises_and_is_full_at_full_pwm():
    for name in ("idris", "msl"):
        drawn = {"drive": {"build": {"motor_sd": 0.0, "radius_sd": 0.0, "distance_sd": 0.0}}}
        drive = build_drive([changed(bundled(name), **drawn)], FIELD, seed=1)
        for duty in drive.duty[0]:
            np.testing.assert_array_equal(duty, -duty[::-1])
            assert (np.diff(duty) > 0).all()
            assert duty[-1] == pytest.approx(1.0, abs=0.02)
            assert duty[255] == 0


@pytest.mark.parametrize(("name", "wheels"), [("idris", 3), ("utama", 6), ("four-wheel", 4)])
def test_bundled_robots_stand_on_all_their_wheels(name, wheels):
    model = bundled(name)
    assert wheel_count(model) == wheels
    rig = Rig(player(model)).run(0.1)
    assert (rig.truth.load[0] > 0).all()
    assert rig.truth.load[0].sum() == pytest.approx(model.mass * G)
    assert np.abs(rig.body[0]).max() < 1e-9  # it stands


def test_full_pwm_is_the_no_load_speed_in_the_drawing():
    drive = build_drive([robot()], FIELD, seed=1)
    assert drive.no_load_speed[0] == pytest.approx(530 * 2 * pi / 60)
    assert drive.duty[0, :, -1] == pytest.approx(1.0)
