"""Whatever a team is told, skills answer with numbers, soon, and the same when all is mirrored."""

from dataclasses import replace
from timeit import repeat

import pytest
from hypothesis import given, settings
from test_api import views

from soccersim.strategy import Ball, Opponent, Player, View, skills
from soccersim.strategy.check import answer_of

SKILLS = {
    "go_to": lambda v, p, m: skills.go_to(v, p, 3.0, -2.0),
    "go_to outside the area": lambda v, p, m: skills.go_to(v, p, -10.0, 2.0, 1.0, area=False),
    "face": lambda v, p, m: skills.face(v, p, 3.0, -2.0),
    "intercept": lambda v, p, m: skills.intercept(v, p),
    "intercept with an aim": lambda v, p, m: skills.intercept(v, p, (3.0, -2.0)),
    "dribble": lambda v, p, m: skills.dribble(v, p, 3.0, -2.0),
    "pass_to": skills.pass_to,
    "shoot": lambda v, p, m: skills.shoot(v, p),
    "block": lambda v, p, m: skills.block(v, p),
    "keep_distance": lambda v, p, m: skills.keep_distance(v, p, 3.0, -2.0),
    "stand_ready": lambda v, p, m: skills.stand_ready(v, p, 3.0, -2.0),
}


@pytest.mark.parametrize("skill", SKILLS)
@settings(max_examples=60, derandomize=True)
@given(view=views)
def test_a_skill_answers_any_view_with_a_command_that_counts(skill, view):
    player, mate = view.robots[0], view.robots[-1]
    [order] = answer_of([SKILLS[skill](view, player, mate)], 1).orders
    assert order[3] <= player.body.kick_speed
    assert abs(order[2]) <= player.body.turn_rate
    assert order[0] ** 2 + order[1] ** 2 <= player.body.speed**2 + 1e-6


@pytest.mark.parametrize("skill", SKILLS)
def test_everything_in_one_place_is_no_trouble(skill):
    here = Player(1, 0, 0), Player(2, 0, 0)
    for has_ball in (False, True):
        robots = (replace(here[0], has_ball=has_ball), here[1])
        view = View(robots=robots, ball=Ball(0, 0), opponents=(Opponent(0, 0),))
        answer_of([SKILLS[skill](view, *robots)], 1)


def mirrored(view):
    """The same with left and right exchanged."""
    robots = tuple(
        replace(p, y=-p.y, heading=-p.heading, vy=-p.vy, omega=-p.omega) for p in view.robots
    )
    ball = view.ball and replace(view.ball, y=-view.ball.y, vy=-view.ball.vy)
    opponents = tuple(replace(o, y=-o.y, vy=-o.vy) for o in view.opponents)
    return replace(view, robots=robots, ball=ball, opponents=opponents)


@settings(max_examples=60, derandomize=True)
@given(view=views)
def test_left_and_right_are_alike(view):
    other = mirrored(view)
    one, two = skills.intercept(view, view.robots[0]), skills.intercept(other, other.robots[0])
    if not view.opponents and len(view.robots) == 1:  # else the sides of a detour may tie
        assert (two.vx, two.vy) == pytest.approx((one.vx, -one.vy), abs=1e-6)
        assert abs(two.omega) == pytest.approx(abs(one.omega), abs=1e-6)  # half a turn: either way
    assert skills.best_pass(view, view.robots[0])[1] == pytest.approx(
        skills.best_pass(other, other.robots[0])[1]
    )


@pytest.mark.benchmark
@pytest.mark.parametrize("skill", SKILLS)
def test_a_skill_takes_microseconds(skill):
    """Five robots at 25 Hz are 125 calls a second: at 40 us each, a two-hundredth of real time."""
    places = [(-4, 1), (2, 3), (3, -3), (-1, -4), (6, 0)]
    robots = tuple(Player(n, x, y, 0.3, 0.5, 0.2) for n, (x, y) in enumerate(places))
    opponents = tuple(Opponent(1 - x, y + 0.5, 0.3, 0.1) for x, y in places)
    view = View(robots=robots, ball=Ball(1, 2, 1.0, 0.5), opponents=opponents)
    mind = SKILLS[skill]
    once = min(repeat(lambda: mind(view, robots[0], robots[1]), number=200, repeat=9)) / 200
    assert once < 80e-6
