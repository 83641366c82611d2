"""When a regression ends, and how: after a fixed number of pairs, or as soon as it is clear.

Both rules look at the pairs in the order of their numbers and at marks settled beforehand, whatever
order the matches end in. A rule that judged what has come in would judge the quick matches first:
with losses that take three times as long as wins, two equal teams and hypotheses of 0 and 50 nElo,
it passes 4.5 % of runs on 16 workers, 16 % on 64 and 74 % on 128; in the order of the numbers it is
3 % on any (tests/regress/test_completion_order.py).

Arrays may have any axes before the last, runs side by side, so that a law over thousands of runs is
tested on the very code that judges one.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from soccersim.regress.closing import closing_bounds
from soccersim.regress.effect import after_fixed, after_stop, bounds_of
from soccersim.regress.likelihood import WIDEST, effect, normalized_llr, outcome_llr
from soccersim.regress.statistics import BAND, Array, Estimate, wald_bounds

AT_LEAST = 8  # pairs that are not exactly 0, before any PASS or FAIL: near copies differ in few
DEFAULT = (-25.0, 25.0)  # nElo
Marks = NDArray[np.int64]  # (K,) how many pair numbers are looked at, ascending
Judged = NDArray[np.int64]  # (..., K) at each mark 1: better, -1: worse, 0: not clear


class Tally(NamedTuple):
    """Sums over the first pair numbers, up to each mark; void pairs left out. Arrays (..., K)."""

    numbers: Marks  # (K,) the marks
    pairs: Array
    total: Array  # sum of outcomes x
    squares: Array  # sum of x^2
    unequal: Array  # how many x are not 0
    counts: Array | None = None  # (..., K, 5) where x is a pair score less 1/2: each one's number

    @property
    def effect(self) -> Array:
        """t = mean / sqrt(mean of x^2), -1 to 1."""
        return effect(self.pairs, self.total, self.squares)


def tally(outcomes: Array, valid: NDArray[np.bool_], marks: Marks, results: bool) -> Tally:
    """Sums at the marks of outcomes (..., n). results: these are pair scores less 1/2."""

    def summed(numbers: Array) -> Array:
        start = np.zeros((*numbers.shape[:-1], 1))
        return np.concatenate([start, numbers.cumsum(axis=-1)], axis=-1)[..., marks]

    x = np.where(valid, outcomes, 0.0)
    counts = None
    if results:
        quarters = np.rint(4.0 * x + 2.0)
        each = [summed(((quarters == k) & valid).astype(np.float64)) for k in range(5)]
        counts = np.stack(each, axis=-1)
    return Tally(
        marks,
        summed(valid.astype(np.float64)),
        summed(x),
        summed(x * x),
        summed((x != 0.0).astype(np.float64)),
        counts,
    )


@dataclass(frozen=True)
class Sprt:
    """Go on until one of two normalized Elo is clearly the likelier, or the pairs are used up."""

    low: float = DEFAULT[0]
    high: float = DEFAULT[1]
    alpha: float = 0.05  # chance to pass where the truth is low
    beta: float = 0.05  # and to fail where it is high
    every: int = 8  # pairs from mark to mark
    most: int = 400  # pairs
    closing: bool = True  # at the last mark decide by the closing bounds

    def __post_init__(self) -> None:
        if not -WIDEST <= self.low < self.high <= WIDEST:
            raise ValueError(f"two normalized Elo, {-WIDEST:g} to {WIDEST:g}, the lower one first")
        if not (0.0 < self.alpha < 0.5 and 0.0 < self.beta < 0.5):
            raise ValueError("alpha and beta are chances of an error: above 0, below 0.5")
        if self.every < 1 or self.most < 1:
            raise ValueError("at least one pair")

    @property
    def nelo(self) -> tuple[float, float]:
        """The two hypotheses."""
        return self.low, self.high

    @property
    def bounds(self) -> tuple[float, float]:
        """Of the log-likelihood ratio: FAIL at the first, PASS at the second."""
        return wald_bounds(self.alpha, self.beta)

    def marks(self, numbers: int) -> Marks:
        """Where to look when so many numbers are there: every few pairs, and at the end."""
        looks = list(range(self.every, min(numbers, self.most) + 1, self.every))
        if numbers >= self.most and self.most % self.every:
            looks.append(self.most)
        return np.array(looks, dtype=np.int64)

    @property
    def closing_bounds(self) -> tuple[float, float]:
        """The bounds at the last mark, nearer to 0: see `closing`."""
        if not self.closing:
            return self.bounds
        bounds = bounds_of(self.nelo, self.alpha, self.beta)
        return closing_bounds(bounds, self.alpha, self.beta, self.most)

    def judge(self, sums: Tally) -> Judged:
        """At each mark 1 where the LLR has reached the upper bound, -1 at the lower."""
        return self.judge_llr(llr_of(sums, self.nelo), sums)

    def judge_llr(self, llr: Array, sums: Tally) -> Judged:
        """The same of ratios that are there already."""
        last = sums.numbers == self.most
        lower, upper = (
            np.where(last, close, bound)
            for close, bound in zip(self.closing_bounds, self.bounds, strict=True)
        )
        clear = (llr >= upper).astype(np.int64) - (llr <= lower).astype(np.int64)
        return np.where(sums.unequal >= AT_LEAST, clear, 0)

    def estimate(self, t: float, pairs: int, llr: float, results: bool) -> Estimate:
        """The effect t with its interval, freed of what stopping early adds to it."""
        bounds = bounds_of(self.nelo, self.alpha, self.beta, results)
        return after_stop(t, pairs, llr, bounds, self.every)


@dataclass(frozen=True)
class Fixed:
    """Play a number of pairs; better or worse if the 95 % interval of the effect leaves out 0."""

    most: int

    def __post_init__(self) -> None:
        if self.most < 1:
            raise ValueError("at least one pair")

    @property
    def nelo(self) -> tuple[float, float]:
        """The hypotheses of the LLR that is told; it decides nothing here."""
        return DEFAULT

    @property
    def bounds(self) -> tuple[float, float]:
        """Of that LLR."""
        return wald_bounds(0.05, 0.05)

    @property
    def closing_bounds(self) -> tuple[float, float]:
        """The same."""
        return self.bounds

    def marks(self, numbers: int) -> Marks:
        """The end alone."""
        return np.array([self.most] if numbers >= self.most else [], dtype=np.int64)

    def judge(self, sums: Tally) -> Judged:
        """1 where t - 1.96 / sqrt(N) is above 0, -1 where t + 1.96 / sqrt(N) is below."""
        deviations = sums.effect * np.sqrt(sums.pairs)
        clear = (deviations > BAND).astype(np.int64) - (deviations < -BAND).astype(np.int64)
        return np.where(sums.unequal >= AT_LEAST, clear, 0)

    def estimate(self, t: float, pairs: int, llr: float, results: bool) -> Estimate:
        """The effect t with its interval."""
        return after_fixed(t, pairs)


Rule = Sprt | Fixed


def llr_of(sums: Tally, nelo: tuple[float, float]) -> Array:
    """The log-likelihood ratio at each mark: of pair scores by their counts, else of outcomes.

    Where every outcome is 0 it is 0: pairs that are all alike say nothing of better or worse.
    """
    if sums.counts is None:
        return outcome_llr(sums.pairs, sums.total, sums.squares, nelo)
    return np.where(sums.unequal > 0.0, normalized_llr(sums.counts, nelo), 0.0)


def first_decided(judged: Judged) -> tuple[NDArray[np.int64], Judged]:
    """Index of the first mark that is not 0, K where none is, and what it says: both (...)."""
    ended = np.concatenate([judged != 0, np.ones((*judged.shape[:-1], 1), dtype=bool)], axis=-1)
    at = ended.argmax(axis=-1)
    padded = np.concatenate([judged, np.zeros((*judged.shape[:-1], 1), np.int64)], axis=-1)
    return at, np.take_along_axis(padded, at[..., None], axis=-1)[..., 0]
