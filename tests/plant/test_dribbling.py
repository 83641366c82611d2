"""A dribbler holds the ball as long as that takes no more than its force, and no longer."""

from math import hypot, sqrt

import numpy as np
import pytest
from factory import bundled, changed, player, robot
from handling_rig import (
    BALL,
    GRAVITY,
    MU,
    REACH,
    SHELL,
    SMOOTH,
    TOUCH,
    Bench,
    alone,
    handler,
    off,
)
from hypothesis import given, settings
from hypothesis import strategies as st

FORCE, STIFFNESS = 5.0, 150.0  # N, N/m of the default dribbler
FREE = FORCE / BALL  # m/s2 that the force gives to the ball where the floor does not hold it
SLIDES = MU * GRAVITY / SHELL  # m/s2 above which a ball that is pulled slides
DRAG = MU * GRAVITY  # m/s2 that the floor then takes
HEAVY = {"mass": 1000.0}  # kg: what the ball does to it does not count
FLOORS = {0.0: SMOOTH, MU: {"ball_rolling": 0.0}}


def dribbling(model=None, **more):
    """A heavy robot that holds the ball, wheels off the floor, near a corner of the field."""
    model = model or handler(HEAVY)
    bench = Bench(player(model, start=(13, -9, 0)), ball={"at": (13 + TOUCH + 1e-4, -9)}, **more)
    bench.command.dribble[0] = 1
    return bench.tick(5)


def loses_at(bench, push, steps):
    """The first of these strengths of a push at which the ball is lost, one a tick."""
    for strength in steps:
        bench.truth.push[0] = np.array(push) * strength
        if bench.tick().handling.held[0] == 0:
            return strength
    return np.inf


# --- held, and lost


@pytest.mark.parametrize("hz", [200, 500, 1000])
@pytest.mark.parametrize("floor", FLOORS)
@pytest.mark.parametrize("direction", [(-1, 0), (0, 1), (-0.6, 0.8)])
def test_braking_loses_the_ball_at_the_force_over_its_mass_less_the_floor(direction, floor, hz):
    """F = m a, and m (a + mu g) for a ball that slides on the floor: 11.6 and 7.7 m/s2."""
    bench = dribbling(field=FLOORS[floor], hz=hz)
    assert bench.handling.held[0] == 1
    rising = np.arange(0.0, 15.0, 5.0 / hz)  # m/s2, by 5 a second
    lost = loses_at(bench, (1000 * direction[0], 1000 * direction[1], 0), rising)
    assert lost == pytest.approx(FREE - floor * GRAVITY, rel=0.01)
    # while the push rises so fast, the damper bears a twentieth of it
    assert bench.stretch == pytest.approx(0.95 * FORCE / STIFFNESS, rel=0.02)


@pytest.mark.parametrize("hz", [200, 500, 1000])
@pytest.mark.parametrize("floor", FLOORS)
def test_turning_loses_the_ball_at_that_centripetal_force(floor, hz):
    """(w2 d)2 + 4 (mu g)2 = (F / m)2 where it slides, its spin lagging behind: 4.7 rad/s.

    Its spin z, of constant length, turns with the robot: w z = mu g / k, across z, along the slip.
    So the floor's pull, mu m g, has mu g / (k a) of it outward and the rest against the ball.
    """
    bench = dribbling(field=FLOORS[floor], hz=hz)
    inertia = bench.machine.drive.inertia[0]
    first = 5.0 if floor == 0.0 else 4.2  # rad/s, soon; from there on slowly
    loses_at(bench, (0, 0, inertia), np.full(round(first / 0.5 * hz), 0.5))
    assert bench.handling.held[0] == 1
    loses_at(bench, (0, 0, inertia), np.full(10 * hz, 0.1))
    assert bench.handling.held[0] == 0
    far = TOUCH + FORCE / STIFFNESS
    a = sqrt(FREE * FREE - (0 if floor == 0.0 else 4 * DRAG * DRAG))
    assert bench.body[0, 5] == pytest.approx(sqrt(a / far), rel=0.01)


def test_rolling_weighs_more_than_sliding_on_ice():
    """A ball that rolls along needs m (1 + k) a, as its turning has to be sped up too."""
    bench = dribbling(field=FLOORS[MU])
    bench.truth.push[0, 0] = -4000.0
    bench.run(1.0)
    assert STIFFNESS * bench.stretch == pytest.approx(BALL * (1 + SHELL) * 4.0, rel=0.01)
    assert SLIDES > 4.0


