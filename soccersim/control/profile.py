"""Motion profiles from rest to rest along a line: bang-bang, with a cruise where there is room."""

from math import expm1, log1p, sqrt

from soccersim.kernel import kernel


@kernel
def profile_time(distance: float, speed: float, acceleration: float) -> float:
    """Seconds from rest to rest: d/v + v/a where the cruise speed is reached, else 2 sqrt(d/a)."""
    if distance <= speed * speed / acceleration:
        return 2.0 * sqrt(distance / acceleration)
    return distance / speed + speed / acceleration


@kernel
def profile_at(t: float, distance: float, speed: float, acceleration: float) -> tuple[float, float]:
    """Distance covered and speed after t seconds of the profile."""
    total = profile_time(distance, speed, acceleration)
    if t >= total:
        return distance, 0.0
    if t <= 0.0:
        return 0.0, 0.0
    ramp = min(0.5 * total, speed / acceleration)
    if t < ramp:
        return 0.5 * acceleration * t * t, acceleration * t
    left = total - t
    if left < ramp:
        return distance - 0.5 * acceleration * left * left, acceleration * left
    top = acceleration * ramp
    return 0.5 * top * ramp + top * (t - ramp), top


def motor_line_time(distance: float, speed: float, acceleration: float) -> float:
    """Seconds from rest to rest with full voltage one way, then the other, no traction limit.

    The motor's line gives x'' = a0 (u - x'/v) with u = 1, then -1; speed is v, the no-load speed,
    acceleration is a0, at stall. T = 2 (v / a0) artanh sqrt(1 - exp(-d a0 / v2)).
    """
    x = distance * acceleration / (speed * speed)
    artanh = log1p(sqrt(-expm1(-x))) + 0.5 * x
    return 2.0 * speed / acceleration * artanh
