"""A round robin: every two teams meet on the same seeds, a pair of matches on each."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

from soccersim.match.keep import Keep
from soccersim.regress.leg import Leg
from soccersim.regress.plan import Schedule, Team, pair_between, pair_in
from soccersim.regress.row import Row
from soccersim.regress.table import Meeting, Table, table
from soccersim.spec.scenario import Scenario


@dataclass(frozen=True)
class Tournament(Schedule):
    """Who plays, on how many seeds."""

    scenario: Scenario
    teams: tuple[Team, ...]
    pairs: int  # of every two teams
    seed: int  # of pair 0
    keep: Keep = "none"

    @property
    def most(self) -> int:
        """Pair numbers."""
        return self.pairs

    @property
    def couples(self) -> tuple[tuple[int, int], ...]:
        """Every two teams, as numbers from 0."""
        return tuple(combinations(range(len(self.teams)), 2))

    @cached_property
    def meetings(self) -> tuple[Leg, ...]:
        """The legs of pair 0: both legs of every two teams."""
        return tuple(
            leg
            for one, two in self.couples
            for leg in pair_between(
                self.scenario, (self.teams[one], self.teams[two]), self.seed, self.keep, None
            )
        )

    def table(self, rows: Mapping[str, Row]) -> Table:
        """Where they stand after these rows, by the keys of their legs; half pairs do not count."""
        met = [
            meeting
            for number in range(self.pairs)
            for meeting in self._met(self.legs_of(number), rows)
        ]
        return table([team.name for team in self.teams], met)

    def _met(self, legs: Sequence[Leg], rows: Mapping[str, Row]) -> list[Meeting]:
        """The meetings of a seed that are whole."""
        met = []
        for at, (one, two) in enumerate(self.couples):
            both = [rows.get(leg.key) for leg in legs[2 * at : 2 * at + 2]]
            played = [row for row in both if row and not row.void]
            if len(played) == 2:
                met.append(Meeting(one, two, pair_in(played)))
        return met
