"""What a sequential test tells of the effect: the estimate that stopping early does not flatter.

A test that stops as soon as it looks good overstates: the plain mean is biased. Seen as a Brownian
motion between two bounds, every end of the test (which bound and when, or where it stood when time
was up) has its rank: an early stop at the lower bound is the worst, an early stop at the upper one
the best. The effect under which the end we saw is the median of all ends is the estimate, and
those under which it lies at 2.5 % and 97.5 % are its interval. Source: D. Siegmund, Sequential
Analysis (1985), chapter III, and the sources of `statistics`.

The walk's distribution is summed over its mirror images in the two bounds: Cox & Miller, The
Theory of Stochastic Processes (1965), 5.7.
"""

from collections.abc import Callable
from math import ceil, copysign, erfc, exp, log, log1p, pi, sqrt
from typing import NamedTuple

from soccersim.regress.statistics import Estimate

MIRRORED_OFTEN = 20.0  # widths: a walk that spread this far has stopped, all but e^-1974 of it
TAIL = 10.0  # standard deviations beyond which erfc is replaced by its series
HALVINGS = 45  # of a bracket: 3e-14 of its width is left


class Walk(NamedTuple):
    """A Brownian motion from 0 between two absorbing bounds."""

    lower: float  # below 0
    upper: float  # above 0
    drift: float  # per unit of time
    variance: float  # per unit of time, above 0

    def ends_worse(self, time: float, level: float) -> float:
        """Probability of a worse end than to stop at `level`, lower to upper, at `time` above 0.

        Worse is: absorbed below before that time, or by then neither absorbed nor above the level.
        """
        width = self.upper - self.lower
        time = min(time, (MIRRORED_OFTEN * width) ** 2 / self.variance)
        chance = self._sunk(time) + self._afloat_below(time, level)
        return min(max(chance, 0.0), 1.0)

    def _sunk(self, time: float) -> float:
        """Probability of absorption at the lower bound by then, and before one at the upper.

        First passages of images at h = -lower + 2 k width, each with the law of a single bound:
        Phi((m t - h) / s) + e^(2 g h) Phi(-(h + m t) / s), m the drift's size, s^2 = variance t.
        """
        lean = self.drift / self.variance
        deviation, way = sqrt(self.variance * time), abs(self.drift) * time
        total = 0.0
        for k in self._mirrors(deviation):
            far = -self.lower + 2 * k * (self.upper - self.lower)
            h = abs(far)
            before = lean * self.lower - abs(lean) * h
            after = lean * self.lower + abs(lean) * h
            reached = exp(before + log_phi((way - h) / deviation))
            reached += exp(after + log_phi(-(way + h) / deviation))
            total += copysign(reached, far)
        return total

    def _afloat_below(self, time: float, level: float) -> float:
        """Probability of never having been absorbed and of standing below the level then."""
        lean, width = self.drift / self.variance, self.upper - self.lower
        deviation, way = sqrt(self.variance * time), self.drift * time
        total = 0.0
        for k in self._mirrors(deviation):
            for source, sign in ((2 * k * width, 1.0), (2 * self.lower + 2 * k * width, -1.0)):
                start = (self.lower - source - way) / deviation
                stop = (level - source - way) / deviation
                if start > 0.0:  # the same area on the other side, where it does not round off
                    start, stop = -stop, -start
                weight = lean * source
                total += sign * (exp(weight + log_phi(stop)) - exp(weight + log_phi(start)))
        return total

    def _mirrors(self, deviation: float) -> range:
        """As many images as can matter: the k-th weighs exp(-2 (k width / deviation)^2) or less."""
        most = 2 + ceil(5.0 * deviation / (self.upper - self.lower))
        return range(-most, most + 1)


def median_unbiased(
    walk_at: Callable[[float], Walk], time: float, level: float, low: float, high: float
) -> Estimate:
    """The effects at which the end (time, level) ranks at 50 %, and at 97.5 and 2.5 %.

    walk_at: the walk that an effect gives, drifting up as it grows; low, high: where to look. An
    effect beyond them is given as the nearer of the two.
    """

    def ranked(chance: float) -> float:
        def excess(effect: float) -> float:
            return walk_at(effect).ends_worse(time, level) - chance

        return falls_to_zero(excess, low, high)

    return Estimate(ranked(0.5), ranked(0.975), ranked(0.025))


def falls_to_zero(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a falling function crosses 0 between two places, by halving; else the nearer place."""
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if function(middle) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def log_phi(x: float) -> float:
    """ln Phi(x) of the standard normal distribution, for any x, far into the lower tail too."""
    if x > 5.0:
        return log1p(-0.5 * erfc(x / sqrt(2.0)))
    if x > -TAIL:
        return log(0.5 * erfc(-x / sqrt(2.0)))
    inverse = 1.0 / (x * x)  # Abramowitz & Stegun 26.2.12
    series = 1.0 - inverse * (1.0 - 3.0 * inverse * (1.0 - 5.0 * inverse * (1.0 - 7.0 * inverse)))
    return -0.5 * x * x - log(-x * sqrt(2.0 * pi)) + log(series)
