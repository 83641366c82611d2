"""How large the effect is: intervals that hold the truth, also after an early stop."""

from math import isfinite, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic_matches import WORLDS, ends, outcomes, play

from soccersim.regress.effect import after_fixed, after_stop, as_elo, bounds_of
from soccersim.regress.likelihood import WIDEST, effect, outcome_llr
from soccersim.regress.statistics import effect_of_elo, elo_of_effect, normalized_elo

PLAIN = bounds_of((-25, 25), 0.05, 0.05)


def test_goals_and_results_name_the_same_effect_in_elo():
    # results as outcomes about zero, and the published formula about the mean
    n = np.array([130, 370, 500, 250, 30])
    x = np.repeat(np.arange(5) / 4 - 0.5, n)
    t = float(effect(len(x), x.sum(), (x * x).sum()))
    assert as_elo(after_fixed(t, len(x)), results=True).value == pytest.approx(normalized_elo(n))
    assert as_elo(after_fixed(t, len(x)), results=False).value == pytest.approx(
        float(normalized_elo(n)), rel=0.04
    )


def test_the_interval_after_a_fixed_number_narrows_with_its_root():
    few, many = after_fixed(0.1, 100), after_fixed(0.1, 400)
    assert few.high - few.value == pytest.approx(1.96 / 10)
    assert many.high - many.value == pytest.approx(1.96 / 20)
    assert after_fixed(1.0, 8) == (1.0, pytest.approx(1 - 1.96 / sqrt(8)), 1.0)
    assert after_fixed(0.0, 0) == (0, -1, 1)


@settings(max_examples=40)
@given(
    st.floats(-1, 1),
    st.integers(0, 10**6),
    st.floats(-1e4, 1e4),
    st.floats(-WIDEST, WIDEST - 0.01),
    st.floats(0.01, 2 * WIDEST),
    st.booleans(),
)
def test_every_end_gives_a_finite_estimate(t, pairs, llr, low, width, results):
    bounds = bounds_of((low, min(low + width, WIDEST)), 0.05, 0.05, results)
    found = as_elo(after_stop(t, pairs, llr, bounds, 8), results)
    assert all(map(isfinite, found))
    assert found.low <= found.value + 1e-9
    assert found.value <= found.high + 1e-9


def test_a_team_that_wins_every_pair_alike_is_far_beyond_the_bound_it_met():
    met, beyond = (after_stop(t, 32, 3.25, PLAIN, 8).value for t in (0.5, 1.0))
    assert beyond > met + 0.4


def test_the_hypotheses_of_results_are_effects_about_zero_of_the_same_distribution():
    x = np.array([-0.5, 0.0, 0.25, 0.5, 0.5])
    about_mean, about_zero = x.mean() / x.std(), x.mean() / sqrt((x * x).mean())
    nelo = float(elo_of_effect(about_mean))
    assert bounds_of((0, nelo), 0.05, 0.05, results=True)[:2] == pytest.approx((0, about_zero))
    assert bounds_of((0, nelo), 0.05, 0.05)[:2] == pytest.approx((0, about_mean))


def test_teams_exchanged_is_the_sign_exchanged():
    for t, pairs in [(0.3, 80), (0.05, 400), (-0.2, 40), (1.0, 32)]:
        ratio = float(outcome_llr(pairs, t * pairs, pairs, (-25, 25)))
        there = after_stop(t, pairs, ratio, PLAIN, 8)
        back = after_stop(-t, pairs, -ratio, PLAIN, 8)
        assert there.value == pytest.approx(-back.value, abs=1e-9)
        assert there.low == pytest.approx(-back.high, abs=1e-9)


@pytest.mark.parametrize("nelo", [-25, 25])
def test_after_a_stop_the_estimate_is_not_flattered_and_its_interval_holds_the_truth(nelo):
    x = outcomes(play(WORLDS["lively"], nelo, "goals", 100, 400, seed=7).legs, "goals")
    pairs, _ = ends(x, "goals")
    truth = float(effect_of_elo(nelo))
    plain, found = [], []
    for run, taken in zip(x, pairs, strict=True):
        total, squares = run[:taken].sum(), (run[:taken] ** 2).sum()
        plain.append(float(effect(taken, total, squares)))
        ratio = float(outcome_llr(taken, total, squares, (-25, 25)))
        found.append(after_stop(plain[-1], int(taken), ratio, PLAIN, 8))
    values = np.array([estimate.value for estimate in found])
    assert abs(np.median(values) - truth) < 0.5 * abs(np.median(plain) - truth)
    assert 0.4 < (values > truth).mean() < 0.6
    assert np.mean([e.low <= truth <= e.high for e in found]) >= 0.95
