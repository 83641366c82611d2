"""Which match was which: for every pair, the legs of the candidate and of the base."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from math import inf
from typing import NamedTuple

from soccersim.match.turn import SIDES
from soccersim.regress.account import Account, Match
from soccersim.regress.samples import Sample


class Fault(NamedTuple):
    """What a team did wrong in a match."""

    match: Match
    team: str
    side: str  # home or away
    kind: str
    tick: int
    detail: str


class Meeting(NamedTuple):
    """The legs of a pair against one opponent. A leg that is not there is None."""

    opponent: str  # "": candidate and base play each other
    candidate: tuple[Match | None, Match | None]  # at home, away
    base: tuple[Match | None, Match | None]  # in a comparison; else both None

    @property
    def legs(self) -> list[Match]:
        """Those that are there."""
        return [match for match in (*self.candidate, *self.base) if match]


class Played(NamedTuple):
    """A pair number with its matches."""

    sample: Sample
    seed: int | None
    meetings: tuple[Meeting, ...]

    @property
    def legs(self) -> list[Match]:
        """All its matches."""
        return [match for meeting in self.meetings for match in meeting.legs]

    @property
    def void(self) -> str:
        """Why the machine did not play it."""
        why = next((match.row.void for match in self.legs if match.row.void), "")
        return why or "the machine failed to play it"


def played(account: Account) -> list[Played]:
    """Every pair number that counts, in order."""
    legs: dict[int, list[Match]] = defaultdict(list)
    for match in account.matches:
        legs[match.row.pair].append(match)
    return [_played(account, sample, legs[sample.number]) for sample in account.samples]


def most_different(pairs: Sequence[Played], most: int) -> list[Played]:
    """The pairs between whose matches most lies: goals first, then how early they parted."""

    def rank(pair: Played) -> tuple[float, float, int]:
        parted = pair.sample.parted
        return -abs(pair.sample.difference), inf if parted is None else parted, pair.sample.number

    apart = (pair for pair in pairs if not pair.sample.void and pair.sample.diverged)
    return sorted(apart, key=rank)[:most]


def faults(matches: Sequence[Match]) -> Iterator[Fault]:
    """All that teams did wrong, in the order of the matches."""
    for match in matches:
        for fault in match.row.faults:
            side = str(fault["side"])
            team = match.home if side == "home" else match.away
            kind, tick, detail = str(fault["kind"]), int(fault["tick"]), str(fault["detail"])
            yield Fault(match, team, side, kind, tick, detail)


def role(fault: Fault) -> str:
    """Whether the candidate, the base or an opponent did it."""
    slot = SIDES.index(fault.side)
    if slot == fault.match.candidate:
        return "candidate"
    return "base" if slot == fault.match.base else "opponent"


def _played(account: Account, sample: Sample, legs: list[Match]) -> Played:
    """A pair's matches, which come in the order in which its legs are planned."""
    seed = legs[0].row.seed if legs else None
    if not account.against:
        one, two, *_ = (*legs, None, None)
        return Played(sample, seed, (Meeting("", (one, two), (None, None)),))
    meetings = []
    for k, opponent in enumerate(account.against):
        mine, mine_away, its, its_away, *_ = (*legs[4 * k : 4 * k + 4], *(None,) * 4)
        meetings.append(Meeting(opponent, (mine, mine_away), (its, its_away)))
    return Played(sample, seed, tuple(meetings))
