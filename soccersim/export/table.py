"""A recording as one table: a row for each recorded tick, units in the header."""

import csv
from collections.abc import Callable, Iterator
from os import PathLike, fspath
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from soccersim.export.remarks import label_table
from soccersim.export.state import SIDES, wheel_counts
from soccersim.problems import MachineError
from soccersim.record.recording import Recording
from soccersim.render.cut import shown
from soccersim.sheet import PHASES
from soccersim.touches import BallPlay

Progress = Callable[[int, int], None]  # how many rows are done, of how many
Array = NDArray[Any]
PIECE = 1000  # rows turned at once: bounds the memory of a long match
POSE = (("x", "m"), ("y", "m"), ("heading", "rad"))
MOTION = (*POSE, ("vx", "m/s"), ("vy", "m/s"), ("omega", "rad/s"))
TWIST = (("vx", "m/s"), ("vy", "m/s"), ("omega", "rad/s"))
ORDER = (*TWIST, ("kick", "m/s"), ("dribble", ""))
ONE = (("", ""),)
SEEN = (("x", "m"), ("y", "m"), ("vx", "m/s"), ("vy", "m/s"), ("age", "s"))
OF_WHEELS = {  # array: what the column is called, and its unit
    "wheel_angle": ("angle", "rad"),
    "wheel_speed": ("speed", "rad/s"),
    "wheel_setpoint": ("set-point", "rad/s"),
    "slip": ("slip", "m/s"),
    "load": ("load", "N"),
    "counts": ("encoder", "counts"),
    "pwm": ("pwm", "of 255"),
}
OF_ROBOTS = {  # array of a match: what its columns are called, and their parts
    "orders": ("command", ORDER),
    "ball_sighted": ("sees ball", (("x", "m"), ("y", "m"))),
    "label": ("label", ONE),
    "in_play": ("in play", ONE),
    "contact": ("feels the ball", ONE),
}
FLAGS = {"started": "started", "direction": "home plays towards x"}


class Column(NamedTuple):
    """One column: what stands above it, and its T numbers; words: what a number stands for."""

    name: str
    unit: str
    values: Array
    words: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        """Name and unit: `home-1 x [m]`."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    def cells(self, part: slice) -> list[Any]:
        """Some of its cells: NaN is empty, numbers are written with all their digits."""
        values = self.values[part]
        if self.words:
            return [self.words[int(value)] for value in values]
        if values.dtype.kind == "f" and not np.isfinite(values).all():
            return ["" if value != value else value for value in values.tolist()]
        return list(values.tolist())


def save_csv(
    recording: Recording,
    path: str | PathLike[str],
    progress: Progress | None = None,
    start: float | None = None,
    end: float | None = None,
) -> int:
    """Write the table and say how many rows it has; start and end in seconds, both included."""
    records, table = shown(recording, start, end), list(columns(recording))
    try:
        with open(path, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow([column.title for column in table])
            for first in range(records.start, records.stop, PIECE):
                last = min(first + PIECE, records.stop)
                cells = [column.cells(slice(first, last)) for column in table]
                writer.writerows(zip(*cells, strict=True))
                if progress:
                    progress(last - records.start, len(records))
    except OSError as error:
        raise MachineError(f"{fspath(path)}: {error.strerror or error}") from error
    return len(records)


def columns(recording: Recording) -> Iterator[Column]:
    """All columns, from left to right; docs/export.md tells them."""
    arrays = recording.arrays
    yield Column("time", "s", recording.time)
    yield Column("tick", "", recording.tick)
    decision = BallPlay(recording).decision if recording.match else None
    if decision is not None:
        yield from _game(arrays, decision)
    if recording.ball is not None:
        yield from _several("ball", MOTION, recording.ball)
    if decision is not None:
        for slot, side in enumerate(SIDES):
            seen = arrays["ball_believed"][:, slot][decision]
            yield from _several(f"{side} believes ball", SEEN, seen)
    counts = wheel_counts(recording)
    told = {} if decision is None else _told(recording, decision)
    for robot, player in enumerate(recording.scenario.robots):
        name = player.name
        yield from _several(name, MOTION, recording.body[:, robot])
        yield from _several(f"{name} believed", POSE, recording.estimate[:, robot])
        for key, (word, parts) in OF_ROBOTS.items():
            if key in told:
                yield from _several(f"{name} {word}", parts, told[key][:, robot])
        if decision is None:
            yield Column(f"{name} leg", "", recording.leg[:, robot])
            yield from _several(f"{name} set-point", POSE, recording.reference[:, robot])
            if "command" in arrays:
                yield from _several(f"{name} command", TWIST, arrays["command"][:, robot])
        yield from _sensors(arrays, name, robot, counts[robot])
    for number, arm in enumerate(recording.scenario.arms):
        if "joint" in arrays:
            joints = tuple((f"joint {k}", "rad") for k in (1, 2, 3))
            yield from _several(arm.name, joints, arrays["joint"][:, number])


def _game(arrays: dict[str, Array], decision: Array) -> Iterator[Column]:
    """The state of a match."""
    yield Column("phase", "", arrays["phase"][decision], tuple(PHASES))
    whose = arrays["whose"][decision].astype(int) + 1  # -1 is nobody's
    yield Column("restart of", "", whose, ("", *SIDES))
    for slot, side in enumerate(SIDES):
        yield Column(f"{side} goals", "", arrays["score"][:, slot][decision])
    for key, name in FLAGS.items():
        yield Column(name, "", arrays[key][decision])


def _told(recording: Recording, decision: Array) -> dict[str, Array]:
    """(T, R, n) of a match: what each robot was told at the last decision, and what it saw.

    A sighting stands in the one row in which it came.
    """
    arrays = dict(recording.arrays, label=label_table(recording))
    told = {key: arrays[key][decision] for key in OF_ROBOTS if key in arrays}
    if "ball_sighted" in told:
        told["ball_sighted"][np.diff(decision, prepend=-1) == 0] = np.nan
    return {key: table if table.ndim == 3 else table[..., None] for key, table in told.items()}


def _sensors(arrays: dict[str, Array], name: str, robot: int, wheels: int) -> Iterator[Column]:
    """What `record` kept of the wheels and the gyro."""
    if "gyro" in arrays:
        yield Column(f"{name} gyro", "rad/s", arrays["gyro"][:, robot])
    for wheel in range(wheels):
        for key, (word, unit) in OF_WHEELS.items():
            if key in arrays:
                yield Column(f"{name} wheel {wheel + 1} {word}", unit, arrays[key][:, robot, wheel])


def _several(name: str, parts: tuple[tuple[str, str], ...], table: Array) -> Iterator[Column]:
    """A column for each part of a table (T, n)."""
    for number, (part, unit) in enumerate(parts):
        yield Column(f"{name} {part}".rstrip(), unit, table[:, number])
