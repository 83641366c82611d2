"""What the pictures of the reproductions share: canvas, colours, bands, legends."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import matplotlib.style
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

from soccersim.render.plot_style import BELIEVED, COMMANDED, GREY, PAPER, RC, TRUE, TURNED

__all__ = ["BELIEVED", "COMMANDED", "FITTED", "GREY", "PAPER", "PHYSICS", "TRUE", "Figure"]

Array = NDArray[Any]

PHYSICS, FITTED = TRUE, "#009E73"
PHYSICS_2 = TURNED  # a second line of ours in one picture
DPI = 120
PAPER_MARK: dict[str, Any] = {
    "color": PAPER,
    "ls": "",
    "marker": "D",
    "ms": 4.5,
    "zorder": 5,
}


@contextmanager
def canvas(
    width: float, height: float, rows: int = 1, columns: int = 1, **grid: Any
) -> Iterator[tuple[Figure, list[Axes]]]:
    """A figure of so many inches and its axes, row by row, in the house's style."""
    with matplotlib.style.context(["default", RC]):
        figure = Figure(figsize=(width, height), dpi=DPI, layout="constrained")
        FigureCanvasAgg(figure)
        yield figure, list(figure.subplots(rows, columns, squeeze=False, **grid).flat)


def axes(figure_axes: Axes, x: str, y: str, title: str = "") -> Axes:
    """Axes with their quantities and units told, and a light grid."""
    figure_axes.set_xlabel(x)
    figure_axes.set_ylabel(y)
    figure_axes.set_title(title, fontsize=10.5, loc="left")
    figure_axes.grid(color="#DDDDDD", lw=0.6)
    figure_axes.set_axisbelow(True)
    return figure_axes


def draw_band(on: Axes, x: Array, samples: Array, colour: str, label: str) -> None:
    """The median of (S, n) samples over (n,) x as a line, 5-95 % as a shade."""
    low, middle, high = np.percentile(samples, (5, 50, 95), axis=0)
    on.fill_between(x, low, high, color=colour, alpha=0.18, lw=0, label=f"{label}, 5-95 %")
    on.plot(x, middle, color=colour, lw=1.5, label=f"{label}, median")


def draw_paper(on: Axes, x: Array, y: Array, label: str = "paper", **more: Any) -> None:
    """The paper's own numbers."""
    on.plot(x, y, label=label, **{**PAPER_MARK, **more})


def draw_cloud(on: Axes, points: Array, colour: str, label: str) -> None:
    """(S, 2) ends of many runs."""
    on.plot(points[:, 0], points[:, 1], ls="", marker=".", ms=3, color=colour, alpha=0.45, mew=0)
    on.plot([], [], ls="", marker=".", ms=6, color=colour, label=label)


def legend_below(figure: Figure, on: Axes, columns: int) -> None:
    """One legend for all axes, of what stands in this one, under them."""
    figure.legend(*on.get_legend_handles_labels(), loc="outside lower center", ncols=columns)
