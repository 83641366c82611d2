"""STOP, signal, START, in play: who stands where, and how a restart is taken."""

import pytest
from whistle import Rig, scenario

from soccersim.referee.phases import Phase


def throw_in(rig=None):
    """A throw-in of away at (1, 7), just signalled, everybody far away."""
    return (rig or Rig()).playing().roll(1.0, 7.13).to_signal()


def seconds(rig, first, then):
    return rig.event(then).time - rig.event(first).time


def test_at_stop_everybody_stands_and_at_the_signal_nobody_must():
    rig = Rig().playing().roll(1.0, 7.13).run(0.1)
    assert rig.phase is Phase.STOP
    assert rig.referee.whose is None
    assert set(rig.ruling.halted) == set(range(10))
    rig.to_signal()
    assert rig.ruling.halted == ()
    assert rig.referee.whose == 1
    assert not rig.referee.started


def test_start_comes_at_the_latest_seven_seconds_after_stop():
    rig = throw_in().to_start()
    assert seconds(rig, "out", "start") == pytest.approx(7.0, abs=0.05)


def test_start_comes_sooner_when_the_taker_waits_and_nobody_stands_wrong():
    rig = throw_in()
    rig.put("away-3", 1.5, 7.2)
    rig.to_start()
    assert seconds(rig, "throw_in", "start") == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("what", ["taker moves", "mate near", "opponent near"])
def test_start_waits_for_who_is_not_ready(what):
    rig = throw_in()
    rig.put("away-3", 1.5, 7.2, 0, 0.6 if what == "taker moves" else 0)
    if what == "mate near":
        rig.put("away-4", 1.0, 5.4)
    if what == "opponent near":
        rig.put("home-4", 1.0, 4.4)
    rig.to_start()
    assert seconds(rig, "out", "start") == pytest.approx(7.0, abs=0.05)


def test_who_stands_too_near_at_start_is_carried_straight_away_to_his_distance():
    rig = throw_in()
    rig.put("away-3", 1.5, 7.2)
    rig.put("away-4", 1.0, 6.0)
    rig.put("home-4", 1.0, 5.0)
    rig.to_start()
    assert rig.far("away-4") == pytest.approx(2.0, abs=0.01)
    assert rig.far("home-4") == pytest.approx(3.0, abs=0.01)
    assert rig.place("home-4")[0] == pytest.approx(1.0)
    assert {event.robots for event in rig.events if event.kind == "carried"} == {
        ("away-4",),
        ("home-4",),
    }


def test_a_little_too_near_is_forgiven():
    rig = throw_in()
    rig.put("away-3", 1.5, 7.2)
    rig.put("away-4", 1.0, 7.0 - 1.75)
    rig.put("home-4", 2.0, 7.0 - 2.6)
    rig.to_start()
    assert "carried" not in rig.kinds


def test_at_a_dropped_ball_everybody_keeps_a_metre():
    rig = Rig().playing()
    rig.until(lambda: rig.phase is Phase.DROPPED_BALL)
    rig.put("home-4", -0.5, 0.0)
    rig.put("home-5", 0.0, 0.5)
    rig.put("away-3", 1.1, 0.0)
    rig.to_start()
    assert rig.referee.whose is None
    assert rig.far("home-4") == pytest.approx(1.0, abs=0.01)
    assert rig.far("home-5") == pytest.approx(1.0, abs=0.01)
    assert rig.place("away-3") == (1.1, 0.0)


def test_a_keeper_may_stay_in_its_penalty_area_however_near_the_ball():
    rig = Rig().playing(-8.0, 2.0)
    rig.until(lambda: rig.phase is Phase.DROPPED_BALL)
    assert tuple(rig.ball) == (-7.4, 3.5)
    rig.put("ball", -8.0, 2.0)
    rig.put("home-1", -9.0, 3.0)
    rig.to_start()
    assert rig.place("home-1") == (-9.0, 3.0)


def test_at_a_kick_off_everybody_but_the_taker_is_in_his_own_half():
    rig = Rig().away()
    rig.put("home-5", 0.3, 0.3)
    rig.put("home-4", 4.0, 2.5)
    rig.put("away-4", -4.0, 2.5)
    rig.to_start()
    assert rig.place("home-5") == (0.3, 0.3)
    assert rig.place("home-4")[0] < -0.2
    assert rig.place("away-4")[0] > 0.2
    assert rig.far("away-4") >= 3.0


def test_in_play_is_a_ball_that_rolled_half_a_metre():
    rig = throw_in().to_start()
    rig.beside("away-3", 0, 1)
    rig.run(0.08).roll(1.0, 6.55).run(0.1)
    assert rig.phase is Phase.THROW_IN
    rig.roll(1.0, 6.48).run(0.1)
    assert rig.phase is Phase.PLAY


@pytest.mark.parametrize("name", ["away-3", "away-4"])
def test_who_touches_it_before_that_gives_a_free_kick_away(name):
    rig = throw_in().to_start()
    rig.kick("away-3", 1.0, 6.6).touch(name, 0, 1).run(0.1)
    assert rig.event("double_touch").robots == (name,)
    rig.to_signal()
    assert rig.phase is Phase.FREE_KICK
    assert rig.referee.whose == 0


def test_a_taker_that_does_not_let_the_ball_go_gives_a_free_kick_away():
    rig = throw_in().to_start()

    def follow(tick):
        rig.ball[1] -= 0.01
        rig.beside("away-3", 0, 1)

    rig.run(0.6, follow).run(0.1)
    assert rig.event("double_touch").robots == ("away-3",)


