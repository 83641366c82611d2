"""The right half of trajectory.png: x, y, heading and drift over time."""

from collections.abc import Sequence
from math import ceil

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator, MultipleLocator

from soccersim.record import Recording
from soccersim.render.plot_style import COMMANDED, GREY, LOST, TURNED, look
from soccersim.render.tracks import Track, letter

# label, factor from SI, least span of the axis: columns of a pose
POSE = (("x (m)", 1.0, 0.4), ("y (m)", 1.0, 0.4), ("heading (deg)", np.degrees(1.0), 20.0))
LEAST_DRIFT = 2.0  # mm and degrees
PARTS_OF_A_TURN = (15, 30, 45, 90, 180)  # degrees: where large angles have their ticks
TICKS = 5  # at most, or about
LETTERS_APART = 0.03  # of the time axis: nearer letters would overlap


def draw_history(panels: Sequence[Axes], recording: Recording, runs: list[Track]) -> None:
    """Three panels with the pose, a fourth with how far belief and truth lie apart."""
    for column, (name, scale, least) in enumerate(POSE):
        panel = panels[column]
        _draw_pose(panel, recording, runs, column, scale)
        low, high = panel.get_ylim()
        short = max(least - (high - low), 0.0) / 2
        _tidy(panel, name, low - short, high + short)
        panel.tick_params(labelbottom=False)
    _draw_drift(panels[-1], recording, runs)
    panels[-1].set_xlabel("time (s)")
    panels[-1].set_xlim(0.0, max(recording.duration, recording.scenario.dt))
    for panel in panels:
        panel.grid(color="#DDDDDD", lw=0.6)
    panels[0].figure.align_ylabels(list(panels))
    if len(runs) == 1:
        _mark_legs(panels, runs[0], recording.duration)


def _draw_pose(
    panel: Axes, recording: Recording, runs: list[Track], column: int, scale: float
) -> None:
    for i, run in enumerate(runs):
        style = look(i, len(runs))
        if len(runs) == 1:
            y = run.commanded[:, column] * scale
            panel.plot(recording.time, y, label="commanded", **style.commanded)
        panel.plot(
            recording.time, run.believed[:, column] * scale, label="believed", **style.believed
        )
        panel.plot(recording.time, run.true[:, column] * scale, label="true", **style.true)


def _draw_drift(panel: Axes, recording: Recording, runs: list[Track]) -> None:
    """How far apart on the left, by what angle on the right."""
    apart = [run.drift[:, 0] for run in runs]
    turned = [np.degrees(np.abs(run.drift[:, 1])) for run in runs]
    unit, scale = ("cm", 100.0) if max(map(np.max, apart)) >= 0.01 else ("mm", 1000.0)
    one, right = len(runs) == 1, panel.twinx()
    for i in range(len(runs)):
        colour = look(i, len(runs)).colour
        panel.plot(recording.time, apart[i] * scale, color=COMMANDED if one else colour, lw=1.4)
        right.plot(recording.time, turned[i], ":", color=TURNED if one else colour, lw=1.4)
    _tidy(panel, f"— drift ({unit})", 0.0, max(panel.get_ylim()[1], LEAST_DRIFT))
    _tidy(right, "··· heading drift (deg)", 0.0, max(right.get_ylim()[1], LEAST_DRIFT))
    right.yaxis.label.set_color(TURNED if one else COMMANDED)


def _tidy(panel: Axes, name: str, low: float, high: float) -> None:
    """Label, limits, and ticks at round numbers: of degrees, at parts of a turn."""
    panel.set_ylabel(name)
    panel.set_ylim(low, high)
    if "deg" in name and high - low > 4 * PARTS_OF_A_TURN[0]:
        turns = 360 * ceil((high - low) / (360 * TICKS))
        step = next((part for part in PARTS_OF_A_TURN if high - low < TICKS * part), turns)
        panel.yaxis.set_major_locator(MultipleLocator(step))
    else:
        panel.yaxis.set_major_locator(MaxNLocator(TICKS, steps=[1, 2, 2.5, 5, 10]))


def _mark_legs(panels: Sequence[Axes], run: Track, duration: float) -> None:
    """A line where each leg ends, its target's letter above; legs given up are shaded."""
    last = -duration
    for end in run.ends:
        for panel in panels:
            panel.axvline(end.time, color=GREY, lw=0.7, ls=(0, (1, 2)), zorder=1)
            if end.given_up:
                panel.axvspan(end.begin, end.time, color=LOST, lw=0, zorder=0)
        if end.place is not None and end.time - last > LETTERS_APART * duration:
            last = end.time
            panels[0].annotate(letter(end.place), (end.time, 1.0), xytext=(0, 3),
                               xycoords=("data", "axes fraction"), textcoords="offset points",
                               ha="center", weight="bold")  # fmt: skip
