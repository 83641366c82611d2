"""Utama et al. again: equations (1) and (2), the square, and the three runs of section III."""

from collections.abc import Iterator

from soccersim.kinematics import papers
from soccersim.kinematics.papers import DISTANCE, RADIUS, UTAMA_DRIVE, UTAMA_ENCODERS_EQ2
from soccersim.reproduce import utama_runs, utama_square
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import forward, inverse, matrix_section, rotation
from soccersim.reproduce.section import Section
from soccersim.state import Array

SMALL_RADIUS, SMALL_DISTANCE = 0.025, 0.08  # m, the encoder wheels'
STRIKER_DEG = 15.18  # the heading at which the striker's run ends


def sections(lab: Lab) -> Iterator[Section]:
    """The equations, then the runs, in the paper's order."""
    yield from equations()
    yield from utama_square.sections(lab)
    lab.told(0.4)
    yield from utama_runs.sections(lab)
    lab.told(1.0)


def equations() -> Iterator[Section]:
    """Equations (1) and (2) as printed beside what is right."""
    size = f"Driven wheels of {RADIUS} m radius, {DISTANCE} m from the centre; m/s, rad/s."
    headings = (0.0, STRIKER_DEG, 90.0)
    yield matrix_section(
        "equation-1",
        "Equation (1): inverse kinematics",
        lambda theta: papers.utama_eq1(theta, RADIUS, DISTANCE),
        lambda theta: inverse(UTAMA_DRIVE),
        ("diag(cos, cos, 1) must be the whole rotation, with which theta cancels",) * 3,
        (size, "x_L and y_L are the robot's own axes: the wheels' speeds cannot depend on theta."),
        headings,
    )
    yield matrix_section(
        "equation-1-driven",
        "Equation (1): what the robot drives, of what is commanded",
        lambda theta: forward(UTAMA_DRIVE) @ papers.utama_eq1(theta, RADIUS, DISTANCE),
        lambda theta: forward(UTAMA_DRIVE) @ inverse(UTAMA_DRIVE),
        ("cos(theta) times the command, turned by -theta",) * 2 + ("",),
        (
            "At the 15.18 degrees of the striker's end the robot drives 0.965 of the speed it is "
            "told, 15.18 degrees askew; at 90 degrees it does not move.",
        ),
        headings,
    )
    yield matrix_section(
        "equation-2",
        "Equation (2): forward kinematics",
        lambda psi: papers.utama_eq2(psi, SMALL_RADIUS, SMALL_DISTANCE),
        right_2,
        ("", "entries (2, 2) and (2, 3) have the wrong sign", ""),
        (
            f"Encoder wheels of {SMALL_RADIUS} m radius, {SMALL_DISTANCE} m from the centre, in "
            "rad/s: the paper's rotations per second lack 2 pi.",
            "As printed the determinant is 0 at psi = +-30 and +-150 degrees. The matrix has its "
            "wheels at 0, 120 and 240 degrees; those of the text, 180, 300 and 60, are the same "
            "with psi negated.",
        ),
    )
    yield matrix_section(
        "equation-2-told",
        "Equation (2): what the odometry tells, of how the robot moves",
        lambda psi: papers.utama_eq2(psi, SMALL_RADIUS, SMALL_DISTANCE) @ right_2_inverse(psi),
        lambda psi: right_2(psi) @ right_2_inverse(psi),
        ("", "y is told as (-2 sin 2psi / 3, (4 cos^2 psi - 3) / 3, 4 L cos(psi) / 3)", ""),
        ("The encoder wheels as (2) places them, in the field frame.",),
    )


def right_2(psi: float) -> Array:
    """What (2) should be: rad/s of the encoder wheels to the field twist."""
    return rotation(psi) @ forward(UTAMA_ENCODERS_EQ2)


def right_2_inverse(psi: float) -> Array:
    """The inverse of right_2."""
    return inverse(UTAMA_ENCODERS_EQ2) @ rotation(-psi)
