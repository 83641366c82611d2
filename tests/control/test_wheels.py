"""From a twist to wheel speeds, and from wheel speeds to PWM."""

from math import pi

import numpy as np
import pytest
from factory import BUNDLED, NO_SLIP, bundled, player, robot, scenario, simulate
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.control.plan import build_plan, new_progress
from soccersim.control.position import build_position_loop
from soccersim.control.wheels import build_wheel_loop, pwm_for, turn_wheels
from soccersim.simulation import Simulation
from soccersim.spec.motor import PWM_MAX, table_speeds
from soccersim.state import new_command, new_readings

twists = st.tuples(st.floats(-6, 6), st.floats(-6, 6), st.floats(-20, 20))
TABLE_ALONE = {"wheel_loop": "table"}


class Wheels:
    """The wheel loop of one robot; what its encoders read is the test's."""

    def __init__(self, model):
        start, self.wheels = np.zeros((1, 3)), len(model.drive.azimuth_deg)
        self.loop = build_wheel_loop([model], self.wheels)
        self.position = build_position_loop([model], start)
        self.plan, self.progress = build_plan(scenario(player(model)), 3), new_progress(start)
        self.command, self.read = new_command(1, self.wheels), new_readings(1, self.wheels)

    def step(self, twist, speeds=0.0):
        """PWM of the wheels for this twist, while they turn with these speeds."""
        self.command.twist[0] = twist
        self.read.wheel_speed[0] = speeds
        turn_wheels(
            self.loop,
            self.position,
            self.plan,
            self.progress,
            self.read,
            self.command,
            0,
            1 / 500,
        )
        return self.command.pwm[0].copy()

    @property
    def speeds(self):
        return self.command.wheel_speed[0]


def spun(model, speeds, seconds=3.0, **more):
    """The true wheel speeds after a while of wanting these."""
    phase = {"seconds": seconds, "wheel_speeds": speeds}
    run = simulate(player(model, open_loop=[phase]), **more)
    return run.arrays["wheel_speed"][-1, 0, : len(speeds)]


@given(st.sampled_from(BUNDLED), st.floats(-80, 80))
def test_the_table_read_backwards_gives_the_speed_asked_for(name, speed):
    model = bundled(name)
    wheels = len(model.drive.azimuth_deg)
    loop, table = build_wheel_loop([model], wheels), table_speeds(model.drive.motor, wheels)
    for wheel in range(wheels):
        level = pwm_for(loop.table, 0, wheel, speed)
        top = table[wheel, -1]
        told = np.interp(abs(level), np.arange(PWM_MAX + 1), table[wheel])
        assert told == pytest.approx(min(abs(speed), top), abs=1e-9)
        assert level * speed >= 0
        assert pwm_for(loop.table, 0, wheel, -speed) == -level


def test_idris_table_read_backwards():
    loop = build_wheel_loop([bundled("idris")], 3)
    for rpm, level in ((0, 0), (20.2, 10), (110.4, 50), (530.3, 255), (600, 255)):
        assert pwm_for(loop.table, 0, 0, rpm * 2 * pi / 60) == pytest.approx(level)
    assert pwm_for(loop.table, 0, 0, 60.3 * 2 * pi / 60) == pytest.approx(25)  # 20: 50.2, 30: 70.4


@given(st.sampled_from(BUNDLED), twists)
@settings(max_examples=50)
def test_too_fast_a_twist_keeps_its_direction(name, twist):
    """All wheels are slowed by the same share: vx to vy to omega stay as they were."""
    model = bundled(name)
    wheels = Wheels(model)
    wheels.step(twist)
    asked, top = model.drive.base.wheel_speeds(twist), wheels.loop.table[0, :, -1]
    excess = max(1.0, (abs(asked) / top).max())
    assert wheels.speeds == pytest.approx(asked / excess, abs=1e-12)
    assert (abs(wheels.speeds) <= top * (1 + 1e-12)).all()
    assert wheels.position.saturated[0] == (excess > 1.0)


def test_pwm_is_whole_and_within_255():
    wheels = Wheels(robot())
    for twist in ((0, 0, 0), (0.3, 0.1, 1), (100, 0, 0), (0, 0, -1e6)):
        pwm = wheels.step(twist)
        assert pwm.dtype == np.int64
        assert (abs(pwm) <= PWM_MAX).all()
    assert abs(pwm).max() == PWM_MAX


def test_a_twist_that_is_no_number_idles_the_wheels():
    for twist in ((np.nan, 0, 0), (0, 0, np.nan), (np.inf, 0, 0)):
        assert (Wheels(robot()).step(twist) == 0).all()


