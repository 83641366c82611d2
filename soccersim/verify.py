"""Play a recording again from what was ordered, and find the first record that differs."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from soccersim.match.game import Game
from soccersim.match.pitch import team_rows
from soccersim.match.seats import TapeSeat
from soccersim.problems import InputError, Problem
from soccersim.record import Recording
from soccersim.record.digest import fingerprint
from soccersim.simulation import Simulation


class Verdict(NamedTuple):
    """Whether a recording is what its scenario and its orders lead to."""

    same: bool
    tick: int | None  # of the first record that differs; None where none does
    elsewhere: list[str]  # what of the platform is not as when it was recorded


def verify(recording: Recording, progress: Callable[[float], None] | None = None) -> Verdict:
    """Simulate again: a run from its scenario alone, a match from the teams' recorded orders."""
    here, there = fingerprint(), recording.meta.get("platform", {})
    elsewhere = [name for name in here if here[name] != there.get(name)]
    again = _again(recording, progress)
    old, new = recording.arrays["chain"], again.arrays["chain"]
    both = min(len(old), len(new))
    differ = np.flatnonzero((old[:both] != new[:both]).any(axis=1))
    if len(differ):
        return Verdict(False, int(recording.tick[differ[0]]), elsewhere)
    if len(old) != len(new) or recording.digest != again.digest:
        end = min(int(run.meta["ticks"]) for run in (recording, again))
        return Verdict(False, end, elsewhere)
    return Verdict(True, None, elsewhere)


def _again(recording: Recording, progress: Callable[[float], None] | None) -> Recording:
    scenario = recording.scenario
    if recording.match is None:
        return Simulation(scenario).run(progress)
    orders = recording.arrays.get("orders")
    if orders is None or orders.ndim != 3 or orders.shape[1:] != (len(scenario.robots), 5):
        raise InputError(Problem("has no orders to play again"))
    seats = [TapeSeat(orders[:, team_rows(scenario, slot)]) for slot in (0, 1)]
    game = Game(scenario)
    return game.play(seats, progress, until=int(recording.meta["ticks"])).recording
