"""trajectory.png: what was commanded, what the odometry believed, where the robot truly was."""

import warnings
from io import BytesIO
from os import PathLike
from pathlib import Path
from typing import Any

import matplotlib.style
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from soccersim.problems import MachineError
from soccersim.record import Recording
from soccersim.render.arm_plots import arm_figure
from soccersim.render.history import draw_history
from soccersim.render.legend import draw_kinds, draw_map, draw_robots
from soccersim.render.plot_style import GREY, RC, ROBOTS
from soccersim.render.topview import draw_top_view
from soccersim.render.tracks import Track, shortened, tracks

STYLE: list[str | dict[str, Any]] = ["default", RC]  # whatever the user's own matplotlibrc says
INCHES, DPI = (14.0, 7.6), 120  # 1680 x 912 pixels
# left, bottom, width, height as shares of the figure
TOP_VIEW = (0.05, 0.245, 0.46, 0.635)
KINDS = (0.05, 0.03, 0.34, 0.15)
MAP = (0.4, 0.03, 0.11, 0.15)
ROBOT_NAMES = (0.575, 0.89, 0.37, 0.09)
HISTORY = {"left": 0.575, "right": 0.945, "top": 0.88, "bottom": 0.07, "hspace": 0.14}


def trajectory_figure(recording: Recording) -> Figure:
    """The top view on the left; x, y, heading and drift over time on the right.

    Everything in the scenario's frame, in metres and degrees counter-clockwise. Of more than ten
    robots the first ten are shown.
    """
    every = tracks(recording)
    runs = every[: len(ROBOTS)]
    with matplotlib.style.context(STYLE):
        figure = Figure(figsize=INCHES, dpi=DPI)
        FigureCanvasAgg(figure)
        top_view = figure.add_axes(TOP_VIEW)
        region = draw_top_view(top_view, recording, runs)
        grid = figure.add_gridspec(4, 1, **HISTORY)
        draw_history(list(grid.subplots(sharex=True, squeeze=False).flat), recording, runs)
        draw_kinds(figure.add_axes(KINDS), top_view, runs)
        if len(runs) > 1:
            draw_robots(figure.add_axes(ROBOT_NAMES), runs)
        if not region.whole:
            draw_map(figure.add_axes(MAP), recording, runs, region)
        name = shortened(recording.scenario.name, 40)
        figure.text(0.05, 0.955, name, size=15, weight="bold", va="center")
        figure.text(0.05, 0.913, _facts(recording, every), color=GREY, va="center")
    return figure


def save_trajectory(recording: Recording, path: str | PathLike[str]) -> None:
    """Write the figure as a PNG: the same bytes for the same recording, or MachineError."""
    image = BytesIO()
    with matplotlib.style.context(STYLE), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing")  # names may have any
        whole = trajectory_figure if recording.scenario.robots else arms_alone
        whole(recording).savefig(image, format="png", metadata={"Software": None})
    try:
        Path(path).write_bytes(image.getvalue())
    except OSError as error:
        raise MachineError(f"{path}: {error.strerror or error}") from error


def arms_alone(recording: Recording) -> Figure:
    """Where there are no robots: what the arms did."""
    name = f"{shortened(recording.scenario.name, 40)}, seed {recording.meta['seed']}"
    return arm_figure([("", recording)], name)


def _facts(recording: Recording, runs: list[Track]) -> str:
    """Seed, time, how many legs were reached, and the largest drift, in one line."""
    said = [f"seed {recording.meta['seed']}", f"{recording.duration:.1f} s"]
    if len(runs) > 1:
        some = f" ({len(ROBOTS)} shown)" if len(runs) > len(ROBOTS) else ""
        said.append(f"{len(runs)} robots{some}")
    aimed = [end for run in runs for end in run.ends if end.place is not None]
    if aimed:
        said.append(f"{sum(end.reached for end in aimed)} of {len(aimed)} legs reached")
    apart, turned = np.abs(np.concatenate([run.drift for run in runs])).max(axis=0)
    said.append(f"odometry off by up to {100 * apart:.1f} cm and {np.degrees(turned):.1f} deg")
    return "  ·  ".join(said)
