"""How large the effect is: normalized Elo with its interval, however the run was ended.

The effect t of an outcome x of a pair is mean / sqrt(mean of x^2), the spread taken about zero as
in `likelihood.outcome_llr`: from -1 to 1, and 0 where all are 0. Its error is taken as 1 /
sqrt(N), the one it has under no effect, which is no less than it has under a large one: eight
pairs that all end 2:0 do not make the effect certain.

Two Elo come of it. From goal differences nElo = C t / sqrt(2), at most 245.7. From results, x =
pair score - 1/2, the custom is the spread about the mean, t / sqrt(1 - t^2); the two are the same
to 1 % up to 35 nElo.
"""

from collections.abc import Callable
from math import sqrt
from typing import NamedTuple

from soccersim.regress.brownian import Walk, median_unbiased
from soccersim.regress.statistics import BAND, Estimate, effect_of_elo, elo_of_effect, wald_bounds

OVERSHOOT = 0.583  # -zeta(1/2) / sqrt(2 pi)
LARGEST = 0.999  # effect of results: 5490 nElo, where it would go on to infinity


class Bounds(NamedTuple):
    """What a sequential test compares and where it stops; here as effects t about zero."""

    t0: float
    t1: float  # above t0
    lower: float  # of the log-likelihood ratio, below 0
    upper: float


def bounds_of(
    nelo: tuple[float, float], alpha: float, beta: float, results: bool = False
) -> Bounds:
    """The bounds of a test between two normalized Elo: of results, or of an outcome about zero."""
    t0, t1 = (float(effect_of_elo(hypothesis)) for hypothesis in nelo)
    if results:
        t0, t1 = t0 / sqrt(1.0 + t0 * t0), t1 / sqrt(1.0 + t1 * t1)
    return Bounds(t0, t1, *wald_bounds(alpha, beta))


def after_fixed(t: float, pairs: int) -> Estimate:
    """The effect after a number of pairs that was settled beforehand: t -+ 1.96 / sqrt(N)."""
    reach = BAND / sqrt(pairs) if pairs else 2.0
    return Estimate(t, max(t - reach, -1.0), min(t + reach, 1.0))


def after_stop(t: float, pairs: int, llr: float, bounds: Bounds, every: int) -> Estimate:
    """The median-unbiased effect after a sequential test that ended with this ratio.

    The log-likelihood ratio is taken as a Brownian motion with the drift (t - (t0 + t1) / 2)(t1 -
    t0) and the variance (t1 - t0)^2 a pair. Looked at every few pairs, it goes beyond its bounds
    before it is stopped: 0.583 of what it spreads between two looks, on average, by which they
    are widened (Siegmund, chapter X). What it went beyond that is put down to its last steps:
    the bound was reached so much earlier.
    """
    if not pairs:
        return after_fixed(t, pairs)
    step, middle = bounds.t1 - bounds.t0, 0.5 * (bounds.t0 + bounds.t1)
    gone = pairs * (t - middle) * step
    beyond = OVERSHOOT * step * sqrt(every)
    lower, upper = bounds.lower - beyond, bounds.upper + beyond
    level = min(max(gone, lower), upper)
    if not bounds.lower < llr < bounds.upper:  # it says better than `gone` whether a bound was met
        level = upper if llr > 0.0 else lower
    early = level / gone if gone * level > 0.0 else 1.0
    time = pairs * min(early, 1.0)

    def walk(effect: float) -> Walk:
        return Walk(lower, upper, (effect - middle) * step, step * step)

    return median_unbiased(walk, time, level, -1.0, 1.0)


def as_elo(effect: Estimate, results: bool) -> Estimate:
    """Normalized Elo of an effect about zero; of results with the spread about the mean."""
    convert: Callable[[float], float] = _about_mean if results else float
    return Estimate(*(float(elo_of_effect(convert(number))) for number in effect))


def _about_mean(t: float) -> float:
    """Mean over standard deviation, from mean over root mean square."""
    t = min(max(t, -LARGEST), LARGEST)
    return t / sqrt(1.0 - t * t)
