"""What stands round the panels: the legends, and where on the field the top view lies."""

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from soccersim.record import Recording
from soccersim.render import markings
from soccersim.render.plot_style import COMMANDED, look
from soccersim.render.topview import Region, draw_field, draw_paths, look_at
from soccersim.render.tracks import Track, framed


def draw_kinds(axes: Axes, top_view: Axes, runs: list[Track]) -> None:
    """Every kind of line and marker in the top view."""
    axes.set_axis_off()
    kinds: dict[str, Artist] = {}
    for handle, name in zip(*top_view.get_legend_handles_labels(), strict=True):
        kinds.setdefault(name, handle)
    legend = axes.legend(
        kinds.values(), kinds.keys(), ncols=2, loc="upper left", handlelength=2.6, columnspacing=2
    )
    if len(runs) > 1:
        for line in legend.get_lines():
            _take_no_colour(line)


def draw_robots(axes: Axes, runs: list[Track]) -> None:
    """The colours of several robots."""
    axes.set_axis_off()
    lines = [
        Line2D([], [], color=look(i, len(runs)).colour, lw=3, label=run.label)
        for i, run in enumerate(runs)
    ]
    axes.legend(handles=lines, ncols=min(len(runs), 4), loc="lower right", handlelength=1.4,
                columnspacing=1.2, labelspacing=0.3)  # fmt: skip


def draw_map(axes: Axes, recording: Recording, runs: list[Track], region: Region) -> None:
    """The whole field, small, with the frame of the top view."""
    axes.set_axis_off()
    axes.set_anchor("NE")
    at = recording.scenario.coordinates
    corners = framed(at, markings.floor(recording.scenario.field))
    look_at(axes, Region(corners.min(axis=0), corners.max(axis=0), whole=True), at.mirror)
    draw_field(axes, recording)
    for i, run in enumerate(runs):
        draw_paths(axes, run, look(i, len(runs)), 0.5)
    width, height = region.high - region.low
    corner = (region.low[0], region.low[1])
    axes.add_patch(Rectangle(corner, width, height, fill=False, ec=COMMANDED, lw=0.9, zorder=9))


def _take_no_colour(line: Line2D) -> None:
    """What all robots have is not shown in the colour of the first."""
    line.set_color(COMMANDED)
    if line.get_markeredgecolor() != "white":
        line.set_markeredgecolor(COMMANDED)
    if line.get_markerfacecolor() != "white":
        line.set_markerfacecolor(COMMANDED)
