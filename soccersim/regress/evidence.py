"""What the samples of a run show, whatever the verdict: sums, ratios, estimates, warnings."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from math import sqrt

import numpy as np

from soccersim.regress.effect import after_fixed, as_elo
from soccersim.regress.likelihood import effect
from soccersim.regress.rules import Marks, Rule, Tally, llr_of, tally
from soccersim.regress.samples import Counts, Sample
from soccersim.regress.standing import Standing, Statistic
from soccersim.regress.statistics import BAND, NORMAL, Array, Estimate, likelihood_of_superiority

MANY_VOID = 0.05  # share of pairs that the machine may fail to play before it is remarked on


def tally_of(run: Sequence[Sample], marks: Marks, statistic: Statistic) -> Tally:
    """The sums of a run at its marks; pair scores are counted unless they are differences."""
    results = statistic is Statistic.RESULTS
    x = np.array([s.result if results else s.outcome for s in run], dtype=np.float64)
    valid = np.array([not sample.void for sample in run], dtype=np.bool_)
    return tally(x, valid, marks, results and not _is_comparison(run))


def evidence(run: Sequence[Sample], rule: Rule, statistic: Statistic) -> Standing:
    """Where a run stands after these samples."""
    marks = rule.marks(len(run))
    path = llr_of(tally_of(run, marks, statistic), rule.nelo)
    whole = tally_of(run, np.array([len(run)]), statistic)
    by_counts = whole.counts is not None
    played = [sample for sample in run if not sample.void]
    llr = float(llr_of(whole, rule.nelo)[0])
    size = rule.estimate(float(whole.effect[0]), len(played), llr, by_counts)
    t = _effect_of_results(played)
    compared = _is_comparison(run)
    counts = _summed(sample.counts for sample in played)
    standing = Standing(
        verdict=None,
        reasons=(),
        warnings=(),
        statistic=statistic,
        numbers=len(run),
        pairs=len(played),
        diverged=sum(sample.diverged for sample in played),
        parted=min((s.parted for s in played if s.parted is not None), default=None),
        unequal=int(whole.unequal[0]),
        llr=llr,
        bounds=rule.bounds,
        closing_bounds=rule.closing_bounds,
        path=tuple((int(mark), float(llr)) for mark, llr in zip(marks, path, strict=True)),
        effect=size,
        elo=as_elo(size, by_counts),
        results_elo=as_elo(after_fixed(t, len(played)), results=not compared),
        superiority=_superiority(t, len(played)) if compared else likelihood_of_superiority(counts),
        goal_difference=_mean([sample.difference for sample in played]),
        counts=counts,
        base_counts=_summed(s.base_counts for s in played) if compared else None,
        faults=sum(sample.faults for sample in played),
        base_faults=sum(sample.base_faults for sample in played),
    )
    return replace(standing, warnings=tuple(_warnings(standing, played)))


def _warnings(found: Standing, played: Sequence[Sample]) -> Iterator[str]:
    """What a reader should know before believing the verdict."""
    goals = sum(sample.outcome for sample in played)
    results = sum(sample.result for sample in played)
    if goals * results < 0.0:
        better = "goals" if goals > 0.0 else "results"
        yield f"goals and results disagree: the candidate is ahead by {better} alone"
    if found.void > MANY_VOID * found.numbers:
        yield f"the machine failed to play {found.void} of {found.numbers} pairs"
    if found.base_faults:
        yield f"the base was at fault {found.base_faults} times: what it forfeits, the other wins"


def _is_comparison(run: Iterable[Sample]) -> bool:
    return any(sample.base_counts is not None for sample in run)


def _effect_of_results(played: Sequence[Sample]) -> float:
    """The effect t of matches won, drawn and lost."""
    x = [sample.result for sample in played]
    return float(effect(len(x), sum(x), sum(result * result for result in x)))


def _superiority(t: float, pairs: int) -> float:
    """LOS from an effect about zero."""
    return NORMAL.cdf(t * sqrt(pairs))


def _mean(numbers: Sequence[float]) -> Estimate:
    """Their mean, and mean -+ 1.96 sd / sqrt(N)."""
    if not numbers:
        return Estimate(0.0, 0.0, 0.0)
    x: Array = np.asarray(numbers, dtype=np.float64)
    mean, reach = float(x.mean()), BAND * float(x.std()) / sqrt(len(x))
    return Estimate(mean, mean - reach, mean + reach)


def _summed(each: Iterable[Counts | None]) -> Counts:
    """Counts added up."""
    total = [0, 0, 0, 0, 0]
    for counts in each:
        total = [a + b for a, b in zip(total, counts or (0,) * 5, strict=True)]
    return (total[0], total[1], total[2], total[3], total[4])