def test_a_mate_may_take_the_ball_on_once_it_has_rolled():
    rig = throw_in().to_start()
    rig.kick("away-3", 1.0, 6.4).touch("away-4", 0, -1).run(0.1)
    assert rig.phase is Phase.PLAY


def test_after_seven_seconds_everybody_may_play_a_ball_that_nobody_takes():
    rig = throw_in().to_start()
    rig.until(lambda: rig.phase is Phase.PLAY)
    assert seconds(rig, "start", "in_play") == pytest.approx(7.0, abs=0.05)
    rig.touch("home-4", 0, -1).roll(1.0, 4.0)
    assert rig.phase is Phase.PLAY


def test_a_defender_that_comes_too_near_has_the_restart_taken_again_then_goes_off():
    rig = throw_in().to_start()
    rig.put("home-4", 1.0, 7.0 - 2.5)
    rig.run(0.1)
    assert rig.phase is Phase.STOP
    assert rig.event("too_near").robots == ("home-4",)
    rig.to_start()
    assert rig.phase is Phase.THROW_IN
    assert rig.referee.whose == 1
    assert rig.far("home-4") >= 2.99
    rig.put("home-4", 1.0, 7.0 - 2.5)
    rig.run(0.1)
    assert rig.event("sent_off").robots == ("home-4",)
    assert rig.phase is Phase.THROW_IN
    assert not rig.referee.in_play[rig.row("home-4")]


def test_mates_that_come_too_near_have_it_taken_again_once():
    rig = throw_in().to_start()
    rig.put("away-3", 1.0, 7.4)
    rig.put("away-4", 1.0, 5.5)
    rig.run(0.1)
    assert rig.event("too_near").robots == ("away-4",)
    rig.to_start()
    rig.put("away-4", 1.0, 5.5)
    rig.run(0.2)
    assert rig.phase is Phase.THROW_IN
    assert rig.kinds.count("too_near") == 1
    assert all(rig.referee.in_play)


def test_a_defender_that_plays_the_ball_too_soon_has_it_taken_again():
    rig = throw_in().to_start()
    rig.put("home-4", 1.0, 3.5)
    rig.ball[:] = 1.0, 3.9  # pushed there by nobody
    rig.touch("home-4", 0, -1).run(0.1)
    assert "too_near" in rig.kinds
    rig.to_signal()
    assert tuple(rig.ball) == pytest.approx((1.0, 7.0))


def test_a_ball_moved_before_start_is_put_back():
    rig = throw_in().roll(3.0, 3.0).to_start()
    assert tuple(rig.ball) == pytest.approx((1.0, 7.0))


def test_the_balls_place_is_made_free_and_nobody_overlaps_then():
    rig = Rig().playing()
    for k, name in enumerate(rig.names):  # a heap where the ball will lie
        rig.put(name, 10.9 - 0.05 * k, 6.9 - 0.05 * (k % 3))
    rig.put("ball", 11.0, 3.0)
    rig.watch.latest[0] = rig.row("away-2")
    rig.roll(11.2, 3.0).to_signal()
    assert rig.phase is Phase.CORNER
    gaps = [rig.far(name) - rig.radius[rig.row(name)] - 0.11 for name in rig.names]
    assert min(gaps) > 0.0
    assert rig.body[:-1, 0].max() < 12 - 0.24
    assert rig.body[:-1, 1].max() < 8 - 0.24


def test_robots_are_placed_where_the_rules_say_so():
    rig = Rig(restarts="place").playing().roll(1.0, 7.13).run(0.1)
    rig.put("home-4", 1.0, 6.0)
    rig.to_signal()
    assert rig.far("home-4") == pytest.approx(3.0, abs=0.01)
    assert rig.event("placed").robots == ("home-4",)


def test_at_a_kick_off_that_is_placed_everybody_stands_at_his_start():
    rig = Rig(restarts="place")
    starts = rig.body[:-1, :2].copy()
    rig.playing(10.0, 0.0).touch("home-4").roll(11.2, 0.0).away().to_signal()
    assert rig.body[:-1, :2] == pytest.approx(starts)


@pytest.mark.parametrize("name", ["krsbi-match", "friendly-match"])
def test_restarts_of_other_rule_sets_lead_to_play_too(name):
    rig = Rig(scenario(name)).to_start()
    rig.until(lambda: rig.phase is Phase.PLAY, seconds=8)


def test_a_hard_pass_may_be_over_before_the_referee_looks():
    rig = throw_in().to_start()
    rig.until(lambda: rig.tick % rig.every == 1)
    rig.beside("away-3", 0, 1)
    rig.step()
    rig.put("ball", 1.0, 6.0)
    rig.beside("away-4", 0, -1)
    rig.run(0.06)
    assert rig.phase is Phase.PLAY
    assert "double_touch" not in rig.kinds


def test_at_a_goal_kick_even_the_keeper_keeps_its_distance():
    rig = Rig().playing(9.0, 3.4).roll(11.2, 3.4).to_signal()
    assert tuple(rig.ball) == (7.4, 3.5)
    rig.put("away-1", 8.76, 3.4)  # in its penalty area
    rig.put("away-2", 7.4, 4.0)
    rig.to_start()
    assert rig.far("away-1") == pytest.approx(2.0, abs=0.01)
    assert rig.place("away-2") == (7.4, 4.0)
