"""Wheels on the floor: how much they hold, how they let go, and that no energy comes of it."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest
from factory import player, robot
from hypothesis import given, settings
from hypothesis import strategies as st
from rig import COULOMB, FOUR, KIWI, MECANUM, Rig, four_wheels, kiwi

from soccersim.plant.traction import friction_coefficient, secant

G = 9.81
DRY = {"static": 0.6, "kinetic": 0.6, **COULOMB}
SMALL = st.floats(1e-4, 1.0)


@given(st.floats(-5, 5), SMALL, SMALL, SMALL)
def test_friction_falls_from_static_to_kinetic_as_the_wheel_slips(slip, low, more, width):
    coefficient = friction_coefficient(slip, low + more, low, width)
    assert low <= coefficient <= low + more
    assert coefficient >= friction_coefficient(slip * 1.5, low + more, low, width)
    assert friction_coefficient(0.0, low + more, low, width) == low + more
    assert friction_coefficient(10 * width, low + more, low, width) == pytest.approx(low)


@given(st.floats(-5, 5), SMALL, st.floats(0.1, 100))
def test_the_floor_never_pushes_more_than_its_grip_nor_a_slipping_wheel_on(slip, creep, grip):
    force = secant(grip, slip, creep) * slip
    assert abs(force) <= grip
    assert force * slip >= 0
    assert secant(grip, creep, creep) * creep == pytest.approx(grip / sqrt(2))


def ramp(rig, acceleration, degrees, seconds=0.5):
    """Speed the wheels up as for this acceleration along a direction; returns the largest slip."""
    rig.seize()
    along = np.array([cos(radians(degrees)), sin(radians(degrees)), 0.0])
    for k in range(1, round(seconds / rig.dt) + 1):
        rig.roll(acceleration * k * rig.dt * along)
        rig.tick()
    return np.abs(rig.truth.slip).max()


@pytest.mark.parametrize("dt", [0.001, 0.002, 0.004])
@pytest.mark.parametrize(("degrees", "limit"), [(0, 2.943), (30, 3.398)])
def test_a_kiwi_holds_to_its_traction_limit_and_slips_beyond(degrees, limit, dt):
    """0.500 and 0.577 mu g: along a wheel's drive axis, and between two."""
    model = robot(load_transfer=False, drive={**KIWI, "grip": DRY})
    assert ramp(Rig(player(model), dt=dt), 0.97 * limit, degrees) < 0.02
    rig = Rig(player(model), dt=dt)
    assert ramp(rig, 1.15 * limit, degrees) > 0.15
    assert np.hypot(*rig.body[0, 3:5]) / 0.5 == pytest.approx(limit, rel=0.03 * (1 + dt / 0.004))


@pytest.mark.parametrize(
    ("layout", "degrees", "deceleration"),
    [(KIWI, 30, 3.398), (KIWI, 90, 3.398), (FOUR, 0, 4.162)],
)
def test_locked_wheels_slide_to_a_stop(layout, degrees, deceleration):
    """mu g times the mean of |cos| between the slide and the wheels: 1/sqrt3 and 1/sqrt2."""
    rig = Rig(player(robot(load_transfer=False, drive={**layout, "grip": DRY})))
    rig.seize()
    along = np.array([cos(radians(degrees)), sin(radians(degrees))])
    rig.throw(0, *(2 * along))
    rig.run(0.3)
    assert (2 - rig.body[0, 3:5] @ along) / 0.3 == pytest.approx(deceleration, rel=0.01)
    assert abs(rig.body[0, 5]) < 1e-3


@pytest.mark.parametrize(("side", "sign"), [(90, 1), (-90, -1)])
def test_leaning_back_costs_a_kiwi_grip_on_its_front_wheels(side, sign):
    """Along y two wheels drive: mu g / sqrt3 / (1 +- mu h / (sqrt3 L)), 2.668 m/s2 to the left."""
    height, distance, mu = 0.15, 0.19, 0.6
    limit = mu * G / sqrt(3) / (1 + sign * mu * height / (sqrt(3) * distance))
    grip = {**DRY, "creep_speed": 1e-3}
    for share, slips in ((0.96, False), (1.04, True)):
        rig = Rig(kiwi(mass_height=height, drive={"grip": grip}))
        slip = ramp(rig, share * limit, side, seconds=1.0)
        assert (slip > 0.02) == slips
    reached = sign * rig.body[0, 4] / 1.0
    assert reached == pytest.approx(2.668 if sign > 0 else limit, rel=0.04)


def test_load_leaves_the_wheels_ahead_when_a_robot_speeds_up():
    rig = Rig(kiwi(mass_height=0.15))
    rig.pwm[0] = [60, -60, 0]  # along y
    rig.run(0.1)
    load, rest = rig.truth.load[0], rig.drive.load[0]
    assert rest == pytest.approx(20 * G / 3)
    assert load.sum() == pytest.approx(20 * G)
    lean = (2 / 3) * 20 * 0.15 / 0.19 * rig.truth.acceleration[0, 1]
    assert load - rest == pytest.approx([-lean / 2, -lean / 2, lean], rel=0.01)
    assert lean > 5.0


