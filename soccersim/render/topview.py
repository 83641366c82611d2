"""The left half of trajectory.png: the paths on the field, seen from above."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle, Polygon
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

from soccersim.record import Recording
from soccersim.render import markings
from soccersim.render.plot_style import BOARD, FEW, GRASS, PAINT, PAPER, Look, look
from soccersim.render.tracks import SAME_PLACE, Array, Track, framed, letter

HEADING_MARKS, LEAST_MARKS = 24, 8  # on all paths together, and at least on each
WHOLE = 0.7  # a region of this share of the field's length and width might as well be all of it
HALO = [withStroke(linewidth=2.5, foreground="white")]


class Region(NamedTuple):
    """A part of the floor, in the scenario's frame."""

    low: Array  # (2,) m
    high: Array
    whole: bool  # the whole field is in it


def draw_top_view(axes: Axes, recording: Recording, runs: list[Track]) -> Region:
    """Draw the region where something happens; returns it."""
    ball = ball_path(recording)
    mirror = recording.scenario.coordinates.mirror
    region = _region(axes, recording, runs, ball)
    look_at(axes, region, mirror)
    axes.set(xlabel="x (m)", ylabel="y (m)", axisbelow=True)
    axes.grid(color="white", lw=0.9)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(8, steps=[1, 2, 2.5, 5, 10]))
    draw_field(axes, recording)
    if len(ball):
        x, y = ball.T
        axes.plot(
            x,
            y,
            "-o",
            color="black",
            lw=0.7,
            ms=4,
            markevery=[-1],
            label="ball, at the end",
            zorder=4,
        )
    for i, run in enumerate(runs):
        style = look(i, len(runs))
        draw_paths(axes, run, style, commanded=len(runs) <= FEW)
        _draw_headings(axes, run, style, max(HEADING_MARKS // len(runs), LEAST_MARKS), mirror)
        if len(runs) <= FEW:
            _draw_places(axes, run, str(style.commanded["color"]))
            _draw_ends(axes, run, style)
        else:
            _label(axes, str(run.number), run.true[0, :2], (0.0, 8.0), style.colour)
    return region


def look_at(axes: Axes, region: Region, mirror: float) -> None:
    """Show the region as seen from above: an author's y to the right is drawn downwards."""
    axes.set_aspect("equal")
    axes.set_xlim(region.low[0], region.high[0])
    bottom, top = (region.low[1], region.high[1])[:: 1 if mirror > 0 else -1]
    axes.set_ylim(bottom, top)


def draw_field(axes: Axes, recording: Recording) -> None:
    """Floor, lines, goals and marks, to the scale of the axes' limits."""
    field, at = recording.scenario.field, recording.scenario.coordinates
    paint = max(field.line_width * _points_per_metre(axes), 0.5)
    axes.add_patch(Polygon(framed(at, markings.floor(field)), fc=GRASS, ec=BOARD, lw=1.2, zorder=0))
    for shapes, colour, width in (
        (markings.lines(field), PAINT, paint),
        (markings.goals(field), BOARD, 1.6),
    ):
        drawn = [framed(at, shape) for shape in shapes]
        axes.add_collection(
            LineCollection(drawn, colors=colour, lw=width, capstyle="projecting", zorder=0.7), False
        )
    x, y = framed(at, markings.spots(field)).T
    axes.plot(x, y, "o", color=PAINT, ms=max(1.6 * paint, 2.0), mew=0, zorder=0.7)


def draw_paths(
    axes: Axes, run: Track, style: Look, scale: float = 1.0, commanded: bool = True
) -> None:
    """Commanded, believed and true path; their widths times scale."""
    lines = [
        ("commanded path", run.route, style.commanded),
        ("believed path (odometry)", run.believed, style.believed),
        ("true path, arrows: heading", run.true, style.true),
    ]
    for name, points, line in lines if commanded and len(run.route) > 1 else lines[1:]:
        axes.plot(points[:, 0], points[:, 1], label=name, **line | {"lw": scale * line["lw"]})


def ball_path(recording: Recording) -> Array:
    """(T, 2): where the ball was, in the scenario's frame; (0, 2) without a ball."""
    if recording.ball is None:
        return np.empty((0, 2))
    return framed(recording.scenario.coordinates, recording.ball[:, :2])


def _draw_headings(axes: Axes, run: Track, style: Look, count: int, mirror: float) -> None:
    """Arrows at equal intervals of way and turn, so that a turn on the spot shows as a fan."""
    steps = np.abs(np.diff(run.true, axis=0))
    gone = np.cumsum(np.hypot(steps[:, 0], steps[:, 1]) + run.radius * steps[:, 2])
    at = np.array([0])
    if len(gone) and gone[-1] > run.radius:
        at = np.unique(np.searchsorted(gone, np.linspace(0, gone[-1], count)))
    x, y, heading = run.true[at].T
    axes.quiver(x, y, np.cos(heading), mirror * np.sin(heading), color=style.colour, angles="xy",
                width=1.5, units="dots", scale=0.042, scale_units="dots", zorder=4,
                headwidth=5.5, headlength=6, headaxislength=5.5)  # fmt: skip


def _draw_places(axes: Axes, run: Track, colour: str) -> None:
    """The start and the targets with their letters, which stand on the outside of the route."""
    name = "start, targets" if len(run.places) > 1 else "start"
    _mark(axes, run.places, "+", name, color=colour, ms=13.0, mew=1.2, zorder=4.5)
    middle = (run.places.min(axis=0) + run.places.max(axis=0)) / 2
    upwards = -1.0 if axes.yaxis_inverted() else 1.0
    for place, point in enumerate(run.places):
        away = (point - middle) * (1.0, upwards)
        side = np.where(np.abs(away) < SAME_PLACE, 1.0, np.sign(away))
        _label(axes, letter(place), point, (13.0 * side[0], 13.0 * side[1]), colour)


def _draw_ends(axes: Axes, run: Track, style: Look) -> None:
    """Where each leg ended, where the paper's robot was then, and how large the robot is."""
    hollow = {"mfc": "white", "mew": 1.4, "ms": 5.5}
    filled = {"mec": "white", "mew": 0.6, "ms": 6.5}
    believed, true = style.believed["color"], style.colour
    got_there = [end.truth for end in run.ends if not end.given_up]
    gave_up = [end.truth for end in run.ends if end.given_up]
    odometry = [end.odometry for end in run.ends]
    _mark(axes, odometry, "o", "believed end of a leg", mec=believed, zorder=6, **hollow)
    _mark(axes, got_there, "o", "true end of a leg", color=true, zorder=6, **filled)
    _mark(axes, gave_up, "X", "true end, timed out", color=true, zorder=6, **filled | {"ms": 9})
    _mark(axes, run.paper_odometry, "D", "paper: odometry", mec=PAPER, zorder=5.5, **hollow)
    _mark(axes, run.paper_truth, "D", "paper: measured", color=PAPER, zorder=5.5, **filled)
    for x, y, _ in run.true[[0, -1]]:
        axes.add_patch(Circle((x, y), run.radius, fill=False, ec=true, lw=0.8, alpha=0.5, zorder=2))


def _mark(axes: Axes, points: Sequence[Array] | Array, marker: str, name: str, **look: Any) -> None:
    if len(points):
        x, y = np.array(points)[:, :2].T
        axes.plot(x, y, marker, ls="", label=name, **look)


def _label(axes: Axes, text: str, at: Array, offset: tuple[float, float], colour: str) -> None:
    axes.annotate(text, (at[0], at[1]), xytext=offset, textcoords="offset points", color=colour,
                  ha="center", va="center", weight="bold", size=11, zorder=8,
                  path_effects=HALO)  # fmt: skip


def _region(axes: Axes, recording: Recording, runs: list[Track], ball: Array) -> Region:
    """What has to be seen, with a margin, in the shape of the axes."""
    scenario = recording.scenario
    shown = [ball] + [run.true[:, :2] for run in runs] + [run.believed[:, :2] for run in runs]
    for run in runs:
        shown += [run.places, run.paper_odometry, run.paper_truth]
    points = np.concatenate(shown)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = max(0.08 * (high - low).max(), 1.5 * max(run.radius for run in runs), 0.4)
    low, high = low - margin, high + margin
    corners = framed(scenario.coordinates, markings.floor(scenario.field))
    board = np.array([corners.min(axis=0), corners.max(axis=0)])
    whole = bool(((high - low) > WHOLE * (board[1] - board[0])).all())
    if whole:
        low, high = np.minimum(low, board[0] - 0.2), np.maximum(high, board[1] + 0.2)
    return Region(*_in_shape(axes, low, high, board), whole)


def _in_shape(axes: Axes, low: Array, high: Array, board: Array) -> tuple[Array, Array]:
    """The box widened to the shape of the axes, towards the inside of the field."""
    span = high - low
    shape = np.array([axes.bbox.width, axes.bbox.height])
    grown = (shape * (span / shape).max() - span) / 2
    outside = np.maximum(board[0] - (low - grown), 0) - np.maximum(high + grown - board[1], 0)
    inwards = np.clip(outside, -grown, grown)
    return low - grown + inwards, high + grown + inwards


def _points_per_metre(axes: Axes) -> float:
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    pixels = min(axes.bbox.width / abs(right - left), axes.bbox.height / abs(top - bottom))
    return float(pixels * 72 / axes.figure.dpi)
