"""The figure of `soccersim plot`: position, heading, error, wheels and PWM over time."""

import warnings
from collections.abc import Callable, Sequence
from functools import partial
from io import BytesIO
from os import PathLike, fspath
from pathlib import Path, PurePath
from typing import Any

import matplotlib.style
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from soccersim.problems import InputError, MachineError, Problem, one_line
from soccersim.render.curves import Curve
from soccersim.render.plot_style import BELIEVED, COMMANDED, GREY, RC, ROBOTS, TRUE

KINDS = {  # ending: what matplotlib shall leave out, for the same bytes
    ".png": {"Software": None},
    ".svg": {"Date": None, "Creator": None},
    ".pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
STYLE: list[str | dict[str, Any]] = ["default", RC, {"svg.hashsalt": "soccersim"}]
DPI, WIDE, ROW = 120, 14.0, 1.75  # inches: width of the figure, height of a panel
ABOVE, BELOW = 0.78, 0.55  # inches above, with the title, and below
LEGEND_ROW, SIDE_ROW = 0.2, 0.2  # inches that a row of a legend takes, and a team's name
LETTER, LINE = 0.075, 0.62  # inches, about: of a legend's letter, and of the line before it
HALVES, WHOLE = ((0.067, 0.485), (0.567, 0.985)), (0.067, 0.985)
MOST_WHEELED = 3  # curves whose wheels can be told apart
DOTS = (0, (1.2, 1.2))
DASHES = ("-", (0, (5, 1.5)), (0, (2, 1)), (0, (6, 1.5, 1.2, 1.5)), (0, (9, 3)), DOTS)  # by wheel
SCALES = (1.0, 1.0, 180 / np.pi)
PANELS = ("x (m)", "y (m)", "heading (deg)", "position error (cm)", "heading error (deg)")
WHEELS = {  # array: what its panel is called
    "wheel_speed": "wheel speed (rad/s)",
    "slip": "slip (m/s)",
    "pwm": "PWM (of 255)",
}
SIDES = ("home", "away")


def plot_kind(path: str | PathLike[str]) -> str:
    """`.png`, `.svg` or `.pdf`, by the ending; InputError for others."""
    kind = PurePath(path).suffix.lower()
    if kind not in KINDS:
        raise InputError(
            Problem("a plot's name ends in .png, .svg or .pdf", one_line(fspath(path)))
        )
    return kind


def save_curves(drawn: list[Curve], title: str, path: str | PathLike[str], kind: str = "") -> None:
    """Write the figure: the same bytes for the same recordings, or MachineError."""
    save_plot(partial(curve_figure, drawn, title), path, kind)


def save_plot(figure: Callable[[], Figure], path: str | PathLike[str], kind: str = "") -> None:
    """Write a figure that is made in our style, by the ending or the kind."""
    kind, image = kind or plot_kind(path), BytesIO()
    with matplotlib.style.context(STYLE), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing")  # names may have any
        figure().savefig(image, format=kind[1:], metadata=KINDS[kind])
    try:
        Path(path).write_bytes(image.getvalue())
    except OSError as error:
        raise MachineError(f"{fspath(path)}: {error.strerror or error}") from error


def wheeled(drawn: Sequence[Curve]) -> list[str]:
    """The arrays of wheels that get a panel."""
    if len(drawn) > MOST_WHEELED:
        return []
    return [key for key in WHEELS if any(key in curve.wheels for curve in drawn)]


def curve_figure(drawn: list[Curve], title: str) -> Figure:
    """Position, heading and errors on the left, wheels on the right; a match has a column a side.

    One robot's lines have the colours of what they are; several robots a colour each.
    """
    teams = [team for team in SIDES if any(curve.team == team for curve in drawn)]
    wheels = wheeled(drawn)
    sided = not wheels and len(teams) == 2 and len(drawn) > MOST_WHEELED
    if sided:
        legends = [_robots(drawn, team) for team in teams]
    else:
        legends = [[*_kinds(drawn), *_robots(drawn)], _wheel_lines(drawn) if wheels else []]
    across = [_across(legend) for legend in legends]
    lines = max(-(-len(legend) // n) for legend, n in zip(legends, across, strict=True))
    above = ABOVE + lines * LEGEND_ROW + (SIDE_ROW if sided else 0.0)
    height = len(PANELS) * ROW + above + BELOW
    figure = Figure(figsize=(WIDE, height), dpi=DPI)
    FigureCanvasAgg(figure)
    box = {"top": 1 - above / height, "bottom": BELOW / height, "hspace": 0.16}
    halves = HALVES if sided or wheels else (WHOLE,)
    columns = []
    for half, (left, right) in enumerate(halves):
        rows = len(wheels) if wheels and half else len(PANELS)
        grid = figure.add_gridspec(rows, 1, left=left, right=right, **box)
        columns.append(list(grid.subplots(sharex=True, squeeze=False)[:, 0]))
        place = (left, 1 - (ABOVE - 0.28) / height)
        figure.legend(handles=legends[half], loc="upper left", ncols=across[half], handlelength=2.4,
                      bbox_to_anchor=place, columnspacing=1.6)  # fmt: skip
    if sided:
        for panels, team in zip(columns, teams, strict=True):
            _draw_pose(panels, drawn, team)
            panels[0].set_title(team, fontsize=11, weight="bold")
        _share_heights(*columns)
    else:
        _draw_pose(columns[0], drawn)
        if wheels:
            _draw_wheels(columns[1], drawn, wheels)
    _finish(figure, columns, drawn)
    figure.text(halves[0][0], 1 - 0.28 / height, title, size=14, weight="bold", va="center")
    return figure


def _across(legend: list[Line2D]) -> int:
    """How many entries of a legend have room side by side over half of the figure."""
    longest = max((len(str(line.get_label())) for line in legend), default=0)
    return max(1, int((HALVES[0][1] - HALVES[0][0]) * WIDE / (LINE + LETTER * longest)))


def _colour(drawn: list[Curve], number: int) -> str:
    return TRUE if len(drawn) == 1 else ROBOTS[number]


def _draw_pose(panels: list[Axes], drawn: list[Curve], team: str | None = None) -> None:
    """x, y, heading, and how far belief lies from truth; of one team, or of all."""
    one, few = len(drawn) == 1, len(drawn) <= MOST_WHEELED
    for number, curve in enumerate(drawn):
        if team not in (None, curve.team):
            continue
        colour, time = _colour(drawn, number), curve.time
        for column, (panel, scale) in enumerate(zip(panels, SCALES, strict=False)):
            if few and curve.wanted is not None:
                shade = COMMANDED if one else colour
                panel.plot(time, scale * curve.wanted[:, column], color=shade, lw=1.0, ls=DOTS)
            if few:
                shade, dash = (BELIEVED, "-") if one else (colour, DASHES[1])
                panel.plot(time, scale * curve.believed[:, column], color=shade, lw=1.1, ls=dash)
            way = scale * (curve.true[:, column] if few or column < 2 else curve.wrapped)
            panel.plot(time, way, color=colour, lw=1.5 if few else 1.2)
        for panel, off, scale in zip(panels[3:], curve.off, (100.0, SCALES[2]), strict=True):
            shade = COMMANDED if one else colour
            panel.plot(time, scale * off, color=shade, lw=1.2 if few else 0.7)
    for panel, name in zip(panels, PANELS, strict=True):
        panel.set_ylabel(name)


def _share_heights(first: list[Axes], second: list[Axes]) -> None:
    """Panels side by side get the same range."""
    for one, other in zip(first, second, strict=True):
        low, high = zip(one.get_ylim(), other.get_ylim(), strict=True)
        for panel in (one, other):
            panel.set_ylim(min(low), max(high))


def _draw_wheels(panels: list[Axes], drawn: list[Curve], wheels: list[str]) -> None:
    """A panel for each array; wheels apart by colour, or by dashes where colours are robots'."""
    for panel, key in zip(panels, wheels, strict=True):
        panel.set_ylabel(WHEELS[key])
        for number, curve in enumerate(drawn):
            table = curve.wheels.get(key)
            if table is None:
                continue
            for wheel in range(_shown(drawn, curve) if key != "pwm" else curve.driven):
                look = _wheel_look(drawn, number, wheel)
                panel.plot(curve.time, table[:, wheel], lw=1.1, **look)
                if key == "wheel_speed" and len(drawn) == 1 and wheel < curve.driven:
                    _draw_set_point(panel, curve, wheel)


def _shown(drawn: list[Curve], curve: Curve) -> int:
    """Wheels of which lines are drawn: of several robots only those with a motor."""
    return curve.count if len(drawn) == 1 else curve.driven


def _draw_set_point(panel: Axes, curve: Curve, wheel: int) -> None:
    if "wheel_setpoint" in curve.wheels:
        wanted = curve.wheels["wheel_setpoint"][:, wheel]
        panel.plot(curve.time, wanted, color=COMMANDED, lw=0.8, ls=DASHES[2], zorder=1.8)


def _wheel_look(drawn: list[Curve], number: int, wheel: int) -> dict[str, Any]:
    if len(drawn) == 1:
        return {"color": ROBOTS[wheel % len(ROBOTS)]}
    return {"color": ROBOTS[number], "ls": DASHES[wheel % len(DASHES)]}


def _finish(figure: Figure, columns: list[list[Axes]], drawn: list[Curve]) -> None:
    """Grids, and the time below."""
    longest = max(float(curve.time[-1]) for curve in drawn)
    for panels in columns:
        for panel in panels:
            panel.grid(color="#DDDDDD", lw=0.6)
            panel.set_xlim(0.0, max(longest, 1e-3))
        panels[-1].set_xlabel("time (s)")
        figure.align_ylabels(panels)


def _kinds(drawn: list[Curve]) -> list[Line2D]:
    """What the lines of a pose are, where a robot has more than one."""
    if len(drawn) > MOST_WHEELED:
        return []
    one = len(drawn) == 1
    kinds: list[tuple[str, str, Any]] = [
        ("true", TRUE if one else GREY, "-"),
        ("believed", BELIEVED if one else GREY, "-" if one else DASHES[1]),
    ]
    if any(curve.wanted is not None for curve in drawn):
        kinds.append(("set-point", COMMANDED if one else GREY, DOTS))
    return [_line(*kind) for kind in kinds]


def _robots(drawn: list[Curve], team: str | None = None) -> list[Line2D]:
    """Each robot's colour, where there are several."""
    if len(drawn) == 1:
        return []
    shown = [(i, curve) for i, curve in enumerate(drawn) if team in (None, curve.team)]
    return [_line(curve.label, ROBOTS[i], "-") for i, curve in shown]


def _wheel_lines(drawn: list[Curve]) -> list[Line2D]:
    """Each wheel's colour or dashes."""
    most = max(drawn, key=lambda curve: _shown(drawn, curve))
    lines = []
    for wheel in range(_shown(drawn, most)):
        look = {"color": GREY, "ls": "-", **_wheel_look(drawn, 0, wheel)}
        colour = GREY if len(drawn) > 1 else look["color"]
        dead = " (no motor)" if wheel >= most.driven else ""
        lines.append(_line(f"wheel {wheel + 1}{dead}", colour, look["ls"]))
    if len(drawn) == 1 and {"wheel_setpoint", "wheel_speed"} <= most.wheels.keys():
        lines.append(_line("set-point", COMMANDED, DOTS))
    return lines


def _line(name: str, colour: str, dash: Any) -> Line2D:
    return Line2D([], [], color=colour, ls=dash, lw=1.6, label=name)
