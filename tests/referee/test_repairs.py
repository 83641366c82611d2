"""Robots that fail, leave or are sent off: they wait beside the field and come back."""

from itertools import pairwise

import pytest
from whistle import Rig, scenario

from soccersim.referee.phases import Phase

FAILURE = {"failures": ({"robot": "home-3", "time": 20.0, "seconds": 30.0},)}


def failing(**more):
    return Rig(scenario(match={**FAILURE, **more})).playing()


def test_a_robot_that_fails_goes_off_and_waits_between_line_and_board():
    rig = failing()
    rig.until(lambda: "failed" in rig.kinds)
    x, y = rig.place("home-3")
    assert rig.event("failed").time == pytest.approx(20.0, abs=0.05)
    assert -7.74 <= y <= -7.26
    assert -11 < x < 0
    assert not rig.referee.in_play[rig.row("home-3")]
    assert rig.row("home-3") in rig.ruling.halted
    assert rig.ruling.out == (rig.row("home-3"),)


def test_it_comes_back_at_the_touch_line_when_it_answers_again():
    rig = failing()
    rig.until(lambda: "back" in rig.kinds)
    assert rig.event("back").time == pytest.approx(50.0, abs=0.05)
    assert abs(rig.place("home-3")[1]) == pytest.approx(7.0 - 0.24, abs=0.01)
    assert rig.far("home-3") > 3.0
    assert all(rig.referee.in_play)
    assert rig.ruling.out == ()


def test_a_short_failure_costs_the_time_of_a_repair():
    short = ({"robot": "home-3", "time": 20.0, "seconds": 1.0},)
    rig = failing(failures=short)
    rig.until(lambda: "back" in rig.kinds)
    assert rig.event("back").time == pytest.approx(40.0, abs=0.05)


def test_a_robot_that_fails_while_it_is_off_stays_off_longer():
    twice = (*FAILURE["failures"], {"robot": "home-3", "time": 40.0, "seconds": 25.0})
    rig = failing(failures=twice)
    rig.until(lambda: "back" in rig.kinds, seconds=90)
    assert rig.event("back").time == pytest.approx(65.0, abs=0.05)


def test_a_second_shorter_failure_brings_nobody_back_sooner():
    twice = (
        {"robot": "home-3", "time": 20.0, "seconds": 60.0},
        {"robot": "home-3", "time": 30.0, "seconds": 1.0},
    )
    rig = failing(failures=twice)
    rig.until(lambda: "back" in rig.kinds, seconds=90)
    assert rig.event("back").time == pytest.approx(80.0, abs=0.05)


def test_who_is_off_waits_at_half_time_in_his_teams_new_half():
    late = ({"robot": "home-3", "time": 20.0, "seconds": 100.0},)
    rig = Rig(scenario(changes={"duration": 60.0}, match={"failures": late})).playing()
    rig.run(30)
    x, y = rig.place("home-3")
    assert rig.referee.half == 2
    assert x > 0
    assert 7.26 <= y <= 7.74


def test_who_is_off_neither_touches_the_ball_nor_fouls():
    rig = failing()
    rig.until(lambda: "failed" in rig.kinds)
    assert rig.watch.active[rig.row("home-3")] == 0
    x = rig.place("home-3")[0]
    rig.put("ball", x, -6.7)
    rig.touch("home-4")
    rig.ball[1] = -7.15  # beside home-3, over the line
    rig.run(0.1)
    assert rig.event("out").robots == ("home-4",)


def test_a_robot_that_stays_outside_the_lines_has_left():
    rig = Rig(stuck_time=60.0).playing()
    rig.put("home-3", 3.0, 7.3)
    rig.run(9.9)
    assert rig.phase is Phase.PLAY
    assert "left" not in rig.kinds
    rig.run(0.3)
    assert rig.event("left").robots == ("home-3",)
    assert rig.phase is Phase.PLAY


def test_a_robot_on_the_line_has_not_left():
    rig = Rig(stuck_time=60.0).playing()
    rig.put("home-3", 3.0, 7.2)
    rig.run(15)
    assert "left" not in rig.kinds


def test_a_whole_team_finds_room_beside_the_field():
    all_home = tuple({"robot": f"home-{k}", "time": 20.0} for k in range(1, 6))
    rig = failing(failures=all_home)
    rig.until(lambda: rig.kinds.count("failed") == 5)
    places = [rig.place(f"home-{k}") for k in range(1, 6)]
    assert all(y == pytest.approx(-7.5) for _, y in places)
    xs = sorted(x for x, _ in places)
    assert min(b - a for a, b in pairwise(xs)) > 0.48


def test_a_restart_of_a_team_that_is_off_goes_on_without_it():
    all_home = tuple({"robot": f"home-{k}", "time": 0.0} for k in range(1, 6))
    rig = Rig(scenario(match={"failures": all_home}))
    rig.until(lambda: rig.phase is Phase.PLAY, seconds=18)