@pytest.mark.parametrize("heading", [0, 90, 200])
def test_spinning_up_pulls_the_ball_along_sideways(heading):
    """m dw/dt d, also at a long tick, while the robot is pushed and the ball not."""
    bench = Bench(
        player(handler(HEAVY), start=(0, 0, heading)),
        ball={"at": (-3, 3)},
        field=SMOOTH,
        hz=200,
    )
    bench.place(TOUCH)
    bench.command.dribble[0] = 1
    bench.truth.push[0, 2] = 10.0 * bench.machine.drive.inertia[0]
    bench.run(0.25)
    soon = bench.body[:, :3] + bench.dt * bench.body[:, 3:]
    c, s = np.cos(soon[0, 2]), np.sin(soon[0, 2])
    x, y = soon[1, :2] - soon[0, :2]
    aside, far = c * y - s * x, hypot(x, y)
    assert -STIFFNESS * aside == pytest.approx(BALL * 10.0 * far, rel=0.1)


@pytest.mark.parametrize(("share", "held"), [(0.85, 1), (0.91, 0)])
def test_a_start_with_a_jolt_loses_it_sooner(share, held):
    """A critically damped spring passes on 1 + e^-2 of an acceleration that jumps: 0.88."""
    bench = dribbling(field=SMOOTH)
    steps = np.full(400, share * FREE)
    assert (loses_at(bench, (-1000, 0, 0), steps) == np.inf) == held


@pytest.mark.parametrize("to", [(3, 0, 0), (-3, 0, 0), (0, 3, 0), (0, 0, 170), (3, 3, 170)])
def test_the_msl_robot_dribbles_ahead_back_sideways_and_round(to):
    """2.4 m/s or 4 rad/s with motors, wheels that creep and control, and to a stop."""
    limits = {"turn_rate": 4.0, "turn_acceleration": 6.0}
    model = changed(bundled("msl"), control={"limits": limits})
    goal = (to[0] - 6, to[1] - 6, to[2])
    bench = Bench(
        player(model, goal, start=(-6, -6, 0)), ball={"at": (-6 + 0.3501, -6)}, lifted=False
    )
    bench.command.dribble[0] = 1
    bench.tick(5)
    fastest = np.zeros(3)
    while not bench.sim.done:
        bench.tick(5)
        assert bench.handling.held[0] == 1, bench.sim.tick
        fastest = np.maximum(fastest, np.abs(bench.body[0, 3:]))
    assert (fastest > np.abs(to) * (0.6, 0.6, 0.02) - 1e-9).all()
    assert bench.machine.readings.contact[0] == 1


@pytest.mark.parametrize(("rate", "held"), [(4.0, True), (6.0, False)])
def test_the_msl_robot_at_its_fastest_turn_loses_the_ball(rate, held):
    limits = {"turn_rate": rate, "turn_acceleration": 2 * rate - 2}
    model = changed(bundled("msl"), control={"limits": limits})
    bench = Bench(player(model, (0, 0, 170)), ball={"at": (0.3501, 0)}, lifted=False)
    bench.command.dribble[0] = 1
    bench.tick(5)
    ticks = [int(bench.tick().handling.held[0]) for _ in range(500)]
    assert all(ticks) == held


def test_a_lost_ball_is_let_go_for_the_pause():
    bench = dribbling(handler(HEAVY, dribbler={"pause": 0.3}), field=SMOOTH)
    loses_at(bench, (-1000, 0, 0), np.arange(0, 15, 0.01))
    bench.truth.push[:] = 0.0
    lost, velocity = bench.sim.tick, bench.body[1, 3:5].copy()
    bench.throw(0, *velocity)  # robot and ball go on side by side
    while bench.handling.held[0] == 0 and bench.sim.tick < lost + 1000:
        assert bench.body[1, 3:5] == pytest.approx(velocity, abs=0.05)
        bench.tick()
    assert (bench.sim.tick - lost) * bench.dt == pytest.approx(0.3, abs=0.02)


def test_a_kicked_ball_is_not_held_back():
    bench = alone()
    bench.command.dribble[0] = 1
    bench.run(0.1)
    assert bench.handling.held[0] == 1
    bench.command.kick[0] = 0.4
    bench.run(0.1)
    assert bench.handling.held[0] == 0
    assert bench.body[1, 3] == pytest.approx(0.4, abs=1e-3)


def test_nobody_holds_who_does_not_want_to_or_cannot():
    idle, bare = alone(ahead=TOUCH + 0.02), alone(robot(), ahead=TOUCH + 0.02)
    bare.command.dribble[0] = 1
    for bench in (idle, bare):
        bench.throw(0, -0.5, 0.0)
        bench.run(0.5)
        assert bench.handling.held[0] == 0
        assert (bench.body[1, 3:5] == 0).all()


# --- caught


