"""What people may do in a match, without any browser."""

import math
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from steering import body, say, seconds

from soccersim import load_scenario
from soccersim.live.catalogue import Catalogue, play_of
from soccersim.live.match import seats_of
from soccersim.live.messages import Wrong
from soccersim.match.game import Game
from soccersim.referee.phases import Phase

BUTTONS = {
    "kick_off": Phase.KICK_OFF,
    "free_kick": Phase.FREE_KICK,
    "throw_in": Phase.THROW_IN,
    "goal_kick": Phase.GOAL_KICK,
    "corner": Phase.CORNER,
    "penalty": Phase.PENALTY,
}


def test_all_restarts_of_the_referee_box(match):
    referee = match.game.referee
    seconds(match, 0.1)
    for call, phase in BUTTONS.items():
        for slot, side in enumerate(("home", "away")):
            say(match, f'{{"do":"referee","call":"{call}","side":"{side}"}}')
            seconds(match, 0.1)
            assert (referee.phase, referee.whose) == (phase, slot)
            assert not referee.started
            say(match, '{"do":"referee","call":"start"}')
            seconds(match, 0.1)
            assert referee.started or referee.phase is Phase.PLAY
    say(match, '{"do":"referee","call":"dropped_ball"}')
    seconds(match, 0.1)
    assert referee.phase is Phase.DROPPED_BALL


def test_stop_holds_until_the_next_button(match):
    referee = match.game.referee
    say(match, '{"do":"referee","call":"stop"}')
    seconds(match, 12)
    assert referee.phase is Phase.STOP
    assert match.simulation.machine.orders.halted.all()
    say(match, '{"do":"referee","call":"start"}')
    seconds(match, 0.1)
    assert referee.started


def test_goal_repair_half_time_and_end(match):
    referee = match.game.referee
    say(match, '{"do":"referee","call":"goal","side":"away"}')
    seconds(match, 0.1)
    assert referee.score == (0, 1)
    say(match, '{"do":"referee","call":"subgoal","side":"away"}')
    seconds(match, 0.1)
    assert referee.score == (0, 0)
    with pytest.raises(Wrong, match="no goal to take back"):
        say(match, '{"do":"referee","call":"subgoal","side":"away"}')
    say(match, '{"do":"referee","call":"repair","robot":2}')
    seconds(match, 0.1)
    assert referee.in_play[2] == 0
    say(match, '{"do":"referee","call":"half_time"}')
    seconds(match, 0.1)
    assert (referee.half, referee.direction[0]) == (2, -1)
    with pytest.raises(Wrong, match="second half already"):
        say(match, '{"do":"referee","call":"half_time"}')
    say(match, '{"do":"referee","call":"end"}')
    seconds(match, 0.1)
    assert referee.phase is Phase.OVER
    with pytest.raises(Wrong, match="over"):
        say(match, '{"do":"referee","call":"start"}')


def test_buttons_that_lack_something_are_refused(match):
    for text, why in (
        ('{"do":"referee","call":"corner"}', "side"),
        ('{"do":"referee","call":"repair"}', "robot"),
    ):
        with pytest.raises(Wrong, match=why):
            say(match, text)


def test_a_robot_of_a_match_is_taken_over_and_given_back(match):
    for _ in range(3):
        say(match, '{"do":"referee","call":"kick_off","side":"home"}')
        say(match, '{"do":"referee","call":"start"}')
        seconds(match, 0.2)
    x, y = (body(match, 1)[:2] + np.array((-1.0, 0.6))).tolist()
    say(match, f'{{"do":"go","robot":1,"x":{x},"y":{y},"heading":0.5}}')
    seconds(match, 4)
    assert math.hypot(body(match, 1)[0] - x, body(match, 1)[1] - y) < 0.12
    assert match.labels()[1] == "by hand"
    say(match, '{"do":"release","robot":1}')
    seconds(match, 0.2)
    assert match.labels()[1] != "by hand"
    with pytest.raises(Wrong, match="obeys its team"):
        say(match, '{"do":"dribble","robot":1,"on":true}')


def test_a_match_nobody_touches_is_the_match(match):
    """The bodies after some seconds, however the time is cut into pieces."""
    seconds(match, 4, piece=7)
    match.advance(2000 - match.tick)
    with TemporaryDirectory() as folder:
        seats = seats_of(match.scenario, Path(folder))
        game = Game(match.scenario)
        game.play(seats, until=2000)
        for seat in seats:
            seat.close()
    assert (game.simulation.machine.truth.body == match.simulation.machine.truth.body).all()


def test_a_team_that_fails_ends_the_match_and_not_the_station(tmp_path):
    team = tmp_path / "bad.py"
    team.write_text(
        "class Bad:\n    def decide(self, view):\n        return 1 / (view.time < 0.5)\n"
    )
    play = Catalogue("friendly-match", home=str(team)).first()
    seconds(play, 1)
    assert play.over
    assert any("home forfeits" in event["text"] for event in play.news)
    play.close()


def test_a_match_ends_with_its_time_and_the_station_goes_on():
    settings = ["match.home.strategy=still", "match.away.strategy=still", "duration=1"]
    match = play_of(load_scenario("friendly-match", settings=settings))
    match.advance(800)
    assert match.tick == 500
    assert match.over
    assert match.game.referee.phase is Phase.OVER
    match.close()
