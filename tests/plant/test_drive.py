"""Motors and what they make of a robot: speeds, torques, sides, brakes."""

import csv
from math import atanh, cos, exp, pi, sqrt

import numpy as np
import pytest
from factory import NO_SLIP, bundled, changed, player, robot
from rig import FOUR, KIWI, MECANUM, Rig, four_wheels, kiwi

from soccersim.bundled import root
from soccersim.control.profile import motor_line_time
from soccersim.plant.drive import drive_robots
from soccersim.plant.world import step_bodies

RPM = 30 / pi  # of one rad/s
PAPER = {0: "idris-table3", 1: "idris-table2", 2: "idris-table4"}  # right, left, back
IDRIS = bundled("idris")
AS_DRAWN = {"radius_sd": 0.0, "distance_sd": 0.0, "motor_sd": 0.0}


def paper_speeds(wheel):
    """PWM and tachometer of Idris' table for one wheel."""
    lines = (root() / "assets" / "papers" / f"{PAPER[wheel]}.csv").read_text().splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return np.array([(int(row["pwm"]), float(row["real"])) for row in rows]).T


def unloaded_rpm(levels):
    """Where Idris' three motors settle at each PWM level with the robot held up."""
    rig = Rig(player(changed(IDRIS, drive={"build": AS_DRAWN})))
    rig.lift()
    settled = []
    for level in levels:
        rig.pwm[:] = level
        rig.run(0.5)
        settled.append(rig.truth.wheel_speed[0] * RPM)
    return np.array(settled)


def test_unloaded_motors_settle_on_the_papers_tables():
    levels = IDRIS.drive.motor.pwm_table.pwm
    settled = unloaded_rpm(map(int, levels))
    assert len(levels) == 27
    for wheel in range(3):
        pwm, real = paper_speeds(wheel)
        np.testing.assert_array_equal(pwm, levels)
        assert settled[:, wheel] == pytest.approx(real, abs=0.5)
        line = np.polyfit(pwm[pwm >= 20], settled[pwm >= 20, wheel], 1)
        off = settled[pwm >= 20, wheel] - np.polyval(line, pwm[pwm >= 20])
        assert sqrt(np.mean(off**2)) <= 2.6
    assert settled[-1] == pytest.approx([530.3, 528.8, 530.1], abs=1)


def test_without_a_table_friction_slows_the_motor():
    rig = Rig(kiwi(drive={"motor": {"friction_torque": 0.05, "stall_torque": 4.0}}))
    rig.lift()
    rig.pwm[:] = 255
    rig.run(1.0)
    assert rig.truth.wheel_speed[0] * RPM == pytest.approx(530 * (1 - 0.05 / 4), abs=0.01)


@pytest.mark.parametrize("level", [1, 37, 128, 255])
def test_backward_is_forward_turned_round(level):
    ahead, back = Rig(kiwi()), Rig(kiwi())
    ahead.pwm[:], back.pwm[:] = [[level, -level, 0]], [[-level, level, 0]]
    ahead.run(1.0)
    back.run(1.0)
    assert ahead.body[0, 4] > 0
    np.testing.assert_allclose(ahead.body[0], -back.body[0], atol=1e-12)
    np.testing.assert_allclose(ahead.truth.wheel_speed, -back.truth.wheel_speed, atol=1e-12)


def test_a_held_wheel_pushes_with_the_stall_torque():
    """Torque over radius, on a robot so heavy that its wheels hardly turn."""
    drive = {"grip": {"roller": 0.0}, "motor": {"friction_torque": 0.0}}
    rig = Rig(four_wheels(mass=1000.0, drive=drive))
    rig.pwm[0] = [-255, -255, 255, 255]
    rig.run(0.02)
    assert rig.truth.wrench[0, 0] == pytest.approx(4 * 4.0 / 0.05 * cos(pi / 4), rel=0.01)


def test_the_driver_limits_the_torque():
    """The first tick's push is no more than the limit over the radius, forward and in braking."""
    motor = {"torque_limit": 1.0, "stall_torque": 14.0, "friction_torque": 0.0}
    rig = Rig(four_wheels(drive={"grip": NO_SLIP, "motor": motor}))
    forward = np.array([-255, -255, 255, 255])
    reach = 4 * 1.0 / 0.05 * cos(pi / 4)  # N
    for level in (forward, -forward, 0 * forward):
        rig.pwm[0] = level
        for _ in range(150):
            rig.tick()
            assert abs(rig.truth.wrench[0, 0]) <= reach * (1 + 1e-9)
        pushing = abs(rig.truth.wrench[0, 0])
    assert pushing < reach  # at the end it stands, or nearly
    rig.pwm[0] = forward
    rig.tick(5)
    assert rig.truth.wrench[0, 0] > 0.8 * reach  # the wheels' own inertia takes the rest


