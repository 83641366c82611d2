"""Utama's Figures 6, 7 and 8 redrawn, in the paper's frame: x to the right, y forward, mm."""

from collections.abc import Mapping, Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.ticker import MultipleLocator

from soccersim.reproduce.figures import (
    BELIEVED,
    COMMANDED,
    GREY,
    PAPER,
    TRUE,
    Figure,
    axes,
    canvas,
    draw_cloud,
    draw_paper,
    legend_below,
)
from soccersim.reproduce.utama_points import Runs, points
from soccersim.state import Array

Track = Mapping[str, Any]

WANTED: dict[str, Any] = {"color": COMMANDED, "lw": 1.0, "ls": (0, (5, 3))}


def figure_6(corners: Array, runs: Runs, one: Track) -> Figure:
    """The square by the encoders, and as measured on the field."""
    with canvas(9.6, 5.2, 1, 2, sharex=True, sharey=True) as (figure, (left, right)):
        for on, key, ends, colour, title in (
            (left, "sensor", runs.sensor, BELIEVED, "a. Encoder reading"),
            (right, "true", runs.true, TRUE, "b. Measurement on the field"),
        ):
            axes(on, "x (mm)", "y (mm)", title)
            draw_cloud(on, ends[:, 1:].reshape(-1, 3), colour, "corners of all runs")
            on.plot(*corners.T, **WANTED, label="commanded")
            on.plot(one[key][:, 0], one[key][:, 1], color=colour, lw=1.6, label="one run")
            on.set_aspect("equal")
            on.legend(loc="center")
    return figure


def figure_7(one: Track) -> Figure:
    """Position and direction over time, of one run."""
    with canvas(8.4, 6.4, 3, 1, sharex=True) as (figure, every):
        for k, (on, name) in enumerate(
            zip(every, ("x (mm)", "y (mm)", "direction (deg, cw)"), strict=True)
        ):
            axes(on, "time (s)" if k == 2 else "", name)
            on.plot(one["time"], one["commanded"][:, k], **WANTED, label="commanded")
            on.plot(one["time"], one["sensor"][:, k], color=BELIEVED, lw=1.6, label="sensors")
            on.plot(one["time"], one["true"][:, k], color=TRUE, lw=1.6, label="true")
        legend_below(figure, every[0], 3)
    return figure


def figure_8(names: Sequence[str], all_runs: Sequence[Runs], ones: Sequence[Track]) -> Figure:
    """The three tasks: the paper's points, one run of ours, and the ends of all."""
    with canvas(11.0, 6.6, 1, 3) as (figure, every):
        for on, letter, name, runs, one in zip(every, "abc", names, all_runs, ones, strict=True):
            axes(on, "x (mm)", "y (mm)", f"{letter}. {name}")
            _draw_task(on, name, runs, one)
        legend_below(figure, every[0], 4)
    return figure


def _draw_task(on: Axes, name: str, runs: Runs, one: Track) -> None:
    draw_cloud(on, runs.true[:, -1], TRUE, "measured ends of all runs")
    if runs.true.shape[1] > 2:
        on.plot(*runs.true[:, 1:-1].reshape(-1, 3).T[:2], ls="", marker=".", ms=3, color=GREY,
                alpha=0.45, mew=0)  # fmt: skip
        on.plot([], [], ls="", marker=".", ms=6, color=GREY, label="the same at point B")
    on.plot(*points(name, "commanded").T, **WANTED, label="commanded")
    for key, colour, label in (("sensor", BELIEVED, "sensors"), ("true", TRUE, "true")):
        on.plot(one[key][:, 0], one[key][:, 1], color=colour, lw=1.4, label=f"one run, {label}")
    for key, marker in (("sensor", "^"), ("measured", "D")):
        told = points(name, key)[1:]
        draw_paper(on, told[:, 0], told[:, 1], f"paper, {key}", marker=marker, ms=6)
    stops = points(name, "commanded")
    # points, clear of marks and lines
    beside = ((10, -4), (12, 2) if len(stops) == 2 else (12, -16), (-20, 8))
    for letter, at, shift in zip("ABC", stops, beside, strict=False):
        on.annotate(letter, at, shift, textcoords="offset points", color=PAPER, size=11)
    on.margins(x=0.15)
    on.set_aspect("equal", adjustable="datalim")
    on.xaxis.set_major_locator(MultipleLocator(1000.0))
