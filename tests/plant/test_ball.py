"""The ball: it slides, then rolls; it bounces off boards, posts and robots, and nets hold it."""

from math import hypot

import numpy as np
import pytest
from factory import player, robot
from hypothesis import given, settings
from hypothesis import strategies as st
from rig import Rig, kiwi

RADIUS, POST = 0.11, 0.0625  # m
TICKS = [0.001, 0.002, 0.004]
FRICTIONLESS = {"ball_friction": 0.0, "ball_rolling": 0.0}
LINE, BOARD, GOAL, DEPTH = 15.0, 16.0, 2.0, 0.5  # m, of the factory's field, goal 2 m wide
AWAY = (0.0, 9.0, 0.0)  # where the robot that every scenario has is in nobody's way


def pitch(at, velocity, *players, dt=0.002, **more):
    """A ball on its way, and a robot at AWAY if no others are wanted."""
    players = players or (player(robot(), start=AWAY),)
    return Rig(*players, dt=dt, ball={"at": at, "velocity": velocity}, **more)


def path(rig, seconds):
    """Where the ball is and how fast, tick by tick: (T, 4)."""
    rows = []
    for _ in range(round(seconds / rig.dt)):
        rig.tick()
        rows.append(rig.body[-1, [0, 1, 3, 4]].copy())
    return np.array(rows)


@pytest.mark.parametrize("dt", TICKS)
def test_a_kicked_ball_slides_then_rolls_at_three_fifths(dt):
    """t = k v / (mu g (1 + k)) and so on, k = 2/3: .612 s, 2.936 m, 3.600 m/s from 6 m/s."""
    rig = pitch((0, 0), (6, 0), dt=dt, field={"ball_rolling": 0.0})
    time = 0.0
    while hypot(*(rig.body[1, 3:5] - rig.truth.ball_roll)) > 1e-9:
        rig.tick()
        time += dt
    assert time == pytest.approx(0.612, rel=0.02)
    assert rig.body[1, 0] == pytest.approx(2.936, rel=0.02)
    assert rig.body[1, 3] == pytest.approx(3.600, rel=0.02)
    assert rig.body[1, 1] == rig.body[1, 4] == 0


def test_a_rolling_ball_slows_down_and_rests():
    rig = pitch((-14, 5), (6, 0))
    moving = path(rig, 15.0)
    speed = moving[:, 2]
    rolling = (speed < 3.55) & (speed > 0.05)
    assert np.diff(speed[rolling]) / rig.dt == pytest.approx(-0.35, abs=1e-6)
    assert (np.diff(speed) <= 1e-12).all()
    assert speed[-1] == 0.0
    assert moving[-1, 0] + 14 == pytest.approx(2.936 + 3.6**2 / (2 * 0.35), rel=0.01)
    np.testing.assert_array_equal(path(rig, 1.0)[-1], moving[-1])


@given(st.floats(-10, 10), st.floats(-10, 10), st.floats(-10, 10), st.floats(-10, 10))
def test_sliding_takes_the_same_from_speed_and_spin(vx, vy, wx, wy):
    """The floor acts at the contact: v + k w stays what it was until the ball rolls."""
    rig = pitch((0, 0), (vx, vy), field={"ball_rolling": 0.0})
    rig.truth.ball_roll[:] = wx, wy
    kept = np.array([vx, vy]) + (2 / 3) * np.array([wx, wy])
    before = 0.5 * (vx**2 + vy**2 + (2 / 3) * (wx**2 + wy**2))
    for _ in range(50):
        rig.tick()
        v, w = rig.body[1, 3:5], rig.truth.ball_roll
        if hypot(*v) > 0.02:
            assert v + (2 / 3) * w == pytest.approx(kept, abs=1e-9)
        energy = 0.5 * (v @ v + (2 / 3) * w @ w)
        assert energy <= before * (1 + 1e-12)
        before = energy


@pytest.mark.parametrize("dt", TICKS)
@pytest.mark.parametrize("start", [15.1, 15.27, 15.333, 15.45])
def test_the_board_gives_back_its_share_of_the_speed(start, dt):
    """12 m/s come back as 7.2; a tick's way deep at most, and out two ticks later."""
    rig = pitch((start, 5.0), (12, 0), dt=dt, field=FRICTIONLESS)
    moving = path(rig, 0.2)
    deep = moving[:, 0] + RADIUS - BOARD
    bounce = int(np.argmax(moving[:, 2] < 0))
    assert moving[-1, 2] == pytest.approx(-7.2, rel=0.01)
    assert (moving[:bounce, 2] == 12).all()
    assert deep.max() <= 12 * dt + 1e-9
    assert (deep[bounce + 2 :] <= 0).all()


@pytest.mark.parametrize("velocity", [(30, 0), (5, 29), (-20, 20)])
def test_no_speed_takes_the_ball_through_the_board(velocity):
    """The fastest kick at the slowest tick that scenarios allow."""
    rig = pitch((3, 4), velocity, dt=0.01)
    moving = path(rig, 2.0)
    assert (np.abs(moving[:, :2]) < (BOARD + 0.3, BOARD - 5 + 0.3)).all()
    assert np.abs(moving[-1, 0]) < BOARD - 0.1
    assert np.abs(moving[:, 2:]).min() < 15


@pytest.mark.parametrize("dt", TICKS)
def test_the_board_leaves_a_ball_its_speed_along_it(dt):
    rig = pitch((10.0, 10.5), (5, 3), dt=dt, field=FRICTIONLESS)
    moving = path(rig, 0.5)
    assert moving[-1, 2:] == pytest.approx([5, -1.8], rel=0.01)


