"""The table of a tournament: points, goals and ratings, and who took what from whom."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from soccersim.regress.rating import Ratings, ratings
from soccersim.regress.samples import Pair

POINTS = (3, 1, 0)  # a match won, drawn, lost: as leagues count
Counted = NDArray[np.int64]


class Meeting(NamedTuple):
    """One pair of a tournament, seen by its first team; teams are numbers from 0."""

    first: int
    second: int
    pair: Pair


class Row(NamedTuple):
    """A team's line in the table."""

    team: str
    played: int  # matches
    won: int
    drawn: int
    lost: int
    goals: int
    against: int
    points: int
    elo: float  # about the mean of the field
    error: float  # half of its 95 % interval
    faults: int


@dataclass(frozen=True)
class Table:
    """Where the teams of a tournament stand."""

    rows: tuple[Row, ...]  # best first: by points a match, goal difference, goals, name
    cross: Counted  # (T, T, 3) in the rows' order: won, drawn, lost by row against column
    ratings: Ratings  # in the order in which the teams were named

    def document(self) -> dict[str, Any]:
        """For JSON. Every number is finite."""
        return {
            "teams": [row._asdict() for row in self.rows],
            "cross": self.cross.tolist(),
            "pairs": int(self.cross.sum()) // 4,
            "draws": self.ratings.draws,
        }


def table(teams: Sequence[str], meetings: Sequence[Meeting]) -> Table:
    """The table after these pairs; void ones are left out by the caller."""
    count = len(teams)
    cross = np.zeros((count, count, 3), dtype=np.int64)
    sums = np.zeros((count, 3), dtype=np.int64)  # goals for, goals against, faults
    results = [_results(meeting.pair) for meeting in meetings]
    for (first, second, pair), (won, drawn, lost) in zip(meetings, results, strict=True):
        cross[first, second] += (won, drawn, lost)
        cross[second, first] += (lost, drawn, won)
        goals, against = sum(leg.goals for leg in pair), sum(leg.against for leg in pair)
        sums[first] += (goals, against, sum(leg.faults for leg in pair))
        sums[second] += (against, goals, sum(leg.faults_against for leg in pair))
    rated = ratings(count, [meeting[:2] for meeting in meetings], results)
    rows = [_row(team, cross[k], sums[k], rated, k) for k, team in enumerate(teams)]
    order = sorted(range(count), key=lambda k: _rank(rows[k]))
    return Table(tuple(rows[k] for k in order), cross[np.ix_(order, order)], rated)


def _row(team: str, cross: Counted, sums: Counted, rated: Ratings, k: int) -> Row:
    won, drawn, lost = (int(number) for number in cross.sum(axis=0))
    goals, against, faults = (int(number) for number in sums)
    return Row(
        team,
        played=won + drawn + lost,
        won=won,
        drawn=drawn,
        lost=lost,
        goals=goals,
        against=against,
        points=won * POINTS[0] + drawn * POINTS[1] + lost * POINTS[2],
        elo=float(rated.elo[k]),
        error=float(rated.error[k]),
        faults=faults,
    )


def _results(pair: Pair) -> tuple[int, int, int]:
    """Matches won, drawn and lost by the first team."""
    won = sum(leg.goals > leg.against for leg in pair)
    lost = sum(leg.goals < leg.against for leg in pair)
    return won, len(pair) - won - lost, lost


def _rank(row: Row) -> tuple[float, int, int, str]:
    """Smaller is better. Points a match: while a tournament runs, some have played more."""
    return -row.points / max(row.played, 1), row.against - row.goals, -row.goals, row.team
