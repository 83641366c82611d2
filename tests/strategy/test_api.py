"""What a team is told: all of the sheet, unchangeable, and soon."""

import math
import subprocess
import sys
from dataclasses import FrozenInstanceError, fields, replace
from timeit import repeat

import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim import sheet as s
from soccersim.spec.load import load_scenario
from soccersim.spec.rules import Rules as RulesSpec
from soccersim.strategy import (
    Ball,
    Body,
    Command,
    Opponent,
    Phase,
    Pitch,
    Player,
    Rules,
    Strategy,
    View,
)
from soccersim.strategy.api import view_of

numbers = st.floats(-100, 100)
ages = st.floats(0, 5)
players = st.builds(
    Player,
    st.integers(0, 99),
    numbers,
    numbers,
    numbers,
    numbers,
    numbers,
    numbers,
    st.booleans(),
    st.sampled_from(["keeper", "field"]),
    st.booleans(),
    ages,
)
views = st.builds(
    View,
    robots=st.lists(players, min_size=1, max_size=6).map(tuple),
    ball=st.none() | st.builds(Ball, numbers, numbers, numbers, numbers, ages),
    opponents=st.lists(
        st.builds(Opponent, numbers, numbers, numbers, numbers, ages), max_size=6
    ).map(tuple),
    field=st.just(Pitch()),
    phase=st.sampled_from(Phase),
    ours=st.sampled_from([True, False, None]),
    started=st.booleans(),
    time=ages,
    time_left=ages,
    half=st.sampled_from([1, 2]),
    score=st.tuples(st.integers(0, 50), st.integers(0, 50)),
)


def sheet_of(view, opponents=8):
    """The sheet that tells a view, filled by the places that soccersim.sheet names."""
    sheet = [0.0] * s.sheet_size(len(view.robots), opponents)
    sheet[s.TIME], sheet[s.LEFT], sheet[s.HALF] = view.time, view.time_left, view.half
    sheet[s.PHASE] = s.PHASES.index(view.phase)
    sheet[s.WHOSE] = {True: 1.0, False: 0.0, None: -1.0}[view.ours]
    sheet[s.STARTED] = float(view.started)
    sheet[s.GOALS : s.GOALS + 2] = map(float, view.score)
    if view.ball:
        b = view.ball
        sheet[s.BALL_KNOWN] = 1.0
        sheet[s.BALL : s.BALL + 5] = b.x, b.y, b.vx, b.vy, b.age
    at = s.HEADER
    for p in view.robots:
        told = (p.in_play, p.number, p.role == "keeper", p.x, p.y, p.heading, p.vx, p.vy, p.omega)
        sheet[at : at + s.ROBOT] = map(float, (*told, p.has_ball, p.age))
        at += s.ROBOT
    sheet[s.OPPONENTS_KNOWN] = len(view.opponents)
    for o in view.opponents:
        sheet[at : at + s.OPPONENT] = o.x, o.y, o.vx, o.vy, o.age
        at += s.OPPONENT
    return sheet


@given(view=views)
def test_a_view_tells_all_that_its_sheet_says(view):
    pitch = Pitch(bodies=(Body(),) * len(view.robots))
    assert view_of(sheet_of(view), pitch) == replace(view, field=pitch)


def test_every_robot_has_the_body_of_its_place():
    bodies = Body(radius=0.2), Body(radius=0.3)
    view = View(robots=(Player(1, 0, 0), Player(2, 0, 0)))
    seen = view_of(sheet_of(view), Pitch(bodies=bodies))
    assert [robot.body.radius for robot in seen.robots] == [0.2, 0.3]


def test_phases_are_those_of_the_sheet_and_of_the_referee():
    from soccersim.referee import phases

    assert [phase.value for phase in Phase] == list(s.PHASES) == [p.value for p in phases.Phase]
    assert Phase.KICK_OFF == "kick_off"


def test_rules_are_told_under_the_scenarios_names_and_default_to_the_leagues():
    told = [field.name for field in fields(Rules)]
    league = load_scenario("msl-match").match.rules
    assert set(told) <= set(RulesSpec.model_fields)
    assert Rules() == Rules(**{name: getattr(league, name) for name in told})


def test_the_pitch_of_a_match_is_the_default_one():
    from soccersim.match.pitch import pitch_of

    pitch = pitch_of(load_scenario("msl-match"), 0)
    assert pitch.ball_sliding == pytest.approx(Pitch().ball_sliding, abs=0.01)
    default = Pitch(bodies=(Body(),) * 5, ball_sliding=pitch.ball_sliding)
    assert pitch == default


@pytest.mark.parametrize(
    "thing",
    [Player(1, 0, 0), Ball(0, 0), Opponent(0, 0), View(robots=()), Pitch(), Command(), Body()],
    ids=lambda thing: type(thing).__name__,
)
def test_nothing_in_a_view_can_be_changed(thing):
    name = fields(thing)[0].name
    with pytest.raises(FrozenInstanceError):
        setattr(thing, name, 5.0)
    with pytest.raises((FrozenInstanceError, TypeError, AttributeError)):
        thing.anything = 5.0


def test_robots_and_opponents_cannot_be_swapped_for_others():
    pitch = Pitch(bodies=(Body(),))
    view = view_of(sheet_of(View(robots=(Player(1, 0, 0),))), pitch)
    with pytest.raises(TypeError):
        view.robots[0] = Player(2, 0, 0)
    assert type(view.opponents) is tuple


def test_a_strategy_without_decide_cannot_be_made():
    class Lazy(Strategy):
        pass

    with pytest.raises(TypeError, match="decide"):
        Lazy(None)


def test_a_strategy_has_the_chance_it_is_given():
    class Mine(Strategy):
        def decide(self, view):
            return []

    assert Mine("dice").rng == "dice"


LIBRARIES = ("numpy", "numba", "pydantic", "pymunk", "yaml", "click", "pygame", "matplotlib")
IMPORTS = f"""
import sys
import soccersim.strategy.api, soccersim.strategy.check, soccersim.strategy.load
import soccersim.strategy.skills, soccersim.strategy.newcomer
print([name for name in {LIBRARIES!r} if name in sys.modules])
"""


def test_a_teams_process_needs_no_library():
    ended = subprocess.run(
        [sys.executable, "-c", IMPORTS], capture_output=True, text=True, check=True
    )
    assert ended.stdout.strip() == "[]"


@pytest.mark.benchmark
def test_views_and_commands_cost_microseconds():
    view = View(
        robots=tuple(Player(n, 0.5, 0.5) for n in range(5)),
        ball=Ball(0, 0),
        opponents=tuple(Opponent(0.5, 0.5) for _ in range(5)),
    )
    sheet, pitch = sheet_of(view), Pitch(bodies=(Body(),) * 5)
    assert min(repeat(lambda: view_of(sheet, pitch), number=500, repeat=9)) / 500 < 25e-6
    assert min(repeat(lambda: Command(1.0, 0.5, 0.2), number=5000, repeat=9)) / 5000 < 1e-6


def test_headings_are_as_they_were_told():
    view = View(robots=(Player(1, 0, 0, heading=math.pi),))
    assert view_of(sheet_of(view), Pitch(bodies=(Body(),))).robots[0].heading == math.pi
