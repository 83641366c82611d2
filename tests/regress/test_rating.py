"""Ratings of a tournament: what a closed formula gives, a second method, and honest error bars."""

from math import log, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.regress.rating import ELO, _derivatives, chances, ratings

results = st.sampled_from([(2, 0, 0), (1, 1, 0), (1, 0, 1), (0, 2, 0), (0, 1, 1), (0, 0, 2)])
NO_PRIOR = 1e-7


def league(true, draws, pairs, rng, alike=0.0):
    """Players and results of a round robin; in a share `alike` both legs have the same winner."""
    players, played = [], []
    for i in range(len(true)):
        for j in range(i):
            odds = chances(true[i] - true[j], draws)
            legs = rng.multinomial(1, odds, size=(pairs, 2))
            legs[:, 1] = np.where(rng.random((pairs, 1)) < alike, legs[:, 0], legs[:, 1])
            players += [(i, j)] * pairs
            played += list(legs.sum(axis=1))
    return np.array(players), np.array(played)


def by_iteration(teams, players, played, rounds=3000):
    """Davidson's own way to the best fit: strengths and nu in turns, from nothing but sums."""
    strength, nu = np.ones(teams), 1.0
    i, j = players.T
    score = np.bincount(i, played[:, 0] + played[:, 1] / 2, teams)
    score += np.bincount(j, played[:, 2] + played[:, 1] / 2, teams)
    for _ in range(rounds):
        root = np.sqrt(strength[i] * strength[j])
        per = played.sum(axis=1) / (strength[i] + strength[j] + nu * root)
        weight = np.bincount(i, per * (1 + nu / 2 * np.sqrt(strength[j] / strength[i])), teams)
        weight += np.bincount(j, per * (1 + nu / 2 * np.sqrt(strength[i] / strength[j])), teams)
        strength = score / weight
        strength /= np.exp(np.log(strength).mean())
        root = np.sqrt(strength[i] * strength[j])
        per = played.sum(axis=1) / (strength[i] + strength[j] + nu * root)
        nu = played[:, 1].sum() / (per * root).sum()
    return ELO * np.log(strength), nu


def test_two_teams_have_the_ratings_of_the_closed_formula():
    won, drawn, lost = 30, 12, 10
    rated = ratings(2, [[0, 1]], [[won, drawn, lost]], prior=NO_PRIOR)
    assert rated.elo[0] - rated.elo[1] == pytest.approx(400 * log(won / lost) / log(10), abs=1e-4)
    assert rated.draws == pytest.approx(drawn / sqrt(won * lost), abs=1e-6)
    assert rated.difference(0, 1)[0] == pytest.approx(rated.elo[0] - rated.elo[1])


def test_the_fit_gives_back_every_teams_score_and_all_draws():
    players, played = league(np.array([0.5, 0, -0.2, -0.6]), 0.8, 30, np.random.default_rng(1))
    rated = ratings(4, players, played, prior=NO_PRIOR)
    odds = chances((rated.elo[players[:, 0]] - rated.elo[players[:, 1]]) / ELO, rated.draws)
    for team in range(4):
        sign = (players[:, 0] == team).astype(float) - (players[:, 1] == team)
        assert sign @ (played[:, 0] - played[:, 2]) == pytest.approx(
            2 * sign @ (odds[:, 0] - odds[:, 2]), abs=1e-4
        )
    assert played[:, 1].sum() == pytest.approx(2 * odds[:, 1].sum(), abs=1e-4)


def test_newtons_method_and_davidsons_iteration_agree():
    players, played = league(np.array([1.0, 0.3, 0, -0.4, -0.9]), 0.6, 20, np.random.default_rng(2))
    rated = ratings(5, players, played, prior=NO_PRIOR)
    elo, nu = by_iteration(5, players, played)
    assert rated.elo == pytest.approx(elo, abs=1e-3)
    assert rated.draws == pytest.approx(nu, abs=1e-5)


