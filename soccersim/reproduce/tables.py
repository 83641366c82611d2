"""The papers' tables as printed, misprints and all, from assets/papers/*.csv.

A file begins with lines `# key: value`: paper, table (its number and title), units and columns
(each `name: text; name: text`), source (the section) and any number of remarks. A header row and
the rows follow, digit by digit as printed. The last three columns are ours: where a figure is
provably wrong, `misprint` names its column, `corrected` has our figure and `note` says why; a
note alone tells of something odd. What sums up Idris' tables (their last rows, and the text)
stands in `idris-summaries`.
"""

import csv
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from soccersim.bundled import root

Cell = float | str | None
Row = dict[str, Cell]

OURS = ("misprint", "corrected", "note")  # the columns that are not the paper's


@dataclass(frozen=True)
class PaperTable:
    """One table of a paper; `table` reads it."""

    name: str  # of the file, such as idris-table6
    paper: str  # authors and title
    title: str  # number and title of the table, as printed
    source: str  # where in the paper
    remarks: tuple[str, ...]
    units: dict[str, str]  # by column; a column without a unit is not in it
    columns: dict[str, str]  # what each column means
    printed: tuple[dict[str, str], ...]  # rows, digit by digit as printed; "" where missing

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """The rows, with numbers as float, missing cells as None and the rest as text."""
        return tuple({name: cell(text) for name, text in row.items()} for row in self.printed)

    @property
    def misprints(self) -> tuple[Row, ...]:
        """The rows in which a figure is provably wrong."""
        return tuple(row for row in self.rows if row["misprint"] is not None)

    def column(self, name: str, *, corrected: bool = False) -> list[Cell]:
        """A column's cells, as printed or with our corrections put in.

        Raises:
            ValueError: the table has no such column.
        """
        if name not in self.columns:
            raise ValueError(
                f"{self.name} has no column {name!r}: it has {', '.join(self.columns)}"
            )
        return [
            row["corrected"] if corrected and row["misprint"] == name else row[name]
            for row in self.rows
        ]

    def numbers(self, name: str, *, corrected: bool = False) -> NDArray[np.float64]:
        """(rows,) a column's numbers, NaN where missing.

        Raises:
            ValueError: there is no such column, or text in it.
        """
        cells = self.column(name, corrected=corrected)
        text = [value for value in cells if isinstance(value, str)]
        if text:
            raise ValueError(f"column {name!r} of {self.name} has text in it: {text[0]!r}")
        return np.array([np.nan if value is None else value for value in cells], dtype=np.float64)


def names() -> list[str]:
    """The tables there are, by name."""
    return sorted(path.stem for path in folder().glob("*.csv"))


def table(name: str) -> PaperTable:
    """The table of this name, such as `idris-table6` or `utama-points`.

    Raises:
        ValueError: there is no such table.
    """
    if name not in names():
        raise ValueError(f"no table {name!r}: there are {', '.join(names())}")
    lines = (folder() / f"{name}.csv").read_text(encoding="utf-8").splitlines()
    head = [line.removeprefix("# ").split(": ", 1) for line in lines if line.startswith("# ")]
    about = {key: value for key, value in head if key != "remark"}
    return PaperTable(
        name=name,
        paper=about["paper"],
        title=about["table"],
        source=about["source"],
        remarks=tuple(value for key, value in head if key == "remark"),
        units=by_column(about["units"]),
        columns=by_column(about["columns"]),
        printed=tuple(csv.DictReader(lines[len(head) :])),
    )


def folder() -> Path:
    """Where the tables are."""
    return root() / "assets" / "papers"


def by_column(line: str) -> dict[str, str]:
    """What a line `name: text; name: text` says of each column."""
    pairs = (part.partition(": ") for part in line.split("; "))
    return {name: text for name, _, text in pairs}


def cell(text: str) -> Cell:
    """A cell's number; its text where it is none; None where it is empty."""
    if not text:
        return None
    try:
        return float(text)
    except ValueError:
        return text
