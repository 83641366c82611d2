"""Fouls, and a ball that gets nowhere."""

import pytest
from whistle import Rig, scenario

from soccersim.referee.phases import Phase


def drive(rig, name, vx=0.0, vy=0.0, ball=False, also=()):
    """A move that carries robots (and the ball) along at a velocity."""
    rows = [rig.row(each) for each in (name, *also)]

    def move(tick):
        for row in [*rows, *([-1] if ball else [])]:
            rig.body[row, 3:5] = vx, vy
            rig.body[row, 0] += vx / rig.hz
            rig.body[row, 1] += vy / rig.hz

    return move


def test_a_robot_may_dribble_three_metres_and_no_more():
    rig = Rig().playing(0.5, -5.0)
    rig.beside("home-4")
    move = drive(rig, "home-4", vx=1.0, ball=True)
    rig.run(2.9, move)
    assert rig.phase is Phase.PLAY
    rig.run(0.3, move)
    assert rig.event("dribbling").robots == ("home-4",)
    rig.to_signal()
    assert rig.phase is Phase.FREE_KICK
    assert rig.referee.whose == 1
    assert tuple(rig.ball) == pytest.approx((3.3, -5.0), abs=0.4)


def test_who_lets_the_ball_go_may_dribble_anew():
    rig = Rig().playing(0.5, -5.0)
    rig.beside("home-4")
    rig.run(2.5, drive(rig, "home-4", vx=1.0, ball=True))
    rig.roll(3.5, -5.0).run(0.3)
    rig.beside("home-4")
    rig.run(2.5, drive(rig, "home-4", vx=1.0, ball=True))
    assert rig.phase is Phase.PLAY


def test_a_kick_is_no_dribble():
    rig = Rig().playing(0.5, -5.0)
    rig.beside("home-4")
    rig.run(2.0, drive(rig, "home-4", vx=1.0, ball=True))
    rig.roll(8.0, -5.0, seconds=0.15).run(0.3)
    assert rig.phase is Phase.PLAY


def opponents(rig, x, y):
    """home-4 touches away-3 from its left; away-3 stands at x, y."""
    rig.put("away-3", x, y)
    rig.put("home-4", x - 0.481, y)
    return rig


def test_who_shoves_an_opponent_away_commits_a_foul():
    rig = opponents(Rig().playing(0.0, -6.0), 1.0, 4.0)
    rig.run(1.5, drive(rig, "home-4", vx=0.5, also=["away-3"])).run(0.1)
    event = rig.event("pushing")
    assert event.robots == ("home-4", "away-3")
    rig.to_signal()
    assert rig.phase is Phase.FREE_KICK
    assert rig.referee.whose == 1
    assert tuple(rig.ball) == pytest.approx((event.x, event.y))


def test_shoving_while_the_ball_is_out_is_forgotten_at_start():
    rig = opponents(Rig().playing(1.0, 6.9), -2.0, -5.0)
    rig.run(0.9, drive(rig, "home-4", vx=0.5, also=["away-3"]))
    rig.roll(1.0, 7.13)
    shove = drive(rig, "home-4", vx=0.05, also=["away-3"])  # they stay in contact
    rig.until(lambda: rig.referee.started and rig.phase is Phase.THROW_IN, move=shove)
    rig.until(lambda: rig.phase is Phase.PLAY, move=shove).run(0.2, shove)
    assert rig.phase is Phase.PLAY
    assert "pushing" not in rig.kinds


def test_robots_that_touch_without_shoving_commit_none():
    rig = opponents(Rig().playing(0.0, -6.0), 1.0, 4.0)
    rig.body[[rig.row("home-4"), rig.row("away-3")], 3] = 0.5, -0.5  # both press
    rig.run(3.0)
    assert rig.phase is Phase.PLAY


def test_the_one_that_goes_backwards_is_not_the_one_that_pushes():
    rig = opponents(Rig().playing(0.0, -6.0), 1.0, 4.0)
    rig.run(1.5, drive(rig, "home-4", vx=-0.5, also=["away-3"])).run(0.1)
    assert rig.event("pushing").robots == ("away-3", "home-4")


def test_pushing_by_a_defender_in_its_penalty_area_is_a_penalty():
    rig = Rig().playing(0.0, -6.0)
    rig.put("home-3", -10.2, 1.5)
    rig.put("away-3", -9.719, 1.5)
    rig.run(1.5, drive(rig, "home-3", vx=0.5, also=["away-3"])).to_signal()
    assert rig.phase is Phase.PENALTY
    assert rig.referee.whose == 1
    assert tuple(rig.ball) == pytest.approx((-11 + 3.6, 0.0))


def test_pushing_by_an_attacker_there_is_a_free_kick_outside_it():
    rig = Rig().playing(0.0, -6.0)
    rig.put("home-3", -9.5, 1.5)
    rig.put("away-3", -9.019, 1.5)
    rig.run(1.5, drive(rig, "away-3", vx=-0.5, also=["home-3"])).to_signal()
    assert rig.phase is Phase.FREE_KICK
    assert rig.referee.whose == 0
    assert tuple(rig.ball) == pytest.approx((-7.4, 3.5))


