"""What is played: which teams meet on which seeds, and what the matches of a seed come to."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from typing import Any

from soccersim.match.keep import Keep
from soccersim.match.turn import SIDES
from soccersim.problems import InputError, Problem
from soccersim.regress import samples
from soccersim.regress.bundle import Bundle, same_program
from soccersim.regress.engine import engine
from soccersim.regress.leg import Leg, Options, pair_of
from soccersim.regress.row import Row
from soccersim.regress.rules import Fixed, Rule, Sprt
from soccersim.regress.samples import Pair, Sample
from soccersim.spec.scenario import Scenario

Parting = Callable[[Row, Row], int | None]  # the first tick at which two matches differ


@dataclass(frozen=True)
class Team:
    """A strategy as it was when the run began, and its options."""

    bundle: Bundle
    options: Options = field(default_factory=dict)

    @property
    def name(self) -> str:
        """As it was named by whoever asked for it."""
        return self.bundle.name

    def document(self) -> dict[str, Any]:
        """All of it but the code."""
        return {"name": self.name, "sha": self.bundle.sha, "options": dict(self.options)}


class Schedule:
    """Meetings of teams, played once on each of so many seeds."""

    scenario: Scenario
    seed: int  # of pair 0

    @property
    def most(self) -> int:
        """Pair numbers."""
        raise NotImplementedError

    @property
    def meetings(self) -> tuple[Leg, ...]:
        """The legs of pair 0."""
        raise NotImplementedError

    def legs_of(self, number: int) -> tuple[Leg, ...]:
        """The legs of a pair number."""
        return tuple(replace(leg, pair=number, seed=self.seed + number) for leg in self.meetings)

    def legs(self, first: int = 0, shard: int = 0, shards: int = 1) -> Iterator[Leg]:
        """All legs from a pair number on, or of every so many-th number; in their order."""
        for number in range(first, self.most):
            if number % shards == shard:
                yield from self.legs_of(number)


@dataclass(frozen=True)
class Plan(Schedule):
    """Candidate and base against each other, or both against the same opponents."""

    scenario: Scenario
    base: Team
    candidate: Team
    against: tuple[Team, ...]
    rule: Rule
    seed: int  # of pair 0
    keep: Keep = "none"
    engine: str = field(default_factory=engine)

    @property
    def most(self) -> int:
        """Pair numbers, at most."""
        return self.rule.most

    @cached_property
    def meetings(self) -> tuple[Leg, ...]:
        """The legs of pair 0: each candidate's pair before the one of the base."""
        met = [(self.candidate, self.base)]
        if self.against:
            met = [(us, them) for them in self.against for us in (self.candidate, self.base)]
        return tuple(leg for two in met for leg in met_by(self, two))

    @cached_property
    def slots(self) -> tuple[tuple[int | None, int | None], ...]:
        """Where candidate and base play in each of them: 0 HOME, 1 AWAY, None: not at all."""
        if not self.against:
            return (0, 1), (1, 0)
        return ((0, None), (1, None), (None, 0), (None, 1)) * len(self.against)

    @cached_property
    def same_code(self) -> bool:
        """Whether both are the same program with the same options."""
        same = same_program(self.base.bundle, self.candidate.bundle)
        return same and self.base.options == self.candidate.options

    def sample(self, number: int, rows: Sequence[Row], parting: Parting) -> Sample:
        """What the legs of this number came to; rows as in legs_of."""
        if any(row.void for row in rows):
            return samples.void(number)
        pairs = [pair_in(rows[at : at + 2]) for at in range(0, len(rows), 2)]
        if not self.against:
            return samples.between(number, pairs[0], parting(rows[0], rows[1]))
        twins = [(at, at + 2) for at in range(len(rows)) if at % 4 < 2]  # candidate's and base's
        parted = [parting(rows[one], rows[two]) for one, two in twins]
        first = min((tick for tick in parted if tick is not None), default=None)
        return samples.compared(number, pairs[::2], pairs[1::2], first)

    @property
    def teams(self) -> tuple[Team, ...]:
        """All who play."""
        return self.base, self.candidate, *self.against

    def document(self) -> dict[str, Any]:
        """All but the teams' code: what makes two plans the same one."""
        kind = "pairs" if isinstance(self.rule, Fixed) else "sprt"
        return {
            "scenario": self.scenario.model_dump(mode="json"),
            "base": self.base.document(),
            "candidate": self.candidate.document(),
            "against": [team.document() for team in self.against],
            "rule": {kind: asdict(self.rule)},
            "seed": self.seed,
            "engine": self.engine,
        }


def met_by(plan: Plan, two: tuple[Team, Team]) -> tuple[Leg, Leg]:
    """The pair 0 of two teams; the losses of the first are those to be kept."""
    one, other = pair_between(plan.scenario, two, plan.seed, plan.keep, 0)
    return replace(one, engine=plan.engine), replace(other, engine=plan.engine)


def pair_between(
    scenario: Scenario, two: tuple[Team, Team], seed: int, keep: Keep, watched: int | None
) -> tuple[Leg, Leg]:
    """The pair 0 of two teams."""
    options = two[0].options, two[1].options
    teams = two[0].bundle, two[1].bundle
    return pair_of(scenario, teams, 0, seed, options=options, keep=keep, watched=watched)


def plan_of(document: Mapping[str, Any], bundles: Mapping[str, Bundle]) -> Plan:
    """The plan that a document tells; InputError where it was written by another soccersim."""

    def team(told: Mapping[str, Any]) -> Team:
        return Team(Bundle(told["name"], bundles[told["sha"]].data), told["options"])

    try:
        ((kind, rule),) = document["rule"].items()
        return Plan(
            Scenario.model_validate_json(json.dumps(document["scenario"])),
            team(document["base"]),
            team(document["candidate"]),
            tuple(map(team, document["against"])),
            Fixed(**rule) if kind == "pairs" else Sprt(**rule),
            document["seed"],
            engine=document["engine"],
        )
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(Problem("holds the plan of another soccersim, or is damaged")) from error


def pair_in(rows: Sequence[Row]) -> Pair:
    """Two legs as the team saw them that was HOME in the first."""
    return Pair(seen(rows[0], 0), seen(rows[1], 1))


def seen(row: Row, slot: int) -> samples.Leg:
    """A match as the team in this slot saw it."""
    faults = [sum(fault["side"] == side for fault in row.faults) for side in SIDES]
    return samples.Leg(
        row.score[slot], row.score[1 - slot], row.digest, faults[slot], faults[1 - slot]
    )