@pytest.mark.parametrize("dt", TICKS)
def test_a_ball_that_comes_to_rest_at_the_board_lies_beside_it(dt):
    rig = pitch((15.7, 5.0), (0.4, 0.0), dt=dt)
    moving = path(rig, 4.0)
    assert moving[-1, 2] == 0
    assert moving[-1, 0] + RADIUS - BOARD < 2e-3


@pytest.mark.parametrize("dt", TICKS)
def test_a_robot_that_pins_the_ball_to_the_board_does_not_bury_it(dt):
    rig = pitch((0.02, 10.8), (0, 0), player(robot(), start=(0, 10.4, 90)), dt=dt)
    rig.pwm[0] = [80, 0, -80]  # ahead, to the board
    for _ in range(round(2.0 / dt)):
        rig.tick()
        ball, pusher = rig.body[1, :2], rig.body[0, :2]
        assert ball[1] + RADIUS - 11.0 < 0.02
        assert hypot(*(ball - pusher)) > 0.25 + RADIUS - 0.02


@given(
    st.floats(0.0, 2 * np.pi),
    st.floats(8, 12),
    st.floats(-0.3, 0.3),
    st.sampled_from(TICKS),
    st.booleans(),
)
@settings(max_examples=40)
def test_the_ball_never_passes_through_a_robot(angle, speed, aside, dt, charges):
    """Not at 12 m/s, nor against a robot that drives at it: a tick's way deep at most."""
    c, s = np.cos(angle), np.sin(angle)
    at = (-1.2 * c + aside * s, -1.2 * s - aside * c)
    model = player(robot(), start=(0, 0, float(np.degrees(angle) + 180)))
    rig = pitch(at, (speed * c, speed * s), model, dt=dt, field=FRICTIONLESS)
    if charges:
        rig.throw(0, -2 * c, -2 * s)
    before = rig.body[1, :2] - rig.body[0, :2]
    for _ in range(round(0.4 / dt)):
        rig.tick()
        apart = rig.body[1, :2] - rig.body[0, :2]
        assert hypot(*apart) > 0.25 + RADIUS - (speed + 2) * dt - 1e-3
        assert apart @ before > 0 or hypot(*apart) > 0.25  # not on the other side at once
        before = apart


def test_a_robot_takes_its_share_of_a_head_on_bounce():
    rig = pitch((-1, 0), (5, 0), player(robot(elasticity=0.4)), field=FRICTIONLESS)
    rig.lift()
    rig.run(0.5)
    ball, hit = rig.body[1, 3], rig.body[0, 3]
    assert hit - ball == pytest.approx(0.4 * 5, rel=1e-3)
    assert 0.43 * ball + 20 * hit == pytest.approx(0.43 * 5, rel=1e-9)


@pytest.mark.parametrize("end", [1, -1])
@pytest.mark.parametrize("velocity", [(12, 0), (9, 1.5), (9, -2), (6, 0.8)])
@pytest.mark.parametrize("dt", TICKS)
def test_a_goal_keeps_the_ball(velocity, end, dt):
    """Whatever it hits inside, it stays behind the line, before the net, and comes to rest."""
    rig = pitch((end * 11.0, 0.1 * end), [end * v for v in velocity], dt=dt)
    moving = path(rig, 6.0)
    x, y = end * moving[:, 0], moving[:, 1]
    inside = np.argmax(x > LINE + RADIUS)
    assert inside > 0
    assert (x[inside:] > LINE).all()
    assert x.max() < LINE + DEPTH - 0.02 - RADIUS + 12 * dt
    assert np.abs(y[inside:]).max() < GOAL / 2 + POST
    assert np.abs(moving[-1, 2:]).max() < 1e-9


@pytest.mark.parametrize("end", [1, -1])
@pytest.mark.parametrize("aside", [0.04, -0.04, 0.0])
def test_a_post_deflects_the_ball(end, aside):
    """Off the inside into the goal, off the outside past it; straight on it comes back."""
    post = GOAL / 2 + POST
    rig = pitch((end * 14, end * (post + aside)), (end * 8, 0), field=FRICTIONLESS)
    moving = path(rig, 0.15)
    vx, vy = end * moving[-1, 2:]
    assert vy == pytest.approx(0, abs=0.1) if aside == 0 else vy * np.sign(aside) > 1.0
    assert hypot(vx, vy) < 8
    nearest = np.hypot(moving[:, 0] - end * LINE, moving[:, 1] - end * post)
    assert nearest.min() > RADIUS + POST - 8 * rig.dt
    if aside == 0:
        assert vx == pytest.approx(-0.6 * 8, rel=0.01)


def test_a_ball_that_bounces_slides_until_its_spin_has_turned():
    """Its turning goes on into the board: backspin, which takes speed and gives back less."""
    rig = pitch((15.0, 5.0), (3, 0), field={"ball_rolling": 0.0})
    rig.truth.ball_roll[:] = 3, 0  # it rolls
    moving = path(rig, 3.0)
    assert moving[:, 2].min() == pytest.approx(-1.8, rel=0.01)
    settled = (-1.8 + (2 / 3) * 3) / (1 + 2 / 3)  # v + k w over 1 + k
    assert moving[-1, 2] == pytest.approx(settled, abs=0.02)


def test_a_kiwi_pushes_the_ball_along():
    rig = pitch((0.4, 0.0), (0, 0), kiwi())
    rig.pwm[0] = [-90, -90, 180]
    rig.run(1.0)
    assert rig.body[1, 0] > rig.body[0, 0] > 0.3
    assert hypot(*(rig.body[1, :2] - rig.body[0, :2])) > 0.25 + RADIUS - 2e-3
    assert rig.body[1, 3] > 0.8
