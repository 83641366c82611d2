"""Where robots stand: between ball and goal, and where the rules want them at restarts."""

from dataclasses import replace
from math import hypot, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from toy import Robot, Toy

from soccersim.strategy import Ball, Command, Phase, Player, View, skills

PLAYED = {
    "mind": lambda v: skills.block(v, v.robots[0], 0.6),
}


@given(st.floats(-8, 5), st.floats(-6, 6), st.floats(0.4, 3))
@settings(max_examples=20, derandomize=True)
def test_a_keeper_stands_between_ball_and_goal(x, y, out):
    toy = Toy([Robot(-10, 0, 0, "keeper")], ball=(x, y))
    toy.play(4, lambda v: skills.block(v, v.robots[0], out))
    keeper = toy.robots[0]
    to_goal, to_keeper = (x + 11, y), (keeper.x + 11, keeper.y)
    cross = to_goal[0] * to_keeper[1] - to_goal[1] * to_keeper[0]
    assert abs(cross) / hypot(*to_goal) < 0.1  # on the line from the goal's middle to the ball
    assert keeper.x > -11 + 0.2
    assert hypot(*to_keeper) <= out + 0.3
    assert keeper.heading == pytest.approx(
        skills.towards(Player(1, keeper.x, keeper.y), x, y), abs=0.1
    )


def test_a_keeper_waits_in_the_middle_while_nobody_knows_where_the_ball_is():
    toy = Toy([Robot(-9, 3)]).play(4, lambda v: skills.block(v, v.robots[0], 0.5))
    assert (toy.robots[0].x, toy.robots[0].y) == pytest.approx((-10.5, 0), abs=0.03)


def test_a_defender_may_stand_against_a_place_instead_of_the_ball():
    toy = Toy([Robot(-6, 0)], ball=(3, 3))
    toy.play(5, lambda v: skills.block(v, v.robots[0], 4.0, threat=(-5, -6)))
    assert (toy.robots[0].x, toy.robots[0].y) == pytest.approx((-8.17, -2.83), abs=0.05)


def shot_at(toy, y, speed):
    """Whether a shot from (-3, 2) at a height of the goal goes in."""
    dx, dy = -11 - -3.0, y - 2.0
    far = hypot(dx, dy)
    toy.ball, toy.spin = [-3.0, 2.0, speed * dx / far, speed * dy / far], [0.0, 0.0]
    end = toy.time + 6
    while toy.time < end:
        toy.play(0.04, PLAYED["mind"])
        if toy.ball[0] < -11.11:
            return abs(toy.ball[1]) < 1.2
        if toy.ball[2] > 0:
            return False
    return False


@pytest.mark.parametrize("y", [-1.0, -0.5, 0.0, 0.5, 1.0])
def test_a_keeper_stops_shots_that_nobody_could_call_hard(y):
    toy = Toy([Robot(-10.4, 0, 0, "keeper")], ball=(-3, 2)).play(2, PLAYED["mind"])
    assert not shot_at(toy, y, 5.0)


def test_a_ball_that_passes_the_goal_or_stops_before_it_is_left_alone():
    player = Player(1, -10.4, 0)
    for ball in (Ball(-5, 0, -3, 2), Ball(-5, 0, -1, 0), Ball(-5, 0, 3, 0), Ball(-11.2, 0, -3, 0)):
        assert skills.stop_shot(View(robots=(player,), ball=ball), player) is None
    view = View(robots=(player,), ball=Ball(-5, 0, -3, 0))
    assert skills.stop_shot(view, player) is not None


def test_a_keeper_that_would_come_too_late_does_not_brake():
    late = Player(1, -10.5, 0, pi / 2), Ball(-6, 0.9, -9, 0)
    early = late[0], Ball(-6, 0.9, -2.5, 0)
    speed = {}
    for name, (player, ball) in (("late", late), ("early", early)):
        command = skills.stop_shot(View(robots=(player,), ball=ball), player)
        speed[name] = hypot(command.vx, command.vy)
    assert speed["late"] > speed["early"] + 0.3


def restart(phase, ours, robots, ball, seconds, mind, **more):
    toy = Toy(robots, ball=ball, phase=phase, ours=ours, started=False, **more)
    return toy.play(seconds, lambda v: mind(v, v.robots[0]))


DISTANCES = [
    (Phase.FREE_KICK, False, 3.0),
    (Phase.THROW_IN, True, 2.0),
    (Phase.DROPPED_BALL, None, 1.0),
]


