"""Matrices and formulae as printed beside ours, entry by entry, at one set of sizes."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from soccersim.reproduce.matrices import SAME, significant
from soccersim.reproduce.section import Cell, Section, Summary


class Part(NamedTuple):
    """A matrix of a paper: what its rows give, as printed, ours, and why rows are wrong."""

    name: str
    gives: Sequence[str]  # one a row
    printed: ArrayLike  # (n, k)
    ours: ArrayLike  # (n, k)
    why: Mapping[int, str] = {}  # by row, from 0: every row in which the two differ


def entries_section(
    key: str,
    title: str,
    of: Sequence[str],
    parts: Sequence[Part],
    summary: Sequence[Summary] = (),
    notes: Sequence[str] = (),
    show_ours: bool = True,
) -> Section:
    """Rows of all parts, one below the other; `of` names their columns.

    Raises:
        ValueError: a part's printed and our rows differ where it gives no reason, or do not where
            it gives one.
    """
    rows: list[list[Cell]] = []
    marks: dict[int, str] = {}
    for part in parts:
        printed, ours = np.asarray(part.printed), np.asarray(part.ours)
        wrong = differing(printed, ours)
        if wrong != sorted(part.why):
            raise ValueError(f"{part.name}: rows {wrong} differ, reasons for {sorted(part.why)}")
        for i, gives in enumerate(part.gives):
            if i in part.why:
                marks[len(rows)] = part.why[i]
            beside = _padded(ours[i], len(of)) if show_ours else []
            rows.append([part.name, gives, *_padded(printed[i], len(of)), *beside])
    columns = ["", "gives", *of]
    if show_ours:
        columns[2:] = [f"{whose} {name}" for whose in ("paper", "ours") for name in of]
    if not any(part.name for part in parts):
        columns, rows = columns[1:], [row[1:] for row in rows]
    return Section(key, title, columns, rows, marks, summary, notes)


def differing(printed: NDArray[np.float64], ours: NDArray[np.float64]) -> list[int]:
    """The rows in which the two differ."""
    wrong: list[int] = (np.abs(printed - ours).max(axis=1) > SAME).nonzero()[0].tolist()
    return wrong


def _padded(row: NDArray[np.float64], size: int) -> list[Cell]:
    """The row's numbers, and nothing where it has none."""
    return [*map(significant, row), *([None] * (size - len(row)))]
