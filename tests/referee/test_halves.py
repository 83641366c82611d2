"""Two halves on a clock that never stops, ends changed between them."""

import numpy as np
import pytest
from whistle import Rig, scenario

from soccersim.referee.phases import Phase

SHORT = {"duration": 60.0}


def test_home_attacks_plus_x_first_and_the_other_way_after_half_time():
    rig = Rig(scenario(changes=SHORT))
    assert list(rig.referee.direction) == [1, -1]
    rig.run(31)
    assert list(rig.referee.direction) == [-1, 1]
    assert rig.referee.half == 2


def test_at_half_time_robots_are_carried_to_their_starts_turned_by_half_a_turn():
    rig = Rig(scenario(changes=SHORT))
    starts = rig.body[:-1, :2].copy()
    rig.run(30.0)
    rig.away()
    rig.run(0.05)
    assert rig.body[:-1, :2] == pytest.approx(-starts)
    assert np.cos(rig.body[:-1, 2]) == pytest.approx(np.sign(rig.body[:-1, 0]) * -1.0)


def test_swapped_ends_are_swapped_from_the_first_tick():
    rig = Rig(scenario(changes=SHORT, match={"swap_ends": True}))
    assert list(rig.referee.direction) == [-1, 1]
    rig.run(31)
    assert list(rig.referee.direction) == [1, -1]
    starts = [player.start[:2] for player in rig.scenario.robots]
    assert rig.body[:-1, :2] == pytest.approx(np.array(starts))


def test_away_kicks_off_the_second_half_whoever_scored_last():
    rig = Rig(scenario(changes=SHORT)).away().to_start()
    rig.until(lambda: rig.referee.half == 2).to_signal()
    assert rig.phase is Phase.KICK_OFF
    assert rig.referee.whose == 1


def test_when_the_time_is_up_everybody_stands_and_nothing_counts_any_more():
    rig = Rig(scenario(changes=SHORT)).run(60.1)
    assert rig.phase is Phase.OVER
    assert set(rig.ruling.halted) == set(range(10))
    before = len(rig.events)
    rig.roll(12.0, 0.0).run(1)
    assert len(rig.events) == before
    assert rig.referee.score == (0, 0)


def test_a_goal_in_the_other_half_counts_for_the_team_that_attacks_that_end_now():
    rig = Rig(scenario(changes=SHORT)).run(30.1)
    rig.away().to_start()
    rig.kick("away-5", 1.0, 0.0).touch("away-4", -1, 0).kick("away-4", 11.3, 0.0).run(0.1)
    assert rig.event("goal").side == "away"
    assert rig.referee.score == (0, 1)


@pytest.mark.parametrize(
    ("half", "team", "whistle"), [(1, "home", "half_time"), (2, "away", "end")]
)
def test_a_goal_counts_until_the_whistle_and_not_after(half, team, whistle):
    for late in (0, 1):  # ticks
        rig = Rig(scenario(changes={"duration": 36.0}))  # over before the ball is stuck
        rig.until(lambda rig=rig: rig.referee.half == half).away().to_start()
        rig.kick(f"{team}-5", 1.0, 0.0).touch(f"{team}-4", -1, 0)
        rig.until(lambda rig=rig, at=1800 * half - 1 + late: rig.tick == at)
        rig.put("ball", 11.3, 0.0)
        rig.run(0.1)
        assert rig.kinds[-2:] == (["in_play", whistle] if late else ["goal", whistle])
        assert sum(rig.referee.score) == 1 - late
