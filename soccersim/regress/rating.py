"""How strong the teams of a tournament are: ratings in Elo, with error bars.

The model is Bradley and Terry's with draws as Davidson has them (R. R. Davidson, J. Am. Stat.
Assoc. 65 (1970), 317): with d the difference of two ratings, won : drawn : lost is as e^(d/2) : nu
: e^(-d/2). Its likelihood is concave, so Newton's method finds the one best fit.

Our own, in a page, because the maintained libraries do something else: trueskill, openskill and
glicko follow players through time, so that the result hangs on the order of the matches, which
here only tells how fast the workers were; choix has no draws and brings scipy; BayesElo and Ordo
are not Python. None knows that the two legs of a pair share their seed: error bars from single
matches are wrong where the legs resemble each other (see `_covariance`).

Everything is finite, also for a team that lost every match or played none: each team has won and
lost one match more against a team of rating 0, and one match more was drawn and one decided.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from soccersim.regress.statistics import BAND, Array

ELO = 400 / np.log(10)  # per unit of d: ten wins to a loss are 400 Elo
ROUNDS = 100  # of Newton's method; 5 to 10 are usual
SETTLED = 1e-10  # gradient, in matches


class Ratings(NamedTuple):
    """Elo about the mean of the field."""

    elo: Array  # (T,)
    error: Array  # (T,) half of the 95 % interval of elo
    draws: float  # nu: between equals, drawn matches as a multiple of those either side wins
    covariance: Array  # (T, T) of elo

    def difference(self, first: int, second: int) -> tuple[float, float]:
        """How many Elo the first is above the second, and half of the 95 % interval."""
        one = np.zeros(len(self.elo))
        one[first] += 1.0
        one[second] -= 1.0
        reach = BAND * np.sqrt(one @ self.covariance @ one)
        return float(self.elo[first] - self.elo[second]), float(reach)


def ratings(teams: int, players: ArrayLike, results: ArrayLike, prior: float = 1.0) -> Ratings:
    """Ratings of so many teams from pairs of matches.

    players (P, 2): the two teams of each pair, as numbers from 0; results (P, 3): how many of its
    matches the first of them won, drew and lost. prior: weight of the matches that were not played.
    """
    who = np.asarray(players, dtype=np.int64).reshape(-1, 2)
    what = np.asarray(results, dtype=np.float64).reshape(-1, 3)
    fit = np.zeros(teams + 1)  # ratings, then ln nu
    for _ in range(ROUNDS):
        scores, curvature = _derivatives(fit, who, what, prior)
        gradient = scores.sum(axis=0)
        if np.abs(gradient).max() < SETTLED:
            break
        step = np.linalg.solve(curvature, gradient)
        fit = fit + step / max(1.0, np.abs(step).max())  # a unit at most: no overshoot from afar
    covariance = _covariance(*_derivatives(fit, who, what, prior))[:teams, :teams]
    centred = np.eye(teams) - 1.0 / teams
    covariance = ELO**2 * centred @ covariance @ centred
    error = BAND * np.sqrt(np.maximum(np.diag(covariance), 0.0))
    elo = ELO * (fit[:teams] - fit[:teams].mean())
    return Ratings(elo, error, float(np.exp(fit[teams])), covariance)


def chances(d: ArrayLike, draws: float) -> Array:
    """(..., 3) chances to win, draw and lose with a rating d above, in units of ELO."""
    d = np.asarray(d, dtype=np.float64)
    level = np.stack([d / 2.0, np.full(d.shape, np.log(draws)), -d / 2.0], axis=-1)
    odds = np.exp(level - level.max(axis=-1, keepdims=True))
    return np.asarray(odds / odds.sum(axis=-1, keepdims=True))


def _derivatives(
    fit: Array, who: NDArray[np.int64], what: Array, prior: float
) -> tuple[Array, Array]:
    """Of the log-likelihood: gradients (clusters, T + 1) and the negative of its Hessian.

    A cluster is what hangs together: the two matches of a pair, or one that was not played.
    """
    teams, pairs = len(fit) - 1, len(who)
    odds = chances(fit[who[:, 0]] - fit[who[:, 1]], float(np.exp(fit[teams])))
    won, drawn, lost = odds.T
    matches = what.sum(axis=1)
    by_d = (what[:, 0] - what[:, 2] - matches * (won - lost)) / 2.0
    scores = np.zeros((pairs, teams + 1))
    rows = np.arange(pairs)
    np.add.at(scores, (rows, who[:, 0]), by_d)
    np.add.at(scores, (rows, who[:, 1]), -by_d)
    scores[:, teams] = what[:, 1] - matches * drawn
    signs = np.zeros((pairs, teams + 1))  # d by each parameter
    np.add.at(signs, (rows, who[:, 0]), 1.0)
    np.add.at(signs, (rows, who[:, 1]), -1.0)
    draw = np.zeros(teams + 1)
    draw[teams] = 1.0
    spread = matches * (won + lost - (won - lost) ** 2) / 4.0
    mixed = signs.T @ (-matches * drawn * (won - lost) / 2.0)
    curvature = signs.T @ (spread[:, None] * signs) + np.outer(mixed, draw) + np.outer(draw, mixed)
    curvature[teams, teams] += (matches * drawn * (1.0 - drawn)).sum()
    unplayed = 1.0 / (1.0 + np.exp(-np.append(fit[:teams], fit[teams] - np.log(2.0))))
    extra = np.concatenate([np.diag(1.0 - unplayed), np.diag(-unplayed)])
    curvature += 2.0 * prior * np.diag(unplayed * (1.0 - unplayed))
    return np.concatenate([scores, prior * extra]), curvature


def _covariance(scores: Array, curvature: Array) -> Array:
    """Of the fit: H^-1 (sum s s') H^-1 over clusters, right whatever joins the legs of a pair.

    Source: P. J. Huber (1967); the usual H^-1 would take the legs as independent.
    """
    inverse = np.linalg.inv(curvature)
    return np.asarray(inverse @ (scores.T @ scores) @ inverse)
