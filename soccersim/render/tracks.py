"""What the plots draw: where each robot was told to go, believed it was and truly was.

All in the scenario's frame: metres and radians, headings counter-clockwise and unwrapped.
"""

from dataclasses import dataclass
from string import ascii_uppercase
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.record import Recording
from soccersim.spec.frame import Coordinates
from soccersim.spec.player import Player

Array = NDArray[Any]
SAME_PLACE = 1e-3  # m; targets as near as this are one place with one letter
TURN = 2 * np.pi


@dataclass(frozen=True)
class End:
    """How a leg, or a phase of open-loop driving, ended."""

    begin: float  # s
    time: float  # s
    reached: bool
    place: int | None  # the track's place it was to reach; None: open loop
    odometry: Array  # (3,)
    truth: Array  # (3,)

    @property
    def given_up(self) -> bool:
        """There was a target, and the robot did not get there."""
        return self.place is not None and not self.reached


@dataclass(frozen=True)
class Track:
    """One robot's run: T records, a route of K points over P places."""

    number: int
    name: str
    radius: float
    true: Array  # (T, 3)
    believed: Array  # (T, 3)
    commanded: Array  # (T, 3), NaN where there is no set-point
    route: Array  # (K, 2): the start and the targets, one after the other
    places: Array  # (P, 2): the same without repetitions
    ends: list[End]
    paper_odometry: Array  # (N, 2): what the scenario's paper printed
    paper_truth: Array  # (M, 2)

    @property
    def label(self) -> str:
        """Number and name, short enough for a legend."""
        return f"{self.number} {shortened(self.name, 10)}"

    @property
    def drift(self) -> Array:
        """(T, 2): how far belief and truth lie apart, m, and the true heading less the believed."""
        apart = self.true - self.believed
        return np.column_stack((np.hypot(apart[:, 0], apart[:, 1]), apart[:, 2]))


def tracks(recording: Recording) -> list[Track]:
    """A track for each robot of the recording."""
    return [_track(recording, i, robot) for i, robot in enumerate(recording.scenario.robots)]


def framed(at: Coordinates, poses: Array) -> Array:
    """Poses (..., 3) or points (..., 2) on the field, in the scenario's frame."""
    x, y, turn = at.from_field((0.0, 0.0, 0.0))
    axes = [at.from_field((1.0, 0.0, 0.0))[:2], at.from_field((0.0, 1.0, 0.0))[:2]]
    result = np.array(poses, dtype=float)
    result[..., :2] = result[..., :2] @ (np.array(axes) - (x, y)) + (x, y)
    result[..., 2:] += turn
    return result


def shortened(text: str, length: int) -> str:
    """The text, or its beginning with an ellipsis."""
    return text if len(text) <= length else text[: length - 1] + "…"


def letter(place: int) -> str:
    """The name of a place: A to Z, then A1 to Z1, and so on."""
    lap, index = divmod(place, len(ascii_uppercase))
    return ascii_uppercase[index] + (str(lap) if lap else "")


def _track(recording: Recording, i: int, robot: Player) -> Track:
    at = recording.scenario.coordinates
    true = _unwrapped(framed(at, recording.body[:, i, :3]))
    believed = _unwrapped(framed(at, recording.estimate[:, i]))
    believed[:, 2] -= TURN * np.round((believed[:1, 2] - true[:1, 2]) / TURN)
    stops = [robot.start, *(leg.to for leg in robot.path or ())]
    if robot.repeat:
        stops.append(stops[1])
    route = _points([at.framed(stop)[:2] for stop in stops])
    places = _distinct(route)
    papers = [leg.paper for leg in robot.path or () if leg.paper]
    truths = [(p.truth[0], p.truth[1], 0.0) for p in papers if p.truth]
    return Track(
        number=robot.number,
        name=robot.name,
        radius=robot.model.radius,
        true=true,
        believed=believed,
        commanded=framed(at, recording.reference[:, i]),
        route=route,
        places=places,
        ends=[_end(recording, leg, places) for leg in recording.legs[i]],
        paper_odometry=_points([at.framed(p.odometry)[:2] for p in papers if p.odometry]),
        paper_truth=_points([at.framed(truth)[:2] for truth in truths]),
    )


def _end(recording: Recording, leg: dict[str, Any], places: Array) -> End:
    at, hz = recording.scenario.coordinates, float(recording.meta["physics_hz"])
    place = None
    if leg["target"] is not None:
        away = places - framed(at, leg["target"])[:2]
        place = int(np.argmin(np.hypot(away[:, 0], away[:, 1])))
    return End(
        begin=leg["start_tick"] / hz,
        time=leg["end_tick"] / hz,
        reached=leg["reached"],
        place=place,
        odometry=framed(at, leg["odometry"]),
        truth=framed(at, leg["truth"]),
    )


def _unwrapped(poses: Array) -> Array:
    poses[:, 2] = np.unwrap(poses[:, 2])
    return poses


def _points(points: list[tuple[float, float]]) -> Array:
    return np.array(points, dtype=float).reshape(-1, 2)


def _distinct(points: Array) -> Array:
    kept: list[Array] = []
    for point in points:
        if all(np.hypot(*(point - other)) > SAME_PLACE for other in kept):
            kept.append(point)
    return np.array(kept)
