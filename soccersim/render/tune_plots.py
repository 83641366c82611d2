"""tune.png: each loop under the relay, at gains about the ultimate one, and after a step."""

from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from os import PathLike
from pathlib import Path
from typing import Any

import matplotlib.style
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from soccersim.problems import MachineError
from soccersim.render.plot_style import BELIEVED, COMMANDED, GREY, RC, ROBOTS, TRUE
from soccersim.state import Array

STYLE: list[str | dict[str, Any]] = ["default", RC, {"text.parse_math": False}]
WIDTH, HEIGHT, DPI = 14.0, 2.9, 110  # inches, of the figure and of a loop's row
HEAD, FOOT = 0.95, 0.75  # inches for the title and the legend
LASTS = {"P": "-", "PI": (0, (5, 2)), "PID": (0, (1, 1.3))}  # line style of a controller
PERIODS = 8  # of a relay test, at its end
TRIALS = (ROBOTS[4], COMMANDED, ROBOTS[1])  # colours: below, at and above the ultimate gain
CLIP = 3.0  # swings: what grows beyond leaves the picture
WILD = 2.0  # steps: so does an answer that swings as far


@dataclass(frozen=True)
class Curve:
    """A line over time."""

    name: str
    time: Array  # s
    value: Array
    kind: str = "P"  # of controller


@dataclass(frozen=True)
class LoopPicture:
    """What is drawn of one loop; values in its unit, m, rad or rad/s."""

    name: str
    unit: str
    push_unit: str
    said: str  # what was found, in a line
    push: Curve  # the relay's
    answer: Curve
    period: float  # s of the relay's oscillation; 0: none
    swing: float
    trials: Sequence[Curve]  # from 0 after a step of one swing
    step: float
    steps: Sequence[Curve]  # the last is the one to take


def tune_figure(title: str, loops: Sequence[LoopPicture]) -> Figure:
    """A row a loop: relay test, trials about the ultimate gain, answers to a step."""
    with matplotlib.style.context(STYLE):
        height = HEAD + HEIGHT * len(loops) + FOOT
        figure = Figure(figsize=(WIDTH, height), dpi=DPI)
        FigureCanvasAgg(figure)
        grid = figure.add_gridspec(
            len(loops), 3, left=0.06, right=0.985, top=1 - HEAD / height,
            bottom=FOOT / height + 0.035, wspace=0.34, hspace=0.52, width_ratios=(1, 1, 1.25),
        )  # fmt: skip
        rules: dict[str, Any] = {}
        for panels, loop in zip(grid.subplots(squeeze=False), loops, strict=True):
            for panel in panels:
                panel.grid(color="#DDDDDD", lw=0.6)
            _draw_relay(panels[0], loop)
            _draw_trials(panels[1], loop)
            _draw_steps(panels[2], loop, rules)
            panels[0].set_title(f"{loop.name}: {loop.said}", loc="left", size=9.5)
        _legend(figure, rules, 0.2 / height)
        figure.text(0.06, 1 - 0.36 / height, title, size=14, weight="bold", va="center")
    return figure


def save_tune(title: str, loops: Sequence[LoopPicture], path: str | PathLike[str]) -> None:
    """Write the figure as a PNG, or MachineError."""
    image = BytesIO()
    with matplotlib.style.context(STYLE):
        tune_figure(title, loops).savefig(image, format="png", metadata={"Software": None})
    try:
        Path(path).write_bytes(image.getvalue())
    except OSError as error:
        raise MachineError(f"{path}: {error.strerror or error}") from error


def _scaled(unit: str, largest: float) -> tuple[str, float]:
    """The unit in which values are shown, and the factor from SI."""
    if unit == "rad":
        return "deg", float(np.degrees(1.0))
    if unit == "m" and largest < 0.1:
        return "mm", 1000.0
    return unit, 1.0


