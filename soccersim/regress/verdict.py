"""The verdict on a candidate: a pure function of the samples and the rule.

Only the pair numbers from 0 on without a gap count, up to the first mark that decides. Samples
beyond are there because several matches run at a time; they change nothing, so that one worker and
sixty-four give the same verdict.
"""

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from soccersim.regress.evidence import evidence, tally_of
from soccersim.regress.rules import AT_LEAST, Fixed, Rule, first_decided
from soccersim.regress.samples import Sample
from soccersim.regress.standing import Standing, Statistic, Verdict
from soccersim.regress.statistics import Estimate

GOALS = Statistic.GOALS
NONE = Estimate(0.0, 0.0, 0.0)  # of matches that are the same there is no doubt


def decide(
    samples: Mapping[int, Sample],
    rule: Rule,
    *,
    statistic: Statistic = GOALS,
    same_code: bool = False,
    contradictions: Sequence[Hashable] = (),
) -> Standing:
    """The standing of a run whose samples, by number, are in as far as they are in.

    same_code: candidate and base are byte for byte the same program with the same options, so that
    a pair whose legs differ is one match played twice. contradictions: see `samples`.
    """
    run = in_order(samples, rule.most)
    end = _end_by_score(run, rule, statistic, same_code)
    used = run[: end.numbers]
    found = evidence(used, rule, statistic)
    broken = _not_repeatable(samples, same_code, contradictions)
    if broken or (end.verdict and found.faults > found.base_faults):
        return replace(found, verdict=Verdict.INVALID, reasons=broken or (_faults(found),))
    if end.verdict is Verdict.IDENTICAL:
        found = replace(found, effect=NONE, elo=NONE, results_elo=NONE)
    if end.verdict:
        reasons = (_why(end.verdict, found, rule),)
        return replace(found, verdict=end.verdict, reasons=reasons)
    return found


def in_order(samples: Mapping[int, Sample], most: int) -> list[Sample]:
    """The samples from number 0 on, as far as none is missing."""
    run: list[Sample] = []
    while len(run) < most and len(run) in samples:
        run.append(samples[len(run)])
    return run


class _End(NamedTuple):
    numbers: int  # pair numbers that count
    clear: int  # 1 better, -1 worse, 0 not clear
    verdict: Verdict | None  # None: go on


def _end_by_score(run: list[Sample], rule: Rule, statistic: Statistic, same_code: bool) -> _End:
    """The end that the rule makes of the samples in order, faults left aside."""
    marks = rule.marks(len(run))
    at, clear = (int(found) for found in first_decided(rule.judge(tally_of(run, marks, statistic))))
    if clear:
        return _End(int(marks[at]), clear, Verdict.PASS if clear > 0 else Verdict.FAIL)
    # a copy need not be played to the end: if its legs agree, they always will
    for numbers in [int(mark) for mark in marks if same_code] + [rule.most]:
        played = [sample for sample in run[:numbers] if not sample.void]
        if len(run) >= numbers and played and not any(sample.diverged for sample in played):
            return _End(numbers, 0, Verdict.IDENTICAL)
    over = len(run) >= rule.most
    return _End(len(run), 0, Verdict.INCONCLUSIVE if over else None)


def _not_repeatable(
    samples: Mapping[int, Sample], same_code: bool, contradictions: Sequence[Hashable]
) -> tuple[str, ...]:
    """Sentences about matches that came out differently when played again, wherever they stand."""
    told = [f"{match} was played twice and came out differently" for match in contradictions]
    if same_code:
        parted = sorted(number for number, sample in samples.items() if sample.diverged)
        told += [
            f"the same code on both sides, and the legs of pair {n} differ" for n in parted[:1]
        ]
    return tuple(told)


def _faults(found: Standing) -> str:
    return f"faults: {found.faults} of the candidate, {found.base_faults} of the base"


def _why(verdict: Verdict, found: Standing, rule: Rule) -> str:
    """The one sentence that a verdict by score rests on."""
    if verdict is Verdict.IDENTICAL:
        return f"all {found.pairs} pairs were the same match on both sides, digest for digest"
    if found.unequal < AT_LEAST:
        return f"only {found.unequal} of {found.pairs} pairs are not exactly 0; {AT_LEAST} needed"
    if isinstance(rule, Fixed):
        return f"the 95 % interval of the effect is {_span(found.elo)} nElo"
    last = found.numbers == rule.most
    lower, upper = found.closing_bounds if last else found.bounds
    named = "the closing bounds " if last and rule.closing else ""
    place = "between" if verdict is Verdict.INCONCLUSIVE else "not between"
    between = f"{place} {named}{lower:.2f} and {upper:.2f}"
    return f"after {found.pairs} pairs the log-likelihood ratio {found.llr:.2f} is {between}"


def _span(estimate: Estimate) -> str:
    return f"{estimate.low:.1f} to {estimate.high:.1f}"
