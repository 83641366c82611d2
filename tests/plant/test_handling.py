"""A robot kicks the ball in its mouth, and feels it there; how it dribbles: test_dribbling.py."""

from math import cos, degrees, hypot, pi, radians, sin

import numpy as np
import pytest
from factory import player, robot
from handling_rig import BALL, REACH, TOUCH, Bench, alone, handler, off
from hypothesis import given, settings
from hypothesis import strategies as st

PLACES = [  # angle from straight ahead, gap; whether that is in the mouth
    (0, 0.001, True),
    (0, REACH - 0.001, True),
    (0, REACH + 0.001, False),
    (24.5, 0.01, True),
    (-24.5, 0.01, True),
    (25.5, 0.01, False),
    (-25.5, 0.01, False),
    (180, 0.001, False),
]


@pytest.mark.parametrize(("angle", "gap", "inside"), PLACES)
@pytest.mark.parametrize("heading", [0, 100])
def test_a_robot_feels_the_ball_in_its_mouth_and_kicks_it_nowhere_else(angle, gap, inside, heading):
    bench = alone(heading=heading)
    bench.place(*off(angle, TOUCH + gap))
    bench.command.kick[0] = 5.0
    bench.tick()
    assert bench.machine.readings.contact[0] == inside
    assert bench.handling.kicks[0] == inside
    assert bench.command.kick[0] == (0.0 if inside else 5.0)
    assert hypot(*bench.body[1, 3:5]) == pytest.approx(5.0 * inside, abs=1e-9)


def test_mouths_differ_from_robot_to_robot():
    wide = alone(handler(mouth={"half_angle_deg": 60, "reach": 0.2}))
    wide.place(*off(55, TOUCH + 0.19))
    assert wide.tick().machine.readings.contact[0] == 1


def test_where_there_is_no_ball_nobody_feels_one():
    bench = Bench(player(handler()))
    bench.command.kick[:], bench.command.dribble[:] = 5.0, 1
    bench.tick(20)
    assert (bench.machine.readings.contact[0], bench.handling.kicks[0]) == (0, 0)


@pytest.mark.parametrize("heading", [0, 37, 180, -90])
@pytest.mark.parametrize("speed", [0.5, 8.0, 12.0])
def test_a_kicked_ball_leaves_at_the_set_speed_along_the_heading(heading, speed):
    bench = alone(heading=heading)
    bench.command.kick[0] = speed
    bench.tick()
    direction = np.array([cos(radians(heading)), sin(radians(heading))])
    assert bench.body[1, 3:5] == pytest.approx(speed * direction, abs=1e-9)
    assert bench.body[0, 3:5] == pytest.approx(-BALL / 20 * speed * direction, abs=1e-9)
    assert bench.handling.kicked[0] == 0


def test_no_kick_is_faster_than_the_kicker():
    bench = alone(handler(kicker={"speed": 7.0}))
    bench.command.kick[0] = 99.0
    assert bench.tick().body[1, 3] == pytest.approx(7.0)


@pytest.mark.parametrize("wrong", [0.0, -5.0, float("nan")])
def test_a_speed_that_is_none_kicks_nothing(wrong):
    bench = alone()
    bench.command.kick[0] = wrong
    bench.tick(5)
    assert (bench.handling.kicks[0], bench.body[1, 3]) == (0, 0.0)


def test_a_robot_without_a_kicker_does_not_kick():
    bench = alone(robot())
    bench.command.kick[0] = 8.0
    bench.tick(5)
    assert (bench.handling.kicks[0], bench.body[1, 3]) == (0, 0.0)
    assert bench.machine.readings.contact[0] == 1  # but it feels


@given(
    heading=st.floats(-180, 180),
    twist=st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(-6, 6)),
    ball=st.tuples(st.floats(-3, 3), st.floats(-3, 3)),
    angle=st.floats(-24, 24),
    speed=st.floats(3, 12),
)
@settings(max_examples=60, deadline=None)
def test_a_kick_keeps_the_momentum_of_ball_and_robot(heading, twist, ball, angle, speed):
    """Also the angular one, with ball and robot on the move and the kick off the centre."""
    scattered = handler(kicker={"speed_sd": 0.1, "angle_sd_deg": 5.0})
    bench = alone(scattered, heading=heading)
    bench.place(*off(angle, TOUCH + 0.03), *ball)
    bench.throw(0, *twist)
    before = bench.motion()
    bench.command.kick[0] = speed
    bench.tick()
    if bench.handling.kicks[0] == 1 and bench.gap[0] > 0.002:  # else the shell rubs too
        assert bench.motion() == pytest.approx(before, abs=1e-9)


