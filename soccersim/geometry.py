"""Angles, rotations and SE(2), as kernels: radians, counter-clockwise positive."""

from math import cos, floor, pi, sin

from soccersim.kernel import kernel

SMALL_ANGLE = 1e-4  # rad; below it the series of se2_arc is exact to the last bit or nearly


@kernel
def wrap_angle(angle: float) -> float:
    """The same direction in [-pi, pi)."""
    return angle - 2.0 * pi * floor((angle + pi) / (2.0 * pi))


@kernel
def rotate(x: float, y: float, angle: float) -> tuple[float, float]:
    """A vector turned by angle: body to field with the heading, field to body with minus it."""
    c, s = cos(angle), sin(angle)
    return c * x - s * y, s * x + c * y


@kernel
def se2_arc(dx: float, dy: float, turn: float) -> tuple[float, float]:
    """The chord, in the frame of the start, of a constant twist that covers (dx, dy, turn).

    SE(2) exponential. Source: Lynch & Park, Modern Robotics, eq. (3.88) with the z axis fixed.
    """
    if abs(turn) < SMALL_ANGLE:
        a = 1.0 - turn * turn / 6.0
        b = turn / 2.0
    else:
        a = sin(turn) / turn
        b = (1.0 - cos(turn)) / turn
    return a * dx - b * dy, b * dx + a * dy


@kernel
def se2_twist(x: float, y: float, turn: float) -> tuple[float, float]:
    """The constant twist's (dx, dy) whose arc ends at (x, y, turn): SE(2) logarithm."""
    if abs(turn) < SMALL_ANGLE:
        a = 1.0 - turn * turn / 12.0
    else:
        a = 0.5 * turn * sin(turn) / (1.0 - cos(turn))
    b = 0.5 * turn
    return a * x + b * y, -b * x + a * y
