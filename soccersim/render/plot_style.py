"""Colours and line styles of the plots: told apart by the colour-blind, and in grey."""

from typing import Any, NamedTuple

TRUE, BELIEVED, COMMANDED, TURNED, PAPER = "#0072B2", "#E8850C", "#222222", "#A8327A", "#7B3294"
# one a robot: Okabe and Ito's, then three of Tol's
ROBOTS = (
    *("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9"),
    *("#E69F00", "#7A7A7A", "#882255", "#999933", "#332288"),
)
GRASS, PAINT, BOARD, GREY, LOST = "#E6EFE1", "#C3D2BB", "#8A8A8A", "#666666", "#F6E3E3"
FEW = 3  # robots whose routes, targets and ends of legs are shown

RC: dict[str, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.labelsize": 9.5,
    "axes.linewidth": 0.8,
    "axes.edgecolor": "#444444",
    "axes.formatter.useoffset": False,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "legend.fontsize": 8.5,
    "legend.frameon": False,
    "legend.borderaxespad": 0.0,
    "legend.borderpad": 0.0,
    "text.parse_math": False,  # a robot may be called $x$
}
Line = dict[str, Any]  # keywords of a line


class Look(NamedTuple):
    """How one robot's lines are drawn."""

    commanded: Line
    believed: Line
    true: Line

    @property
    def colour(self) -> str:
        """The robot's own."""
        return str(self.true["color"])


def look(i: int, count: int) -> Look:
    """One robot: a colour for each line; several: a colour for each robot."""
    if count == 1:
        return Look(
            {"color": COMMANDED, "lw": 1.0, "ls": (0, (5, 3)), "zorder": 3.2},
            {"color": BELIEVED, "lw": 1.6, "ls": "-", "zorder": 3.0},
            {"color": TRUE, "lw": 1.9, "ls": "-", "zorder": 3.4},
        )
    return Look(
        {"color": ROBOTS[i], "lw": 1.0, "ls": (0, (1, 2)), "zorder": 3.0},
        {"color": ROBOTS[i], "lw": 0.9, "ls": (0, (5, 2)), "zorder": 3.2},
        {"color": ROBOTS[i], "lw": 1.5, "ls": "-", "zorder": 3.4},
    )
