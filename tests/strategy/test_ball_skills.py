"""Getting the ball, carrying, passing, shooting and stopping it: in a toy world."""

from dataclasses import replace
from math import cos, hypot, inf, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from toy import Robot, Toy

from soccersim.strategy import Ball, Command, Opponent, Pitch, Player, View, skills
from soccersim.strategy.motion import wrap
from soccersim.strategy.rolling import field_has, kick_time, reaching
from soccersim.strategy.taking import off_the_line

field = Pitch()
near = st.floats(-4, 4)
angle = st.floats(-pi, pi)


def has_it(toy, mind, seconds=8.0, decisions=10):
    """Play until the first robot has held the ball for some decisions; the time it took."""
    held = 0
    while toy.time < seconds:
        toy.step([mind(toy.now(), toy.now().robots[0])])
        held = held + 1 if toy.in_mouth(toy.robots[0]) else 0
        if held == decisions:
            return toy.time - decisions * 0.04
    return inf


@settings(max_examples=30, derandomize=True)
@given(near, near, angle, near, near)
def test_a_ball_that_lies_is_taken(x, y, heading, ball_x, ball_y):
    if hypot(x - ball_x, y - ball_y) > 0.4:
        toy = Toy([Robot(x, y, heading)], ball=(ball_x, ball_y))
        assert has_it(toy, skills.intercept) < 2.2 + hypot(x - ball_x, y - ball_y) / 1.2


@settings(max_examples=30, derandomize=True)
@given(near, near, angle, angle, st.floats(0.6, 2.0))
def test_a_rolling_ball_is_met_and_held(x, y, heading, way, speed):
    ball = -2.0 * cos(way), -2.0 * sin(way), speed * cos(way), speed * sin(way)
    if hypot(x - ball[0], y - ball[1]) > 0.5:
        assert has_it(Toy([Robot(x, y, heading)], ball=ball), skills.intercept) < 7


@pytest.mark.parametrize("speed", [1.5, 2.5, 3.5])
def test_a_ball_that_comes_is_waited_for_not_run_away_from(speed):
    toy = Toy([Robot(3, 0.2, pi)], ball=(0, 0, speed, 0))
    robot = toy.robots[0]
    has_it(toy, skills.intercept, 4, 2)
    assert toy.in_mouth(robot)
    assert robot.x < 3.3


def test_a_ball_that_rolls_away_is_run_down():
    toy = Toy([Robot(0, 0)], ball=(0.8, 0.2, 2.2, 0.3))
    assert has_it(toy, skills.intercept) < 3.2


def test_a_robot_beside_the_ball_goes_round_behind_it_at_once():
    toy = Toy([Robot(0.38, 0, 2.0)], ball=(0, 0))
    assert has_it(toy, lambda v, p: skills.intercept(v, p, (8, 0)), decisions=1) < 2.8


def test_a_ball_that_lies_is_taken_from_behind_as_seen_towards_the_aim():
    for heading in (0.0, 2.0, -2.0):
        toy = Toy([Robot(2, 1, heading)], ball=(0, 0))
        assert has_it(toy, lambda v, p: skills.intercept(v, p, (8, 3)), decisions=1) < 6
        assert toy.robots[0].heading == pytest.approx(0.36, abs=0.2)
        assert hypot(toy.ball[0], toy.ball[1]) < 0.1  # it was not pushed about on the way


def test_a_ball_on_the_touch_line_is_not_pushed_over_it():
    for y in (6.9, -6.9):
        toy = Toy([Robot(1, 0.5 * y)], ball=(0, y))
        assert has_it(toy, skills.intercept) < 8
        assert abs(toy.ball[1]) < 7.11


def test_near_a_line_no_push_goes_outwards():
    for x, y in ((0, 6.9), (0, -6.9), (-10.9, 0), (10.9, 3)):
        ball = Ball(x, y)
        dx, dy = off_the_line(field, ball, x, y)
        assert dx * x + dy * y < 0
        assert hypot(dx, dy) == pytest.approx(1)
    assert off_the_line(field, Ball(10.9, 0), 1, 0) == (1, 0)  # that is the goal
    walls = replace(field, rules=replace(field.rules, lines=False))
    assert off_the_line(walls, Ball(0, 6.9), 0, 1) == (0, 1)