def penalty():
    rig = Rig().playing(0.0, -6.0)
    rig.put("home-3", -10.2, 1.5)
    rig.put("away-3", -9.719, 1.5)
    rig.run(1.5, drive(rig, "home-3", vx=0.5, also=["away-3"])).to_signal()
    return rig


def test_at_a_penalty_the_keeper_is_on_its_line_and_others_out_of_the_area():
    rig = penalty()
    rig.put("home-1", -9.5, 0.3)
    rig.put("away-3", -7.0, 0.0)
    rig.put("away-4", -9.5, 2.5)
    rig.put("home-4", -9.5, -2.5)
    rig.put("away-1", 10.0, 0.0)
    rig.to_start()
    assert rig.place("home-1") == pytest.approx((-11 + 0.24, 0.3), abs=0.05)
    assert rig.place("away-3") == (-7.0, 0.0)
    assert rig.place("away-1") == (10.0, 0.0)
    for name in ("away-4", "home-4"):
        assert rig.referee.ground.penalty_end(*rig.place(name)) == 0.0
        assert rig.far(name) >= (2.0 if name == "away-4" else 3.0)


def test_a_penalty_may_be_shot_straight_into_the_goal():
    rig = penalty()
    rig.to_start()
    rig.put("home-1", -9.9, 2.0)
    rig.kick("away-3", -11.2, 0.0, seconds=0.6).run(0.1)
    assert rig.event("goal").side == "away"


def test_who_touches_a_keeper_in_its_goal_area_commits_a_foul():
    rig = Rig().playing(0.0, -6.0)
    rig.put("home-1", -10.5, 0.0)
    rig.put("away-3", -10.5, 0.481)
    rig.run(0.1)
    assert rig.event("keeper").robots == ("away-3", "home-1")
    rig.to_signal()
    assert rig.phase is Phase.FREE_KICK
    assert rig.referee.whose == 0


def test_outside_its_goal_area_a_keeper_is_touched_like_anybody():
    rig = Rig().playing(0.0, -6.0)
    rig.put("home-1", -9.5, 0.0)
    rig.put("away-3", -9.5, 0.481)
    rig.run(0.5)
    assert rig.phase is Phase.PLAY


@pytest.mark.parametrize(("name", "side"), [("away-3", 0), ("home-3", 1)])
def test_one_robot_may_be_in_a_penalty_area_for_ten_seconds(name, side):
    rig = Rig(stuck_time=60.0).playing(0.0, -6.0)
    rig.put("home-1", -10.5, 0.0)
    rig.put(name, -9.5, 2.0)
    rig.run(9.9)
    assert rig.phase is Phase.PLAY
    rig.run(0.3)
    assert rig.event("area").robots == (name,)
    rig.to_signal()
    assert rig.referee.whose == side


def test_the_second_one_may_not_stay_and_the_keeper_is_not_counted():
    rig = Rig(stuck_time=60.0).playing(0.0, -6.0)
    rig.put("home-1", -10.5, 0.0)
    rig.put("home-3", -9.5, 2.0)
    rig.run(3.0)
    assert rig.phase is Phase.PLAY
    rig.put("home-4", -9.5, -2.0)
    rig.run(1.2)
    assert rig.event("area").robots == ("home-4",)


def test_who_leaves_the_area_in_time_may_come_again():
    rig = Rig(stuck_time=60.0).playing(0.0, -6.0)
    for _ in range(3):
        rig.put("away-3", -9.5, 2.0)
        rig.run(8.0)
        rig.put("away-3", -7.5, 2.0)
        rig.run(0.1)
    assert rig.phase is Phase.PLAY


def test_a_ball_that_gets_nowhere_for_ten_seconds_is_dropped_at_the_nearest_spot():
    rig = Rig().playing(6.5, -3.0)
    rig.run(9.5, lambda tick: rig.put("ball", 6.5 + 0.2 * (tick % 3), -3.0))
    assert rig.phase is Phase.PLAY
    rig.run(0.4)
    assert rig.kinds[-1] == "stuck"
    rig.to_signal()
    assert rig.phase is Phase.DROPPED_BALL
    assert tuple(rig.ball) == pytest.approx((7.4, -3.5))


def test_a_ball_that_moves_on_is_not_stuck():
    rig = Rig().playing(0.0, -6.0)
    rig.run(30, lambda tick: rig.put("ball", 0.3 * (tick // 100) - 8.0, -6.0))
    assert rig.phase is Phase.PLAY


def test_a_friendly_knows_no_fouls():
    rig = Rig(scenario("friendly-match", stuck_time=300.0)).away().to_start()
    rig.kick("home-5", 1.0, 0.0)
    rig.put("home-3", -5.0, 1.0)
    rig.put("away-3", -4.519, 1.0)
    rig.put("away-4", -5.5, -1.5)
    rig.put("away-5", -5.6, 0.0)
    rig.run(1.5, drive(rig, "home-3", vx=0.5, also=["away-3"])).run(15)
    assert rig.phase is Phase.PLAY
