"""Self-localisation: odometry between frames, corrected by the poses that field lines tell.

One scalar Kalman filter for each of x, y and heading. A frame is worked on late: the pose of its
moment is corrected, and every pose believed since moves along with it.
"""

from math import radians, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.geometry import rotate, wrap_angle
from soccersim.kernel import inner
from soccersim.spec.senses import Senses
from soccersim.state import Array

SURE = 1e-4  # m, rad: standard deviation of a pose told by hand, and the least of a fix
SURPRISE = 4.0  # standard deviations: a fix farther off says that the robot was pushed


class Localisation(NamedTuple):
    """What the filter counts on, and how sure each robot is."""

    step: Array  # (4,) slip, wander m/rt s, turn slip, turn wander rad/rt s
    fix: Array  # (3,) variance of a fix: m2, m2, rad2
    variance: Array  # (R, 3) of the believed pose


def build_localisation(senses: Senses, robots: int) -> Localisation:
    """Everybody sure of where it stands."""
    spec, lines = senses.localisation, senses.camera.lines
    spreads = [lines.distance_sd, lines.distance_sd, radians(lines.heading_sd_deg)]
    return Localisation(
        np.array([spec.slip, spec.wander, spec.turn_slip, radians(spec.turn_wander_deg)]),
        np.array([max(sd, SURE) ** 2 for sd in spreads]),
        np.full((robots, 3), SURE**2),
    )


@inner
def lose(loc: Localisation, robot: int, twist: Array, seconds: float) -> None:
    """Grow less sure while a robot drives with a twist (3,) for so long."""
    step = seconds * sqrt(twist[0] * twist[0] + twist[1] * twist[1])
    slip, wander = loc.step[0] * step, loc.step[1]
    turn_slip, turn_wander = loc.step[2] * seconds * twist[2], loc.step[3]
    for k in range(2):
        loc.variance[robot, k] += slip * slip + wander * wander * seconds
    loc.variance[robot, 2] += turn_slip * turn_slip + turn_wander * turn_wander * seconds


@inner
def correction(
    loc: Localisation, robot: int, believed: Array, fix: Array
) -> tuple[float, float, float]:
    """What a fix (3,) adds to the pose believed at its moment (3,): x, y, heading."""
    dx = fix[0] - believed[0]
    dy = fix[1] - believed[1]
    turn = wrap_angle(fix[2] - believed[2])
    return (
        _gain(loc, robot, 0, dx) * dx,
        _gain(loc, robot, 1, dy) * dy,
        _gain(loc, robot, 2, turn) * turn,
    )


@inner
def _gain(loc: Localisation, robot: int, k: int, off: float) -> float:
    """How much of a difference is believed; the variance is left as it then is."""
    variance, noise = loc.variance[robot, k], loc.fix[k]
    if off * off > SURPRISE * SURPRISE * (variance + noise):
        variance = off * off
    gain = variance / (variance + noise)
    loc.variance[robot, k] = (1.0 - gain) * variance
    return float(gain)


@inner
def carry(pose: Array, robot: int, x: float, y: float, dx: float, dy: float, turn: float) -> None:
    """Move a pose of the array (R, 3) along, when the one before it at (x, y) moves.

    The earlier pose shifts by (dx, dy) and turns by turn; the later one stays where it was as
    seen from there. For the earlier pose itself that is the correction.
    """
    rx, ry = rotate(pose[robot, 0] - x, pose[robot, 1] - y, turn)
    pose[robot, 0], pose[robot, 1] = x + dx + rx, y + dy + ry
    pose[robot, 2] += turn