def test_with_the_ball_it_is_held():
    toy = Toy([Robot(0, 0)], ball=(0.36, 0))
    toy.play(2, lambda v: skills.intercept(v, v.robots[0]))
    assert toy.in_mouth(toy.robots[0])
    assert hypot(toy.robots[0].x, toy.robots[0].y) < 0.3


@settings(max_examples=25, derandomize=True)
@given(angle, st.floats(-3, 3), st.floats(-3, 3))
def test_the_ball_is_carried_to_a_place_and_never_lost(heading, x, y):
    toy = Toy([Robot(0, 0, heading)], ball=(0.35 * cos(heading), 0.35 * sin(heading)))
    robot = toy.robots[0]
    fastest = 0.0
    for _ in range(120):
        toy.play(0.04, lambda v: skills.dribble(v, v.robots[0], x, y))
        assert toy.in_mouth(robot)
        fastest = max(fastest, hypot(robot.vx, robot.vy))
    assert hypot(robot.x - x, robot.y - y) < 0.1
    assert fastest < 2.3


def kicked(toy, mind, seconds=8.0):
    """Play until the ball is kicked; its velocity then."""
    idle = [Command()] * (len(toy.robots) - 1)
    while toy.time < seconds and not toy.kicks:
        view = toy.now()
        toy.step([mind(view, view.robots[0]), *idle])
    return toy.kicks[0][1:]


@settings(max_examples=25, derandomize=True)
@given(st.floats(1, 8), st.floats(-4, 4), angle, angle)
def test_a_shot_goes_into_the_goal(x, y, heading, behind):
    toy = Toy([Robot(x - 1.5 * cos(behind), y - 1.5 * sin(behind), heading)], ball=(x, y))
    vx, vy = kicked(toy, skills.shoot)
    assert vx > 0
    assert abs(toy.ball[1] + vy / vx * (11 - toy.ball[0])) < 1.2 - 0.11


def test_a_robot_faces_the_goal_before_it_kicks():
    toy = Toy([Robot(6, 2, pi)], ball=(5.65, 2))
    while not toy.kicks and toy.time < 5:
        view = toy.now()
        command = skills.shoot(view, view.robots[0])
        if command.kick:
            aim, _ = skills.free_goal(view, view.robots[0].x, view.robots[0].y)
            want = skills.towards(view.robots[0], 11, aim)
            assert abs(wrap(view.robots[0].heading - want)) < 0.16
        toy.step([command])
    assert toy.kicks
    assert toy.kicks[0][0] > 0.8  # s, for half a turn with the ball


def test_a_shot_leaves_where_it_is_sent_though_the_robot_runs_across():
    robot = Robot(6, -2, 0.3)
    robot.vy = robot.asked[1] = 1.5
    toy = Toy([robot], ball=(6.34, -1.9, 0, 1.5))
    vx, vy = kicked(toy, skills.shoot)
    assert abs(toy.ball[1] + vy / vx * (11 - toy.ball[0])) < 1.1


def test_a_robot_that_drifts_kicks_when_it_looks_beside_the_place():
    drift = 0.8  # m/s to its left, so the ball goes to the left of where it looks
    looks = {turned: Player(2, 5, 0, turned, vy=drift, has_ball=True) for turned in (0.0, -0.1)}
    view = View(robots=tuple(looks.values()), ball=Ball(5.35, 0))
    kicks = {turned: skills.kick_at(view, p, 11, 0, 8.0, 0.04).kick for turned, p in looks.items()}
    assert kicks[0.0] == 0
    assert kicks[-0.1] > 7


def test_a_shot_goes_past_the_keeper():
    keeper = Opponent(10.5, 0.5)
    toy = Toy([Robot(6, 0)], ball=(6.35, 0), opponents=[keeper])
    vx, vy = kicked(toy, skills.shoot)
    at_keeper = toy.ball[1] + vy / vx * (keeper.x - toy.ball[0])
    assert abs(at_keeper - keeper.y) > 0.35
    assert abs(toy.ball[1] + vy / vx * (11 - toy.ball[0])) < 1.1


