"""Counts of pairs, Elo and error bars: published numbers, and finite for whatever was counted."""

from math import isfinite, log

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim.regress.statistics import (
    ELO_PER_SPREAD,
    elo_of_score,
    expected_score,
    games_needed,
    likelihood_of_superiority,
    logistic_elo,
    moments,
    normalized_elo,
    normalized_elo_of_matches,
    wald_bounds,
)

counts = st.lists(st.integers(0, 10**9) | st.just(0), min_size=5, max_size=5)
SEVERAL = [10789, 19328, 33806, 19402, 10543]  # of a chess engine's test


def test_the_published_elo():
    assert moments([13, 37, 50, 25, 3]).mean == pytest.approx(0.4375, abs=1e-12)
    assert normalized_elo([13, 37, 50, 25, 3]) == pytest.approx(-63.97, abs=5e-3)
    elo = logistic_elo(SEVERAL)
    assert elo.value == pytest.approx(-0.774, abs=5e-4)
    assert (elo.high - elo.low) / 2 == pytest.approx(1.278, abs=5e-4)


def test_an_elo_difference_of_400_is_ten_points_to_one():
    assert expected_score(400) == pytest.approx(10 / 11)
    assert expected_score(0) == 0.5
    assert elo_of_score(10 / 11) == pytest.approx(400)


def test_normalized_elo_is_the_logistic_one_of_matches_without_draws_near_zero():
    assert pytest.approx(347.4356, abs=5e-5) == ELO_PER_SPREAD
    assert normalized_elo_of_matches(0.501, 0.25) == pytest.approx(elo_of_score(0.501), rel=1e-5)


def test_pairs_of_two_independent_matches_have_the_normalized_elo_of_their_matches():
    won, drawn, lost = 0.4, 0.35, 0.25
    pair = np.convolve(np.convolve([lost, drawn, won], [1]), [lost, drawn, won]) * 1e6
    mean = won + drawn / 2
    variance = won + drawn / 4 - mean**2
    assert normalized_elo(pair) == pytest.approx(normalized_elo_of_matches(mean, variance))


def test_walds_bounds():
    assert wald_bounds(0.05, 0.05) == pytest.approx((-2.9444, 2.9444), abs=5e-5)
    assert wald_bounds(0.01, 0.2) == pytest.approx((log(0.2 / 0.99), log(0.8 / 0.01)))


@pytest.mark.parametrize(
    ("width", "ends", "worst"),
    [(5, 25.6e3, 41.9e3), (10, 6.4e3, 10.5e3), (20, 1.6e3, 2.6e3), (50, 256, 419), (100, 64, 105)],
)
def test_games_needed(width, ends, worst):
    needed = games_needed(width)
    assert needed.at_the_ends == pytest.approx(ends, rel=6e-3)
    assert needed.halfway == pytest.approx(worst, rel=7e-3)


def test_superiority_is_even_between_equals_and_nearly_sure_after_many_wins():
    assert likelihood_of_superiority([5, 8, 20, 8, 5]) == pytest.approx(0.5)
    assert likelihood_of_superiority([0, 2, 20, 30, 8]) > 0.999
    # 0.774 Elo down with a standard error of 1.278 / 1.96
    assert likelihood_of_superiority(SEVERAL) == pytest.approx(0.1177, abs=1e-3)


@given(counts)
def test_every_vector_of_counts_gives_finite_numbers(n):
    numbers = [*logistic_elo(n), float(normalized_elo(n)), likelihood_of_superiority(n)]
    assert all(map(isfinite, numbers))
    assert logistic_elo(n).low <= logistic_elo(n).value <= logistic_elo(n).high


@given(counts)
def test_teams_exchanged_is_the_sign_exchanged(n):
    size = sum(n) + 1
    assert normalized_elo(n[::-1]) == pytest.approx(-normalized_elo(n), rel=1e-6, abs=1e-6 * size)
    assert logistic_elo(n[::-1]).value == pytest.approx(-logistic_elo(n).value, abs=1e-6)
