"""One moving thing seen by many: a Kalman filter over position and velocity in the field frame.

A sighting is two numbers, along and across the line of sight, each with its own variance.
"""

from typing import NamedTuple

from soccersim.kernel import inner
from soccersim.state import Array


class Sighting(NamedTuple):
    """Where somebody saw something, field frame."""

    x: float
    y: float
    ux: float  # line of sight, a unit vector
    uy: float
    along: float  # m2, variance along the line of sight
    across: float  # m2, variance across it


@inner
def sighting_of(row: Array) -> Sighting:
    """The sighting that a row (6,) of numbers holds."""
    return Sighting(row[0], row[1], row[2], row[3], row[4], row[5])


@inner
def start(state: Array, cov: Array, x: float, y: float, variance: float, speed: float) -> None:
    """Begin at a place, at rest as far as anybody knows, with a standard deviation of speed.

    state (4,) is x, y, vx, vy, cov (4, 4) its covariance.
    """
    state[0], state[1], state[2], state[3] = x, y, 0.0, 0.0
    for i in range(4):
        for j in range(4):
            cov[i, j] = 0.0
    cov[0, 0] = cov[1, 1] = variance
    cov[2, 2] = cov[3, 3] = speed * speed


@inner
def blur(cov: Array, seconds: float, wander: float) -> None:
    """Grow less sure for so long: velocity carries on, and wanders, in m/s a root second."""
    for i in range(2):
        for j in range(4):
            cov[i, j] += seconds * cov[i + 2, j]
    for i in range(2):
        for j in range(4):
            cov[j, i] += seconds * cov[j, i + 2]
    jolt(cov, seconds, wander * wander * seconds)


@inner
def jolt(cov: Array, seconds: float, variance: float) -> None:
    """The velocity changed, by a variance in m2/s2, at some time in the last so many seconds."""
    for i in range(2):
        cov[i, i] += variance * seconds * seconds / 3.0
        cov[i, i + 2] += variance * seconds / 2.0
        cov[i + 2, i] += variance * seconds / 2.0
        cov[i + 2, i + 2] += variance


@inner
def far_off(state: Array, cov: Array, sighting: Sighting) -> float:
    """How unlikely a sighting is: its squared distance in standard deviations.

    Along and across the line of sight are taken one by one.
    """
    ux, uy = sighting.ux, sighting.uy
    dx, dy = sighting.x - state[0], sighting.y - state[1]
    a, c = ux * dx + uy * dy, ux * dy - uy * dx
    a *= a / (_variance(cov, ux, uy) + sighting.along)
    c *= c / (_variance(cov, -uy, ux) + sighting.across)
    return float(a + c)


@inner
def _variance(cov: Array, ux: float, uy: float) -> float:
    """Of the position, in a direction."""
    return float(ux * ux * cov[0, 0] + 2.0 * ux * uy * cov[0, 1] + uy * uy * cov[1, 1])


@inner
def see(state: Array, cov: Array, sighting: Sighting) -> None:
    """Take in a sighting: first along the line of sight, then across it."""
    ux, uy = sighting.ux, sighting.uy
    _take_in(state, cov, sighting.x, sighting.y, ux, uy, sighting.along)
    _take_in(state, cov, sighting.x, sighting.y, -uy, ux, sighting.across)


@inner
def _take_in(
    state: Array, cov: Array, x: float, y: float, ux: float, uy: float, variance: float
) -> None:
    """Kalman update with the one number u . (x, y)."""
    off = ux * (x - state[0]) + uy * (y - state[1])
    h0, h1 = ux * cov[0, 0] + uy * cov[1, 0], ux * cov[0, 1] + uy * cov[1, 1]
    h = (h0, h1, ux * cov[0, 2] + uy * cov[1, 2], ux * cov[0, 3] + uy * cov[1, 3])
    total = ux * h0 + uy * h1 + variance
    for i in range(4):
        gain = h[i] / total
        state[i] += gain * off
        for j in range(4):
            cov[i, j] -= gain * h[j]
