"""Whatever robots and ball do, the match goes on by its rules."""

from math import hypot, isfinite

import pytest
from rig import Rig, scenario
from walk import Walk

from soccersim.referee.phases import Phase

KINDS = {
    *("kick_off", "throw_in", "goal_kick", "corner", "free_kick", "penalty", "dropped_ball"),
    *("start", "in_play", "half_time", "end", "out", "goal", "no_goal", "stuck"),
    *("pushing", "dribbling", "keeper", "area", "double_touch", "too_near"),
    *("sent_off", "left", "failed", "back", "carried", "placed"),
}
FAILURES = {
    "failures": [{"robot": "home-2", "time": 11.0}, {"robot": "away-3", "time": 35.0, "seconds": 50}]
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
                most = rules.stop_time
            else:
                most = rules.play_time if started else late
            if phase not in (Phase.PLAY, Phase.OVER):
                assert seconds <= most + 2 * self.every / self.hz + 1e-9, (phase, started)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("name", ["msl-match", "krsbi-match", "friendly-match"])
def test_a_match_of_wanderers_goes_on_by_its_rules(name, seed):
    place = {"restarts": "place"} if seed % 3 == 2 else {}
    written = scenario(name, {"duration": 120.0}, FAILURES, **place)
    rig = Checked(written)
    rig.run(120.1, Walk(rig, seed, halts=seed % 2 == 0))
    assert rig.phase is Phase.OVER
    rig.is_in_time()
    assert rig.kinds.count("in_play") >= 2
    assert rig.kinds.count("failed") == 2


def test_wanderers_meet_nearly_every_rule():
    met = set()
    for seed in range(4):
        rig = Rig(scenario("msl-match", {"duration": 300.0}, FAILURES))
        rig.run(300.1, Walk(rig, seed, halts=False))
        met |= set(rig.kinds)
    assert met >= KINDS - {"placed", "penalty"}
