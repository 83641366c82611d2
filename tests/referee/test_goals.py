"""Which goals count: after a pass, from the opponents' half, by more than one robot."""

import pytest
from whistle import Rig

from soccersim.referee.phases import Phase


def kick_off(rig):
    rig.away().to_start()
    return rig


def shoot(rig, name):
    """From where the ball is into the goal that home attacks."""
    rig.touch(name)
    rig.put("ball", 10.9, 0.0)
    return rig.roll(11.2, 0.0).run(0.1)


def test_straight_from_a_kick_off_there_is_no_goal():
    rig = kick_off(Rig())
    rig.kick("home-5", 1.0, 0.0)
    rig.put("ball", 10.9, 0.0)
    rig.roll(11.2, 0.0).run(0.1)
    assert rig.kinds[-1] == "no_goal"
    assert rig.referee.score == (0, 0)
    rig.to_signal()
    assert rig.phase is Phase.GOAL_KICK
    assert rig.referee.whose == 1


def test_the_taker_himself_may_play_on_but_not_score():
    rig = kick_off(Rig())
    rig.kick("home-5", 1.0, 0.0)
    assert shoot(rig, "home-5").kinds[-1] == "no_goal"


def test_after_a_pass_to_a_mate_the_goal_counts():
    rig = kick_off(Rig())
    rig.kick("home-5", 1.0, 0.0)
    assert shoot(rig, "home-4").kinds[-1] == "goal"


def test_once_the_opponents_have_had_the_ball_a_restart_is_forgotten():
    rig = kick_off(Rig())
    rig.kick("home-5", 2.0, 0.0).touch("away-5", 1, 0)
    assert shoot(rig, "home-5").kinds[-1] == "goal"


def test_where_the_rule_is_not_played_the_taker_may_score():
    rig = kick_off(Rig(pass_at_restart=False))
    rig.kick("home-5", 1.0, 0.0)
    assert shoot(rig, "home-5").kinds[-1] == "goal"


def test_a_goal_kicked_from_the_own_half_does_not_count():
    rig = Rig().playing(-1.0)
    assert shoot(rig, "home-4").kinds[-1] == "no_goal"
    assert "own half" in rig.events[-1].text


def test_a_goal_from_the_own_half_counts_where_the_rules_say_so():
    rig = Rig(own_half_goals=True).playing(-1.0)
    assert shoot(rig, "home-4").kinds[-1] == "goal"


def won_in_the_own_half(**rules):
    """home-4 has won the ball in its own half and brought it over the half-way line."""
    rig = Rig(**rules).playing(-2.0).touch("away-3", 1, 0).touch("home-4")
    rig.put("ball", 2.0, 0.0)
    return rig.touch("home-4")


def test_who_wins_the_ball_in_the_own_half_may_not_score_alone():
    rig = shoot(won_in_the_own_half(), "home-4")
    assert rig.kinds[-1] == "no_goal"
    assert "not passed" in rig.events[-1].text


def test_a_pass_in_the_other_half_makes_it_good():
    rig = won_in_the_own_half().roll(3.1, 0.0).touch("home-5")
    assert shoot(rig, "home-4").kinds[-1] == "goal"


def test_a_pass_of_less_than_a_metre_does_not():
    rig = won_in_the_own_half().roll(2.9, 0.0).touch("home-5")
    assert shoot(rig, "home-5").kinds[-1] == "no_goal"


def test_a_pass_received_in_the_own_half_does_not():
    rig = Rig().playing(-5.0, 4.0).touch("away-3", 1, 0).touch("home-4")
    rig.roll(-2.0, 4.0).touch("home-5")
    rig.put("ball", 2.0, 0.0)
    assert shoot(rig, "home-5").kinds[-1] == "no_goal"


def test_who_wins_the_ball_in_the_other_half_may_score_alone():
    rig = Rig().playing(2.0).touch("away-3", 1, 0)
    assert shoot(rig, "home-4").kinds[-1] == "goal"


@pytest.mark.parametrize("robots", [("home-4",), ("home-4", "home-5"), ("away-3", "home-4")])
def test_a_dropped_ball_needs_two_robots_before_a_goal(robots):
    rig = Rig().playing()
    rig.until(lambda: rig.phase is Phase.DROPPED_BALL).to_start()
    rig.put("ball", 2.0, 0.0)
    for name in robots[:-1]:
        rig.touch(name).run(0.3)
    shoot(rig, robots[-1])
    assert rig.kinds[-1] == ("goal" if len(robots) > 1 else "no_goal")


def test_straight_from_the_own_restart_into_the_own_goal_is_a_corner():
    rig = kick_off(Rig())
    rig.kick("home-5", -1.0, 0.0)
    rig.put("ball", -10.9, 0.0)
    rig.roll(-11.2, 0.0).to_signal()
    assert rig.referee.score == (0, 0)
    assert rig.phase is Phase.CORNER
    assert rig.referee.whose == 1


def test_a_goal_is_judged_by_who_touched_the_ball_before_it_crossed_the_line():
    rig = Rig().playing(9.0).touch("home-4")
    rig.put("ball", 11.0, 0.0)
    rig.ball[0] = 11.12
    rig.step()
    rig.beside("away-1", 1, 0)
    rig.run(0.1)
    assert rig.kinds[-1] == "goal"
    assert rig.event("goal").robots == ("home-4",)


def test_a_touch_behind_the_line_does_not_make_a_goal_good():
    rig = kick_off(Rig())
    rig.kick("home-5", 1.0, 0.0).run(0.3)
    rig.until(lambda: rig.tick % rig.every == 1)  # the referee has just looked
    rig.put("ball", 11.13, 0.0)
    rig.step()
    rig.beside("away-1", 1, 0)
    rig.run(0.05)
    assert "since the restart" in rig.event("no_goal").text
