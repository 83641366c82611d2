"""Matches put together into samples: one number of a pair, or of a seed, on which verdicts rest.

A pair is one seed with HOME and AWAY exchanged, so that a better side or a better draw of chance
falls to both teams. Against each other, the pair itself is the sample. Against the same opponents
(`compared`), the sample is how much better the candidate did than the base did on that seed.
"""

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

CLIP = 3.0  # goals; a pair lost by more says no more, and a forfeit counts 0:3


class Leg(NamedTuple):
    """One match, seen by the team whose worth is asked: candidate, or base against an opponent."""

    goals: int  # of this team; a forfeit is in the score already
    against: int
    digest: str  # of the recording, sides as played: HOME and AWAY, not the teams' names
    faults: int = 0  # of this team
    faults_against: int = 0


class Pair(NamedTuple):
    """The two legs of a seed between two teams."""

    at_home: Leg  # this team plays HOME
    away: Leg

    @property
    def difference(self) -> int:
        """Goals for this team less goals against, both legs together."""
        return sum(leg.goals - leg.against for leg in self)

    @property
    def quarters(self) -> int:
        """The pair's score in quarters, 0 to 4: two for a match won, one for a draw."""
        return sum(1 + (leg.goals > leg.against) - (leg.goals < leg.against) for leg in self)


Counts = tuple[int, int, int, int, int]  # (LL, LD, LW + DD, DW, WW)


@dataclass(frozen=True)
class Sample:
    """What one pair number came to. Void: the machine failed, not a team; it says nothing."""

    number: int  # from 0; the seed is the first seed plus this
    void: bool = False
    outcome: float = (
        0.0  # goal difference of the pair, clipped; in a comparison the difference of two
    )
    result: float = 0.0  # pair score less 1/2; in a comparison the difference of two scores
    difference: float = 0.0  # goal difference as it was, a match
    diverged: bool = False  # the legs played the same match with the teams exchanged, or not
    parted: int | None = None  # first tick at which they differ, where it is known
    faults: int = 0  # of the candidate
    base_faults: int = 0
    counts: Counts = (0, 0, 0, 0, 0)  # of the candidate's pairs, against base or opponents
    base_counts: Counts | None = None  # in a comparison, of the base's pairs against the opponents


def between(number: int, pair: Pair, parted: int | None = None, clip: float = CLIP) -> Sample:
    """The sample of a pair of candidate against base; parted: where the legs' recordings part."""
    return Sample(
        number,
        outcome=_clipped(pair, clip),
        result=pair.quarters / 4 - 0.5,
        difference=pair.difference / 2,
        diverged=pair.at_home.digest != pair.away.digest,
        parted=parted,
        faults=sum(leg.faults for leg in pair),
        base_faults=sum(leg.faults_against for leg in pair),
        counts=_counts([pair]),
    )


def compared(
    number: int,
    candidate: Sequence[Pair],
    base: Sequence[Pair],
    parted: int | None = None,
    clip: float = CLIP,
) -> Sample:
    """The sample of a seed on which both played the same opponents, in the same order.

    Each pair's goal difference is clipped; then candidate less base, mean over the opponents. What
    an opponent did wrong counts in the score alone.
    """
    both = list(zip(candidate, base, strict=True))
    if not both:
        raise ValueError("a comparison needs an opponent")
    opponents = len(both)
    return Sample(
        number,
        outcome=sum(_clipped(mine, clip) - _clipped(its, clip) for mine, its in both) / opponents,
        result=sum(mine.quarters - its.quarters for mine, its in both) / (4 * opponents),
        difference=sum(mine.difference - its.difference for mine, its in both) / (2 * opponents),
        diverged=any(
            leg.digest != other.digest
            for mine, its in both
            for leg, other in zip(mine, its, strict=True)
        ),
        parted=parted,
        faults=sum(leg.faults for pair in candidate for leg in pair),
        base_faults=sum(leg.faults for pair in base for leg in pair),
        counts=_counts(candidate),
        base_counts=_counts(base),
    )


def void(number: int) -> Sample:
    """A pair that the machine failed to play, retries included."""
    return Sample(number, void=True)


def contradictions(digests: Iterable[tuple[Hashable, str]]) -> list[Hashable]:
    """The matches, (pair, leg) or a longer key, that were played twice and came out differently."""
    first: dict[Hashable, str] = {}
    twice: dict[Hashable, None] = {}  # a set that keeps its order
    for match, digest in digests:
        if first.setdefault(match, digest) != digest:
            twice[match] = None
    return list(twice)


def _clipped(pair: Pair, clip: float) -> float:
    return min(max(float(pair.difference), -clip), clip)


def _counts(pairs: Iterable[Pair]) -> Counts:
    counts = [0, 0, 0, 0, 0]
    for pair in pairs:
        counts[pair.quarters] += 1
    return (counts[0], counts[1], counts[2], counts[3], counts[4])
