"""One match to be played: plain values, told apart by a key."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, Literal

from soccersim.match.keep import Keep
from soccersim.regress.bundle import Bundle
from soccersim.regress.engine import engine
from soccersim.spec.scenario import Scenario

Options = Mapping[str, Any]


@dataclass(frozen=True)
class Leg:
    """One match of a pair."""

    scenario: str  # JSON, everything in it expanded
    home: Bundle
    away: Bundle
    seed: int
    pair: int
    leg: Literal[0, 1]  # 1: HOME and AWAY exchanged
    engine: str  # what the key holds for
    keep: Keep = "none"  # whether its recording is wanted: not part of the key
    watched: int | None = None  # the slot whose losses are `lost` ones; None: both

    @cached_property
    def key(self) -> str:
        """SHA-256 of all that may change how it comes out; names and pair numbers do not."""
        teams = self.home.sha, self.away.sha
        told = [identity(self.scenario), *teams, self.engine, self.seed, self.leg]
        return hashlib.sha256(json.dumps(told).encode()).hexdigest()


def pair_of(
    scenario: Scenario,
    teams: tuple[Bundle, Bundle],
    number: int,
    seed: int,
    *,
    options: tuple[Options, Options] = ({}, {}),
    keep: Keep = "none",
    watched: int | None = None,
) -> tuple[Leg, Leg]:
    """The two legs of a pair, the first team HOME in the first of them.

    options: of the teams. watched: the team, 0 or 1, whose losses are `lost` ones.
    """
    one, two = teams
    first = told(scenario, (one, options[0]), (two, options[1]))
    second = told(scenario, (two, options[1]), (one, options[0]))
    away = None if watched is None else 1 - watched
    return (
        Leg(first, one, two, seed, number, 0, engine(), keep, watched),
        Leg(second, two, one, seed, number, 1, engine(), keep, away),
    )


def told(scenario: Scenario, home: tuple[Bundle, Options], away: tuple[Bundle, Options]) -> str:
    """The scenario with these teams, as JSON."""
    if scenario.match is None:
        raise ValueError(f"{scenario.name} is no match")
    teams = {
        side: getattr(scenario.match, side).model_copy(
            update={"strategy": bundle.name, "options": dict(options)}
        )
        for side, (bundle, options) in (("home", home), ("away", away))
    }
    match = scenario.match.model_copy(update=teams)
    return scenario.model_copy(update={"match": match}).model_dump_json()


@lru_cache(1024)  # two for every two teams that meet
def identity(text: str) -> str:
    """SHA-256 of a scenario, without its seed and what is a name alone."""
    told = json.loads(text)
    for key in ("seed", "name", "about"):
        told.pop(key, None)
    for side in ("home", "away"):
        told["match"][side].pop("strategy", None)
    return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()
