"""When a run ends: at which marks the pairs are looked at, and what is clear enough."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from synthetic_matches import sums

from soccersim.regress.brownian import Walk
from soccersim.regress.effect import bounds_of
from soccersim.regress.rules import Fixed, Sprt, first_decided, tally


def judged(rule, x, by="goals"):
    x = np.array(x, dtype=float)
    return rule.judge(sums(x, rule.marks(len(x)), by)).tolist()


def test_the_defaults_are_the_documented_ones():
    rule = Sprt()
    assert (rule.low, rule.high, rule.alpha, rule.beta) == (-25, 25, 0.05, 0.05)
    assert (rule.every, rule.most) == (8, 400)
    assert rule.bounds == pytest.approx((-2.9444, 2.9444), abs=5e-5)


def test_marks_are_every_eight_pairs_and_the_last():
    assert Sprt().marks(7).tolist() == []
    assert Sprt().marks(23).tolist() == [8, 16]
    assert Sprt(most=20).marks(19).tolist() == [8, 16]
    assert Sprt(most=20).marks(99).tolist() == [8, 16, 20]
    assert Sprt(most=16).marks(99).tolist() == [8, 16]
    assert Sprt(most=5).marks(5).tolist() == [5]
    assert Fixed(30).marks(29).tolist() == []
    assert Fixed(30).marks(99).tolist() == [30]


def test_a_tally_leaves_out_void_pairs_and_counts_pair_scores():
    x = np.array([0.5, -0.25, 0.5, 0.0, 0.5])
    valid = np.array([True, True, False, True, True])
    sums = tally(x, valid, np.array([2, 3, 5]), results=True)
    assert sums.pairs.tolist() == [2, 2, 4]
    assert sums.total.tolist() == [0.25, 0.25, 0.75]
    assert sums.squares.tolist() == [0.3125, 0.3125, 0.5625]
    assert sums.unequal.tolist() == [2, 2, 3]
    assert sums.counts.tolist() == [[0, 1, 0, 0, 1], [0, 1, 0, 0, 1], [0, 1, 1, 0, 2]]


def test_no_verdict_before_eight_pairs_are_not_exactly_zero():
    seven = [3] * 7 + [0] * 393
    eight = [3] * 8 + [0] * 392
    for rule in (Sprt(-100, 100), Fixed(400)):
        assert not any(judged(rule, seven))
    assert first_decided(np.array(judged(Sprt(-100, 100), eight)))[1] == 1
    assert judged(Fixed(400), eight) == [1]
    assert judged(Fixed(400), [-v for v in eight]) == [-1]
    assert judged(Fixed(7), [3] * 7) == [0]
    assert judged(Fixed(8), [3] * 8) == [1]


def test_a_team_that_wins_every_pair_passes_and_one_that_loses_them_fails():
    for size, by in ((2, "goals"), (0.5, "results"), (0.25, "results")):
        assert 1 in judged(Sprt(), [size] * 48, by)
        assert -1 in judged(Sprt(), [-size] * 48, by)


def test_all_zero_is_never_clear():
    for by in ("goals", "results"):
        for rule in (Sprt(), Sprt(0, 50), Fixed(400)):
            assert not any(judged(rule, [0] * 400, by))


@given(st.lists(st.sampled_from([-3, -1, 0, 0, 1, 2, 3]), min_size=30, max_size=120))
def test_a_fixed_run_is_clear_when_its_interval_leaves_out_zero(x):
    clear = judged(Fixed(len(x)), x)[0]
    t = float(sums(np.array(x, dtype=float), np.array([len(x)]), "goals").effect[0])
    interval = Fixed(len(x)).estimate(t, len(x), 0.0, False)
    outside = (interval.low > 0) - (interval.high < 0)
    assert clear == (outside if np.count_nonzero(x) >= 8 else 0)


def test_the_first_decision_counts_whatever_comes_after():
    at, clear = first_decided(np.array([[0, -1, 1], [0, 0, 0], [1, 0, -1]]))
    assert at.tolist() == [1, 3, 0]
    assert clear.tolist() == [-1, 0, 1]
    at, clear = first_decided(np.zeros((2, 0), dtype=np.int64))
    assert (at.tolist(), clear.tolist()) == ([0, 0], [0, 0])


def test_the_last_look_spends_what_the_cap_takes_from_the_chances_of_error():
    rule = Sprt()
    lower, upper = rule.closing_bounds
    assert upper == pytest.approx(1.4115, abs=1e-3)
    assert lower == pytest.approx(-upper)
    bounds = bounds_of(rule.nelo, rule.alpha, rule.beta)
    drift = (bounds.t1 - bounds.t0) ** 2 / 2
    worse, better = (Walk(*rule.bounds, d, 2 * drift) for d in (-drift, drift))
    assert 1 - worse.ends_worse(400, upper) == pytest.approx(0.05)  # false PASS
    assert better.ends_worse(400, lower) == pytest.approx(0.05)  # false FAIL
    assert 1 - better.ends_worse(400, rule.bounds[1]) == pytest.approx(0.932, abs=1e-3)
    assert 1 - better.ends_worse(400, upper) == pytest.approx(0.939, abs=1e-3)
    assert Sprt(closing=False).closing_bounds == rule.bounds


@given(
    st.floats(-100, 100),
    st.floats(1, 100),
    st.floats(0.001, 0.49),
    st.floats(0.001, 0.49),
    st.integers(1, 10**5),
)
def test_closing_bounds_lie_between_the_bounds_and_never_near_zero(low, width, alpha, beta, most):
    rule = Sprt(low, low + width, alpha, beta, most=most)
    (lower, upper), (least, most_) = rule.closing_bounds, rule.bounds
    assert least <= lower < 0 < upper <= most_
    assert upper >= min(np.log(4) - 1e-12, most_)
    assert lower <= max(-np.log(4) + 1e-12, least)


def test_closing_bounds_hold_at_the_last_mark_alone():
    x = [1, -1] * 195 + [1] * 10  # the ratio climbs to 2.01 by the end
    ahead = judged(Sprt(), x)
    assert set(judged(Sprt(closing=False), x)) == {0}
    assert (ahead[-1], set(ahead[:-1])) == (1, {0})


def test_a_short_run_of_a_sequential_test_stays_open():
    assert judged(Sprt(most=8), [3] * 8) == [0]


@pytest.mark.parametrize(
    "wrong",
    [
        {"low": 5, "high": 5},
        {"low": 10, "high": 5},
        {"high": 201},
        {"low": float("nan")},
        {"alpha": 0},
        {"beta": 0.5},
        {"every": 0},
        {"most": 0},
    ],
)
def test_a_rule_that_cannot_be_is_refused(wrong):
    with pytest.raises(ValueError, match=r"Elo|alpha|pair"):
        Sprt(**wrong)


def test_a_fixed_run_needs_a_pair():
    with pytest.raises(ValueError, match="at least one pair"):
        Fixed(0)