@pytest.mark.parametrize("angle", [-20, 0, 20])
def test_a_ball_at_rest_in_the_mouth_is_drawn_to_its_middle(angle):
    bench = alone(field={})
    bench.place(*off(angle, TOUCH + 0.03))
    bench.command.dribble[0] = 1
    bench.run(1.5)
    assert bench.handling.held[0] == 1
    assert bench.stretch < 5e-3


@pytest.mark.parametrize(("share", "hits"), [(0.95, False), (1.2, True)])
def test_a_slow_ball_is_caught_before_it_hits_the_robot(share, hits):
    """The force stops m v2 / 2 within the reach: v = sqrt(2 F reach / m) = 1.08 m/s."""
    bench = alone(handler(HEAVY))
    bench.command.dribble[0] = 1
    bench.place(0.6, 0.0, -share * sqrt(2 * FORCE * REACH / BALL), 0.0)
    fastest = 0.0  # m/s, where it touches
    for _ in range(500):
        vx = bench.body[1, 3]
        if bench.tick().gap[0] < 1e-3:
            fastest = max(fastest, -vx)
    assert bench.handling.held[0] == 1
    assert (fastest > 0.4) == hits


@pytest.mark.parametrize("speed", [4.0, 8.0])
def test_a_ball_that_rolls_past_is_slowed_down_but_not_caught(speed):
    bench = alone(field={})
    bench.command.dribble[0] = 1
    bench.place(TOUCH + 0.02, -0.5, 0.0, speed)
    bench.truth.ball_roll[1] = speed
    bench.run(0.5)
    assert bench.handling.held[0] == 0
    assert bench.body[1, 1] > 0.3
    assert bench.body[1, 4] < speed - 0.2


# --- nothing from nothing


@given(
    st.tuples(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3), st.floats(-4, 4)),
    st.tuples(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3)),
    st.floats(-20, 20),
)
@settings(max_examples=60, deadline=None)
def test_dribbling_keeps_momentum_and_makes_no_energy(twist, ball, angle):
    """Of motion and spring together, robot and ball on ice, whether it holds or catches."""
    bench = alone(ahead=TOUCH + 0.02)
    bench.command.dribble[0] = 1
    bench.place(*off(angle, TOUCH + 0.03), *ball)
    bench.throw(0, *twist)
    before, lively = bench.motion(), np.inf
    for _ in range(100):
        bench.tick()
        let_go = bench.sim.tick < bench.handling.rested[0]
        if let_go or bench.handling.inside[0] == 0 or bench.gap[0] < 1e-3:
            return
        x = bench.stretch_soon
        most = FORCE / STIFFNESS
        stored = 0.5 * STIFFNESS * x * x if x < most else FORCE * (x - most / 2)
        assert bench.energy() + stored <= lively + 1e-5
        lively = bench.energy() + stored
        assert bench.motion() == pytest.approx(before, abs=1e-9)


@pytest.mark.parametrize("others", [0, 1])
@pytest.mark.parametrize("damping", [None, 0.0])
def test_no_spring_is_too_stiff_for_a_tick(others, damping):
    """A feather on springs that swing many times a tick, of one robot or two: it comes to rest."""
    stiff = handler(dribbler={"stiffness": 1e4, "force": 100.0, "damping": damping})
    far = TOUCH + 0.005
    bench = Bench(
        player(stiff, start=(0, 0, 0)),
        *[player(stiff, start=(2 * far, 0, 180))] * others,
        ball={"at": (far, 0.02), "mass": 0.02},
        field=SMOOTH,
        hz=200,
    )
    bench.command.dribble[:] = 1
    bench.run(0.1)
    assert bench.handling.held.all()
    assert abs(bench.body[-1, 1]) < 1e-3
    bench.run(0.1)
    assert hypot(*bench.body[-1, 3:5]) < 1e-2


@pytest.mark.parametrize("hz", [200, 500, 1000])
@pytest.mark.parametrize("aside", [0.0, 0.01, 0.04])
@pytest.mark.parametrize("pwm", [60, 250])
def test_a_ball_between_two_dribblers_stays_physical(pwm, aside, hz):
    plan = [{"seconds": 3, "pwm": [-pwm // 2, -pwm // 2, pwm]}]
    far = TOUCH + 0.02
    bench = Bench(
        player(handler(), start=(-far, 0, 0), open_loop=plan),
        player(handler(), start=(far, aside, 180), open_loop=plan),
        ball={"at": (0, 0)},
        hz=hz,
        lifted=False,
    )
    bench.command.dribble[:] = 1
    for _ in range(round(2.5 * hz)):
        bench.tick()
        assert np.isfinite(bench.body).all()
        assert bench.gap.min() > -0.002 * 500 / hz - 0.001  # m
        assert hypot(*bench.body[2, 3:5]) < 3.5
        assert bench.energy() < 2 * 250
