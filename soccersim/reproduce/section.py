"""One table, figure or set of equations of a paper, again: the paper's numbers beside ours."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Cell = float | int | str | bool | None


@dataclass(frozen=True)
class Summary:
    """A number that a paper prints about a whole table: as printed, recomputed, and ours."""

    what: str
    printed: float | None
    recomputed: float | None = None
    """From the paper's own rows, by the rule it states."""
    ours: float | None = None
    band: tuple[float, float] | None = None
    """5 and 95 % of ours over seeds, where it is a matter of chance."""
    fitted: bool = False
    """True: a parameter behind `ours` was fitted to this very table; not a prediction."""
    note: str = ""

    @property
    def inside(self) -> bool | None:
        """Whether the paper's number lies in our band; None where one of them is missing."""
        value = self.printed if self.recomputed is None else self.recomputed
        if self.band is None or value is None:
            return None
        return self.band[0] <= value <= self.band[1]


@dataclass(frozen=True)
class Section:
    """What a researcher looks up: rows of paper and ours, marks where the paper is wrong."""

    key: str
    """Short and unique within the paper: `table-1`; also names the picture."""
    title: str
    columns: Sequence[str]
    """Titles with units. `paper …`, `physics …`, `fitted …` say where a number comes from."""
    rows: Sequence[Sequence[Cell]]
    marks: dict[int, str] = field(default_factory=dict)
    """Number of a row, from 0: why the paper is wrong there."""
    summary: Sequence[Summary] = ()
    notes: Sequence[str] = ()
    """What the reader must know: conditions, estimates, what falls short."""
    figure: "Callable[[], Figure] | None" = None
    """Draws the picture, where there is one."""

    def document(self) -> dict[str, Any]:
        """The section as JSON; whoever writes the picture adds its file's name."""
        return {
            "key": self.key,
            "title": self.title,
            "columns": list(self.columns),
            "rows": [list(row) for row in self.rows],
            "marks": {str(row): why for row, why in self.marks.items()},
            "summary": [
                {
                    "what": s.what,
                    "printed": s.printed,
                    "recomputed": s.recomputed,
                    "ours": s.ours,
                    "band": list(s.band) if s.band else None,
                    "inside": s.inside,
                    "fitted": s.fitted,
                    "note": s.note,
                }
                for s in self.summary
            ],
            "notes": list(self.notes),
        }


def text(cell: Cell) -> str:
    """A cell for people: numbers with five significant digits, nothing for None."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, float):
        return f"{cell + 0.0:.5g}"
    return str(cell)
