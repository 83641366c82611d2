"""The papers' bases as instances of the one model, and their matrices and formulae as printed.

The instances are right; the functions are not: each keeps what its paper prints, faults and all,
so that tests and reproductions can show what the fault does. Where a paper gives no
sizes, the instance has those of Utama's robot. SI and radians; theta and psi are headings.
"""

from collections.abc import Sequence
from math import acos, atan2, cos, degrees, hypot, pi, sin, sqrt

import numpy as np

from soccersim.kinematics.omni import Array, OmniBase, read_only

RADIUS, DISTANCE = 0.05, 0.19  # m, Utama, section 2.1; Idris' Table 5 gives the same radius
MECANUM_HALF_LENGTH, MECANUM_HALF_WIDTH = 0.20, 0.15  # m, an example of ours

MIRROR_Y = read_only(np.diag((1.0, -1.0, 1.0)))
"""Between Idris' frame and ours, for a twist: y the other way, theta the same way."""

UTAMA_DRIVE = OmniBase.tangential((30, 150, 270), DISTANCE, RADIUS)
"""Utama's driven wheels, the matrix of eq. (1)."""

UTAMA_ENCODERS = OmniBase.general((180, 300, 60), 0.08, 0.025, directions_deg=(90, 210, -30))
"""Utama's passive encoder wheels as the text places them, b = a - 90 deg."""

UTAMA_ENCODERS_EQ2 = OmniBase.tangential((0, 120, 240), 0.08, 0.025)
"""The encoder wheels as eq. (2) has them: UTAMA_ENCODERS but for the sign of psi."""

IDRIS_EQ5 = OmniBase.tangential((150, 30, 270), DISTANCE, RADIUS)
"""Idris' wheels as the inverse kinematics (5) has them, seen through MIRROR_Y."""

IDRIS_EQ4 = OmniBase.tangential((0, 120, 240), DISTANCE, RADIUS)
"""Idris' wheels as the forward kinematics (4) has them, seen through MIRROR_Y: not those of (5)."""

NOTE = OmniBase.tangential((45, 315, 225, 135), DISTANCE, RADIUS)
"""The four-wheel note's base, in the note's order of wheels: 1, 4, 3, 2 counter-clockwise."""

GARCIA = OmniBase.general(
    (180, 60, -60), DISTANCE, RADIUS, directions_deg=(90, -30, -150), roller_radius=0.01
)
"""Garcia-Sillas' triangular base, b = a - 90 deg: positive wheels turn it to the right."""


def mecanum(half_length: float, half_width: float, wheel_radius: float) -> OmniBase:
    """Four mecanum wheels, front left, front right, rear left, rear right, that drive along x.

    The contact points stand at (+-half_length, +-half_width), m.
    Source: Lynch & Park, Modern Robotics, eq. (13.10), which has the rear right wheel third.
    """
    corner = degrees(atan2(half_width, half_length))
    return OmniBase.general(
        (corner, -corner, 180 - corner, corner - 180),
        hypot(half_length, half_width),
        wheel_radius,
        directions_deg=0,
        roller_angles_deg=(-45, 45, 45, -45),
    )


MECANUM = mecanum(MECANUM_HALF_LENGTH, MECANUM_HALF_WIDTH, RADIUS)
"""A mecanum base to try things on."""


def idris_eq4(theta: float, radius: float, distance: float) -> Array:
    """Idris (4), forward: entry (1, 2) repeats (1, 3), -c/sqrt3 + s/3 is right; singular at 0."""
    s, c, root3 = sin(theta), cos(theta), sqrt(3)
    return radius * np.array(
        [
            [-2 * s / 3, c / root3 + s / 3, c / root3 + s / 3],
            [-2 * c / 3, c / 3 + s / root3, c / 3 - s / root3],
            [1 / (3 * distance), 1 / (3 * distance), 1 / (3 * distance)],
        ]
    )


def idris_eq5(theta: float) -> Array:
    """Idris (5), inverse: column 3 must be the wheels' distance, and all of it 1/r for rad/s."""
    ahead, back = pi / 3 + theta, pi / 3 - theta
    return np.array(
        [
            [-cos(ahead), sin(ahead), 1 / 3],
            [-cos(back), -sin(back), 1 / 3],
            [cos(theta), -sin(theta), 1 / 3],
        ]
    )


def utama_eq1(theta: float, radius: float, distance: float) -> Array:
    """Utama (1), inverse: diag(cos, cos, 1) must be the whole rotation; singular at 90 deg."""
    angles = theta + np.radians((30.0, 150.0, 270.0))
    wheels = np.column_stack((-np.sin(angles), np.cos(angles), np.full(3, distance)))
    return wheels @ np.diag((cos(theta), cos(theta), 1.0)) / radius


