"""Garcia-Sillas' equations (4) to (28) as printed, and the chain of Jacobians behind them.

Body frame. A wheel has its leg's pivot lambda, its contact p and its direction theta = alpha +
beta + gamma, whose y axis it rolls against. R is the wheel's radius, r the rollers', L the
distance from the centre. A wheel's speeds are w_ix of the motor, w_ir of the rollers and w_iz
about its contact. The functions named `eq...` keep what the paper prints, faults and all;
(29) and (30) stand in papers.py.
"""

from collections.abc import Sequence
from math import cos, sin, sqrt

import numpy as np

from soccersim.kinematics.omni import Array, read_only

ROOT3 = sqrt(3)
AXES_DEG = (180.0, 60.0, -60.0)
"""theta of the wheels, Table 1 with gamma_1 = 0: (15) to (17) are of these."""

MOTORS = read_only(np.eye(9)[::3].copy())
"""(3, 9): picks the w_ix out of all wheels' speeds."""

EQ4 = read_only(np.array([[-1.0, 1.0]]))
"""(4), omega_c of (omega_i, beta_i'): (5) has (1, -1), which is right."""


def pivots(distance: float) -> Array:
    """(3, 2) lambda of Table 1; the contacts p are the same, as delta is 0."""
    x, y = distance / 2, distance * ROOT3 / 2
    return np.array([[-distance, 0.0], [x, y], [x, -y]])


def eq5(theta: float, contact: Sequence[float], pivot: Sequence[float]) -> Array:
    """(5), right: (3, 4) from v_ix, v_iy, omega_i and beta_i' to the body's twist."""
    s, c = sin(theta), cos(theta)
    return np.array(
        [
            [c, -s, contact[1], -pivot[1]],
            [s, c, -contact[0], pivot[0]],
            [0.0, 0.0, 1.0, -1.0],
        ]
    )


