"""What skills make of the opponents: gaps in the goal, ways of passes, mates worth a pass."""

from math import atan2, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.strategy import Ball, Opponent, Phase, Player, View, skills
from soccersim.strategy.openings import POST

ME = Player(2, 0, 0)


def view(*opponents, robots=(ME,)):
    return View(robots=robots, opponents=opponents)


def test_an_empty_goal_is_aimed_at_in_the_middle():
    aim, half_angle = skills.free_goal(view(), 5, 0)
    assert aim == 0
    assert half_angle == pytest.approx(atan2(1.2 - POST, 6))


def test_a_keeper_in_the_middle_leaves_two_halves_and_one_aside_the_other():
    aim, _ = skills.free_goal(view(Opponent(10.5, 0)), 5, 0)
    assert 0.5 < abs(aim) < 1.1
    aim, wide = skills.free_goal(view(Opponent(10.5, 0.5)), 5, 0)
    assert aim < -0.2
    _, narrow = skills.free_goal(view(Opponent(10.5, 0)), 5, 0)
    assert wide > narrow


def test_a_wall_leaves_nothing_and_then_the_middle_is_named():
    wall = [Opponent(6, y) for y in (-0.6, 0, 0.6)]
    assert skills.free_goal(view(*wall), 5, 0) == (0, 0)
    assert skills.free_goal(view(), 12, 0) == (0, 0)


def test_who_is_behind_the_goal_covers_nothing():
    assert skills.free_goal(view(Opponent(11.9, 0)), 5, 0) == skills.free_goal(view(), 5, 0)


@settings(derandomize=True)
@given(
    st.floats(-5, 10),
    st.floats(-6, 6),
    st.lists(st.builds(Opponent, st.floats(-5, 11), st.floats(-6, 6)), max_size=5),
)
def test_the_aim_is_between_the_posts_and_clear_of_everybody(x, y, opponents):
    aim, half_angle = skills.free_goal(view(*opponents), x, y)
    assert abs(aim) <= 1.2 - POST + 1e-9
    assert half_angle >= 0
    if half_angle > 0:
        for other in opponents:
            if x + 0.1 < other.x < 11:
                beside = y + (aim - y) * (other.x - x) / (11 - x) - other.y
                assert abs(beside) > 0.2
    mirrored = [Opponent(o.x, -o.y) for o in opponents]
    other = skills.free_goal(view(*mirrored), x, -y)[1]
    assert other == pytest.approx(half_angle, rel=0.3)  # of two gaps as wide either may be taken


def test_a_pass_is_clear_of_who_cannot_reach_it():
    assert skills.clearance(view(), 0, 0, 5, 0, 5) > 100
    behind = skills.clearance(view(Opponent(-2, 0)), 0, 0, 5, 0, 5)
    assert behind > 100
    aside = skills.clearance(view(Opponent(2.5, 3)), 0, 0, 5, 0, 5)
    close = skills.clearance(view(Opponent(2.5, 1)), 0, 0, 5, 0, 5)
    between = skills.clearance(view(Opponent(2.5, 0.1)), 0, 0, 5, 0, 5)
    assert aside > close > 0 > between
    late = skills.clearance(view(Opponent(4.5, 1)), 0, 0, 5, 0, 5)
    assert late < close  # there is more time to get there


def test_a_pass_leads_a_mate_who_runs_and_stays_on_the_field():
    runner = Player(3, 5, 0, 0.0, vx=0, vy=2.0)
    x, y = skills.lead(view(), ME, runner)
    assert x == pytest.approx(5)
    assert 0.5 < y < 2.5
    _, y = skills.lead(view(), ME, Player(3, 5, 6.8, 0.0, vy=2.0))
    assert y <= 6.5


def passed(*mates, me=ME, opponents=()):
    found, free = skills.best_pass(view(*opponents, robots=(me, *mates)), me)
    assert (free > 0) == (found is not None)
    return found and found.number


def test_the_ball_goes_forward_to_who_is_free():
    ahead, back = Player(3, 5, 1), Player(4, -5, 1)
    assert passed(ahead, back) == 3
    assert passed(ahead, Player(4, 5, -1), opponents=[Opponent(2.5, 0.5)]) == 4
    assert passed(ahead, opponents=[Opponent(2.5, 0.5)]) is None


@pytest.mark.parametrize(
    "mate",
    [
        Player(3, 0.5, 0.5),
        Player(3, 10.5, 0),
        Player(3, 5, 0, role="keeper"),
        Player(3, 5, 0, in_play=False),
    ],
)
def test_no_pass_goes_to_who_is_too_near_too_far_or_no_field_player(mate):
    assert passed(mate) is None


def test_of_two_alike_the_one_it_looks_at_is_passed_to():
    left, right = Player(3, 4, 3), Player(4, 4, -3)
    assert passed(left, right, me=Player(2, 0, 0, heading=0.6)) == 3
    assert passed(left, right, me=Player(2, 0, 0, heading=-0.6)) == 4


def test_a_pass_back_is_no_help():
    assert passed(Player(3, -6, 0), me=Player(2, 0, 0, heading=0)) is None
    assert passed(Player(3, -1, 2), me=Player(2, 0, 0, heading=pi / 2)) == 3


def test_a_template_of_a_team_answers_in_every_phase():
    from soccersim.strategy.check import answer_of
    from soccersim.strategy.newcomer import Newcomer

    robots = tuple(Player(n, -2.0 * n, n - 2.0, role="field" if n else "keeper") for n in range(5))
    for phase in Phase:
        for ours in (True, False, None):
            for ball in (None, *(Ball(x, 0) for x in (-9, 0, 9))):
                told = View(robots=robots, ball=ball, phase=phase, ours=ours, started=False)
                answer_of(Newcomer(None).decide(told), 5)
