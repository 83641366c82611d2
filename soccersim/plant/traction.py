"""Friction of a wheel on the floor, as secants that keep the implicit update stable.

Source: Stribeck friction regularised by slip-ratio creep; model of sections 3.2 and 3.4 of
docs/models.md.
"""

from math import exp, sqrt

from soccersim.kernel import kernel

ROLLER_CREEP = 0.05  # m/s across the wheel at which half the rollers' friction is felt
STICTION_SPEED = 0.5  # rad/s over which dry friction in a bearing changes its sign


@kernel
def friction_coefficient(slip: float, static: float, kinetic: float, stribeck: float) -> float:
    """Stribeck: static at rest, falling to kinetic within a few times the stribeck speed."""
    ratio = slip / stribeck
    return kinetic + (static - kinetic) * exp(-ratio * ratio)


@kernel
def secant(limit: float, speed: float, creep: float) -> float:
    """Force over slip speed, N s/m: limit at large slip, proportional to slip at small."""
    return limit / sqrt(speed * speed + creep * creep)


@kernel
def dry_friction(torque: float, speed: float) -> float:
    """Torque over speed of a bearing's dry friction, N m s/rad; regularised round zero."""
    return torque / sqrt(speed * speed + STICTION_SPEED * STICTION_SPEED)
