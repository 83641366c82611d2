"""The same match turned by half a turn is ruled the same, to the last bit of every place."""

from math import cos, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from walk import Walk
from whistle import Rig, scenario

CHANGES = {"duration": 16.0}
FAILURES = {"failures": [{"robot": "home-2", "time": 5.0}, {"robot": "away-4", "time": 6.0}]}


def turned(place):
    return tuple(-value for value in place)


class Pair:
    """A match, and the same with home beginning at the other end, wandering alike."""

    def __init__(self, name, seed, polite, **rules):
        self.rigs, self.walks = [], []
        for side, swap in ((1.0, False), (-1.0, True)):
            match = {**FAILURES, "swap_ends": swap}
            rig = Rig(scenario(name, CHANGES, match, **rules))
            self.rigs.append(rig)
            self.walks.append(Walk(rig, seed, side, polite=polite))

    def step(self):
        for rig, walk in zip(self.rigs, self.walks, strict=True):
            rig.step(walk)
        if (self.rigs[0].tick - 1) % self.rigs[0].every == 0:
            self.compare()

    def compare(self):
        one, two = self.rigs
        assert (one.phase, one.referee.whose, one.referee.started) == (
            two.phase,
            two.referee.whose,
            two.referee.started,
        )
        assert one.referee.score == two.referee.score
        assert tuple(one.referee.direction) == turned(two.referee.direction)
        a, b = one.ruling, two.ruling
        assert (a.halted, a.out) == (b.halted, b.out)
        assert (a.ball and turned(a.ball)) == b.ball
        assert list(a.robots) == list(b.robots)
        for (x, y, turn), (x2, y2, turn2) in zip(a.robots.values(), b.robots.values(), strict=True):
            assert (x, y) == (-x2, -y2)
            assert (cos(turn), sin(turn)) == pytest.approx((-cos(turn2), -sin(turn2)), abs=1e-12)
        for event, other in zip(a.events, b.events, strict=True):
            assert (event.x, event.y) == (-other.x, -other.y)
            for key in ("kind", "rule", "robots", "side", "text"):
                assert getattr(event, key) == getattr(other, key)


@settings(max_examples=6)
@given(
    seed=st.integers(0, 10**6),
    name=st.sampled_from(["msl-match", "friendly-match"]),
    restarts=st.sampled_from(["drive", "place"]),
    polite=st.booleans(),
)
def test_a_turned_match_is_ruled_alike(seed, name, restarts, polite):
    pair = Pair(name, seed, polite, restarts=restarts, restart_time=3.0, kick_off_time=3.0)
    for _ in range(1610):
        pair.step()
    assert pair.rigs[0].kinds[-1] == "end"


@given(x=st.integers(-120, 120), y=st.integers(-80, 80))
def test_places_of_restarts_turn_with_the_field(x, y):
    ground = Rig().referee.ground
    x, y = x / 10, y / 10  # often where two spots are equally near
    for place in (
        ground.dropped,
        ground.free_kick,
        ground.goal_kick,
        ground.corner,
        ground.throw_in,
        ground.inside,
    ):
        if x != 0.0 and (y != 0.0 or place.__name__ not in ("corner", "throw_in")):
            assert place(-x, -y) == turned(place(x, y))


@pytest.mark.parametrize("slot", [0, 1])
def test_who_stands_exactly_on_the_balls_place_goes_towards_his_own_goal(slot):
    referee = Rig().referee
    referee.scene.look(0, Rig().body)
    row, ball = 5 * slot + 2, (1.0, 2.0)
    referee.scene.x, referee.scene.y = ball
    x, y = referee.room.find(row, ball, ball, lambda x, y: True)
    assert (x - 1.0) * referee.direction[slot] < -0.3
    assert y == 2.0
