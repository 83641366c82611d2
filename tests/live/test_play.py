"""What people may do on the field, without any browser."""

import math

import numpy as np
import pytest
from steering import body, say, seconds

from soccersim import Simulation, load_scenario
from soccersim.live.catalogue import play_of
from soccersim.live.frame import HEAD, Framer
from soccersim.live.messages import Wrong


def test_a_robot_goes_where_it_is_sent_and_says_so(play):
    say(play, '{"do":"go","robot":0,"x":-1,"y":1,"heading":1.57}')
    seconds(play, 5)
    x, y, heading = body(play, 0)[:3]
    assert math.hypot(x + 1, y - 1) < 0.05
    assert heading == pytest.approx(1.57, abs=0.1)
    x, y, heading = play.simulation.machine.estimate.pose[0]
    assert math.hypot(x + 1, y - 1) < 0.01
    assert heading == pytest.approx(1.57, abs=0.02)
    assert any("idris there after" in event["text"] for event in play.news)


def test_without_a_heading_it_keeps_its_own(play):
    say(play, '{"do":"go","robot":0,"x":-1,"y":1}')
    seconds(play, 4)
    assert body(play, 0)[2] == pytest.approx(0, abs=0.05)


def test_a_halted_robot_stands_and_goes_on_when_it_is_sent(play):
    seconds(play, 0.5)
    say(play, '{"do":"halt","robot":0}')
    seconds(play, 1.5)
    where = body(play, 0)[:2].copy()
    seconds(play, 1)
    assert np.abs(body(play, 0)[:2] - where).max() < 0.01
    say(play, '{"do":"go","robot":0,"x":-1,"y":0}')
    seconds(play, 3)
    assert abs(body(play, 0)[0] + 1) < 0.05


def test_who_is_driven_stops_when_nobody_says_it_again(play):
    seconds(play, 4)
    say(play, '{"do":"drive","robot":0,"vx":-1,"vy":0,"omega":0}')
    seconds(play, 0.3)
    assert body(play, 0)[3] < -0.5
    seconds(play, 2)
    assert abs(body(play, 0)[3]) < 0.02


def test_a_driven_robot_keeps_to_its_limits(play):
    seconds(play, 4)
    say(play, '{"do":"drive","robot":2,"vx":15,"vy":15,"omega":20}')
    seconds(play, 0.2)
    limits = play.scenario.robots[2].model.control.limits
    vx, vy, omega = play.simulation.machine.command.twist[2]
    assert math.hypot(vx, vy) <= limits.speed + 1e-9
    assert omega <= limits.turn_rate


def test_a_robot_kicks_the_ball_that_is_put_into_its_mouth(play):
    seconds(play, 4)
    ahead = play.simulation.machine.handling.ahead[1]
    x, y = body(play, 1)[:2].tolist()
    say(play, f'{{"do":"ball","x":{x + ahead + 0.01},"y":{y}}}')
    say(play, '{"do":"kick","robot":1,"speed":6}')
    seconds(play, 0.1)
    assert body(play, 4)[3] > 4


def test_a_kick_without_a_ball_is_forgotten_after_a_second(play):
    say(play, '{"do":"kick","robot":1,"speed":6}')
    assert play.simulation.machine.command.kick[1] == 6
    seconds(play, 1.2)
    assert play.simulation.machine.command.kick[1] == 0


def test_the_ball_rolls_as_it_is_thrown(play):
    say(play, '{"do":"ball","x":1,"y":2,"vx":2}')
    seconds(play, 0.5)
    x, y = body(play, 4)[:2]
    assert 1.4 < x < 2.1
    assert y == pytest.approx(2, abs=1e-6)


def test_a_pushed_robot_is_carried_off_and_stands_again(play):
    seconds(play, 6)
    say(play, '{"do":"push","robot":0,"fx":0,"fy":150}')
    seconds(play, 0.3)
    away = body(play, 0)[1]
    assert away > 0.05
    assert (play.simulation.machine.truth.push[0] == 0).all()
    seconds(play, 3)
    assert np.hypot(*body(play, 0)[3:5]) < 0.02


def test_gains_change_how_it_moves(play):
    seconds(play, 6)
    say(play, '{"do":"gains","robot":1,"loop":"position","kp":0,"ki":0,"kd":0}')
    say(play, '{"do":"go","robot":1,"x":-1,"y":-1}')
    seconds(play, 2)
    assert body(play, 1)[0] == pytest.approx(-2.5, abs=0.05)
    assert play.told_gains()[1]["position"] == [0, 0, 0]
    say(play, '{"do":"gains","robot":1,"loop":"position","kp":3,"ki":0,"kd":0}')
    seconds(play, 4)
    assert math.hypot(body(play, 1)[0] + 1, body(play, 1)[1] + 1) < 0.2
    say(play, '{"do":"gains","robot":1,"loop":"wheel","kp":0,"ki":0}')
    assert play.told_gains()[1]["wheel"] == [0, 0]


def test_a_hand_that_pushes_a_robot_lets_go_when_it_is_sent_elsewhere():
    play = play_of(load_scenario("idris-table6"))
    seconds(play, 1)
    with pytest.raises(Wrong, match="hand"):
        say(play, '{"do":"push","robot":0,"fx":10,"fy":0}')
    say(play, '{"do":"go","robot":0,"x":0.5,"y":-0.5}')
    seconds(play, 4)
    assert math.hypot(body(play, 0)[0] - 0.5, body(play, 0)[1] + 0.5) < 0.1


@pytest.mark.parametrize("name", ["defender", "idris-table7", "four-wheel-path"])
def test_a_papers_run_is_that_of_the_papers(name):
    play, simulation = play_of(load_scenario(name)), Simulation(load_scenario(name))
    recording = simulation.run()
    while not play.digest:
        play.advance(7)
    assert play.digest == recording.digest
    seconds(play, 1)
    assert play.tick > simulation.tick
    assert any(event["kind"] == "end" for event in play.news)


def test_a_picture_holds_what_is_so(play):
    seconds(play, 1)
    framer = Framer(play)
    numbers = np.frombuffer(framer.packed({"paused": 1.0}), "<f8")
    layout = framer.layout()
    assert numbers[HEAD.index("tick")] == play.tick
    assert numbers[HEAD.index("paused")] == 1
    rows = numbers[len(HEAD) + len(layout["ball"]) :].reshape(4, -1)
    assert (rows[:, :6] == play.simulation.machine.truth.body[:4]).all()
    wheel = rows[1, len(layout["robot"]) :][: len(layout["wheel"])]
    assert wheel[0] == play.simulation.machine.readings.counts[1, 0]
    assert rows[0, layout["robot"].index("tx")] == pytest.approx(-1)


def test_nothing_is_kept_of_a_long_time(play, match):
    for each in (play, match):
        seconds(each, 12, piece=100)
        assert not each.simulation._pieces
        log = getattr(each, "game", None)
        assert not log or not (log.log.events or any(log.log.rows.values()))
