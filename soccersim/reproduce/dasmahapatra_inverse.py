"""Dasmahapatra, Table 2: every inverse solution, and what the paper's arc cosines give."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import hypot

import numpy as np

from soccersim.kinematics import PlanarArm
from soccersim.kinematics.papers import dasmahapatra_inverse
from soccersim.reproduce.dasmahapatra_figure import Drawn, arms
from soccersim.reproduce.section import Cell, Section, Summary
from soccersim.reproduce.tables import Row, table
from soccersim.state import Array

SAME_DEG = 6e-4  # what rounding of the printed X and Y leaves in the angles
NEAR_DEG = 0.01
HITS = 0.01  # cm
ELBOWS = ("+", "-")  # the sign of theta2
ANGLES = ("theta1", "theta2", "theta3")
SHOWN = (5, 18, 29, 38, 43, 48)  # rows of the figure, one a set of links
PAPER_COLUMNS = tuple(f"paper {name} (deg)" for name in ANGLES)


@dataclass(frozen=True)
class Target:
    """A row of Table 2; angles in degrees, lengths in cm."""

    number: int
    arm: PlanarArm
    tip: tuple[float, float]  # as printed
    angles: Array  # (3,) as printed
    why: str  # what is misprinted
    corrected: tuple[float, float]

    @property
    def phi(self) -> float:
        """The direction of the last link, which the paper does not print."""
        return float(self.angles.sum())

    @cached_property
    def branches(self) -> list[Array]:
        """theta2 > 0, then theta2 < 0; each angle in [0, 360)."""
        return self.solved(self.tip)

    @cached_property
    def literal(self) -> Array:
        """(3,) by (2.10b), (2.13c) and (2.14)."""
        pose = (*self.tip, np.radians(self.phi))
        return np.degrees(dasmahapatra_inverse(self.arm.lengths, pose))

    @property
    def missed(self) -> float:
        """How far from the target the literal formulae bring the tip."""
        x, y, _ = self.arm.forward(np.radians(self.literal).tolist())
        return hypot(x - self.tip[0], y - self.tip[1])

    def solved(self, tip: tuple[float, float]) -> list[Array]:
        """Every inverse solution for this tip."""
        found = self.arm.inverse((*tip, float(np.radians(self.phi))))
        return [np.degrees(q) % 360.0 for q in found]

    def off(self, angles: Array) -> float:
        """The greatest difference from the paper's angles, mod 360 degrees."""
        return float(np.abs((angles - self.angles + 180.0) % 360.0 - 180.0).max())


def targets() -> list[Target]:
    """The rows of Table 2."""
    return [_target(row) for row in table("dasmahapatra-table2").rows]


def _target(row: Row) -> Target:
    tip = {axis: _number(row[axis]) for axis in "xy"}
    right = dict(tip)
    if isinstance(row["misprint"], str):
        right[row["misprint"]] = _number(row["corrected"])
    why = f"{row['misprint']} misprinted" if row["misprint"] else ""
    return Target(
        int(_number(row["no"])),
        PlanarArm(tuple(_number(row[f"l{k}"]) for k in (1, 2, 3))),
        (tip["x"], tip["y"]),
        np.array([_number(row[name]) for name in ANGLES]),
        why,
        (right["x"], right["y"]),
    )


def sections() -> Iterator[Section]:
    """Both branches of every row, then the literal formulae."""
    rows = targets()
    yield solutions(rows)
    yield formulae(rows)


def solutions(targets: Sequence[Target]) -> Section:
    """Our two branches, and which of them the paper has."""
    rows: list[list[Cell]] = []
    for target in targets:
        offs = [target.off(branch) for branch in target.branches]
        best = int(np.argmin(offs))
        angles = [cell for q in (target.angles, *target.branches) for cell in _told(q)]
        rows.append([target.number, *angles, ELBOWS[best], _small(offs[best])])
    marks = {i: target.why for i, target in enumerate(targets) if target.why}
    return Section(
        "table-2",
        "Table 2: inverse kinematics, every solution",
        (
            *("row", *PAPER_COLUMNS),
            *(f"ours {elbow} {name}" for elbow in ELBOWS for name in ANGLES),
            *("branch", "off (deg)"),
        ),
        rows,
        marks,
        _solution_summary(targets),
        (
            "phi, without which X and Y have infinitely many solutions, is not printed: here it "
            "is theta1 + theta2 + theta3 of the paper. Ours are by atan2 with the elbow to either "
            "side, in [0, 360) degrees; off is the greatest difference, mod 360, of the one "
            "that is the paper's. Table 2 has other angles than Table 1 in rows 41 to 50.",
        ),
        lambda: arms([_drawn(targets[row - 1]) for row in SHOWN]),
    )


