"""What `soccersim plot` draws: of robots of one or several recordings, numbers over time."""

from dataclasses import dataclass
from pathlib import PurePath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.problems import InputError, Problem, one_line
from soccersim.record import Recording
from soccersim.render.plot_style import ROBOTS
from soccersim.render.tracks import framed, shortened

Array = NDArray[Any]
WHEELED = ("wheel_speed", "wheel_setpoint", "slip", "pwm")
LEFT_OUT = {  # arrays a recording may lack, and the group of the scenario's `record` they are of
    "wheel speeds and slip": ("wheel_speed", "wheels"),
    "set-points of wheels and PWM": ("pwm", "control"),
}
CARRIED = 20.0  # m/s; what is faster has been put there, as at half-time
LONGEST = 34  # letters of a name in a legend


@dataclass(frozen=True)
class Curve:
    """One robot's run: T records, W wheels; poses in its scenario's frame, headings unwrapped."""

    label: str
    team: str
    time: Array  # (T,) s
    true: Array  # (T, 3)
    believed: Array  # (T, 3)
    wanted: Array | None  # (T, 3), NaN where there is no set-point; None in a match
    wheels: dict[str, Array]  # of those that were recorded (T, W)
    driven: int  # wheels with a motor; the others follow

    @property
    def count(self) -> int:
        """All wheels."""
        return max((table.shape[1] for table in self.wheels.values()), default=self.driven)

    @property
    def wrapped(self) -> Array:
        """(T,) the true heading within half a turn, NaN where it would jump; rad."""
        heading = (self.true[:, 2] + np.pi) % (2 * np.pi) - np.pi
        heading[1:][np.abs(np.diff(heading)) > np.pi] = np.nan
        return heading

    @property
    def off(self) -> tuple[Array, Array]:
        """How far belief lies from truth, m, and believed less true heading, rad."""
        apart = self.believed - self.true
        return np.hypot(apart[:, 0], apart[:, 1]), apart[:, 2]


def curves(
    recordings: list[tuple[str, Recording]], robots: tuple[str, ...] = ()
) -> tuple[list[Curve], list[str]]:
    """What there is to draw, and what is left out and why, a line each.

    recordings: each with its file's name. Of one recording all robots are drawn, of several the
    first of each, unless robots are named.
    """
    told, drawn = [], []
    for label, (name, recording) in zip(labels(recordings), recordings, strict=True):
        if len(recording.tick) == 0:
            raise InputError(Problem("is empty: a team forfeited before it began", name))
        if not recording.scenario.robots:
            raise InputError(Problem("has no robots: arms alone are plotted by themselves", name))
        rows = _rows(name, recording, robots)
        if len(recordings) > 1 and not robots and len(rows) > 1:
            told.append(f"{name}: {len(rows)} robots; the first is shown, --robot NAME chooses")
            rows = rows[:1]
        for row in rows:
            player = recording.scenario.robots[row]
            parts = [label] if label else []
            if len(rows) > 1 or len(recordings) == 1:
                parts.append(player.name)
            drawn.append(_curve(recording, row, " ".join(parts)))
        if recording.scenario.arms:
            told.append(f"{name}: its arms are left out; --csv of replay tells their joints")
        for what, (key, group) in LEFT_OUT.items():
            if key not in recording.arrays:
                told.append(f"{name}: holds no {what}: `record` of its scenario lacks {group}")
    if len(drawn) > len(ROBOTS):
        told.append(f"the first {len(ROBOTS)} of {len(drawn)} robots are shown")
    return drawn[: len(ROBOTS)], told


def _rows(name: str, recording: Recording, robots: tuple[str, ...]) -> list[int]:
    """The robots of this name or number; all, where none is named."""
    names = [player.name for player in recording.scenario.robots]
    for robot in robots:
        if robot not in names:
            wrong = f"has no robot {one_line(robot)}: there are {', '.join(names)}"
            raise InputError(Problem(wrong, name))
    return [names.index(robot) for robot in dict.fromkeys(robots)] or list(range(len(names)))


def _curve(recording: Recording, row: int, label: str) -> Curve:
    at, model = recording.scenario.coordinates, recording.scenario.robots[row].model
    true = _unwrapped(framed(at, recording.body[:, row, :3]))
    believed = _unwrapped(framed(at, recording.estimate[:, row]))
    believed[:, 2] -= 2 * np.pi * np.round((believed[0, 2] - true[0, 2]) / (2 * np.pi))
    steps = np.hypot(*np.diff(true[:, :2], axis=0).T) / np.diff(recording.time)
    carried = 1 + np.flatnonzero(steps > CARRIED)
    true[carried] = believed[carried] = np.nan  # no line leads there
    driven = len(model.drive.azimuth_deg)
    count = driven + (len(model.dead.azimuth_deg) if model.dead else 0)
    arrays = recording.arrays
    return Curve(
        label=label,
        team=recording.scenario.robots[row].team,
        time=recording.time,
        true=true,
        believed=believed,
        wanted=framed(at, recording.reference[:, row]) if "reference" in arrays else None,
        wheels={key: arrays[key][:, row, :count] for key in WHEELED if key in arrays},
        driven=driven,
    )


def labels(recordings: list[tuple[str, Recording]]) -> list[str]:
    """Each file by as little of its path as tells it from the others; a single one by nothing."""
    if len(recordings) == 1:
        return [""]
    paths = [PurePath(name).with_suffix("").parts for name, _ in recordings]
    while len(set(paths)) > 1 and len({path[-1:] for path in paths}) == 1:
        paths = [path[:-1] for path in paths]  # all are called recording.npz
    for parts in range(1, 9):
        names = ["/".join(path[-parts:]) for path in paths]
        if len(set(names)) == len(names):
            break
    else:
        names = [f"{number} {name}" for number, name in enumerate(names, 1)]
    return [
        name if len(name) <= LONGEST else "…" + shortened(name[1 - LONGEST :], LONGEST)
        for name in names
    ]


def _unwrapped(poses: Array) -> Array:
    poses[:, 2] = np.unwrap(poses[:, 2])
    return poses