def test_without_encoders_the_table_alone_speaks():
    wheels = Wheels(robot(control=TABLE_ALONE))
    first = wheels.step((0.5, 0.2, 1.0), speeds=0.0)
    for _ in range(100):
        assert (wheels.step((0.5, 0.2, 1.0), speeds=55.0) == first).all()


@pytest.mark.parametrize("speeds", [(20, 20, 20), (-10, -10, -10), (12, -12, 0)])
def test_the_wheel_loop_holds_the_speed_under_load(speeds):
    """Brakes that drag, which the robot does not know of; the table alone gives in."""
    slow = {"drive": {"motor": {"friction_torque": 0.8}}}
    by_loop = spun(robot(slow), speeds)
    by_table = spun(robot(slow, control=TABLE_ALONE), speeds)
    asked = np.array(speeds, float)
    assert by_loop == pytest.approx(asked, abs=0.02 * 20)
    assert (abs(by_table) < 0.85 * abs(asked) + 1e-9).all()


def test_motors_of_different_strength_turn_alike():
    unlike = robot(drive={"build": {"motor_sd": 0.1}})
    assert spun(unlike, (20, 20, 20)) == pytest.approx(np.full(3, 20.0), rel=0.01)
    lone = spun(robot(unlike.model_dump(exclude_unset=True), control=TABLE_ALONE), (20, 20, 20))
    assert np.ptp(lone) > 0.2


def test_a_wheel_held_fast_stops_summing_at_full_pwm():
    """Held for ten seconds at full PWM, a wheel lets go as soon as it is to."""
    model = robot(control={"wheel": {"kp": 2.0, "ki": 20.0}})
    wheels = Wheels(model)
    twist = (0, 0, 8.0)  # 30.4 rad/s of each wheel
    for _ in range(1000):
        pwm = wheels.step(twist, speeds=0.0)
    assert (pwm == PWM_MAX).all()
    assert (wheels.loop.sums[0] < PWM_MAX).all()
    assert (wheels.step(twist, speeds=60.0) < PWM_MAX).all()
    assert (wheels.step((0, 0, -8.0), speeds=0.0) < 0).all()


def test_the_sum_shrinks_even_at_full_pwm():
    wheels = Wheels(robot(control={"wheel": {"kp": 0.0, "ki": 20.0}}))
    wheels.loop.sums[0] = 1000.0
    wheels.step((0, 0, 1.0), speeds=20.0)
    assert (wheels.loop.sums[0] < 1000.0).all()


def test_a_spinning_wheel_does_not_ring():
    """On ice the wheel has nothing but its own inertia: the quickest plant its loop meets."""
    for name in BUNDLED:
        model = bundled(name)
        if model.control.wheel_loop == "table":
            continue
        wheels = len(model.drive.azimuth_deg)
        phase = {"seconds": 2.0, "wheel_speeds": (20.0,) * wheels}
        ice = {"field": {"grip": 1e-3}}
        run = simulate(player(model, open_loop=[phase]), **ice)
        speed = run.arrays["wheel_speed"][75:, 0, :wheels]
        encoder = model.drive.encoder
        quantum = 2 * pi / encoder.edges_per_turn / encoder.window
        assert abs(speed - 20).max() < 0.5 + 2 * quantum, name


def test_levels_held_open_loop_reach_the_motors_as_they_stand():
    run = simulate(player(robot(), open_loop=[{"seconds": 0.5, "pwm": (200, -30, 0)}]))
    driven = run.time < 0.5
    assert (run.arrays["pwm"][driven, 0] == (200, -30, 0)).all()


def test_speeds_held_open_loop_are_the_wheels_speeds():
    model = robot(drive={"grip": NO_SLIP})
    assert spun(model, (10, 5, -15)) == pytest.approx(np.array((10, 5, -15.0)), abs=0.1)


def test_a_robot_told_nothing_resists_a_blow():
    """Its wheel loop wants speed 0: PWM comes back where something turns a wheel."""
    coasting = {"drive": {"motor": {"at_zero": "coast"}}}
    turned = []
    for wheel in ({"kp": 8.0, "ki": 15.0}, {"kp": 0.0}):
        model = robot(coasting, control={"wheel": wheel})
        simulation = Simulation(scenario(player(model), duration=1.0))
        next(iter(simulation.world.space.bodies)).angular_velocity = 2.0
        simulation.machine.truth.body[0, 5] = 2.0
        turned.append(simulation.run().body[-1, 0, 2])
    assert abs(turned[0]) < 0.2 * abs(turned[1])