@settings(max_examples=20, derandomize=True)
@given(st.floats(1.5, 6), angle, angle)
def test_a_pass_comes_to_the_mate_at_a_speed_it_can_hold(far, way, heading):
    mate = Robot(far * cos(way), far * sin(way))
    toy = Toy([Robot(0, 0, heading), mate], ball=(0.36 * cos(heading), 0.36 * sin(heading)))
    kicked(toy, lambda v, p: skills.pass_to(v, p, v.robots[1]))
    least, speed = 9.0, 0.0
    for _ in range(150):
        toy.step([Command(), Command()])
        off = hypot(toy.ball[0] - mate.x, toy.ball[1] - mate.y)
        if off < least:
            least, speed = off, hypot(toy.ball[2], toy.ball[3])
    assert least < 0.55  # of 0.35 at which it touches
    assert speed < 2.6


def test_a_pass_is_received():
    toy = Toy([Robot(0, 0, 0.5), Robot(5, 1, pi)], ball=(0.31, 0.17))
    taken = False
    while toy.time < 7 and not taken:
        one, two = (view := toy.now()).robots
        first = Command() if toy.kicks else skills.pass_to(view, one, two)
        second = skills.intercept(view, two) if toy.kicks else Command()
        toy.step([first, second])
        taken = toy.in_mouth(toy.robots[1])
    assert taken


@settings(derandomize=True)
@given(st.floats(0.5, 15), st.floats(0, 4))
def test_kick_speed_and_time_agree_with_the_balls_physics(far, arrive):
    speed = skills.kick_speed(field, far, arrive)
    toy = Toy([Robot(-5, 5)], ball=(0, 0, speed, 0))
    toy.spin = [0, 0]
    while toy.ball[0] < far - 1e-9 and toy.tick < 10_000 and toy.ball[2] > 0:
        before = toy.ball[2]
        toy.tick += 1
        toy.roll([0, 0])
    assert before == pytest.approx(arrive, abs=0.1 + 0.6 / max(far, 1))
    if arrive > 0.5:
        assert kick_time(field, far, speed) == pytest.approx(toy.time, abs=0.05)


def test_a_ball_that_stops_short_never_comes():
    assert kick_time(field, 30, 5) == inf
    assert kick_time(replace(field, ball_sliding=0.0), 4, 2) == pytest.approx(2.6, abs=0.1)


@settings(derandomize=True)
@given(near, near, angle, st.floats(0.1, 2.5))
def test_a_meeting_is_in_time_and_no_earlier_one_was(x, y, way, speed):
    ball = Ball(-1, 1, speed * cos(way), speed * sin(way))
    player = Player(1, x, y)
    needed = reaching(player, player.body.radius + field.ball_radius)
    mx, my, seconds = skills.meeting(field, ball, player)
    assert field_has(field, mx, my)
    if field_has(field, *skills.ball_at(field, ball, seconds)):
        assert needed(mx, my) <= seconds + 0.3
    for step in range(int((seconds - 0.15) / 0.05)):
        there = skills.ball_at(field, ball, 0.05 * step)
        assert needed(*there) > 0.05 * step - 0.15


def test_a_ball_that_runs_out_is_met_on_the_line_at_the_latest():
    x, y, _ = skills.meeting(field, Ball(0, 5, 0, 6), Player(1, 0, -6))
    assert (x, y) == (0, pytest.approx(7))
    walls = replace(field, rules=replace(field.rules, lines=False))
    assert skills.meeting(walls, Ball(0, 5, 0, 6), Player(1, 0, -6))[1] > 7


def test_the_quickest_is_not_always_the_nearest():
    ball = Ball(0, 0, 2.0, 0)
    behind, ahead = Player(1, -1, 0.5), Player(2, 2.5, 0)
    view = View(robots=(behind, ahead), ball=ball)
    assert skills.nearest(view.robots, 0, 0) is behind
    assert skills.quickest(view, view.robots) is ahead
    holder = replace(behind, has_ball=True)
    assert skills.quickest(view, (ahead, holder)) is holder
    assert skills.quickest(view, (replace(ahead, in_play=False),)) is None