def test_a_body_takes_a_moment_to_lean():
    """A constant push's acceleration arrives on the wheels within a lag of 20 ms: 63 % by then."""
    rig = Rig(kiwi(mass_height=0.15, drive={"motor": {"at_zero": "coast"}}))
    rig.lift()
    rig.truth.push[0, 0] = 40.0
    rig.run(0.02)
    assert rig.truth.acceleration[0] == pytest.approx([2 * 0.63, 0], abs=0.1)
    rig.run(0.2)
    assert rig.truth.acceleration[0] == pytest.approx([2.0, 0], abs=1e-3)


def test_rollers_rub_a_little():
    """Two wheels of four roll along, freely; the others' rollers hold with mu_r of their load."""
    grip = {"roller": 0.05, "creep_ratio": 0.0}
    motor = {"at_zero": "coast", "friction_torque": 0.0}
    drive = {"azimuth_deg": [0, 90, 180, 270], "grip": grip, "motor": motor}
    rig = Rig(player(robot(drive=drive)))
    rig.throw(0, 2.0, 0.0)
    rig.roll((2.0, 0.0, 0.0))
    rig.run(1.0)
    carried = 20 + 2 * 3.35e-3 / 0.05**2  # kg, with the turning wheels
    assert 2.0 - rig.body[0, 3] == pytest.approx(0.05 * 20 * G / 2 / carried, rel=0.01)


def test_a_lifted_wheel_pulls_nothing():
    """Beyond g L / (2 h) along a kiwi's axis a wheel would have to hold the robot down."""
    rig = Rig(kiwi(mass_height=0.3, drive={"grip": {"static": 3.0, "kinetic": 3.0}}))
    rig.truth.acceleration[0] = 0.0, -2 * G * 0.19 / (2 * 0.3)
    rig.tick()
    assert rig.truth.load[0, 2] == 0.0
    assert rig.truth.load[0, 0] > 0


CRUISE = np.array([0.3, 1.0, 0.5])  # vx, vy, omega of the body


def cruise(mass, mu, creep, dt, seconds=2.0):
    """Wheels held at the cruise's speeds by a PI that knows them exactly, every 4 ms.

    Returns the body twists and the floor's forces on the body, of the second half.
    """
    grip = {"static": mu, "kinetic": 0.85 * mu, "creep_speed": creep, "creep_ratio": 0.0}
    rig = Rig(kiwi(mass=mass, mass_height=0.15, drive={"grip": grip}), dt=dt)
    wanted = rig.drive.forward[0] @ CRUISE / 0.05
    top, total = rig.drive.no_load_speed[0], np.zeros(3)
    rig.pwm[0] = 1
    twists, forces = [], []
    for k in range(round(seconds / dt)):
        if k % round(0.004 / dt) == 0:
            error = wanted - rig.truth.wheel_speed[0]
            total += error * 0.004
            rig.drive.duty[0, :, 256] = wanted / top + 0.1 * error + 1.0 * total
        rig.tick()
        c, s = cos(rig.body[0, 2]), sin(rig.body[0, 2])
        vx, vy, omega = rig.body[0, 3:]
        fx, fy = rig.truth.wrench[0, :2]
        if k * dt >= seconds / 2:
            twists.append((c * vx + s * vy, c * vy - s * vx, omega))
            forces.append((c * fx + s * fy, c * fy - s * fx))
    return np.array(twists), np.array(forces)


@pytest.mark.parametrize("mass", [10, 20, 40])
@pytest.mark.parametrize("mu", [0.3, 0.8])
@pytest.mark.parametrize("creep", [0.005, 0.02, 0.05])
def test_stiff_friction_neither_chatters_nor_depends_on_the_tick(mass, mu, creep):
    ends = {}
    for dt in (0.001, 0.002, 0.004):
        twists, forces = cruise(mass, mu, creep, dt)
        assert np.abs(np.diff(forces, axis=0)).max() < 1.0  # N a step
        turns = forces[1:] * forces[:-1] < 0
        assert not (turns[1:] & turns[:-1]).any()  # never to and fro
        ends[dt] = twists[-1]
    assert ends[0.001] == pytest.approx(CRUISE, abs=0.03)
    assert ends[0.004] == pytest.approx(ends[0.001], abs=1e-3)
    assert ends[0.002] == pytest.approx(ends[0.001], abs=1e-3)


VELOCITY = st.floats(-3, 3)
LAYOUTS = st.sampled_from([KIWI, FOUR, MECANUM])


def energy(rig):
    """Kinetic energy of robot 0 and its wheels, J."""
    vx, vy, omega = rig.body[0, 3:]
    wheels = rig.drive.spin_inertia[0] @ rig.truth.wheel_speed[0] ** 2
    moving = rig.drive.mass[0] * (vx * vx + vy * vy)
    return 0.5 * (moving + rig.drive.inertia[0] * omega**2 + wheels)


