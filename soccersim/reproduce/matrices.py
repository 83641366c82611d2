"""A paper's kinematic matrix as printed, beside what is right, at a few headings."""

from collections.abc import Callable, Sequence
from math import radians

import numpy as np

from soccersim.kinematics import OmniBase
from soccersim.reproduce.section import Cell, Section
from soccersim.state import Array

Matrix = Callable[[float], Array]  # of the heading, rad

SAME = 1e-9  # entries of the printed and the right matrix that differ by less are equal
HEADINGS_DEG = (0.0, 30.0, 90.0)


def matrix_section(
    key: str,
    title: str,
    printed: Matrix,
    right: Matrix,
    reasons: Sequence[str],
    notes: Sequence[str] = (),
    headings_deg: Sequence[float] = HEADINGS_DEG,
) -> Section:
    """Row by row; `reasons` say, for each row of the matrix, why it is wrong where it differs."""
    rows: list[list[Cell]] = []
    marks: dict[int, str] = {}
    for heading in headings_deg:
        paper, ours = printed(radians(heading)), right(radians(heading))
        for i, (one, other) in enumerate(zip(paper, ours, strict=True)):
            if np.abs(one - other).max() > SAME:
                marks[len(rows)] = reasons[i]
            dets = [significant(np.linalg.det(m)) if i == 0 else None for m in (paper, ours)]
            rows.append([heading, i + 1, *map(significant, (*one, *other)), *dets])
    columns = ["heading (deg)", "row"]
    columns += [f"{whose} column {k + 1}" for whose in ("paper", "ours") for k in range(3)]
    columns += ["paper determinant", "our determinant"]
    return Section(key, title, columns, rows, marks, notes=notes)


def tidy(value: float) -> float:
    """The number, without what rounding leaves of a zero."""
    return 0.0 if abs(value) < 1e-12 else float(value)


def significant(value: float) -> float:
    """The number to four significant digits."""
    return float(f"{tidy(value):.4g}")


def rotation(theta: float) -> Array:
    """(3, 3) body to field, for a twist."""
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def forward(base: OmniBase) -> Array:
    """(3, n) wheel speeds in rad/s to the body twist."""
    return base.inverse_jacobian * base.rolling_radius


def inverse(base: OmniBase) -> Array:
    """(n, 3) body twist to wheel speeds in rad/s."""
    return base.jacobian / base.rolling_radius[:, None]