def test_the_curvature_is_how_the_gradient_falls():
    players, played = league(np.array([0.9, 0, -0.7]), 0.6, 20, np.random.default_rng(8))
    at, step = np.array([0.8, 0.1, -0.5, -0.3]), 1e-5
    falls = [
        (gradient(at - e, players, played) - gradient(at + e, players, played)) / (2 * step)
        for e in step * np.eye(4)
    ]
    assert _derivatives(at, players, played, 1.0)[1] == pytest.approx(np.array(falls), abs=1e-5)


def gradient(fit, players, played):
    return _derivatives(fit, players, played, 1.0)[0].sum(axis=0)


def test_error_bars_agree_with_resampled_pairs():
    rng = np.random.default_rng(3)
    players, played = league(np.array([0.6, 0.1, -0.7]), 0.7, 60, rng, alike=0.6)
    rated = ratings(3, players, played)
    again = []
    for _ in range(300):
        drawn = rng.integers(len(played), size=len(played))
        again.append(ratings(3, players[drawn], played[drawn]).elo)
    assert rated.error == pytest.approx(1.96 * np.std(again, axis=0), rel=0.15)


def covered(alike, seed, tournaments):
    """How often the interval holds the true rating: four teams, 25 pairs each."""
    rng, held = np.random.default_rng(seed), []
    for _ in range(tournaments):
        true = rng.normal(0, 0.6, 4)
        true -= true.mean()
        rated = ratings(4, *league(true, 0.7, 25, rng, alike))
        held.append(np.abs(rated.elo - ELO * true) <= rated.error)
    return np.mean(held)


@pytest.mark.parametrize("alike", [0.0, 0.9])
def test_intervals_hold_the_truth_also_when_the_legs_of_a_pair_resemble_each_other(alike):
    assert 0.92 <= covered(alike, 4, 150) <= 0.98


@settings(max_examples=50)
@given(
    st.integers(1, 5),
    st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4), results), max_size=30),
    st.integers(1, 200),
)
def test_every_tournament_gives_finite_ratings(teams, pairs, times):
    kept = [pair for pair in pairs if pair[0] != pair[1] and max(pair[:2]) < teams] * times
    rated = ratings(teams, [pair[:2] for pair in kept], [pair[2] for pair in kept])
    numbers = [*rated.elo, *rated.error, rated.draws, *rated.covariance.ravel()]
    assert np.isfinite(numbers).all()
    assert rated.elo.sum() == pytest.approx(0, abs=1e-6)
    assert (rated.error >= 0).all()


def test_a_team_that_loses_all_is_last_and_one_that_never_played_is_uncertain():
    pairs = [(0, 1), (0, 2), (1, 2)] * 20
    rated = ratings(4, pairs, [(2, 0, 0)] * 60)
    assert rated.elo[0] > rated.elo[1] > rated.elo[2]
    assert rated.error[3] > 300


def test_the_order_in_which_pairs_are_given_tells_nothing():
    players, played = league(np.array([0.5, 0.0, -0.5]), 0.7, 10, np.random.default_rng(6))
    order = np.random.default_rng(7).permutation(len(played))
    one, other = ratings(3, players, played), ratings(3, players[order], played[order])
    turned = ratings(3, players[:, ::-1], played[:, ::-1])
    assert other.elo == pytest.approx(one.elo, abs=1e-6)
    assert turned.elo == pytest.approx(one.elo, abs=1e-6)
    assert turned.error == pytest.approx(one.error, abs=1e-6)


@given(st.floats(-40, 40), st.floats(1e-3, 1e3))
def test_chances_add_up_and_turn_with_the_sign(d, draws):
    won, drawn, lost = chances(d, draws)
    assert won + drawn + lost == pytest.approx(1)
    assert chances(-d, draws) == pytest.approx([lost, drawn, won])
    assert chances(400 / ELO, draws)[0] == pytest.approx(10 * chances(400 / ELO, draws)[2])
