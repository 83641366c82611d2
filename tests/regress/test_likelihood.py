"""Log-likelihood ratios: published numbers, second methods, and finite whatever was counted."""

from math import sqrt

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from soccersim.regress.likelihood import (
    WIDEST,
    _likeliest,
    closed_llr,
    effect,
    logistic_llr,
    normalized_llr,
    outcome_llr,
    tilted,
)
from soccersim.regress.statistics import SCORES, effect_of_elo, expected_score, regularized

counts = st.lists(st.integers(0, 10**9) | st.integers(0, 20), min_size=5, max_size=5)
some = st.lists(st.integers(1, 300), min_size=5, max_size=5)
nelo = st.floats(-WIDEST, WIDEST)
elo = st.floats(-1200, 1200)
SINGLE = np.eye(5) * np.array([1, 8, 400, 10**6])[:, None, None]


def test_the_published_ratios():
    assert normalized_llr([13, 37, 50, 25, 3], (0, 4)) == pytest.approx(-0.54912, abs=1e-5)
    assert closed_llr([13, 37, 50, 25, 3], (0, 4)) == pytest.approx(-0.54012, abs=1e-5)
    several = [10789, 19328, 33806, 19402, 10543]
    assert normalized_llr(several, (-3, 1)) == pytest.approx(0.30087, abs=1e-5)
    assert logistic_llr(several, (-3, 1)) == pytest.approx(2.131068, abs=1e-5)
    assert normalized_llr([0, 1, 5, 3, 0], (0, 10)) == pytest.approx(0.113724, abs=1e-5)
    assert logistic_llr([0, 1, 5, 3, 0], (0, 10)) == pytest.approx(0.226963, abs=1e-5)


@given(counts, nelo, nelo, elo, elo)
@example([0, 0, 0, 0, 0], -25.0, 25.0, 0.0, 5.0)
def test_every_vector_of_counts_gives_finite_ratios(n, nelo0, nelo1, elo0, elo1):
    assert np.isfinite(normalized_llr(n, (nelo0, nelo1)))
    assert np.isfinite(closed_llr(n, (nelo0, nelo1)))
    assert np.isfinite(logistic_llr(n, (elo0, elo1)))


@pytest.mark.parametrize("llr", [normalized_llr, closed_llr, logistic_llr])
def test_single_columns_speak_for_the_side_they_are_on(llr):
    ratios = llr(SINGLE, (-25, 25))  # (sizes, columns)
    assert np.isfinite(ratios).all()
    assert (ratios[:, :2] < 0).all()
    assert ratios[:, 2] == pytest.approx(0, abs=1e-6)
    assert (ratios[:, 3:] > 0).all()


def test_many_runs_at_once_are_each_as_alone():
    n = np.random.default_rng(1).integers(0, 40, size=(3, 4, 5))
    both = normalized_llr(n, (-25, 25))
    assert both.shape == (3, 4)
    alone = [[float(normalized_llr(counted, (-25, 25))) for counted in run] for run in n]
    assert both == pytest.approx(np.array(alone), abs=1e-9)


@given(some, st.floats(-400, 400))
def test_the_likeliest_distribution_has_the_mean_asked_for_and_no_other_is_likelier(n, hypothesis):
    shares = np.array(n) / sum(n)
    wanted = float(expected_score(hypothesis))
    q = tilted(shares, SCORES - wanted)
    assert q.sum() == pytest.approx(1)
    assert q @ SCORES == pytest.approx(wanted)
    rng = np.random.default_rng(0)
    aside = rng.normal(size=(50, 5))  # steps that keep the sum and the mean
    kept = np.linalg.qr(np.stack([np.ones(5), SCORES], axis=1))[0]
    aside -= aside @ kept @ kept.T
    others = q + aside * (0.5 * q.min() / np.abs(aside).max())
    assert (np.log(others) @ shares <= np.log(q) @ shares + 1e-12).all()


