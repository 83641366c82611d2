"""Bodies that meet: Chipmunk behind our kernels, many robots, the same run every time."""

import os
import subprocess
import sys
from itertools import combinations
from math import hypot

import numpy as np
import pytest
from factory import bundled, player, robot, scenario
from hypothesis import given, settings
from hypothesis import strategies as st
from pymunk import batch
from rig import FOUR, KIWI, MECANUM, Rig

from soccersim.plant.build import wheel_count
from soccersim.plant.world import World, step_bodies
from soccersim.simulation import Simulation
from soccersim.state import new_truth

BOARD = (16.0, 11.0)  # m, |x| and |y| of the factory's field with its border
SIX = {
    "drive": KIWI,
    "dead": {"azimuth_deg": [0, 120, 240], "distance": 0.08, "radius": 0.025},
}
MODELS = [robot({"drive": KIWI}), robot({"drive": FOUR}), robot(SIX), robot({"drive": MECANUM})]


def crowd(count, spacing=0.7, columns=6):
    """Robots of all models, close together round the centre."""
    return [
        player(
            MODELS[i % len(MODELS)],
            start=(spacing * (i % columns - 2), spacing * (i // columns - 1), 37.0 * i),
        )
        for i in range(count)
    ]


class PlainWorld:
    """The same space moved by pymunk's own Space.step and batch calls."""

    fields = (
        batch.BodyFields.POSITION
        | batch.BodyFields.ANGLE
        | batch.BodyFields.VELOCITY
        | batch.BodyFields.ANGULAR_VELOCITY
    )

    def __init__(self, written, bodies):
        self.world = World(written, new_truth(bodies, len(written.robots), 1))
        self.wrenches = np.zeros((bodies + 1, 3))  # the static body comes last
        self.write, self.read = batch.Buffer(), batch.Buffer()
        self.write.set_float_buf(self.wrenches)

    def tick(self, wrench, dt):
        """The bodies after a tick under (B, 3) forces and torques."""
        self.wrenches[:-1] = wrench
        wrenches = batch.BodyFields.FORCE | batch.BodyFields.TORQUE
        batch.set_space_bodies(self.world.space, wrenches, self.write)
        self.world.space.step(dt)
        self.read.clear()
        batch.get_space_bodies(self.world.space, self.fields, self.read)
        return np.frombuffer(self.read.float_buf()).reshape(-1, 6)[: len(wrench)]


def test_a_kernels_tick_is_pymunks_own():
    """Bit by bit, over contacts between robots, ball, posts and boards."""
    players = [
        player(robot(), start=(14.2, 0.7, 0)),
        player(robot(), start=(14.3, -0.3, 90)),
        player(robot(), start=(13.6, 0.1, 45)),
    ]
    written = scenario(*players, ball={"at": (14.6, 0.2), "velocity": (3, -1)})
    rig = Rig(*players, ball={"at": (14.6, 0.2), "velocity": (3, -1)})
    plain = PlainWorld(written, 4)
    rng = np.random.default_rng(7)
    for k in range(1500):
        if k % 50 == 0:
            rig.pwm[:] = rng.integers(-255, 256, rig.pwm.shape)
        rig.tick()
        np.testing.assert_array_equal(plain.tick(rig.truth.wrench, rig.dt), rig.body)
    assert np.abs(rig.body[:, :2]).max() < 16


def test_no_tick_is_done_with_a_force_that_is_no_number():
    for wrong in (np.nan, np.inf, -np.inf, 1e12):
        rig = Rig(player(robot()), ball={"at": (1, 1)})
        rig.truth.wrench[1, 1] = wrong
        before = rig.body.copy()
        assert not step_bodies(rig.world.chipmunk, rig.truth, rig.dt)
        np.testing.assert_array_equal(rig.body, before)


@pytest.mark.parametrize("elasticity", [0.0, 0.4, 1.0])
@pytest.mark.parametrize("aside", [0.0, 0.2])
def test_robots_that_meet_keep_their_momentum(elasticity, aside):
    """Two masses, head on and aside, with the wheels off the floor; energy never grows."""
    light = player(robot(mass=10.0, elasticity=elasticity), start=(-1, aside, 20))
    heavy = player(robot(mass=30.0, elasticity=elasticity), start=(1, 0, -50))
    rig = Rig(light, heavy)
    rig.lift()
    rig.throw(0, 3.0, 0.0, 2.0)
    rig.throw(1, -1.0, 0.5, -1.0)
    mass, inertia = rig.drive.mass, rig.drive.inertia

    def motion():
        x, y, _, vx, vy, omega = rig.body.T
        spin = inertia @ omega + mass @ (x * vy - y * vx)
        return np.array([mass @ vx, mass @ vy, spin])

    def energy():
        vx, vy, omega = rig.body.T[3:]
        return 0.5 * (mass @ (vx**2 + vy**2) + inertia @ omega**2)

    before, lively = motion(), energy()
    rig.run(1.0)
    assert np.abs(rig.body[:, 3:5] - [[3, 0], [-1, 0.5]]).max() > 1.0  # they met
    assert motion()[:2] == pytest.approx(before[:2], abs=1e-10)
    assert motion()[2] == pytest.approx(before[2], abs=0.05)  # friction acts an overlap apart
    assert energy() <= lively * (1 + 1e-9)


def test_shells_rub_with_their_friction():
    """A robot thrown along the board while pressed to it loses mu N / m of its speed."""
    rig = Rig(player(robot(elasticity=0.0), start=(0, 10.75, 0)))
    rig.lift()
    rig.throw(0, 2.0, 0.0)
    rig.truth.push[0, 1] = 50.0
    rig.run(0.2)
    assert 2 - rig.body[0, 3] == pytest.approx(0.3 * 50 / 20 * 0.2, rel=0.05)


@pytest.mark.parametrize("dt", [0.001, 0.002, 0.004])
def test_a_robot_that_the_board_stops_is_soon_set_beside_it(dt):
    """A tick's way deep at most, and nothing left of that after a third of a second."""
    rig = Rig(player(robot(elasticity=0.0), start=(0, 10.0, 0)), dt=dt)
    rig.lift()
    rig.throw(0, 0.0, 3.0)
    rig.run(0.3)
    assert abs(rig.body[0, 4]) < 1e-6
    assert 10.75 - 1e-3 < rig.body[0, 1] < 10.75 + 3 * dt
    rig.run(0.33)
    assert rig.body[0, 1] == pytest.approx(10.75, abs=1e-3)


def test_two_robots_that_push_each_other_stand():
    """Head on, alike and with equal voltage: nobody wins."""
    rig = Rig(player(robot(), start=(-0.3, 0, 0)), player(robot(), start=(0.3, 0, 180)))
    rig.pwm[:] = [[-60, -60, 120]] * 2
    rig.run(0.5)
    assert np.abs(rig.body[:, 3:5]).max() < 0.1
    apart = rig.body[1, :2] - rig.body[0, :2]
    assert hypot(*apart) > 0.5 - 3e-3
    assert rig.body[:, 0].sum() == pytest.approx(0, abs=0.01)


def test_twenty_two_robots_of_all_models_share_a_field():
    rig = Rig(*crowd(22), ball={"at": (-2.2, -2.0)})
    rng = np.random.default_rng(3)
    driven = [len(MODELS[i % len(MODELS)].drive.azimuth_deg) for i in range(22)]
    assert [wheel_count(model) for model in MODELS] == [3, 4, 6, 4]
    for _ in range(20):
        for row, count in enumerate(driven):
            rig.pwm[row, :count] = rng.integers(-255, 256, count)
        rig.run(0.2)
    truth = rig.truth
    assert all(np.isfinite(array).all() for array in truth)
    moved = np.array([hypot(*row) for row in rig.body[:22, 3:5]])
    assert (moved > 0).all()
    for row in range(22):
        total = wheel_count(MODELS[row % len(MODELS)])
        assert (truth.wheel_speed[row, :total] != 0).all()
        assert (truth.wheel_speed[row, total:] == 0).all()
        assert truth.load[row, :total].sum() == pytest.approx(20 * 9.81)
    for first, second in combinations(range(22), 2):
        assert hypot(*(rig.body[first, :2] - rig.body[second, :2])) > 0.5 - 0.03


def test_a_robot_drives_as_it_does_alone():
    """Other robots on the field, with other wheels, change nothing as long as none is touched."""
    alone = Rig(player(MODELS[2], start=(5, 5, 30)))
    among = Rig(*crowd(9), player(MODELS[2], start=(5, 5, 30)), player(start=(-9, 9, 0)))
    alone.pwm[0, :3] = among.pwm[9, :3] = [200, -120, 40]
    alone.run(1.0)
    among.run(1.0)
    np.testing.assert_array_equal(alone.body[0], among.body[9])
    np.testing.assert_array_equal(alone.truth.wheel_angle[0], among.truth.wheel_angle[9, :6])


SPEED = st.floats(-12, 12)


@given(st.data())
@settings(max_examples=100)
def test_whatever_happens_everybody_stays_on_the_floor(data):
    """Random robots, levels that jump, a ball at any speed, any tick: no nan, nobody outside."""
    count = data.draw(st.integers(1, 6))
    rng = np.random.default_rng(data.draw(st.integers(0, 2**32 - 1)))
    places = [(-15 + 6 * i, data.draw(st.sampled_from([-10.5, 0.0, 10.5]))) for i in range(count)]
    players = [
        player(
            data.draw(st.sampled_from(MODELS)),
            start=(x, y, data.draw(st.floats(-360, 360))),
        )
        for x, y in places
    ]
    velocity = data.draw(SPEED), data.draw(SPEED)
    dt = data.draw(st.sampled_from([0.001, 0.002, 0.004]))
    rig = Rig(*players, dt=dt, ball={"at": (-12.0, 2.0), "velocity": velocity})
    for row in range(count):
        rig.throw(row, *rng.uniform(-4, 4, 2), rng.uniform(-10, 10))
    for _ in range(4):
        rig.pwm[:] = rng.integers(-255, 256, rig.pwm.shape)
        rig.pwm[rng.random(rig.pwm.shape) < 0.3] = 0
        rig.tick(60)
        assert all(np.isfinite(array).all() for array in rig.truth)
        radius = np.array([0.25] * count + [0.11])
        outside = np.abs(rig.body[:, :2]) + radius[:, None] - BOARD
        assert outside.max() < 16 * dt + 5e-3


# --- the same run every time


def busy(seconds=1.2):
    """Three kinds of robot that drive at a ball and each other, with all their noise."""
    real = {"perfect": False, "pulses_per_turn": 270}
    models = [
        robot(
            {"drive": layout, "gyro": {"perfect": False}},
            drive={"encoder": real, "build": {"radius_sd": 0.004, "motor_sd": 0.02}},
        )
        for layout in (KIWI, FOUR)
    ]
    places = [(-0.6, 0.05, 0), (0.6, 0, 170), (0.1, 0.9, -90), (0, -0.9, 80)]
    players = [
        player(model, (0.1, 0, 90), start=start)
        for model, start in zip([*models, bundled("utama"), bundled("msl")], places, strict=True)
    ]
    return scenario(
        *players, ball={"at": (0.0, 0.1), "velocity": (0.5, 0.0)}, seed=5, duration=seconds
    )


def digest(written):
    return Simulation(written).run().meta["digest"]


def test_the_same_seed_gives_the_same_run_to_the_last_bit():
    first, second = Simulation(busy()), Simulation(busy())
    second.advance(17)  # cut into other pieces
    one, two = first.run(), second.run()
    for key in one.arrays:
        np.testing.assert_array_equal(one.arrays[key], two.arrays[key])
    assert one.meta["digest"] == two.meta["digest"]
    assert digest(busy().model_copy(update={"seed": 6})) != one.meta["digest"]
    assert np.abs(one.body[:, -1, 3:5]).max() > 0.6  # somebody met the ball


CHILD = """
import sys
from soccersim.simulation import Simulation
from soccersim.spec.scenario import Scenario
print(Simulation(Scenario.model_validate_json(sys.stdin.read())).run().meta["digest"])
"""


def digests_elsewhere(written, *environments):
    """The digests that other processes find, at the same time."""
    children = [
        subprocess.Popen(
            [sys.executable, "-c", CHILD],
            env={**os.environ, **environment},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for environment in environments
    ]
    text = written.model_dump_json()
    return [child.communicate(text)[0].strip() for child in children]


def test_other_processes_give_the_same_run():
    salts = [{"PYTHONHASHSEED": salt} for salt in ("0", "1", "random")]
    assert digests_elsewhere(busy(), *salts) == [digest(busy())] * 3


def test_plain_python_gives_the_same_run_as_compiled():
    short = busy(0.4)
    recording = Simulation(short).run()
    moved = recording.body[-1] - recording.body[0]
    assert np.abs(moved[:, 3:]).max() > 0.5
    plain = digests_elsewhere(short, {"NUMBA_DISABLE_JIT": "1"})
    assert plain == [recording.meta["digest"]]