def _solution_summary(targets: Sequence[Target]) -> list[Summary]:
    """How many rows each branch, and both, give."""
    ours = [[target.off(q) < SAME_DEG for q in target.branches] for target in targets]
    right = [[t.off(q) < SAME_DEG for q in t.solved(t.corrected)] for t in targets]
    missing = ", ".join(
        str(t.number) for t, found in zip(targets, ours, strict=True) if not any(found)
    )
    return [
        Summary("rows that come out, of 50", 50.0, ours=_count(map(any, ours)),
                note=f"within {SAME_DEG} deg; not row {missing}"),
        Summary("the same, row 24 mended", 50.0, ours=_count(map(any, right))),
        Summary("by elbow + (rows 1 to 40)", None, ours=_count(found[0] for found in right)),
        Summary("by elbow - (rows 41 to 50)", None, ours=_count(found[1] for found in right)),
    ]  # fmt: skip


def formulae(targets: Sequence[Target]) -> Section:
    """(2.10b), (2.13c) and (2.14) to the letter."""
    rows: list[list[Cell]] = []
    marks = {}
    for i, target in enumerate(targets):
        off, missed = target.off(target.literal), target.missed
        if off >= NEAR_DEG:
            marks[i] = _reason(target)
        angles = (*_told(target.angles), *_told(target.literal))
        rows.append([target.number, *angles, _small(off), _small(missed), missed < HITS])
    agree = [target.off(target.literal) < NEAR_DEG for target in targets]
    hits = [target.missed < HITS for target in targets]
    return Section(
        "table-2-formulae",
        "Table 2: equations (2.10b), (2.13c) and (2.14) to the letter",
        (
            *("row", *PAPER_COLUMNS, *(f"formulae {name}" for name in ANGLES)),
            *("off (deg)", "tip misses by (cm)", "hits"),
        ),
        rows,
        marks,
        [
            Summary("rows that the formulae give, of 50", 50.0, recomputed=_count(agree),
                    note="the text has all 50 from them; 1 to 23 and 25 to 36 are"),
            Summary("rows in which they hit the target", 50.0, recomputed=_count(hits),
                    note="row 41 by the other elbow; not 37 to 40 and 42 to 50"),
            Summary("greatest miss (cm)", None, recomputed=max(t.missed for t in targets)),
        ],
        (
            "Recomputed is by the paper's own formulae. An arc cosine ends at 180 degrees: where "
            "they miss, Table 2 has angles that they cannot give. It holds the inputs of the "
            "forward kinematics, not results. Row 41's other elbow hits the target too.",
        ),
    )  # fmt: skip


def _reason(target: Target) -> str:
    """Why the formulae do not give the paper's angles."""
    if target.why:
        return target.why
    if target.missed < HITS:
        return "the other elbow"
    return "theta1, theta2 > 180" if target.angles[1] > 180.0 else "theta1 > 180"


def _drawn(target: Target) -> Drawn:
    return Drawn(
        target.number,
        target.arm,
        target.tip,
        np.radians(target.phi),
        [np.radians(q) for q in target.branches],
        np.radians(target.literal),
        target.missed,
    )


def _told(angles: Array) -> list[float]:
    return [round(float(angle), 3) for angle in angles]


def _small(value: float) -> float:
    """Two digits of it, and 0 for what is less than the table can tell."""
    return 0.0 if value < 1e-7 else float(f"{value:.2g}")


def _count(found: object) -> float:
    return float(sum(found))  # type: ignore[call-overload]


def _number(cell: Cell) -> float:
    return float(cell) if isinstance(cell, float) else float("nan")