@given(
    LAYOUTS,
    st.tuples(VELOCITY, VELOCITY, st.floats(-20, 20)),
    st.lists(st.floats(-60, 60), min_size=4, max_size=4),
    st.sampled_from([0.001, 0.002, 0.004]),
    st.sampled_from(["brake", "coast"]),
)
@settings(max_examples=40)
def test_with_the_motors_off_energy_never_rises(layout, thrown, speeds, dt, at_zero):
    model = robot(mass_height=0.15, drive={**layout, "motor": {"at_zero": at_zero}})
    rig = Rig(player(model), dt=dt)
    rig.throw(0, *thrown)
    count = len(layout["azimuth_deg"])
    rig.truth.wheel_speed[0] = speeds[:count]
    before = energy(rig)
    for _ in range(150):
        rig.tick()
        after = energy(rig)
        assert after <= before * (1 + 1e-12) + 1e-15
        before = after


@pytest.mark.parametrize("dt", [0.001, 0.004])
def test_a_free_body_keeps_its_velocity_while_it_spins(dt):
    rig = Rig(kiwi(), dt=dt)
    rig.lift()
    rig.throw(0, 1.0, -0.5, 7.0)
    rig.run(2.0)
    assert rig.body[0, 3:] == pytest.approx([1.0, -0.5, 7.0], abs=1e-10)
    assert rig.body[0, :3] == pytest.approx([2.0, -1.0, 14.0], abs=1e-8)


def test_a_knocked_robot_is_held_by_no_more_than_its_grip():
    """Wheels that stand still and are hit sideways brake with mu m g at most, from the first tick.

    A friction computed for the slip before the blow would stop the robot at once.
    """
    rig = Rig(four_wheels(drive={"grip": {"static": 0.5, "kinetic": 0.5}}))
    rig.run(0.5)
    rig.throw(0, 1.0, 0.0)
    rig.tick()
    assert abs(rig.truth.wrench[0, 0]) <= 1.05 * 0.5 * 20 * G
    assert rig.body[0, 3] > 0.98


def test_a_wheel_that_breaks_away_pushes_with_no_more_than_its_grip():
    """Full voltage from rest: the push never passes what the floor can hold, in any tick."""
    grip = {"static": 0.5, "kinetic": 0.425, "roller": 0.0}
    rig = Rig(four_wheels(drive={"grip": grip, "motor": {"stall_torque": 14.0}}))
    rig.pwm[0] = [-255, -255, 255, 255]
    limit = 0.5 * 20 * G * cos(pi / 4)
    for _ in range(200):
        rig.tick()
        assert rig.truth.wrench[0, 0] < 1.1 * limit


def dead_wheeled(**dead):
    """A coasting kiwi with three dead wheels as Utama's."""
    wheels = {
        "azimuth_deg": [180, 300, 60],
        "direction_deg": [90, 210, -30],
        "distance": 0.08,
        "radius": 0.025,
        **dead,
    }
    drive = {**KIWI, "motor": {"at_zero": "coast"}, "grip": {"roller": 0.0}}
    return robot({"drive": drive, "dead": wheels})


def test_dead_wheels_turn_with_the_floor():
    """Their rim covers what rolls under it, however the driven wheels slip."""
    rig = Rig(player(dead_wheeled()))
    rig.pwm[0, :3] = [255, -200, 30]
    floor = np.zeros(3)
    for _ in range(400):
        vx, vy, omega = rig.body[0, 3:]
        c, s = cos(rig.body[0, 2]), sin(rig.body[0, 2])
        floor += rig.drive.forward[0, 3:] @ (c * vx + s * vy, c * vy - s * vx, omega) * rig.dt
        rig.tick()
    rolled = rig.truth.wheel_angle[0, 3:] * rig.drive.radius[0, 3:]
    assert np.abs(floor).max() > 0.3
    assert rolled == pytest.approx(floor, abs=2e-3)
    driven = rig.truth.wheel_angle[0, :3] * 0.05
    assert np.abs(driven).max() > 1.5 * np.abs(floor).max()


def test_dead_wheels_barely_hold_a_robot_back():
    """Their bearings take a newton or so: torque over radius, and rollers."""
    speeds = []
    for model in (
        dead_wheeled(),
        robot(drive={**KIWI, "motor": {"at_zero": "coast"}, "grip": {"roller": 0.0}}),
    ):
        rig = Rig(player(model))
        rig.throw(0, 1.0, 0.0)
        rig.roll((1.0, 0.0, 0.0))
        rig.run(1.0)
        speeds.append(rig.body[0, 3])
    assert 0 < speeds[1] - speeds[0] < 0.05


def test_driven_wheels_carry_what_the_dead_ones_do_not():
    rig = Rig(player(dead_wheeled(load=5.0))).tick()
    assert rig.truth.load[0, 3:] == pytest.approx(5.0)
    assert rig.truth.load[0].sum() == pytest.approx(20 * G)
