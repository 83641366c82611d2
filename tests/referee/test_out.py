"""The ball over the lines: whole ball, and who goes on where."""

import pytest
from whistle import Rig, scenario

from soccersim.referee.phases import Phase

EDGE = 7.0 + 0.11  # where the whole ball is over the touch line
LINE = 11.0 + 0.11


def test_a_ball_partly_over_a_line_is_in_play():
    rig = Rig().playing().roll(1.0, EDGE - 0.005).run(0.2)
    rig.roll(1.0, -EDGE + 0.005).run(0.2)
    rig.put("ball", 9.0, 3.0)
    rig.roll(LINE - 0.005, 3.0).run(0.2)
    assert rig.phase is Phase.PLAY
    rig.roll(LINE + 0.005, 3.0).run(0.1)
    assert rig.phase is Phase.STOP


def test_over_the_touch_line_the_others_throw_in_where_it_crossed():
    rig = Rig().playing().roll(1.0, EDGE + 0.01).to_signal()
    assert rig.phase is Phase.THROW_IN
    assert rig.referee.whose == 1
    assert rig.ball == pytest.approx([1.0, 7.0], abs=0.02)


def test_behind_the_attacked_goal_line_the_defenders_have_a_goal_kick():
    rig = Rig().playing(9.0, 3.0).roll(LINE + 0.01, 3.0).to_signal()
    assert rig.phase is Phase.GOAL_KICK
    assert rig.referee.whose == 1
    assert rig.ball == pytest.approx([11 - 3.6, 14 / 4])


def test_behind_their_own_goal_line_the_others_have_a_corner():
    rig = Rig().playing(9.0, -3.0).touch("away-3", 1, 0).roll(LINE + 0.01, -3.0).to_signal()
    assert rig.phase is Phase.CORNER
    assert rig.referee.whose == 0
    assert rig.ball == pytest.approx([11, -7])


def test_whoever_touched_the_ball_last_is_asked_not_who_played_it_before():
    rig = Rig().playing(1.0, 6.0).touch("away-3", 0, -1).roll(1.0, EDGE + 0.01).to_signal()
    assert rig.referee.whose == 0
    assert rig.event("out").robots == ("away-3",)


def test_a_touch_after_the_ball_is_out_changes_nothing():
    rig = Rig().playing(1.0, 7.0)
    rig.ball[1] = EDGE + 0.01
    rig.step()
    rig.beside("away-3", 0, 1)
    rig.to_signal()
    assert rig.referee.whose == 1


def test_between_the_posts_it_is_a_goal_and_beside_them_none():
    for y, kind in ((0.0, "goal"), (1.19, "goal"), (1.25, "out")):
        rig = Rig().playing(9.0, y).touch("home-4").roll(LINE + 0.02, y).run(0.1)
        assert rig.kinds[-1] == kind


def test_after_a_goal_the_others_kick_off_from_the_centre():
    rig = Rig().playing(9.0, 0.0).touch("home-4").roll(LINE + 0.02, 0.0).run(0.1)
    assert rig.referee.score == (1, 0)
    assert rig.event("goal").text == "goal by home-4 for home, 1:0"
    rig.away().to_signal()
    assert rig.phase is Phase.KICK_OFF
    assert rig.referee.whose == 1
    assert tuple(rig.ball) == (0, 0)


def test_an_own_goal_counts_for_the_others():
    rig = Rig().playing(-9.0, 0.0).touch("home-4").roll(-LINE - 0.02, 0.0).run(0.1)
    assert rig.referee.score == (0, 1)
    assert rig.event("goal").text == "own goal by home-4 for away, 0:1"


def test_a_friendly_has_no_lines_but_goals():
    rig = Rig(scenario("friendly-match")).away().to_start()
    rig.kick("home-5", 1.0, 0.0).roll(5.0, 4.5).roll(6.6, 2.0).run(0.2)
    assert rig.phase is Phase.PLAY
    rig.put("ball", 5.0, 0.0)
    rig.roll(6.2, 0.0).run(0.1)
    assert rig.referee.score == (1, 0)
