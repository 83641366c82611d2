"""The speed of a match that reports tell."""

from soccersim.match import pace
from soccersim.match.pace import Pace


def test_what_is_loaded_before_the_second_decision_does_not_make_a_match_slow(monkeypatch):
    clock = iter([100.0, 101.5])  # s, at the second decision and at the end
    monkeypatch.setattr(pace, "perf_counter", lambda: next(clock))
    match = Pace(duration=60.0)
    for decision in range(1500):
        match(decision / 1500)
    assert match.factor(played=60.0) == (60.0 - 0.04) / 1.5


def test_a_match_that_ends_at_once_has_no_speed():
    match = Pace(duration=60.0)
    match(0.0)
    assert match.factor(played=0.04) == 0.0