def eq7(radius: float) -> Array:
    """(7), right: (4, 3) of a wheel that is steered; without its last column it is (6)."""
    return np.array([[0.0, 0.0, 0.0], [-radius, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])


def eq8(theta: float, contact: Sequence[float], radius: float) -> Array:
    """(8), (3, 2): entry (2, 2) must be -p_ix, as (5) times (6) gives."""
    s, c = sin(theta), cos(theta)
    return np.array([[radius * s, contact[1]], [-radius * c, contact[0]], [0.0, 1.0]])


def eq13(radius: float, roller: float) -> Array:
    """(13), (4, 3): its 1 must stand in row 3, as the wheels have no steering to turn."""
    return np.array([[0.0, roller, 0.0], [-radius, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def omni_wheel(radius: float, roller: float) -> Array:
    """What (13) should be, (4, 3): the wheel turns about its contact, its leg does not."""
    return eq13(radius, roller)[[0, 1, 3, 2]]


def wheel_jacobian(theta: float, pivot: Sequence[float], radius: float, roller: float) -> Array:
    """What (14) should be, (3, 3): (5) times (13), entries (1, 3) and (2, 3) those of lambda."""
    return eq5(theta, pivot, pivot) @ omni_wheel(radius, roller)


def wheel_jacobians(radius: float, roller: float, distance: float) -> Array:
    """What (15) to (17) should be, (3, 3, 3): one for each wheel."""
    return np.array(
        [
            wheel_jacobian(theta, pivot, radius, roller)
            for theta, pivot in zip(np.radians(AXES_DEG), pivots(distance), strict=True)
        ]
    )


def eq15_to_17(radius: float, roller: float, distance: float) -> Array:
    """(15) to (17), (3, 3, 3): entry (2, 2) of (16) must be +r sqrt3/2, as in (18)."""
    x, y = distance / 2, distance * ROOT3 / 2
    across, along, half = radius * ROOT3 / 2, roller * ROOT3 / 2, radius / 2
    return np.array(
        [
            [[0.0, -roller, 0.0], [radius, 0.0, distance], [0.0, 0.0, 1.0]],
            [[across, roller / 2, y], [-half, -along, -x], [0.0, 0.0, 1.0]],
            [[-across, roller / 2, -y], [-half, -along, -x], [0.0, 0.0, 1.0]],
        ]
    )


def stacked(jacobians: Array) -> tuple[Array, Array]:
    """A (9, 3) and B (9, 9) of (9), from three wheels' Jacobians (3, 3, 3)."""
    b = np.zeros((9, 9))
    for i, jacobian in enumerate(jacobians):
        b[3 * i : 3 * i + 3, 3 * i : 3 * i + 3] = jacobian
    return np.tile(np.eye(3), (3, 1)), b


def composite(jacobians: Array) -> Array:
    """(10), (3, 9): the body's twist that fits all wheels' speeds best."""
    a, b = stacked(jacobians)
    return np.asarray(np.linalg.solve(a.T @ a, a.T @ b))


def slip_operator(jacobians: Array) -> Array:
    """Omega(A) B of (11) and (12), (9, 9): 0 for the speeds of wheels that agree."""
    a, b = stacked(jacobians)
    return np.asarray((a @ np.linalg.solve(a.T @ a, a.T) - np.eye(9)) @ b)


def eq18(radius: float, roller: float, distance: float) -> Array:
    """(18), right: (3, 9) from all wheels' speeds to the body's twist."""
    big, small, far = radius / (2 * ROOT3), roller / (2 * ROOT3), distance / (2 * ROOT3)
    return np.array(
        [
            [0, -roller / 3, 0, big, roller / 6, far, -big, roller / 6, -far],
            [
                *(radius / 3, 0, distance / 3),
                *(-radius / 6, small, -distance / 6),
                *(-radius / 6, -small, -distance / 6),
            ],
            [0, 0, 1 / 3, 0, 0, 1 / 3, 0, 0, 1 / 3],
        ]
    )


def eq19(radius: float, roller: float, distance: float) -> Array:
    """(19), (9, 9): (2, 1) must be -2R/3, (4, 8) +r/6 and (7, 9) +L/sqrt3."""
    j = eq18(radius, roller, distance)
    big, small, far = radius / ROOT3, roller / ROOT3, distance / ROOT3
    own = np.array(
        [
            [[0, 2 * roller / 3, 0], [-2 * roller / 3, 0, -2 * distance / 3], [0, 0, -2 / 3]],
            [[-big, -roller / 3, -far], [radius / 3, -small, distance / 3], [0, 0, -2 / 3]],
            [[big, -roller / 3, -far], [radius / 3, small, distance / 3], [0, 0, -2 / 3]],
        ]
    )
    matrix = np.tile(j, (3, 1))
    for i in range(3):
        matrix[3 * i : 3 * i + 3, 3 * i : 3 * i + 3] = own[i]
    matrix[3, 7] = -roller / 6
    return matrix


def eq20_to_25(radius: float, roller: float, distance: float) -> Array:
    """(20) to (25), (6, 3): motors to w_1r, w_2r, w_3r, w_1z, w_2z, w_3z; these three need a -."""
    turn = radius / (3 * distance)
    rollers = np.array([[0, -1, 1], [1, 0, -1], [-1, 1, 0]]) * radius / (roller * ROOT3)
    return np.vstack((rollers, np.full((3, 3), turn)))


def eq26_to_28(radius: float, distance: float) -> Array:
    """(26) to (28), (3, 3): motors to the body's twist; (27) with its w_2y, a misprint, as w_2x.

    (27) must be R (2 w_1x - w_2x - w_3x)/3 and (28) -R (w_1x + w_2x + w_3x)/(3 L).
    """
    across, along, turn = radius / ROOT3, radius / 3, radius / (3 * distance)
    return np.array([[0, across, -across], [0, along, -along], [-turn, turn, turn]])


def no_slip(operator: Array) -> Array:
    """(9, 3): all wheels' speeds for the motors' where `operator`, of (12), is 0.

    Raises:
        ValueError: the operator leaves not just the three motors free.
    """
    _, size, basis = np.linalg.svd(operator)
    free = basis[size <= 1e-12 * size[0]].T
    if free.shape[1] != len(MOTORS):
        raise ValueError(f"{free.shape[1]} speeds are free, not {len(MOTORS)}")
    return np.asarray(free @ np.linalg.inv(MOTORS @ free))
