"""The last look of a sequential test that may not go on for ever.

Wald's bounds hold the chances of error, alpha and beta, for a test that goes on until it reaches
one. Capped at 400 pairs, it leaves some runs open that would have ended right: between -25 and 25
nElo the power falls from .95 to .932. The cap takes from the errors too, and what it takes may be
given back: at the last mark the bounds are drawn in until the chances of error are alpha and beta
again, which gives 1.41 in place of 2.94 and a power of .939; looking every 8 pairs overshoots,
which adds a little to both. Worked out for Brownian motion, as Wald's bounds are. Compare A. Wald,
Sequential Analysis (1947), 3.8, who decides every open run by the sign of its ratio.
"""

from functools import lru_cache
from math import log

from soccersim.regress.brownian import Walk, falls_to_zero
from soccersim.regress.effect import Bounds

LEAST = log(4)  # data four times likelier: below it a last look leaves the run open, however short


@lru_cache(maxsize=64)
def closing_bounds(bounds: Bounds, alpha: float, beta: float, pairs: int) -> tuple[float, float]:
    """The bounds of the log-likelihood ratio after the last pair: no wider than the others."""
    step = (bounds.t1 - bounds.t0) ** 2
    worse = Walk(bounds.lower, bounds.upper, -step / 2.0, step)  # the first hypothesis is true
    better = Walk(bounds.lower, bounds.upper, step / 2.0, step)  # the second is
    upper = falls_to_zero(
        lambda level: 1.0 - worse.ends_worse(pairs, level) - alpha, bounds.lower, bounds.upper
    )
    lower = falls_to_zero(
        lambda level: beta - better.ends_worse(pairs, level), bounds.lower, bounds.upper
    )
    return max(min(lower, -LEAST), bounds.lower), min(max(upper, LEAST), bounds.upper)
