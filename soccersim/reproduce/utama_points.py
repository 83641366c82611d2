"""Utama's points, and our runs of the same tasks in the same units: mm, degrees clockwise."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccersim.reproduce.lab import Lab
from soccersim.reproduce.samples import band_cells, distance, percentile, poses, rounded
from soccersim.reproduce.section import Cell
from soccersim.reproduce.tables import table
from soccersim.spec.load import load_scenario
from soccersim.spec.scenario import Scenario
from soccersim.state import Array

RUNS = ("defender", "midfielder", "striker")
FROM_SI = (1000.0, 1000.0, -180.0 / np.pi)  # to mm and degrees clockwise
COLUMNS = (
    *("point", "what", "paper", "physics median", "physics 5 %", "physics 95 %"),
    *("paper - physics", "paper's percentile in physics"),
    *("fitted median", "fitted 5 %", "fitted 95 %", "paper's percentile in fitted"),
)
CHOSEN = (
    "Physics: motors, slip, encoders of the dead wheels, gyro. Chosen by the order of magnitude of "
    "section III, so no prediction: dead wheels that roll 3 % +- 3 % smaller than drawn (legs are "
    "0.970 +- 0.031 of what the sensors say) and a gyro with 1 deg/s (1 sd) of offset left (legs "
    "turned by 4.2 degrees, 1 sd). Grip, motors and mass are estimates."
)
FITTED = (
    "Fitted: each leg of the paper's sensors scaled by N(0.970, 0.031) and turned by N(0, 4.2 "
    "degrees), as its five legs are."
)


def points(run: str, quantity: str) -> Array:
    """(n + 1, 2) mm, from A on: `commanded`, `sensor` or `measured`."""
    rows = [r for r in table("utama-points").rows if (r["run"], r["quantity"]) == (run, quantity)]
    return np.array([[row["x"], row["y"]] for row in rows], dtype=np.float64)


def compass(run: str) -> Array:
    """(n + 1,) degrees clockwise as the paper's compass had them, 0 at A."""
    rows = [r for r in table("utama-points").rows if (r["run"], r["quantity"]) == (run, "sensor")]
    return np.array([row["heading"] or 0.0 for row in rows], dtype=np.float64)


@dataclass(frozen=True)
class Runs:
    """All seeds of one task, poses (S, n + 1, 3) from the start on."""

    sensor: Array  # where the robot believes to be
    true: Array
    target: Array  # (n, 3)


def simulate(lab: Lab, name: str) -> Runs:
    """A task over the seeds of the lab."""
    runs = lab.runs(name)
    start = np.zeros((len(runs), 1, 3))
    sensor, true = (
        np.concatenate((start, poses(runs, key) * FROM_SI), axis=1) for key in ("odometry", "truth")
    )
    return Runs(sensor, true, poses(runs[:1], "target")[0] * FROM_SI)


def median_seed(lab: Lab, runs: Runs) -> int:
    """The seed whose gap between measured and sensor end is the median one."""
    gaps = distance(runs.sensor[:, -1], runs.true[:, -1])
    return lab.seeds[int(np.argsort(gaps)[len(gaps) // 2])]


def track(name: str, seed: int) -> dict[str, Any]:
    """One run over time: `time` (T,) s; `sensor`, `true`, `commanded` (T, 3) in mm and deg."""
    from soccersim.render.tracks import tracks
    from soccersim.simulation import Simulation

    scenario: Scenario = load_scenario(name, seed=seed)
    recording = Simulation(scenario).run()
    robot = tracks(recording)[0]
    return {
        "time": recording.time,
        "sensor": robot.believed * FROM_SI,
        "true": robot.true * FROM_SI,
        "commanded": robot.commanded * FROM_SI,
    }


def row(
    point: str, what: str, paper: float | None, physics: Array, fitted: Array | None = None
) -> list[Cell]:
    """What COLUMNS name, of (S,) numbers."""
    cells: list[Cell] = [*band_cells(physics)]
    if paper is None:
        cells += [None, None]
    else:
        cells += [float(paper - np.median(physics)), percentile(paper, physics)]
    if fitted is None:
        cells += [None, None, None, None]
    else:
        cells += [*band_cells(fitted), None if paper is None else percentile(paper, fitted)]
    digits = 2 if "(mm)" not in what else 1
    return [point, what, paper, *rounded([cells], digits)[0]]


def outside(rows: Sequence[Sequence[Cell]]) -> list[str]:
    """`B sensor x` and the like: where the paper lies out of the physics' band."""
    names = []
    for point, what, paper, _, low, high, *_rest in rows:
        numbers = [value for value in (paper, low, high) if isinstance(value, float)]
        if len(numbers) == 3 and not numbers[1] <= numbers[0] <= numbers[2]:
            names.append(f"{point} {str(what).split(' (')[0]}")
    return names
