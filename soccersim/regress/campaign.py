"""A run of a plan: legs become samples, samples a standing, and at last that is a verdict.

Only what is in the store counts, and only in the order of the pair numbers: however often a run is
stopped, and however many matches it plays at a time, it comes to the same end.
"""

import json
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, closing
from dataclasses import replace

from soccersim.regress.account import Account, Match
from soccersim.regress.engine import environment
from soccersim.regress.leg import Leg
from soccersim.regress.plan import Plan
from soccersim.regress.pool import Pool
from soccersim.regress.recordings import Recordings
from soccersim.regress.row import Row
from soccersim.regress.runner import run
from soccersim.regress.samples import Sample
from soccersim.regress.standing import Standing
from soccersim.regress.store import Store
from soccersim.regress.verdict import decide

PoolOf = Callable[[], AbstractContextManager[Pool]]
TWICE = 50  # of so many legs one is played again, the first of a run among them: see runner.run
BEAT = 0.5  # s from one look at where it stands to the next, between marks
MOST_WITH_EVENTS = 10_000  # matches; of more, the account leaves the events in the store
SHARE = 20  # times as long as a look takes, at least, until the next


class Campaign:
    """One plan and the store it is played into.

    >>> campaign = Campaign(plan, store)
    >>> campaign.play(lambda: LocalPool(2, Ground(plan.meetings[0].scenario)))
    >>> campaign.standing.verdict
    """

    def __init__(self, plan: Plan, store: Store) -> None:
        self.plan, self.store = plan, store
        self.recordings = Recordings(store.path)
        self.samples: dict[int, Sample] = {}
        self.whole = 0  # pair numbers from 0 on without a gap
        self._rows: dict[int, dict[str, Row]] = {}  # of pair numbers that are not whole, by key
        self._places: dict[str, tuple[int, int]] = {}  # pair and leg of each key that was seen
        self._marks, self._next = 0, 0.0
        self._before = store.added
        self.width = 0  # matches that were played at a time
        self.standing = self.look()

    @property
    def played(self) -> int:
        """Legs played in this run."""
        return self.store.added - self._before

    @property
    def found(self) -> int:
        """Legs of an earlier run that came out of the store."""
        return len(self._places) - self.played

    def recall(self) -> None:
        """Take what is in the store, from pair 0 on until a leg is missing, or it is decided."""
        for number in range(self.plan.most):
            legs = self.plan.legs_of(number)
            rows = [row for leg in legs if (row := self.store.row(leg.key))]
            if len(rows) < len(legs):
                break
            if any(self.take(leg, row) for leg, row in zip(legs, rows, strict=True)):
                return
        self.standing = self.look()

    def play(
        self,
        pool: PoolOf,
        tell: Callable[["Campaign"], None] = lambda _: None,
    ) -> None:
        """Go on until there is a verdict; tell: called after each leg.

        What run() raises; what is in the store stays, and the same plan goes on from there.
        """
        self.recall()
        tell(self)
        if self.standing.verdict:
            return
        with pool() as place:
            legs, self.width = self.plan.legs(self.whole), place.width
            with closing(run(legs, self.store, place, twice=TWICE)) as rows:
                for leg, row in rows:
                    decided = self.take(leg, row)
                    tell(self)
                    if decided:
                        return
        self.standing = self.look()

    def take(self, leg: Leg, row: Row) -> bool:
        """A leg is over; whether there is a verdict now."""
        number = leg.pair
        self._places[leg.key] = number, leg.leg
        if number in self.samples:  # two opponents with the same code: their matches are the same
            return False
        found = self._rows.setdefault(number, {})
        found[leg.key] = row
        legs = self.plan.legs_of(number)
        if len(found) < len({each.key for each in legs}):
            return False
        rows = [found[each.key] for each in legs]
        self.samples[number] = self.plan.sample(number, rows, self.recordings.parting)
        del self._rows[number]
        while self.whole in self.samples:
            self.whole += 1
        if self.is_due():
            self.standing = self.look()
        return self.standing.verdict is not None

    def see_again(self, numbers: Iterable[int]) -> None:
        """Make the samples of these pair numbers anew: there is more in the store about them."""
        for number in numbers:
            rows = [self.store.row(leg.key) for leg in self.plan.legs_of(number)]
            told = [row for row in rows if row]
            self.samples[number] = self.plan.sample(number, told, self.recordings.parting)
        self.standing = self.look()

    def is_due(self) -> bool:
        """Whether a mark has been passed, or enough time that somebody may want to look."""
        marks = len(self.plan.rule.marks(self.whole))
        passed, self._marks = marks > self._marks, marks
        return passed or time.monotonic() > self._next

    def look(self) -> Standing:
        """Where it stands."""
        start = time.monotonic()
        standing = decide(
            self.samples,
            self.plan.rule,
            same_code=self.plan.same_code,
            contradictions=self.contradictions(),
        )
        end = time.monotonic()
        self._next = end + max(BEAT, SHARE * (end - start))
        return standing

    def contradictions(self) -> list[str]:
        """The legs of this plan that came out differently when they were played again."""
        places = [self._places.get(found.key) for found in self.store.contradictions()]
        return [f"leg {place[1]} of pair {place[0]}" for place in sorted(filter(None, places))]

    def account(self, command: str, jobs: int, seconds: float) -> Account:
        """All that it came to; command: to repeat it, seconds: that this run took."""
        plan, counted = self.plan, range(self.standing.numbers)
        matches = [match for number in counted for match in self.matches(number)]
        if len(matches) > MOST_WITH_EVENTS:
            matches = [replace(each, row=replace(each.row, events=())) for each in matches]
        return Account(
            command=command,
            scenario=plan.scenario.name,
            base=plan.base.name,
            candidate=plan.candidate.name,
            against=tuple(team.name for team in plan.against),
            base_sha=plan.base.bundle.sha,
            candidate_sha=plan.candidate.bundle.sha,
            rule=plan.rule,
            standing=self.standing,
            samples=tuple(self.samples[number] for number in counted),
            matches=tuple(matches),
            jobs=self.width or jobs,
            seconds=seconds,
            played=self.played,
            found=self.found,
            environment=json.loads(self.store.noted("environment") or "null") or environment(),
            store=self.store.path,
            recordings=self.recordings.folder,
        )

    def matches(self, number: int) -> Iterator[Match]:
        """The matches of a pair number."""
        legs, slots = self.plan.legs_of(number), self.plan.slots
        for leg, (candidate, base) in zip(legs, slots, strict=True):
            if row := self.store.row(leg.key):  # its own numbers may be those of another run
                here = replace(row, pair=leg.pair, leg=leg.leg)
                yield Match(here, leg.home.name, leg.away.name, candidate, base)


def gathered(legs: Sequence[Leg], store: Store, pool: PoolOf) -> Iterator[tuple[Leg, Row]]:
    """The rows of all these legs: those that are there first, in order, then as they come.

    What run() raises. No pool is made where nothing is missing.
    """
    there = 0
    for leg in legs:
        row = store.row(leg.key)
        if row is None:
            break
        there += 1
        yield leg, row
    if there < len(legs):
        with pool() as place, closing(run(legs[there:], store, place, twice=TWICE)) as rows:
            yield from rows
