"""Frames of a log: what they are called, and how each lies in its parent, as ROS has it.

REP-103: metres, radians, x forward, y left, z up, counter-clockwise; our field frame is its `map`.
REP-105: `odom -> base_link` is what the robot's odometry believes, without jumps of its own;
`map -> odom` is what it is off by. The product of both is where the robot truly is.
"""

import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

MAP = "map"
DIGITS = 9  # behind the point, of metres and quaternions: less than any float32 shows

Array = NDArray[Any]


def ros_names(names: Iterable[str]) -> list[str]:
    """Each name in letters that ROS allows, none of them twice: `home-1` is `home_1`."""
    given: list[str] = []
    for name in names:
        plain = re.sub(r"[^A-Za-z0-9_]", "_", name)
        plain = plain if plain[:1].isalpha() else f"robot_{plain}"
        unique, number = plain, 2
        while unique in given:
            unique, number = f"{plain}_{number}", number + 1
        given.append(unique)
    return given


def between(true: Array, believed: Array) -> Array:
    """(..., 3) of `map -> odom`: what carries each believed pose to the true one."""
    turn = true[..., 2] - believed[..., 2]
    c, s = np.cos(turn), np.sin(turn)
    x, y = believed[..., 0], believed[..., 1]
    moved = (true[..., 0] - (c * x - s * y), true[..., 1] - (s * x + c * y), turn)
    return np.stack(moved, axis=-1)


def placed(poses: Array, z: float = 0.0) -> list[Any]:
    """Poses (..., 3) as pairs of a position and a quaternion, ready for JSON."""
    poses = np.asarray(poses, float)
    half = poses[..., 2] / 2
    numbers = np.stack((poses[..., 0], poses[..., 1], np.sin(half), np.cos(half)), axis=-1)
    flat = np.round(numbers, DIGITS).reshape(-1, 4) + 0.0  # no -0.0
    pairs = [
        ({"x": x, "y": y, "z": z}, {"x": 0.0, "y": 0.0, "z": turn, "w": rest})
        for x, y, turn, rest in flat.tolist()
    ]
    if poses.ndim < 3:
        return pairs
    columns = poses.shape[1]
    return [pairs[row * columns : (row + 1) * columns] for row in range(len(poses))]


def stamp(tick: int, hz: int) -> dict[str, int]:
    """A tick as seconds and nanoseconds since the run began."""
    nanoseconds = nanosecond(tick, hz)
    return {"sec": nanoseconds // 10**9, "nsec": nanoseconds % 10**9}


def nanosecond(tick: int, hz: int) -> int:
    """A tick in nanoseconds since the run began."""
    return int(tick) * 10**9 // int(hz)
