"""Whatever robots and ball do, the match goes on by its rules."""

from math import hypot, isfinite

import pytest
from walk import Walk
from whistle import Rig, scenario

from soccersim.referee.phases import Phase

KINDS = {
    *("kick_off", "throw_in", "goal_kick", "corner", "free_kick", "penalty", "dropped_ball"),
    *("start", "in_play", "half_time", "end", "out", "goal", "no_goal", "stuck"),
    *("pushing", "dribbling", "keeper", "area", "double_touch", "too_near"),
    *("sent_off", "left", "failed", "back", "carried", "placed"),
}
MATCHES = ["msl-match", "krsbi-match", "friendly-match"]
FAILURES = {
    "failures": [
        {"robot": "home-2", "time": 11.0},
        {"robot": "away-3", "time": 35.0, "seconds": 50},
    ]
}


class Checked(Rig):
    """A rig that looks at every ruling."""

    def judge(self):
        before = self.referee.score
        super().judge()
        goals = [event for event in self.ruling.events if event.kind == "goal"]
        assert sum(self.referee.score) - sum(before) == len(goals)
        for event in self.ruling.events:
            assert event.kind in KINDS
            assert event.rule
            assert event.text
            assert event.tick == self.tick
            assert event.time == self.tick / self.hz
            assert isfinite(event.x)
            assert isfinite(event.y)
            assert set(event.robots) <= set(self.names)
        for row in self.ruling.robots:
            self.stands_free(row)
        if self.ruling.ball:
            for row, radius in enumerate(self.radius):
                assert self.far(self.names[row]) >= radius + 0.11

    def stands_free(self, row):
        x, y = self.body[row, :2]
        field, radius = self.scenario.field, self.radius[row]
        assert abs(x) <= field.half_length + field.border - radius
        assert abs(y) <= field.half_width + field.border - radius
        for other in range(len(self.names)):
            if other != row:
                dx, dy = self.body[other, :2] - (x, y)
                assert hypot(dx, dy) >= radius + self.radius[other]

    def is_in_time(self):
        rules = self.referee.rules
        late = max(rules.restart_time, rules.kick_off_time)
        for phase, started, seconds in self.stretches():
            if phase is Phase.STOP:
                most = 2 * rules.stop_time  # half-time may come in the middle
            else:
                most = rules.play_time if started else late
            if phase not in (Phase.PLAY, Phase.OVER):
                assert seconds <= most + 2 * self.every / self.hz + 1e-9, (phase, started)


def wander(name, seed, seconds):
    place = {"restarts": "place"} if seed % 3 == 2 else {}
    rig = Checked(scenario(name, {"duration": seconds}, FAILURES, **place))
    rig.run(seconds + 0.1, Walk(rig, seed, halts=seed % 2 == 0, polite=seed % 4 == 3))
    assert rig.phase is Phase.OVER
    rig.is_in_time()
    assert rig.kinds.count("failed") == 2


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", MATCHES)
def test_a_match_of_wanderers_goes_on_by_its_rules(name, seed):
    wander(name, seed, 60.0)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3, 20))
@pytest.mark.parametrize("name", MATCHES)
def test_many_long_matches_of_wanderers_do_too(name, seed):
    wander(name, seed, 300.0)


@pytest.mark.slow
def test_polite_wanderers_meet_most_rules():
    met = set()
    quick = {"stop_time": 0.2, "restart_time": 0.5, "kick_off_time": 0.5, "play_time": 0.5}
    for seed in range(4):
        rig = Rig(scenario("msl-match", {"duration": 300.0}, FAILURES, **quick, pushing=0.1))
        rig.run(300.1, Walk(rig, seed, polite=True))
        met |= set(rig.kinds)
    assert met >= {"goal", "no_goal", "out", "pushing", "dribbling", "area"}
    assert met >= {"throw_in", "goal_kick", "corner", "free_kick", "penalty", "dropped_ball"}
