"""What may be opened: bundled scenarios and teams, and those named on the command line.

A browser names them by the names told to it: no path of its own ever reaches the disk.
"""

import json
from dataclasses import dataclass, field
from functools import cached_property

from soccersim import bundled
from soccersim.live.free import FreePlay
from soccersim.live.match import MatchPlay
from soccersim.live.messages import Open, Wrong
from soccersim.live.play import Play
from soccersim.spec.load import load_scenario
from soccersim.spec.scenario import Scenario
from soccersim.spec.yaml12 import read

PAPERS = "the papers' runs"
AUTHORS = ("Utama", "Idris et al.", "Garcia-Sillas et al.", "Dasmahapatra", "The four-wheel note")


@dataclass
class Catalogue:
    """What is offered, and what runs now."""

    source: str  # of the command line: a name or a path
    settings: tuple[str, ...] = ()
    seed: int | None = None
    home: str | None = None
    away: str | None = None
    current: Open = field(init=False)

    def __post_init__(self) -> None:
        self.current = Open(do="open", scenario=self.source)

    @cached_property
    def scenarios(self) -> dict[str, tuple[str, str]]:
        """Names that may be opened, each with its group and a sentence about it."""
        known = {name: described(name) for name in bundled.names("scenario")}
        return known if self.source in known else {self.source: ("yours", ""), **known}

    @property
    def teams(self) -> list[str]:
        """Strategies that may be named."""
        return bundled.names("strategy")

    def first(self) -> Play:
        """What the command line named; InputError where it cannot be."""
        return self._play(self.current)

    def open(self, message: Open) -> Play:
        """What a browser names; Wrong where it is not offered."""
        if message.scenario not in self.scenarios:
            raise Wrong("scenario: not one of those offered")
        for team in (message.home, message.away):
            if team is not None and team not in self.teams:
                raise Wrong("team: not one of those offered")
        play = self._play(message)
        self.current = message
        return play

    def _play(self, message: Open) -> Play:
        own = message.scenario == self.source
        teams = []
        for side in ("home", "away"):
            name = getattr(message, side) or (getattr(self, side) if own else None)
            if name:
                teams += [f"match.{side}.strategy={json.dumps(name)}", f"match.{side}.options={{}}"]
        settings = [*teams, *(self.settings if own else ())]
        seed = message.seed if message.seed is not None else self.seed if own else None
        return play_of(load_scenario(message.scenario, seed=seed, settings=settings))


def described(name: str) -> tuple[str, str]:
    """The group of a bundled scenario, and its first sentence."""
    tree = read(bundled.find("scenario", name)).value
    told = tree if isinstance(tree, dict) else {}
    about = str(told.get("about", "")).split(". ")[0].rstrip(".")
    group = PAPERS if about.startswith(AUTHORS) else "matches" if "match" in told else "others"
    return group, about


def play_of(scenario: Scenario) -> Play:
    """A play of its kind."""
    return MatchPlay(scenario) if scenario.match else FreePlay(scenario)