@pytest.mark.parametrize(("phase", "ours", "asked"), DISTANCES)
@settings(max_examples=15, derandomize=True)
@given(x=st.floats(-10, 10), y=st.floats(-6, 6), to=st.tuples(st.floats(-9, 9), st.floats(-6, 6)))
def test_robots_keep_the_distance_that_the_rules_ask(phase, ours, asked, x, y, to):
    robot = Robot(2.0, 1.0)
    toy = restart(phase, ours, [robot], (x, y), 7, lambda v, p: skills.keep_distance(v, p, *to))
    off = hypot(robot.x - x, robot.y - y)
    assert off > asked
    assert abs(robot.x) < 11.3
    assert abs(robot.y) < 7.3
    if hypot(to[0] - x, to[1] - y) > asked + 1.0 and toy.time > 6:
        assert hypot(robot.x - to[0], robot.y - to[1]) < 1.5


def test_a_robot_that_stands_at_the_ball_walks_straight_away_from_it():
    toy = restart(
        Phase.FREE_KICK,
        False,
        [Robot(0.5, 0)],
        (0, 0),
        0.8,
        lambda v, p: skills.keep_distance(v, p, -9, 0),
    )
    assert toy.robots[0].x > 0.9


def test_nobody_but_the_taker_crosses_the_middle_before_a_kick_off():
    toy = restart(
        Phase.KICK_OFF,
        True,
        [Robot(-4, 2)],
        (0, 0),
        6,
        lambda v, p: skills.keep_distance(v, p, 5, 4),
    )
    assert toy.robots[0].x < -0.24
    assert toy.robots[0].y == pytest.approx(4, abs=0.3)


def test_at_a_penalty_only_the_keeper_stays_in_the_area():
    ball = 7.4, 0
    toy = restart(
        Phase.PENALTY,
        True,
        [Robot(5, 0)],
        ball,
        6,
        lambda v, p: skills.keep_distance(v, p, 10, 0),
    )
    assert toy.robots[0].x < 11 - 2.25 - 0.24
    keeper = restart(
        Phase.PENALTY,
        False,
        [Robot(-9, 0, 0, "keeper")],
        (-7.4, 0),
        6,
        lambda v, p: skills.keep_distance(v, p, -10.7, 0),
    ).robots[0]
    assert keeper.x == pytest.approx(-10.7, abs=0.1)


@pytest.mark.parametrize("start", [(-3, 0), (3, 1), (0.5, 2), (-0.4, 0.1), (2, -0.1)])
def test_the_taker_waits_behind_the_ball_and_does_not_touch_it(start):
    toy = restart(
        Phase.FREE_KICK,
        True,
        [Robot(*start)],
        (0, 0),
        7,
        lambda v, p: skills.stand_ready(v, p, 5, 5),
    )
    robot = toy.robots[0]
    assert hypot(*toy.ball[:2]) == 0
    assert (robot.x, robot.y) == pytest.approx((-0.46, -0.46), abs=0.04)
    assert robot.heading == pytest.approx(pi / 4, abs=0.05)


def test_the_taker_stops_before_the_ball_though_its_aim_changes():
    toy = Toy([Robot(-4, 0.3)], ball=(0, 0), phase=Phase.KICK_OFF, ours=True, started=False)
    aims = [(5, 5), (5, -5), (-5, 0), (0, 5)]
    for k in range(160):
        toy.play(0.04, lambda v, k=k: skills.stand_ready(v, v.robots[0], *aims[k // 12 % 4]))
    assert hypot(*toy.ball[:2]) == 0


def test_a_taker_that_comes_fast_is_told_to_slow_down():
    speed = {}
    for vx in (0.0, 2.0):
        player = Player(2, -1.4, 0, vx=vx)
        view = View(robots=(player,), ball=Ball(0, 0))
        command = skills.stand_ready(view, player, -5, 0)  # round to the other side
        speed[vx] = hypot(command.vx, command.vy)
    assert speed[2.0] < speed[0.0] - 0.1


def test_a_restart_is_taken_without_pushing_the_ball_about():
    toy = restart(
        Phase.FREE_KICK, True, [Robot(-2, 1), Robot(3, 2)], (0, 0), 0, lambda v, p: Command()
    )
    for _ in range(250):
        view = toy.now()
        one, two = view.robots
        if toy.time > 4:
            view = replace(view, started=True)
        first = (
            skills.pass_to(view, one, two) if view.started else skills.stand_ready(view, one, 3, 2)
        )
        toy.step([first, Command()])
        if toy.kicks:
            break
    assert toy.kicks
    assert hypot(*toy.ball[:2]) < 0.3  # it was kicked from where it lay


@pytest.mark.parametrize(
    ("phase", "ours", "started", "may"),
    [
        (Phase.PLAY, None, True, True),
        (Phase.STOP, None, False, False),
        (Phase.OVER, None, False, False),
        (Phase.CORNER, True, False, False),
        (Phase.CORNER, True, True, True),
        (Phase.CORNER, False, True, False),
        (Phase.DROPPED_BALL, None, True, True),
        (Phase.DROPPED_BALL, None, False, False),
    ],
)
def test_who_may_play_the_ball(phase, ours, started, may):
    assert skills.may_play(View(robots=(), phase=phase, ours=ours, started=started)) is may
