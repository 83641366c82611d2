"""Dasmahapatra again: the planar 3R arm, Tables 1 and 2, and the equations behind them."""

from collections.abc import Iterator

import numpy as np

from soccersim.kinematics import PlanarArm
from soccersim.reproduce import dasmahapatra_inverse
from soccersim.reproduce.entries import Part, entries_section
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.section import Cell, Section, Summary
from soccersim.reproduce.tables import PaperTable, table

EXAMPLE = 12  # the row of Table 1 at which the equations are evaluated
UM = 1e4  # um per cm
HOLDS = 1e-4  # cm; what rounding of the printed digits leaves is less
COLUMNS = (
    *("row", "links (cm)", "angles (deg)", "paper X (cm)", "ours X", "X off (um)"),
    *("paper Y (cm)", "ours Y", "Y off (um)"),
)


def sections(lab: Lab) -> Iterator[Section]:
    """The equations, Table 1 and Table 2."""
    yield equations()
    yield forward_table()
    lab.told(0.5)
    yield from dasmahapatra_inverse.sections()
    lab.told(1.0)


def equations() -> Section:
    """(2.6) to (2.13) as printed, at a row of Table 1."""
    row = table("dasmahapatra-table1").rows[EXAMPLE - 1]
    l1, l2, _, q1, q2, q3 = (_number(row[key]) for key in KEYS)
    one, both, two = np.radians((q1, q1 + q2, q2))
    c1, s1, c2, s2 = np.cos(one), np.sin(one), np.cos(two), np.sin(two)
    m, n = l1 * c1 + l2 * np.cos(both), l1 * s1 + l2 * np.sin(both)
    wide, high = l1 + l2 * c2, l2 * s2
    sign = "C12 is C1 C2 - S1 S2"
    parts = [
        _line("(2.10a)", "C2", (m**2 + n**2 - l1**2 - l2**2) / (2 * l1 * l2), c2),
        _line("(2.11a)", "C12", c1 * c2 + s1 * s2, np.cos(both), sign),
        _line("(2.11b)", "m", l1 * c1 + l2 * (c1 * c2 + s1 * s2), m, sign),
        _line("(2.11c)", "m", c1 * wide - s1 * high, m),
        _line("(2.12a)", "S12", s1 * c2 + c1 * s2, np.sin(both)),
        _line("(2.12c)", "n", s1 * wide + c1 * high, n),
        _line("(2.13b)", "C1", (m * wide + n * high) / (wide**2 + high**2), c1),
    ]
    notes = (
        f"At row {EXAMPLE} of Table 1: angles {q1:g}, {q2:g}, {q3:g} degrees; m and n in cm. From "
        "(2.11c) on the sign is right again. (2.10b) and (2.13c), the arc cosines of C2 and C1, "
        "end in [0, 180] degrees: see Table 2.",
    )
    title = "Equations (2.10a) to (2.13b), on the way to the inverse"
    return entries_section("equations", title, ("value",), parts, notes=notes)


KEYS = ("l1", "l2", "l3", "theta1", "theta2", "theta3")


def _line(name: str, gives: str, printed: float, ours: float, why: str = "") -> Part:
    return Part(name, (gives,), [[printed]], [[ours]], {0: why} if why else {})


def forward_table() -> Section:
    """Table 1: (2.6a) and (2.6b) for all 50 rows."""
    paper = table("dasmahapatra-table1")
    printed = np.column_stack([paper.numbers(axis) for axis in "xy"])
    ours = np.array([_forward(paper, i) for i in range(len(paper.rows))])
    off = printed - ours
    rows: list[list[Cell]] = [
        [
            *(i + 1, _joined(paper, i, "l"), _joined(paper, i, "theta")),
            *(cell for k in range(2) for cell in _beside(printed[i, k], ours[i, k])),
        ]
        for i in range(len(ours))
    ]
    marks = {
        i: f"{row['misprint']}: {str(row['note']).partition(';')[0].removeprefix('a ')}"
        for i, row in enumerate(paper.rows)
        if row["misprint"]
    }
    holds = (np.abs(off) < HOLDS).all(axis=1)
    exact = np.abs(off) <= _half_units(paper) * (1 + 1e-6)
    kept = np.abs(np.delete(off, sorted(marks), axis=0)).max()
    return Section(
        "table-1",
        "Table 1: forward kinematics",
        COLUMNS,
        rows,
        marks,
        summary=[
            Summary("rows within 1 um in X and Y", 50.0, ours=float(holds.sum()),
                    note=f"not rows {_numbers(~holds)}"),
            Summary("rows right to the last digit", 50.0, ours=float(exact.all(axis=1).sum()),
                    note="X of rows 12-14 has 6 digits and a 0; the last one is cut off, not "
                    "rounded, in 42 and 44-49"),
            Summary("greatest difference in the others (um)", None, ours=round(UM * kept, 3)),
        ],
        notes=(
            "Ours is (2.6a) and (2.6b), which are right. Off is paper less ours.",
        ),
    )  # fmt: skip


def _forward(paper: PaperTable, i: int) -> tuple[float, float]:
    """X and Y of row i, cm."""
    lengths, angles = (
        [_number(paper.rows[i][key]) for key in keys] for keys in (KEYS[:3], KEYS[3:])
    )
    return PlanarArm(tuple(lengths)).forward(np.radians(angles).tolist())[:2]


def _beside(printed: float, ours: float) -> tuple[float, float, float]:
    return float(printed), float(ours), round(UM * float(printed - ours), 3) + 0.0


def _half_units(paper: PaperTable) -> np.ndarray:
    """(n, 2) half a unit of the last digit that is printed of X and Y, cm."""
    return np.array(
        [[10.0 ** -len(row[axis].partition(".")[2]) / 2 for axis in "xy"] for row in paper.printed]
    )


def _joined(paper: PaperTable, i: int, name: str) -> str:
    return ", ".join(paper.printed[i][f"{name}{k}"] for k in (1, 2, 3))


def _numbers(chosen: np.ndarray) -> str:
    return ", ".join(str(i + 1) for i in np.flatnonzero(chosen))


def _number(cell: Cell) -> float:
    return float(cell) if isinstance(cell, float) else float("nan")
