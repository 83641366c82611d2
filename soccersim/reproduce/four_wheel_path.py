"""The planned path that the four-wheel note sets as its aim, followed by a robot of ours."""

import numpy as np
from matplotlib.axes import Axes

from soccersim.record import Recording
from soccersim.render.topview import draw_top_view
from soccersim.render.tracks import letter, tracks
from soccersim.reproduce.figures import GREY, Figure, axes, canvas, draw_cloud
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.samples import (
    band_cells,
    distance,
    held_against,
    poses,
    rounded,
    times,
)
from soccersim.reproduce.section import Cell, Section
from soccersim.simulation import Simulation
from soccersim.spec.load import load_scenario
from soccersim.state import Array

SCENARIO = "four-wheel-path"
COLUMNS = (
    *("leg", "target (m, deg)", "time (s)", "believed off by (mm)"),
    *("truly off by (mm)", "5 %", "95 %", "true heading off by (deg)", "5 %", "95 %"),
)
LEG_COLOURS = ("#D55E00", "#009E73", "#56B4E9", "#CC79A7", "#0072B2")  # by leg, Okabe and Ito


def followed(lab: Lab) -> Section:
    """The path over the lab's seeds; all of it is physics, nothing is the note's."""
    runs = lab.runs(SCENARIO)
    target, believed, true = (poses(runs, key) for key in ("target", "odometry", "truth"))
    took = times(runs)
    off = 1000 * distance(true, target)
    heading = (np.degrees((true - target)[..., 2]) + 180) % 360 - 180
    near = 1000 * distance(believed, target)
    rows: list[list[Cell]] = [
        [
            *(f"{letter(k)} to {letter((k + 1) % target.shape[1])}", _pose(target[0, k])),
            *(float(np.median(took[:, k])), float(np.median(near[:, k]))),
            *(*band_cells(off[:, k]), *band_cells(heading[:, k])),
        ]
        for k in range(target.shape[1])
    ]
    path = float(distance(target[0], np.roll(target[0], 1, axis=0)).sum())
    return Section(
        "path",
        "A planned path followed (the path is ours: the note prints none)",
        COLUMNS,
        rounded(rows, 2),
        summary=[
            held_against("truly off at the end (mm)", off[:, -1]),
            held_against("the same, % of the path", off[:, -1] / 10 / path),
            held_against("believed off at the end (mm)", near[:, -1]),
        ],
        notes=_notes(runs, path),
        figure=lambda: _figure(target[0], true),
    )


def _notes(runs: list[dict[str, object]], path: float) -> tuple[str, ...]:
    return (
        f"Physics: {len(runs)} seeds of the scenario {SCENARIO}, {path:.2f} m with 360 degrees of "
        "turning on the way; medians, and 5 to 95 %. Encoders and gyro alone: the robot comes to "
        "what it believes to be the target.",
        "Robot, path and all sizes are ours. Wheels as built differ by 0.4 % (estimate), the gyro "
        "by 1 % in scale and 0.03 deg/s in offset (MPU-6050, estimate): its scale error grows "
        "with each turn, and a heading believed wrong takes the next leg askew.",
    )


def _pose(pose: Array) -> str:
    x, y, heading = pose
    return f"{x:g}, {y:g}, {np.degrees(heading):.0f}"


def _figure(target: Array, true: Array) -> Figure:
    """One run from above, and where all end each leg; target (K, 3), true (S, K, 3)."""
    recording = Simulation(load_scenario(SCENARIO)).run()
    with canvas(12.0, 5.8, 1, 2, width_ratios=(1.45, 1)) as (figure, (left, right)):
        _draw_path(left, recording)
        axes(right, "x (mm)", "y (mm)", "True ends less targets, all seeds")
        for k, colour in enumerate(LEG_COLOURS):
            ends = 1000 * (true - target)[:, k, :2]
            draw_cloud(right, ends, colour, f"leg {k + 1}, at {letter((k + 1) % len(target))}")
        right.plot(0, 0, "+", color=GREY, ms=13, mew=1.2)
        right.set_aspect("equal", adjustable="datalim")
        right.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=3)
    return figure


def _draw_path(on: Axes, recording: Recording) -> None:
    runs = tracks(recording)
    draw_top_view(on, recording, runs)
    on.set_title(
        f"Seed {recording.meta['seed']}: commanded, believed and true; the path is ours",
        fontsize=10.5,
        loc="left",
    )
    on.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=3)
