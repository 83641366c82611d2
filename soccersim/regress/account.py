"""What a regression came to, whole: all that its report, its tables and its files are made of."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from soccersim.regress.row import Row
from soccersim.regress.rules import Rule
from soccersim.regress.samples import Sample
from soccersim.regress.standing import Standing


@dataclass(frozen=True)
class Match:
    """One leg as it was played, for people."""

    row: Row
    home: str  # the team's name as it is shown
    away: str
    candidate: int | None = None  # the slot that it played in, 0 HOME or 1 AWAY; None: it did not
    base: int | None = None


@dataclass(frozen=True)
class Account:
    """A run that is over, or stopped where it stands."""

    command: str  # to repeat it, as it was typed
    scenario: str
    base: str
    candidate: str
    against: tuple[str, ...]  # the opponents of both; none: they play each other
    base_sha: str
    candidate_sha: str
    rule: Rule
    standing: Standing
    samples: tuple[Sample, ...]  # that count, in order
    matches: tuple[Match, ...]  # all legs of these samples, by pair and leg
    jobs: int
    seconds: float  # that this run took, not those that it goes on from
    played: int  # legs played in this run
    found: int  # legs that were in the store already
    environment: Mapping[str, str]  # versions, platform, fingerprint
    store: Path
    recordings: Path  # Row.recording is the name of a file in this folder