@given(some, st.floats(-60, 60))
def test_the_fixed_point_has_the_effect_asked_for_and_no_other_is_likelier(n, hypothesis):
    shares = np.array(n) / sum(n)
    t = float(effect_of_elo(hypothesis))
    q = _likeliest(shares, t)
    assert has_effect(q) == pytest.approx(t, abs=2e-3)  # ten rounds, 1e-9 for most counts
    best = np.log(q) @ shares
    for other in np.random.default_rng(0).dirichlet(50 * q + 0.1, size=5):
        assert np.log(with_effect(other, has_effect(q))) @ shares <= best + 1e-3


def has_effect(q):
    mean = q @ SCORES
    return (mean - 0.5) / sqrt(q @ (SCORES - mean) ** 2)


def with_effect(q, t):
    """q tilted exponentially until it has the effect t, by halving."""
    low, high = -60.0, 60.0
    for _ in range(60):
        tilt = 0.5 * (low + high)
        tried = q * np.exp(tilt * SCORES)
        tried = np.maximum(tried / tried.sum(), 1e-300)
        low, high = (tilt, high) if has_effect(tried) < t else (low, tilt)
    return tried


@given(some)
@example([1, 1, 118, 1, 1])
def test_near_the_hypotheses_the_formula_agrees_with_the_fixed_point(n):
    """They part in the fourth order of the effect: by t**4 / 8 a pair, times the kurtosis."""
    even = np.array(n) + np.array(n)[::-1]  # no effect at all
    shares, off, hypotheses = even / even.sum(), SCORES - 0.5, (-10, 20)
    kurtosis = shares @ off**4 / (shares @ off**2) ** 2
    apart = max(effect_of_elo(hypotheses)) ** 4 * kurtosis / 8 * even.sum()
    assert closed_llr(even, hypotheses) == pytest.approx(
        float(normalized_llr(even, hypotheses)), abs=apart
    )


@given(st.lists(st.integers(-9, 9), max_size=50), nelo, nelo)
def test_any_outcomes_give_finite_ratios_and_zeros_none(x, nelo0, nelo1):
    x = np.array(x, dtype=float)
    ratio = float(outcome_llr(len(x), x.sum(), (x * x).sum(), (nelo0, nelo1)))
    assert np.isfinite(ratio)
    assert -1 - 1e-12 <= effect(len(x), x.sum(), (x * x).sum()) <= 1 + 1e-12
    turned = float(outcome_llr(len(x), -x.sum(), (x * x).sum(), (-nelo0, -nelo1)))
    assert turned == pytest.approx(ratio, abs=1e-9)
    assert x.any() or ratio == 0


def test_the_outcome_ratio_is_the_written_formula():
    x = np.array([2.0, -1.0, 0.0, 3.0, 0.0, 1.0])
    t, (t0, t1) = x.mean() / sqrt((x * x).mean()), effect_of_elo([0, 50])
    written = 3 * np.log((1 + (t - t0) ** 2) / (1 + (t - t1) ** 2))
    assert outcome_llr(6, x.sum(), (x * x).sum(), (0, 50)) == pytest.approx(written)


def test_a_team_that_wins_every_pair_alike_gets_ever_clearer():
    pairs = np.arange(1, 100)
    assert (np.diff(outcome_llr(pairs, 2 * pairs, 4 * pairs, (-25, 25))) > 0).all()
    wins = np.stack([np.array([0, 0, 0, 0, n]) for n in pairs])
    assert (np.diff(normalized_llr(wins, (-25, 25))) > 0).all()
    assert normalized_llr(wins[-1], (-25, 25)) > 5 * closed_llr(
        wins[-1], (-25, 25)
    )  # which does not


def test_hypotheses_beyond_reach_are_refused():
    for llr in (normalized_llr, lambda n, both: outcome_llr(1, 1, 1, both)):
        with pytest.raises(ValueError, match="normalized Elo from -200 to 200"):
            llr([1, 2, 3, 4, 5], (0, 201))
        with pytest.raises(ValueError, match="normalized Elo"):
            llr([1, 2, 3, 4, 5], (float("nan"), 0))


def test_a_count_of_zero_counts_as_a_thousandth():
    assert regularized([0, 3, 0, 1, 0]).tolist() == [1e-3, 3, 1e-3, 1, 1e-3]