def utama_eq2(psi: float, radius: float, distance: float) -> Array:
    """Utama (2), forward: entries (2, 2) and (2, 3) have the wrong sign; singular at 30 deg."""
    s, c, root3 = sin(psi), cos(psi), sqrt(3)
    return radius * np.array(
        [
            [-2 * s / 3, -c / root3 + s / 3, c / root3 + s / 3],
            [2 * c / 3, c / 3 + s / root3, c / 3 - s / root3],
            [1 / (3 * distance), 1 / (3 * distance), 1 / (3 * distance)],
        ]
    )


def note_forward(radius: float, distance: float) -> Array:
    """The note's first (3, 4) matrix: for omni wheels at 45 deg rows 1 and 2 lack a sqrt2."""
    yaw = 1 / distance
    return radius / 4 * np.array([[-1, 1, 1, -1], [1, 1, -1, -1], [yaw, yaw, yaw, yaw]])


def note_inverse(radius: float, distance: float) -> Array:
    """The note's (4, 3) matrix: row 3 must be (1, -1, L); columns 1 and 2 lack a 1/sqrt2."""
    yaw = distance
    return np.array([[-1, 1, yaw], [1, 1, yaw], [-1, -1, yaw], [-1, -1, yaw]]) / radius


def note_expanded(radius: float) -> Array:
    """The lines that the note draws from its first matrix, (3, 4): v_x, v_y and again `v_x`.

    The first has the sign of row 1 reversed, the second is row 3 without its 1/L, and the third is
    row 2, v_y; the line of the yaw rate is missing.
    """
    return radius / 4 * np.array([[1, -1, -1, 1], [1, 1, 1, 1], [1, 1, -1, -1]])


def note_wheels(azimuths: Sequence[float]) -> Array:
    """The note's speed of each rim, (4, 2) of v_x and v_y, before it is simplified.

    That of wheel 3 needs a - before its v_y, that of wheel 4 a cosine; the note also writes
    alpha_2 for alpha_3 and alpha_4. What it simplifies them to is right.
    """
    one, two, three, four = azimuths
    return np.array(
        [
            [-sin(one), cos(one)],
            [-sin(pi - two), -cos(pi - two)],
            [cos(1.5 * pi - three), sin(1.5 * pi - three)],
            [sin(2 * pi - four), sin(2 * pi - four)],
        ]
    )


def note_last(azimuth: float, radius: float, distance: float) -> Array:
    """The note's last (3, 4) matrix, of alpha_1: rows 1 and 2 lack a factor of -2."""
    angles = (pi / 2 + azimuth, 1.5 * pi - azimuth, 1.5 * pi + azimuth, pi / 2 - azimuth)
    along, across = [sin(angle) for angle in angles], [cos(angle) for angle in angles]
    return radius / 4 * np.array([along, across, [1 / distance] * 4])


def garcia_eq29(radius: float, distance: float) -> Array:
    """Garcia-Sillas (29), forward: entry (1, 3) must be -R/sqrt3; as printed the rank is 2."""
    x, yaw = radius / sqrt(3), -radius / (3 * distance)
    return np.array([[0, x, x], [2 * radius / 3, -radius / 3, -radius / 3], [yaw, yaw, yaw]])


def garcia_eq30(radius: float) -> Array:
    """Garcia-Sillas (30), inverse: column 3 must be -L/R, not -1/R."""
    x = sqrt(3) / 2
    return np.array([[0, 1, -1], [x, -0.5, -1], [-x, -0.5, -1]]) / radius


def dasmahapatra_inverse(
    lengths: Sequence[float], pose: Sequence[float]
) -> tuple[float, float, float]:
    """Dasmahapatra (2.10b), (2.13c), (2.14): the arm's angles, right for some poses only.

    An arc cosine ends in [0, pi]: theta2 is the one elbow alone, and theta1 loses its sign.
    `lengths` are l1, l2, l3 and `pose` is (X, Y, phi) of the tip, phi in radians.

    Raises:
        ValueError: an arc cosine of more than 1: the pose is out of reach, or on its edge but
            for rounding.
    """
    (l1, l2, l3), (x, y, phi) = lengths, pose
    m, n = x - l3 * cos(phi), y - l3 * sin(phi)  # (2.7)
    theta2 = acos((m**2 + n**2 - l1**2 - l2**2) / (2 * l1 * l2))
    c2, s2 = cos(theta2), sin(theta2)
    theta1 = acos((m * (l1 + l2 * c2) + n * l2 * s2) / ((l1 + l2 * c2) ** 2 + (l2 * s2) ** 2))
    return theta1, theta2, phi - theta1 - theta2