def test_a_kick_adds_to_how_the_robot_carries_the_ball():
    """v + w x d along the kick, seen from there the set speed; across it the ball goes on."""
    bench = alone(heading=90)
    bench.place(*off(15, TOUCH + 0.01), 0.3, 0.2)
    bench.throw(0, 1.0, -0.5, 2.0)
    bench.command.kick[0] = 6.0
    before, heading = bench.body.copy(), pi / 2 + 2.0 * bench.dt
    bench.tick()
    d = bench.body[1, :2] - bench.body[0, :2]
    carried = before[0, 3:5] + 2.0 * np.array([-d[1], d[0]])
    along, across = np.array([cos(heading), sin(heading)]), np.array([-sin(heading), cos(heading)])
    assert (bench.body[1, 3:5] - carried) @ along == pytest.approx(6.0, abs=1e-9)
    assert bench.body[1, 3:5] @ across == pytest.approx(before[1, 3:5] @ across, abs=1e-9)


def test_a_kicker_cannot_pull_a_faster_ball_back():
    bench = alone()
    bench.place(TOUCH + 0.01, 0.0, 9.0, 0.0)
    bench.command.kick[0] = 3.0
    assert bench.tick().body[1, 3] == pytest.approx(9.0)
    assert bench.handling.kicks[0] == 1


def test_a_kicked_ball_slides_then_rolls_at_three_fifths():
    bench = alone(field={"ball_rolling": 0.0})
    bench.command.kick[0] = 6.0
    bench.run(0.8)
    assert bench.body[1, 3] == pytest.approx(0.6 * 6.0, rel=0.01)


def test_a_kick_waits_for_the_ball():
    bench = alone()
    bench.place(1.0, 0.0, -2.0, 0.0)
    bench.command.kick[0] = 5.0
    bench.run(0.2)
    assert bench.handling.kicks[0] == 0
    bench.run(0.2)
    assert bench.handling.kicked[0] * bench.dt == pytest.approx((1.0 - TOUCH - REACH) / 2, abs=0.01)
    assert bench.body[1, 3] == pytest.approx(5.0)


@pytest.mark.parametrize("hz", [200, 500, 1000])
def test_a_kick_waits_for_the_charge(hz):
    bench = alone(handler(kicker={"recharge": 0.4}), hz=hz)
    ticks = []
    for _ in range(hz):
        bench.place(TOUCH + 0.01)
        bench.command.kick[0] = 5.0
        bench.tick()
        if bench.command.kick[0] == 0.0:
            ticks.append(bench.sim.tick - 1)
    assert ticks == [0, round(0.4 * hz), round(0.8 * hz)]
    assert bench.handling.kicks[0] == 3


def test_kicks_scatter_as_told():
    bench = alone(handler(kicker={"speed_sd": 0.05, "angle_sd_deg": 2.0}))
    kicks = []
    for _ in range(400):
        bench.sim.place_robot(0, 0.0, 0.0, 0.0)
        bench.place(TOUCH + 0.01)
        bench.command.kick[0], bench.handling.charged[0] = 8.0, 0
        bench.tick()
        kicks.append(bench.body[1, 3:5].copy())
    speeds = np.hypot(*np.transpose(kicks))
    angles = [degrees(np.arctan2(vy, vx)) for vx, vy in kicks]
    assert np.mean(speeds) == pytest.approx(8.0, abs=4 * 0.4 / 20)
    assert np.std(speeds) == pytest.approx(0.4, rel=0.15)
    assert np.mean(angles) == pytest.approx(0.0, abs=4 * 2 / 20)
    assert np.std(angles) == pytest.approx(2.0, rel=0.15)
    assert abs(np.corrcoef(speeds, angles)[0, 1]) < 0.2


def test_a_kick_into_a_robot_that_stands_close_moves_that_one():
    """The ball goes no way through, and what it loses the other robot has."""
    bench = Bench(
        player(handler(), start=(0, 0, 0)),
        player(robot(elasticity=0.0), start=(0.8, 0, 180)),
        ball={"at": (TOUCH + 0.01, 0)},
        field={"ball_friction": 0.0, "ball_rolling": 0.0},
    )
    bench.command.kick[0] = 12.0
    before = bench.motion()
    bench.run(0.1)
    assert bench.body[1, 3] == pytest.approx(12 * BALL / (20 + BALL), rel=0.05)
    assert bench.body[0, 0] < bench.body[2, 0] < bench.body[1, 0]
    assert bench.motion() == pytest.approx(before, abs=1e-9)
