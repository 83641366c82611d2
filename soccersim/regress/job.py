"""How a match of a run is played: plain values in, plain values out.

`play_leg` is what a pool runs, in a thread here or on a machine of a cluster.
"""

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

from soccersim.match.supervise import APART, Attempt, Outcome, Request, attempt
from soccersim.match.turn import State
from soccersim.problems import InputError, MachineError, Problem
from soccersim.regress.bundle import Bundle, unpack
from soccersim.regress.engine import engine
from soccersim.regress.ground import Ground, own_ground
from soccersim.regress.leg import Leg
from soccersim.regress.row import Document, Row
from soccersim.spec.scenario import Scenario
from soccersim.strategy.load import Origin

RECORDING = "recording.npz"


@dataclass(frozen=True)
class Played:
    """What playing a leg came to."""

    row: Row | None  # None: the match came to no end
    doubt: str = ""  # why it should be played again before a team is blamed
    recording: bytes = b""  # of its file; empty where it is not wanted


class Lost(Exception):
    """Raised by a pool whose machine was lost, and with it the match."""


class Unwanted(Exception):
    """Raised in a match that nobody waits for any more."""


def play_leg(
    leg: Leg,
    alone: bool = False,
    ground: Ground | None = None,
    wanted: Callable[[], bool] | None = None,
) -> Played:
    """Play a match in a process of its own, each team in one too where it is played alone.

    wanted: asked many times a second, as is the ground. InputError where a strategy is not there,
    MachineError where the machine fails; Unwanted where nobody wants it any more.
    """
    start = time.perf_counter()
    if leg.engine != engine():
        wrong = "another soccersim, or another platform, than where the run was started"
        raise InputError(Problem(f"this is {wrong}: the matches would not be the same"))
    ground = ground or own_ground(leg.scenario)
    try:
        with TemporaryDirectory(
            prefix="leg-", dir=ground.folder, ignore_cleanup_errors=True
        ) as name:
            folder = Path(name)
            tried = tried_in(folder, leg, alone, ground, wanted)
            path = folder / RECORDING
            recording = path.read_bytes() if path.is_file() else b""
            if not tried.outcome:
                return Played(None, tried.doubt)
            row = row_of(leg, tried.outcome, folder, time.perf_counter() - start)
            return Played(row, tried.doubt, recording)
    except OSError as error:
        raise MachineError(f"{error.filename or 'a match'}: {error.strerror or error}") from error


def tried_in(
    folder: Path, leg: Leg, alone: bool, ground: Ground, wanted: Callable[[], bool] | None
) -> Attempt:
    """Play it once, with all its files in this folder."""
    request = Request(
        scenario_of(leg.scenario).model_copy(update={"seed": leg.seed}),
        (placed(leg.home, folder / "home"), placed(leg.away, folder / "away")),
        APART if alone else "match",
        None if leg.keep == "none" else folder / RECORDING,
        leg.keep,
        leg.watched,
    )

    def look(state: State) -> None:
        if ground.stopping.is_set() or not (wanted is None or wanted()):
            raise Unwanted

    return attempt(request, look, None, ground.child, ground.begin, folder)


def row_of(leg: Leg, outcome: Outcome, folder: Path, seconds: float) -> Row:
    """The row of a match; seconds: that it took with all round it."""
    factor = outcome.realtime_factor
    played = outcome.duration / factor if factor else 0.0
    return Row(
        key=leg.key,
        pair=leg.pair,
        leg=leg.leg,
        seed=leg.seed,
        home=leg.home.sha,
        away=leg.away.sha,
        score=outcome.score,
        digest=outcome.digest,
        duration=outcome.duration,
        faults=tuple(shown(fault, folder) for fault in outcome.faults),
        events=tuple(outcome.events),
        seconds=played,
        overhead=seconds - played,
    )


def void_row(leg: Leg, why: str) -> Row:
    """The row of a leg that the machine failed to play."""
    teams = leg.home.sha, leg.away.sha
    where = leg.key, leg.pair, leg.leg, leg.seed
    return Row(*where, *teams, (0, 0), "", 0.0, (), (), void=why)


def shown(fault: Document, folder: Path) -> Document:
    """A fault without the folder that its team's files stood in for this match."""
    detail = fault["detail"]
    for team in ("home", "away"):
        detail = detail.replace(f"{folder / team}{os.sep}", "")
    return {**fault, "detail": detail}


def placed(bundle: Bundle, folder: Path) -> Origin:
    """A bundle's files in a folder of this match alone: what a team does to them, no other sees."""
    folder.mkdir()
    return unpack(bundle, folder)


@lru_cache(16)
def scenario_of(text: str) -> Scenario:
    """The scenario that a text tells."""
    return Scenario.model_validate_json(text)
