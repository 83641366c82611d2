"""What a match came to: each number as its docstring defines it."""

import json
import re

import numpy as np
import pytest
from pages import ROOT, rows
from tape import RECORD_HZ, STRIDE, event, tape
from test_touches import REACH, rolling, still

from soccersim.match.faults import TeamFault
from soccersim.match.log import ROWS
from soccersim.match_report import match_report, summary, team_name
from soccersim.record.compact import STEPS
from soccersim.record.recording import MATCH
from soccersim.referee.events import Event
from soccersim.sheet import PHASES

PAGE = ROOT / "docs" / "recording.md"
HOME_1, HOME_2, AWAY_1 = 0, 1, 5


def moved(ball, robots, **told):
    """The report of a match with these robots where they stand, and this way of the ball."""
    ways = still(len(ball))
    for row, pose in robots.items():
        ways[:, row] = pose
    return match_report(tape(ways, ball, **told))


def kicked(start, velocity, seconds=0.6, robots=None, side="home", mate=True, **told):
    """The report of a kick: from the mouth of one robot, with a velocity.

    mate: a mate has touched the ball before.
    """
    row = {"home": HOME_2, "away": AWAY_1 + 1}[side]
    x, y = start
    rest = np.tile(start, (10, 1))
    way = start + np.arange(1, int(seconds * RECORD_HZ))[:, None] / RECORD_HZ * np.array(velocity)
    ball = np.concatenate((rest, way))
    by = np.array(velocity) / np.hypot(*velocity) * REACH
    robots = {row: (x - by[0], y - by[1], 0.0), **(robots or {})}
    contact = np.zeros((-(-len(ball) // STRIDE), 10))
    contact[0, row - 1] = mate
    return moved(ball, robots, kicks=[(9, row)], contact=contact, **told)


# passes


@pytest.mark.parametrize(
    ("to", "far", "passes"), [(HOME_2, 2.0, 1), (HOME_2, 0.3, 0), (AWAY_1, 2.0, 0)]
)
def test_pass_goes_to_a_mate_over_half_a_metre(to, far, passes):
    ball = np.concatenate((np.tile((0.0, 0.0), (10, 1)), rolling((0, 0), (far, 0), 20)))
    report = moved(ball, {HOME_1: (-REACH, 0, 0), to: (far + REACH, 0, 0)})
    assert (report["home"]["passes"], report["away"]["passes"]) == (passes, 0)


def test_stoppage_between_two_mates_makes_it_no_pass():
    ball = np.concatenate((np.tile((0.0, 0.0), (10, 1)), rolling((0, 0), (2, 0), 20)))
    phase = ["play"] * 8 + ["stop"] * 2 + ["play"] * 5
    report = moved(ball, {HOME_1: (-REACH, 0, 0), HOME_2: (2 + REACH, 0, 0)}, phase=phase)
    assert report["home"]["passes"] == 0


# shots: the field is 22 m long, the goal 2.4 m wide


@pytest.mark.parametrize(
    ("velocity", "shots", "on_goal"),
    [
        ((10.0, 0.0), 1, 1),
        ((10.0, 2.1), 1, 1),  # crosses at 1.05 m
        ((10.0, 2.3), 1, 0),  # at 1.15 m: the ball would hit the post
        ((10.0, 4.2), 1, 0),  # at 2.1 m
        ((10.0, 4.6), 0, 0),  # at 2.3 m, more than a metre beside the post
        ((1.5, 0.0), 0, 0),  # would not get there
        ((-10.0, 0.0), 0, 0),
    ],
)
def test_shot_is_a_kick_that_would_roll_over_the_goal_line_near_the_goal(velocity, shots, on_goal):
    report = kicked((6.0, 0.0), velocity)
    assert (report["home"]["shots"], report["home"]["on_goal"]) == (shots, on_goal)
    assert report["home"]["kicks"] == 1
    if shots:
        (shot,) = report["shots"]
        assert (shot["side"], shot["robot"], shot["on_goal"]) == ("home", "home-2", on_goal > 0)
        assert shot["speed"] == pytest.approx(np.hypot(*velocity), rel=1e-4)
        assert shot["time"] == pytest.approx(9 / RECORD_HZ)


def test_teams_shoot_at_the_ends_they_play_to():
    for direction, side, towards in ((1, "home", 1), (1, "away", -1), (-1, "home", -1)):
        right = kicked((6.0 * towards, 0.0), (10.0 * towards, 0.0), side=side, direction=direction)
        wrong = kicked((6.0 * towards, 0.0), (10.0 * towards, 0.0), side=side, direction=-direction)
        assert (right[side]["shots"], wrong[side]["shots"]) == (1, 0)


def test_kick_from_which_no_goal_counts_is_no_shot():
    assert kicked((-1.0, 0.0), (10.0, 0.0))["home"]["shots"] == 0  # from the own half
    assert kicked((6.0, 0.0), (10.0, 0.0), mate=False)["home"]["shots"] == 0  # the first to touch
    free = ("match.rules=friendly",)
    assert kicked((-1.0, 0.0), (10.0, 0.0), settings=free)["home"]["shots"] == 1
    assert kicked((6.0, 0.0), (10.0, 0.0), mate=False, settings=free)["home"]["shots"] == 1


def test_penalty_is_a_shot():
    phase = ["penalty"] * 6 + ["play"] * 14
    whose = [0] * 6 + [-1] * 14
    report = kicked((7.4, 0.0), (10.0, 0.0), mate=False, phase=phase, whose=whose)
    assert (report["home"]["shots"], report["home"]["restarts"]) == (1, {"penalty": 1})


def test_kick_that_a_mate_gets_is_a_pass_and_no_shot():
    mate = kicked((6.0, 0.0), (10.0, 0.0), robots={HOME_1: (8.0, 0.3, 0.0)})
    keeper = kicked((6.0, 0.0), (10.0, 0.0), robots={AWAY_1: (8.0, 0.3, 0.0)})
    assert (mate["home"]["passes"], mate["home"]["shots"]) == (1, 0)
    assert (keeper["home"]["passes"], keeper["home"]["shots"]) == (0, 1)


# possession, restarts, distances


def test_possession_goes_to_who_touched_the_ball_last():
    ball = np.concatenate((rolling((3, 0), (0, 0), 30), rolling((0, 0), (3, 0), 30)))
    report = moved(np.concatenate((ball, ball[-1:].repeat(40, axis=0))), {
        HOME_1: (-REACH, 0, 0), AWAY_1: (3 + REACH, 0, 0),
    })  # fmt: skip
    assert report["away"]["possession"] == pytest.approx(0.7, abs=0.02)
    assert report["home"]["possession"] + report["away"]["possession"] == pytest.approx(1)


def test_ball_that_nobody_touches_is_nobodys():
    report = moved(np.zeros((10, 2)), {})
    assert (report["home"]["possession"], report["away"]["possession"]) == (None, None)


def test_restarts_are_counted_for_each_side_also_when_taken_again():
    given = [("play", -1), ("throw_in", 0), ("throw_in", 0), ("play", -1), ("stop", 1)]
    given += [("throw_in", 1), ("stop", 1), ("throw_in", 1), ("dropped_ball", -1), ("play", -1)]
    phase, whose = zip(*given, strict=True)
    report = moved(np.zeros((20, 2)), {}, phase=phase, whose=whose)
    assert report["home"]["restarts"] == {"throw_in": 1}
    assert report["away"]["restarts"] == {"throw_in": 2}
    assert report["dropped_balls"] == 1
    assert report["in_play"] == pytest.approx(0.3)


def test_robot_that_is_carried_has_not_driven():
    ways = still(101)
    ways[:, 0, 0] = np.linspace(0, 3, 101)
    ways[50:, 0, 1] = 4.0
    report = match_report(tape(ways, np.zeros((101, 2))))
    assert report["home"]["distance"]["home-1"] == pytest.approx(3 * 99 / 100)
    assert sum(report["away"]["distance"].values()) == 0


def test_goals_are_the_referees():
    goal = event(0.1, "goal", "home", "goal by home-4 for home, 1:0")
    events = [event(0.0, "kick_off", "home", "kick-off of home"), goal]
    report = moved(np.zeros((10, 2)), {}, events=events)
    assert report["goals"] == [goal]
    assert report["events"] == {"kick_off": 1, "goal": 1}


# the document


def test_report_of_a_match_that_never_began():
    report = match_report(tape(np.zeros((0, 10, 3)), np.zeros((0, 2))))
    assert report["ball"] == {"mean": 0.0, "top": 0.0}
    assert (report["in_play"], report["home"]["kicks"]) == (0.0, 0)


def test_summary_says_it_in_a_few_lines():
    goal = event(0.1, "goal", "home", "goal by home-2 for home, 1:0")
    report = kicked((6.0, 0.0), (10.0, 0.0), events=[goal], match={"score": [1, 0]})
    lines = summary(report)
    said = [line.split() for line in lines]
    assert said[0] == ["roles", "1", ":", "0", "chaser"]
    assert ["possession", "100", "%", "0", "%"] in said
    assert ["shots", "(on", "goal)", "1", "(1)", "0", "(0)"] in said
    assert ["in", "play", "100", "%", "of", "1", "s"] in said
    assert all(len(line) < 100 for line in lines)
    unplayed = summary(match_report(tape(np.zeros((0, 10, 3)), np.zeros((0, 2)))))
    assert ["possession", "-", "-"] in [line.split() for line in unplayed]


def test_report_is_plain_json():
    report = kicked((6.0, 0.0), (10.0, 0.0))
    assert json.loads(json.dumps(report, allow_nan=False)) == report


def test_page_tells_every_key_of_the_report():
    report = kicked((6.0, 0.0), (10.0, 0.0))
    assert set(rows(PAGE, "What a match came to")) == {*report, *report["home"]}


def test_page_tells_every_array_of_a_match_with_its_shape():
    told = rows(PAGE, "The arrays of a match")
    assert list(told) == list(MATCH) == list(ROWS)
    letters = {"R": -1}
    for key, (shape, kind, *_) in told.items():
        first, *row = re.findall(r"\w+", shape)
        assert first == "D"
        assert tuple(letters.get(n) or int(n) for n in row) == ROWS[key][1], key
        stored = np.float32 if key in STEPS else ROWS[key][0]
        assert np.dtype(stored) == kind, key
    phases = re.findall(r"\d ([a-z -]+)[,.]", told["phase"][-1])
    assert [name.replace(" ", "_").replace("-", "_") for name in phases] == list(PHASES)


def test_page_tells_the_meta_document_of_a_match():
    told = rows(PAGE, "The meta document of a match")
    match = tape(still(2), np.zeros((2, 2))).match
    said = Event(0, 0.0, "goal", "", 0.0, 0.0, (), None, "").document()
    assert set(told) == {*match, *said}
    fault = TeamFault("home", "init", 0, "").document()
    assert all(f"`{key}`" in told["faults"][0] for key in fault)


@pytest.mark.parametrize(
    ("strategy", "name"),
    [
        ("roles", "roles"),
        ("strategies/press.py", "press"),
        ("/home/me/surabaya/strategy.py", "surabaya"),
        (r"C:\teams\surabaya\strategy.py", "surabaya"),
        ("C:/teams/press.py:High", "press:High"),
        ("press.py:Press", "press"),
        ("surabaya/strategy.py:Strategy", "surabaya"),
        ("package.press:Team", "press"),
        ("package.press", "press"),
    ],
)
def test_team_is_called_by_the_last_word_that_tells_something(strategy, name):
    assert team_name(strategy) == name
