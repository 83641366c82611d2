"""A match in a scenario: who plays, by which rules."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field as Key

from soccersim.spec.base import Name, NonNegative, Positive, Rate, Spec
from soccersim.spec.rules import Rules
from soccersim.spec.validate import Fault

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario

MAX_TEAM = 11  # robots of one team; the league plays with five


class Team(Spec):
    """One side: its strategy, and what the strategy is told when it is made."""

    strategy: Annotated[str, Key(min_length=1, max_length=1000)] = "still"
    """A bundled name, a file, `file.py:Class`, `package.module:Class`, or an entry point."""
    options: dict[str, Any] = Key(default_factory=dict)
    """Keyword arguments of the strategy's class."""


class Failure(Spec):
    """A robot that stops answering."""

    robot: Name
    """Its name."""
    time: NonNegative
    """Seconds from the start of the match."""
    seconds: Positive = 10.0
    """How long it does not answer."""


class Match(Spec):
    """A match of two halves, each half of the scenario's duration; the clock never stops."""

    rules: Rules
    """A bundled set of rules by name, a file, or the rules themselves."""
    home: Team = Team()
    """Kicks off the first half."""
    away: Team = Team()
    """Kicks off the second half."""
    decide_hz: Rate = 25
    """Decisions a second of each team, and of the referee."""
    swap_ends: bool = False
    """True: home begins at the other end, all starts turned by half a turn."""
    failures: Annotated[tuple[Failure, ...], Key(strict=False, max_length=1000)] = ()
    """Robots that stop answering for a while."""


def line_up_faults(scenario: "Scenario") -> Iterator[Fault]:
    """What keeps a scenario from being a match."""
    match = scenario.match
    if match is None:
        return
    if scenario.ball is None:
        yield Fault("needs a `ball`", at=("match",))
    elif scenario.ball.shots:
        yield Fault("have no place in a match", at=("ball", "shots"))
    if scenario.timing.physics_hz % match.decide_hz:
        wrong = f"must divide physics_hz = {scenario.timing.physics_hz}"
        yield Fault(wrong, at=("match", "decide_hz"))
    for team in ("home", "away"):
        rows = [(i, p) for i, p in enumerate(scenario.robots) if p.team == team]
        if not 1 <= len(rows) <= MAX_TEAM:
            wrong = f"a match needs 1 to {MAX_TEAM} robots of team {team}, not {len(rows)}"
            yield Fault(wrong, at=("robots",))
        numbers = [p.number for _, p in rows]
        keepers = [p.keeper for _, p in rows]
        for at, (i, player) in enumerate(rows):
            if player.number in numbers[:at]:
                yield Fault(f"{player.number} is taken in team {team}", at=("robots", i, "number"))
            if player.keeper and any(keepers[:at]):
                yield Fault(f"team {team} has a keeper already", at=("robots", i, "keeper"))
    for i, player in enumerate(scenario.robots):
        for key in ("path", "open_loop"):
            if getattr(player, key):
                yield Fault("has no place in a match: strategies decide", at=("robots", i, key))
    names = [player.name for player in scenario.robots]
    for i, failure in enumerate(match.failures):
        if failure.robot not in names:
            yield Fault(f"no robot is named {failure.robot}", at=("match", "failures", i, "robot"))