@pytest.mark.parametrize(("at_zero", "rolled"), [("coast", (1.5, 2.5)), ("brake", (0.0, 0.5))])
def test_a_coasting_robot_rolls_on_and_a_braking_one_stops(at_zero, rolled):
    rig = Rig(kiwi(drive={"motor": {"at_zero": at_zero}}))
    rig.throw(0, 1.0, 0.0)
    rig.roll((1.0, 0.0, 0.0))
    rig.run(3.0)
    assert rolled[0] <= rig.body[0, 0] <= rolled[1]
    assert abs(rig.body[0, 3]) < (1.0 if at_zero == "coast" else 1e-3)


def test_a_braked_robot_comes_to_rest_for_good():
    """Not to ever smaller numbers, over which the processor would brood."""
    rig = Rig(kiwi())
    rig.throw(0, 1.0, -0.5, 3.0)
    rig.run(5.0)
    assert (rig.body[0, 3:] == 0).all()
    assert (rig.truth.wheel_speed == 0).all()
    assert (rig.truth.acceleration == 0).all()


def test_wheels_alone_drive_ahead_and_aside_on_mecanum():
    """All four forward go ahead; forward and backward by turns round the robot go aside."""
    model = robot(drive={**MECANUM, "grip": NO_SLIP, "motor": {"friction_torque": 0.0}})
    for levels, direction in (((1, 1, 1, 1), (1, 0)), ((1, -1, 1, -1), (0, 1))):
        rig = Rig(player(model))
        rig.pwm[0] = np.array(levels) * 120
        rig.run(1.5)
        velocity, omega = rig.body[0, 3:5], rig.body[0, 5]
        rim = rig.truth.wheel_speed[0, 0] * 0.05
        assert rim > 1.0
        assert abs(velocity @ direction) == pytest.approx(rim, rel=5e-3)
        assert velocity @ (direction[1], -direction[0]) == pytest.approx(0, abs=1e-9)
        assert omega == pytest.approx(0, abs=1e-9)


def switching_distance(rig, seconds):
    """How far a robot comes with full voltage ahead for so long, then back until it stands."""
    start, travelled = rig.body[0, 0], 0.0
    rig.pwm[0] = [0, -255, 0, 255]
    rig.run(seconds)
    rig.pwm[0] = [0, 255, 0, -255]
    while rig.body[0, 3] > 0:
        travelled += rig.dt
        rig.tick()
    return rig.body[0, 0] - start, seconds + travelled


def test_full_voltage_ahead_then_back_takes_the_motor_lines_time():
    """Two wheels of four drive along x, the others roll aside; the floor holds all it is given."""
    top, pull = 2.775, 2.943  # m/s without load, m/s2 at stall
    mass = 20.0 + 2 * 3.35e-3 / 0.05**2  # the turning wheels are carried along
    motor = {
        "no_load_speed_rpm": top / 0.05 * RPM,
        "stall_torque": pull * mass * 0.05 / 2,
        "friction_torque": 0.0,
        "gear_ratio": 1.0,
        "rotor_inertia": 0.0,
        "wheel_inertia": 3.35e-3,
    }
    model = robot(drive={"azimuth_deg": [0, 90, 180, 270], "grip": NO_SLIP, "motor": motor})
    low, high = 1.0, 2.8
    while high - low > 1e-3:
        middle = (low + high) / 2
        distance, taken = switching_distance(Rig(player(model, start=(-5, 0, 0))), middle)
        low, high = (middle, high) if distance < 4.5 else (low, middle)
    expected = 2 * top / pull * atanh(sqrt(1 - exp(-4.5 * pull / top**2)))
    assert expected == pytest.approx(2.838, rel=1e-3)
    assert motor_line_time(4.5, top, pull) == pytest.approx(expected)
    assert distance == pytest.approx(4.5, abs=0.01)
    assert taken == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("layout", [KIWI, FOUR])
def test_a_push_on_the_body_moves_it_and_its_wheels(layout):
    """Force over mass and reflected inertia: a hand on a coasting robot that does not slip."""
    model = robot(
        drive={
            **layout,
            "grip": NO_SLIP,
            "motor": {"at_zero": "coast", "friction_torque": 0.0},
        }
    )
    rig = Rig(player(model))
    rig.truth.push[0, 0] = 10.0
    rig.run(1.0)
    wheels = 3.35e-3 / 0.05**2 * len(layout["azimuth_deg"]) / 2  # of n at all angles, half
    assert rig.body[0, 3] == pytest.approx(10.0 / (20.0 + wheels), rel=2e-3)


def test_a_level_no_driver_has_stops_the_run():
    """Broken robot code may ask for anything: nothing beside the table is read."""
    for level in (256, -256, 2**40, -(2**63)):
        rig = Rig(kiwi())
        rig.pwm[0, 1] = level
        drive_robots(rig.drive, rig.truth, rig.pwm, rig.dt)
        assert not step_bodies(rig.world.chipmunk, rig.truth, rig.dt)
