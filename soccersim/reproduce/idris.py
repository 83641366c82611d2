"""Idris et al. again: Tables 1 to 7 and equations (4) and (5)."""

from collections.abc import Callable, Iterator

from soccersim.kinematics import papers
from soccersim.kinematics.papers import DISTANCE, MIRROR_Y, RADIUS
from soccersim.reproduce import idris_driven, idris_motors, idris_pushed, idris_sensors
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import forward, inverse, matrix_section, rotation
from soccersim.reproduce.section import Section
from soccersim.state import Array


def sections(lab: Lab) -> Iterator[Section]:
    """The equations, then the tables, in the paper's order."""
    yield from equations()
    steps: tuple[Callable[[Lab], Section | Iterator[Section]], ...] = (
        idris_sensors.gyro,
        idris_motors.motors,
        idris_sensors.mileage,
        idris_pushed.pushed,
        idris_driven.driven,
    )
    for i, step in enumerate(steps):
        made = step(lab)
        lab.told((i + 1) / len(steps))
        yield from [made] if isinstance(made, Section) else made


def equations() -> Iterator[Section]:
    """Equations (4) and (5) as printed beside what is right in the paper's own frame."""
    size = f"Wheels of {RADIUS} m radius, {DISTANCE} m from the centre; m/s, rad/s."
    yield matrix_section(
        "equation-4",
        "Equation (4): forward kinematics",
        lambda theta: papers.idris_eq4(theta, RADIUS, DISTANCE),
        forward_4,
        ("entry (1, 2) repeats (1, 3): it must be -c/sqrt3 + s/3", "", ""),
        (
            size,
            "As printed the determinant is (2 cos(2 theta + 30 deg) - sqrt3) / 9 R^3/L: 0 at "
            "headings 0 and -30 degrees, where wheels 2 and 3 cannot be told apart. Its row of y "
            "is right only where y points to the right, as in ours here. The v of its wheels "
            "must be angular speeds, rad/s.",
        ),
    )
    yield matrix_section(
        "equation-5",
        "Equation (5): inverse kinematics",
        papers.idris_eq5,
        inverse_5,
        ("column 3 must be L, the wheels' distance from the centre",) * 3,
        (
            size,
            "Ours is the speed of each rim, m/s, as printed. With 1/3 for L a commanded turning "
            f"rate is driven 1/(3 L) = {1 / (3 * DISTANCE):.2f} times as fast.",
        ),
    )
    yield matrix_section(
        "equations-4-5",
        "Equation (4) times (5), which must be the identity",
        lambda t: papers.idris_eq4(t, RADIUS, DISTANCE) @ papers.idris_eq5(t) / RADIUS,
        lambda t: forward_4(t) @ inverse_4(t),
        ("(4) and (5) are of different layouts, each with a fault of its own",) * 3,
        (
            "With both mended the product still is no identity but [[s, c], [c, -s]] of 2 theta + "
            "60 deg: (4) has its wheels at 0, 120, 240 degrees, (5) at 150, 30, 270. Ours takes "
            "the inverse of (4)'s own layout.",
        ),
    )


def forward_4(theta: float) -> Array:
    """What (4) should be: rad/s of the wheels to the field twist, y to the right."""
    return MIRROR_Y @ rotation(theta) @ forward(papers.IDRIS_EQ4)


def inverse_4(theta: float) -> Array:
    """The inverse of forward_4."""
    return inverse(papers.IDRIS_EQ4) @ rotation(-theta) @ MIRROR_Y


def inverse_5(theta: float) -> Array:
    """What (5) should be: the field twist, y to the right, to m/s of the rims."""
    return RADIUS * inverse(papers.IDRIS_EQ5) @ rotation(-theta) @ MIRROR_Y
