"""Where a regression stands or how it ended: numbers for people, for JSON, the exit code."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from soccersim.regress.samples import Counts
from soccersim.regress.statistics import Estimate


class Verdict(StrEnum):
    """What a regression ends with."""

    PASS = "PASS"  # the candidate is better
    FAIL = "FAIL"  # it is worse
    INCONCLUSIVE = "INCONCLUSIVE"  # the pairs are used up, and it may be either
    IDENTICAL = "IDENTICAL"  # not one match differed
    INVALID = "INVALID"  # more faults than the base, or matches that cannot be repeated


class Statistic(StrEnum):
    """What of a pair is judged. Goals tell more: 175 matches where results need 285."""

    GOALS = "goals"  # its goal difference, clipped
    RESULTS = "results"  # its matches won, drawn and lost


EXIT = {
    Verdict.PASS: 0,
    Verdict.IDENTICAL: 0,
    Verdict.INCONCLUSIVE: 0,
    Verdict.FAIL: 1,
    Verdict.INVALID: 4,
}


def exit_code(verdict: Verdict, strict: bool = False) -> int:
    """For CI; strict: what is not clear does not pass."""
    return 1 if strict and verdict is Verdict.INCONCLUSIVE else EXIT[verdict]


@dataclass(frozen=True)
class Standing:
    """The evidence of the first pair numbers, and the verdict if they give one."""

    verdict: Verdict | None  # None: go on
    reasons: tuple[str, ...]  # of the verdict, in sentences
    warnings: tuple[str, ...]
    statistic: Statistic
    numbers: int  # pair numbers that count, 0 to this less one
    pairs: int  # of them played; the others are void
    diverged: int  # pairs whose legs were not the same match
    parted: int | None  # first tick at which one of them parted, where that is known
    unequal: int  # pairs with an outcome that is not exactly 0
    llr: float
    bounds: tuple[float, float]
    closing_bounds: tuple[float, float]  # of the LLR after the last pair, nearer to 0
    path: tuple[tuple[int, float], ...]  # the LLR at each mark: pair numbers, LLR
    effect: Estimate  # t, -1 to 1
    elo: Estimate  # normalized, of the statistic
    results_elo: Estimate  # normalized, of matches won, drawn and lost, whatever is judged
    superiority: float  # LOS by results: 0 to 1
    goal_difference: Estimate  # a match, not clipped
    counts: Counts  # of the candidate's pairs
    base_counts: Counts | None  # of the base's against the same opponents, in a comparison
    faults: int  # of the candidate
    base_faults: int

    @property
    def void(self) -> int:
        """Pairs that the machine failed to play."""
        return self.numbers - self.pairs

    @property
    def divergence(self) -> str:
        """How many pairs differed at all, and when first: for near copies it tells most."""
        told = f"{self.diverged} of {self.pairs} pairs diverged"
        return told if self.parted is None else f"{told}, first at tick {self.parted}"

    def document(self) -> dict[str, Any]:
        """For JSON: what is promised first, then what stands behind it. All numbers are finite."""
        return {
            "verdict": None if self.verdict is None else self.verdict.value,
            "pairs": self.pairs,
            "diverged": self.diverged,
            "llr": self.llr,
            "bounds": list(self.bounds),
            "elo": self.elo.value,
            "elo_ci": [self.elo.low, self.elo.high],
            "goal_difference": self.goal_difference.value,
            "goal_difference_ci": [self.goal_difference.low, self.goal_difference.high],
            "pentanomial": list(self.counts),
            "base_pentanomial": None if self.base_counts is None else list(self.base_counts),
            "faults": {"candidate": self.faults, "base": self.base_faults},
            "statistic": self.statistic.value,
            "closing_bounds": list(self.closing_bounds),
            "results_elo": self.results_elo._asdict(),
            "los": self.superiority,
            "void": self.void,
            "parted": self.parted,
            "unequal": self.unequal,
            "path": [list(look) for look in self.path],
            "reasons": list(self.reasons),
            "warnings": list(self.warnings),
        }