def _draw_relay(panel: Axes, loop: LoopPicture) -> None:
    """The last periods of the relay test: answer on the left, push on the right."""
    unit, scale = _scaled(loop.unit, loop.swing)
    end = loop.answer.time[-1]
    start = max(0.0, end - PERIODS * loop.period) if loop.period else 0.0
    right = panel.twinx()
    right.step(loop.push.time, loop.push.value, where="post", color=BELIEVED, lw=1.0)
    panel.plot(loop.answer.time, loop.answer.value * scale, color=TRUE, lw=1.5)
    panel.set_xlim(start, end)
    shown = loop.answer.value[loop.answer.time >= start] * scale
    _centre(panel, float(np.abs(shown).max()) * 1.15)
    _centre(right, float(np.abs(loop.push.value).max()) * 1.6)
    panel.set_ylabel(f"answer ({unit})", color=TRUE)
    right.set_ylabel(f"push ({loop.push_unit})", color=BELIEVED)
    panel.set_xlabel("time of the relay test (s)")
    panel.set_zorder(right.get_zorder() + 1)
    panel.patch.set_visible(False)


def _centre(panel: Axes, most: float) -> None:
    panel.set_ylim(-most or -1.0, most or 1.0)


def _draw_trials(panel: Axes, loop: LoopPicture) -> None:
    """The error after a small step, at gains below, at and above the ultimate one."""
    unit, scale = _scaled(loop.unit, loop.swing)
    for colour, curve in zip(TRIALS, loop.trials, strict=False):
        error = (curve.value - np.mean(curve.value[: len(curve.value) // 3])) * scale
        panel.plot(curve.time, error, color=colour, lw=1.3, label=f"kp {curve.name}")
    _centre(panel, CLIP * loop.swing * scale)
    panel.set_ylabel(f"from its mean ({unit})")
    panel.set_xlabel("time after a small step, no limits (s)")
    if loop.trials:
        panel.set_xlim(0.0, loop.trials[0].time[-1])
        panel.legend(loc="upper right", ncols=3, handlelength=1.2, columnspacing=1.0,
                     bbox_to_anchor=(1.0, 1.1))  # fmt: skip


def _draw_steps(panel: Axes, loop: LoopPicture, rules: dict[str, Any]) -> None:
    """Answers with the gains of every rule; the present ones black, those to take broad."""
    unit, scale = _scaled(loop.unit, loop.step)
    panel.axhline(loop.step * scale, color=GREY, lw=0.8)
    for at, curve in enumerate(loop.steps):
        last = at == len(loop.steps) - 1
        if not last and curve.name not in rules:
            rules[curve.name] = COMMANDED if curve.name == "present" else ROBOTS[len(rules) - 1]
        look: dict[str, Any] = {"color": rules[curve.name], "lw": 1.2, "zorder": 3}
        if curve.name == "present":
            look["zorder"] = 4
        elif not last:
            look["ls"] = LASTS[curve.kind]
        if last:
            look = {"color": rules[curve.name], "lw": 5.0, "alpha": 0.3, "zorder": 2}
        wild = np.flatnonzero(np.abs(curve.value) > WILD * loop.step)
        until = wild[0] + 1 if len(wild) else len(curve.value)
        panel.plot(curve.time[:until], curve.value[:until] * scale, **look)
    panel.set_xlim(0.0, _interesting(loop))
    panel.set_ylim(-0.12 * loop.step * scale, 1.5 * loop.step * scale)
    panel.set_ylabel(f"answer ({unit})")
    panel.set_xlabel("time after the step, the robot's own limits (s)")


def _interesting(loop: LoopPicture) -> float:
    """Seconds until nearly all answers are settled."""
    last = []
    for curve in loop.steps:
        outside = np.flatnonzero(np.abs(curve.value / loop.step - 1.0) > 0.06)
        last.append(curve.time[outside[-1]] if len(outside) else 0.0)
    return float(max(0.5, min(1.4 * np.median(last), loop.steps[0].time[-1])))


def _legend(figure: Figure, rules: dict[str, Any], bottom: float) -> None:
    """Rules by colour, controllers by line, below all panels."""
    handles = [Line2D([], [], color=colour, lw=2, label=name) for name, colour in rules.items()]
    handles += [Line2D([], [], color=GREY, lw=1.4, ls=ls, label=n) for n, ls in LASTS.items()]
    handles.append(Line2D([], [], color=GREY, lw=5, alpha=0.3, label="recommended"))
    figure.legend(handles=handles, loc="lower right", ncols=len(handles), handlelength=2.2,
                  columnspacing=1.4, bbox_to_anchor=(0.985, bottom))  # fmt: skip
