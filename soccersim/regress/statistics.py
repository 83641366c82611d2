"""What pairs of matches say about two teams: their counts, Elo, error bars, and games needed.

A pair is one seed played twice with the sides exchanged. Its score is 0, 1/4, 1/2, 3/4 or 1 for the
candidate: a match won counts 1/2, a draw 1/4. How often each came are the pair's counts,
(LL, LD, LW + DD, DW, WW), an array whose last axis has these five. Leading axes are runs or moments
of one run, so that a thousand runs are worked out at once.

Source: M. Van den Bergh, "A practical introduction to the GSPRT", "Normalized Elo" and "The
generalized maximum likelihood ratio for the expectation value of a distribution", the papers behind
the way chess engines are tested.
"""

from math import log, sqrt
from statistics import NormalDist
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

SCORES: Array = np.arange(5) / 4  # of a pair, beside its counts
FEWEST = 1e-3  # stands for a count of zero: what has not been seen is rare, not impossible
ELO_PER_SPREAD = 800 / log(10)  # 347.4356; so that near 0 a match with v = 1/4 gives logistic Elo
BAND = 1.96  # standard deviations on either side hold 95 % of a normal distribution
NORMAL = NormalDist()
SCORE_EDGE = 1e-3  # Elo are given between the scores 0.001 and 0.999, which is -1200 to 1200


class Moments(NamedTuple):
    """Of pair scores: how many pairs, their mean, their variance."""

    pairs: Array  # (...)
    mean: Array  # (...) 0 to 1
    variance: Array  # (...) above 0


class Estimate(NamedTuple):
    """A number with its 95 % interval."""

    value: float
    low: float
    high: float


def regularized(counts: ArrayLike) -> Array:
    """Counts (..., 5) without zeros, so that every likelihood is finite."""
    counts = np.asarray(counts, dtype=np.float64)
    return np.where(counts > 0.0, counts, FEWEST)


def moments(counts: ArrayLike) -> Moments:
    """N = sum n, mu = sum p a, v = sum p (a - mu)^2, with p = n / N."""
    filled = regularized(counts)
    pairs = filled.sum(axis=-1)
    shares = filled / pairs[..., None]
    mean = shares @ SCORES
    deviation = SCORES - mean[..., None]
    return Moments(pairs, mean, (shares * deviation**2).sum(axis=-1))


def expected_score(elo: ArrayLike) -> Array:
    """The logistic curve: s = 1 / (1 + 10^(-elo / 400))."""
    return np.asarray(1.0 / (1.0 + 10.0 ** (-np.asarray(elo, dtype=np.float64) / 400.0)))


def elo_of_score(score: float) -> float:
    """The Elo difference that gives a score: the logistic curve backwards, cut at its ends."""
    inside = min(max(score, SCORE_EDGE), 1.0 - SCORE_EDGE)
    return -400.0 * log(1.0 / inside - 1.0) / log(10.0)


def logistic_elo(counts: ArrayLike) -> Estimate:
    """Elo of one vector of counts, and at mu -+ 1.96 sqrt(v / N)."""
    pairs, mean, variance = (float(number) for number in moments(counts))
    reach = BAND * sqrt(variance / pairs)
    return Estimate(elo_of_score(mean), elo_of_score(mean - reach), elo_of_score(mean + reach))


def normalized_elo(counts: ArrayLike) -> Array:
    """nElo = C (mu - 1/2) / sqrt(2 v): advantage over spread, whatever the share of draws is."""
    _, mean, variance = moments(counts)
    return np.asarray(ELO_PER_SPREAD * (mean - 0.5) / np.sqrt(2.0 * variance))


def normalized_elo_of_matches(mean: float, variance: float) -> float:
    """nElo = C (mu - 1/2) / sqrt(v) from the mean and variance of the scores of single matches."""
    return ELO_PER_SPREAD * (mean - 0.5) / sqrt(variance)


def likelihood_of_superiority(counts: ArrayLike) -> float:
    """LOS = Phi((mu - 1/2) / sqrt(v / N)): how likely the candidate is the better team."""
    pairs, mean, variance = (float(number) for number in moments(counts))
    return NORMAL.cdf((mean - 0.5) / sqrt(variance / pairs))


def effect_of_elo(nelo: ArrayLike) -> Array:
    """t = sqrt(2) nElo / C: mean over spread of a pair, whose two matches count as independent."""
    return np.asarray(np.sqrt(2.0) * np.asarray(nelo, dtype=np.float64) / ELO_PER_SPREAD)


def elo_of_effect(effect: ArrayLike) -> Array:
    """nElo = C t / sqrt(2), from mean over spread of a pair."""
    return np.asarray(ELO_PER_SPREAD * np.asarray(effect, dtype=np.float64) / np.sqrt(2.0))


def wald_bounds(alpha: float, beta: float) -> tuple[float, float]:
    """Where a sequential test stops: ln(beta / (1 - alpha)) and ln((1 - beta) / alpha)."""
    return log(beta / (1.0 - alpha)), log((1.0 - beta) / alpha)


class GamesNeeded(NamedTuple):
    """Expected number of matches, two a pair, until a sequential test stops."""

    at_the_ends: float  # when one of the two hypotheses is true; the slower of both
    halfway: float  # at worst: when the truth lies midway between them


def games_needed(width: float, alpha: float = 0.05, beta: float = 0.05) -> GamesNeeded:
    """For hypotheses `width` nElo apart: Wald's expected sample sizes, overshoot left out.

    With d = width / C per match, the log-likelihood ratio drifts by -+ d^2 / 2 a match at the ends
    and by 0 halfway, and spreads by d^2 everywhere. Source: A. Wald, Sequential Analysis (1947),
    3.5.
    """
    lower, upper = wald_bounds(alpha, beta)
    step = (width / ELO_PER_SPREAD) ** 2
    worse = -((1.0 - alpha) * lower + alpha * upper)  # how far it has gone on average, downwards
    better = beta * lower + (1.0 - beta) * upper  # and upwards
    return GamesNeeded(2.0 * max(worse, better) / step, -lower * upper / step)
