"""Phases stand in one table, and every phase leads on."""

import pytest
from whistle import Rig, scenario

from soccersim.referee.phases import RESTARTS, RULES, TRANSITIONS, Cue, Phase
from soccersim.sheet import PHASES


def test_teams_are_told_the_phases_of_the_table():
    assert tuple(Phase) == PHASES
    assert set(TRANSITIONS) == set(Phase)


def test_every_phase_can_be_reached_and_leads_to_the_end():
    reached, ends = {Phase.STOP}, {Phase.OVER}
    for _ in Phase:
        reached |= {to for phase in reached for to in TRANSITIONS[phase].values()}
        ends |= {phase for phase in Phase if ends & set(TRANSITIONS[phase].values())}
    assert reached == ends == set(Phase)


def test_every_restart_has_its_signal_and_its_rule():
    assert {Cue(phase.value) for phase in RESTARTS} <= set(TRANSITIONS[Phase.STOP])
    assert set(RULES) == set(RESTARTS)


def test_a_match_of_teams_that_do_nothing_goes_on_to_its_end():
    rig = Rig().run(600.1)
    assert rig.phase is Phase.OVER
    assert rig.kinds[-1] == "end"
    assert rig.kinds.count("half_time") == 1
    most = {Phase.STOP: 2.0, Phase.KICK_OFF: 8.0, Phase.DROPPED_BALL: 5.0, Phase.PLAY: 10.0}
    for phase, started, seconds in rig.stretches():
        assert seconds <= (7.0 if started and phase is not Phase.PLAY else most.get(phase, 0)) + 2.1
    assert rig.referee.score == (0, 0)


@pytest.mark.parametrize("name", ["msl-match", "krsbi-match", "friendly-match"])
def test_a_bundled_match_begins_with_homes_kick_off_and_then_aways(name):
    rig = Rig(scenario(name))
    rig.run(rig.scenario.duration)
    kick_offs = [event for event in rig.events if event.kind == "kick_off"]
    assert [event.side for event in kick_offs] == ["home", "away"]
    assert kick_offs[0].tick == 0
    half = rig.scenario.duration / 2
    assert kick_offs[1].time == pytest.approx(half + rig.referee.rules.stop_time, abs=0.1)


def test_an_event_tells_when_where_who_and_by_which_rule():
    rig = Rig().playing().roll(1.0, 7.3)
    event = rig.run(0.1).event("out")
    assert event.document() == {
        "tick": event.tick,
        "time": event.tick / 100,
        "kind": "out",
        "rule": "Law 9: ball out of play",
        "place": [1.0, pytest.approx(7.3, abs=0.2)],
        "robots": ["home-4"],
        "side": "home",
        "text": "over the touch line, last touched by home-4",
    }
