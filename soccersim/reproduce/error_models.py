"""Error models fitted to the papers' own tables: what their scatter was, not why.

Where a paper's scatter cannot come out of first principles (how a hand pushed a robot, how one
floor slipped), these give it again. Whatever is drawn from them is shown as `fitted`, never as
physics. tests/reproduce/test_error_models.py fits each constant to its table anew.
"""

from collections.abc import Sequence

import numpy as np

from soccersim.state import Array
from soccersim.streams import stream

# Idris, Table 1: gyro less arc, deg
GYRO_MEAN, GYRO_SD = 0.96, 0.76  # without row 19
OUTLIER_SHARE, OUTLIER_MEAN = 0.05, 9.0  # row 19: one of 20, 9.1

# Idris, Table 6: measured less real, gained on each leg of 10 cm, cm; of the heading, deg
ALONG_MEAN, ALONG_SD = 0.15, 1.04  # on the axis of the leg
CROSS_MEAN, CROSS_SD = 0.31, 0.52  # on the other axis
HEADING_MEAN, HEADING_SD = 0.43, 0.89  # at each mark: it does not grow

# Utama, section III: measured leg over sensor leg of the five legs that have both
SCALE_MEAN, SCALE_SD = 0.970, 0.031
ROTATION_SD = 4.2  # deg


def gyro_angles(real: Array, seeds: Sequence[int], outlier_share: float = OUTLIER_SHARE) -> Array:
    """(S, n) angles that the gyro of Idris' Table 1 gives for (n,) real ones, deg.

    It is zeroed at 0 degrees, where the paper has no error either.
    """
    result = np.empty((len(seeds), real.size))
    for i, seed in enumerate(seeds):
        rng = stream(seed, 0, "fitted.idris-table1")
        error = rng.normal(GYRO_MEAN, GYRO_SD, real.size)
        outlier = rng.random(real.size) < outlier_share
        result[i] = real + np.where(outlier, error - GYRO_MEAN + OUTLIER_MEAN, error)
    result[:, real == 0.0] = 0.0
    return result


def pushed_poses(marks: Array, seeds: Sequence[int]) -> Array:
    """(S, n, 3) poses measured at Idris' (n, 3) marks of Table 6: cm, cm, deg.

    The first leg starts at the origin; every leg goes along one axis.
    """
    legs = np.diff(marks[:, :2], axis=0, prepend=np.zeros((1, 2)))
    moving = legs != 0.0
    result = np.empty((len(seeds), *marks.shape))
    for i, seed in enumerate(seeds):
        rng = stream(seed, 0, "fitted.idris-table6")
        along = rng.normal(ALONG_MEAN, ALONG_SD, (len(marks), 1))
        cross = rng.normal(CROSS_MEAN, CROSS_SD, (len(marks), 1))
        result[i, :, :2] = marks[:, :2] + np.cumsum(np.where(moving, along, cross), axis=0)
        result[i, :, 2] = marks[:, 2] + rng.normal(HEADING_MEAN, HEADING_SD, len(marks))
    return result


def slipped_ends(sensor: Array, seeds: Sequence[int]) -> Array:
    """(S, n, 2) true points behind Utama's (n + 1, 2) points as his sensors gave them.

    Every leg is scaled and turned by draws of its own.
    """
    count = len(sensor) - 1
    result = np.empty((len(seeds), count, 2))
    for i, seed in enumerate(seeds):
        rng = stream(seed, 0, "fitted.utama-legs")
        scale = rng.normal(SCALE_MEAN, SCALE_SD, count)
        rotation = rng.normal(0.0, ROTATION_SD, count)
        result[i] = replay(sensor, scale, rotation)[1:]
    return result


def replay(sensor: Array, scale: Array, rotation_deg: Array) -> Array:
    """(n + 1, 2) true points: each of the n legs of the sensors scaled and turned."""
    legs = np.diff(sensor @ (1, 1j))
    true = legs * scale * np.exp(1j * np.radians(rotation_deg))
    points = sensor[0] @ (1, 1j) + np.cumsum(np.concatenate(([0], true)))
    return np.column_stack((points.real, points.imag))


def leg_errors(sensor: Array, measured: Array) -> tuple[Array, Array]:
    """Scale and rotation (deg) of each measured leg over that of the sensors: replay undone.

    Points are (..., n + 1, 2), the answers (..., n).
    """
    ratio = np.diff(measured @ (1, 1j), axis=-1) / np.diff(sensor @ (1, 1j), axis=-1)
    return np.abs(ratio), np.degrees(np.angle(ratio))
