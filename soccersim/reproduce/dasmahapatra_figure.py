"""The planar arm's workspace, and arms at targets of Table 2."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Annulus, Circle

from soccersim.kinematics import PlanarArm
from soccersim.reproduce.figures import (
    BELIEVED,
    COMMANDED,
    GREY,
    PAPER,
    TRUE,
    Figure,
    axes,
    canvas,
    legend_below,
)
from soccersim.state import Array

NEAR = 0.01  # cm; an arm that misses by less is not drawn apart


@dataclass(frozen=True)
class Drawn:
    """What is drawn of a row of Table 2; angles in radians, lengths in cm."""

    row: int
    arm: PlanarArm
    tip: tuple[float, float]
    phi: float
    branches: Sequence[Array]  # theta2 > 0, then theta2 < 0
    literal: Array  # by the paper's formulae
    missed: float  # cm, by the formulae


def arms(rows: Sequence[Drawn]) -> Figure:
    """A panel a row, six in all."""
    with canvas(11.0, 8.0, 2, 3) as (figure, every):
        for on, drawn in zip(every, rows, strict=True):
            links = ", ".join(f"{length:g}" for length in drawn.arm.lengths)
            miss = f"\nformulae miss by {drawn.missed:.1f} cm" if drawn.missed > NEAR else ""
            axes(on, "x (cm)", "y (cm)", f"Row {drawn.row}: {links} cm{miss}")
            _draw_reach(on, drawn)
            _draw_arms(on, drawn)
            on.set_aspect("equal")
        legend_below(figure, every[-1], 4)
    return figure


def _draw_reach(on: Axes, drawn: Drawn) -> None:
    """Where the tip can be: with some phi, and with the phi of this row."""
    least, most = drawn.arm.workspace()
    on.add_patch(Annulus((0, 0), most, most - least - 1e-9, fc="#EEF3F8", ec=GREY, lw=0.6,
                         label="workspace"))  # fmt: skip
    first, second, last = drawn.arm.lengths
    middle = last * np.cos(drawn.phi), last * np.sin(drawn.phi)
    for radius in {first + second, abs(first - second)}:
        on.add_patch(Circle(middle, radius, fill=False, ec=GREY, lw=0.9, ls=":"))
    on.plot([], [], color=GREY, lw=0.9, ls=":", label="its edges with this row's phi")
    on.set_xlim(-1.05 * most, 1.05 * most)
    on.set_ylim(-1.05 * most, 1.05 * most)


def _draw_arms(on: Axes, drawn: Drawn) -> None:
    """Both branches, and the formulae's arm where it misses."""
    wrong = drawn.missed > NEAR
    for q, colour, style, label in (
        *((drawn.literal, BELIEVED, "-", "by the paper's formulae"),) * wrong,
        (drawn.branches[0], TRUE, "-", "elbow +"),
        (drawn.branches[1], TRUE, (0, (4, 2)), "elbow -"),
    ):
        x, y = drawn.arm.joints(q.tolist()).T
        on.plot(x, y, color=colour, ls=style, lw=2.2, marker="o", ms=4.5, label=label)
    on.plot(0, 0, "s", color=COMMANDED, ms=6)
    on.plot(*drawn.tip, "x", color=PAPER, ms=11, mew=2.2, label="target X, Y", zorder=6)
