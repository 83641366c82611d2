"""Arms over time: the ways of their tips from above, and the angles of their joints."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from soccersim.record import Recording
from soccersim.render.plot_style import GREY, ROBOTS
from soccersim.render.tracks import Array, framed, shortened

INCHES, DPI = (14.0, 7.6), 120
TIPS = (0.06, 0.09, 0.42, 0.75)  # left, bottom, width, height as shares of the figure
JOINTS = {"left": 0.565, "right": 0.985, "top": 0.84, "bottom": 0.09, "hspace": 0.14}
LONGEST = 24  # letters of a name in the legend


def arm_figure(recordings: list[tuple[str, Recording]], title: str) -> Figure:
    """Tips on the left, in the scenario's frame; joints on the right, counter-clockwise.

    recordings: with what each is called, where there are several. A cross stands at an arm's base,
    a dot where a tip was when a hold ended. Ten arms at most are shown.
    """
    figure = Figure(figsize=INCHES, dpi=DPI)
    FigureCanvasAgg(figure)
    top, grid = figure.add_axes(TIPS), figure.add_gridspec(3, 1, **JOINTS)
    panels = list(grid.subplots(sharex=True, squeeze=False).flat)
    arms = [(*each, row) for each in recordings for row in range(len(each[1].scenario.arms))]
    for colour, (label, recording, row) in zip(ROBOTS, arms, strict=False):
        arm, at = recording.scenario.arms[row], recording.scenario.coordinates
        name = shortened(f"{label} {arm.name}".strip(), LONGEST)
        base, tip = ends(recording, row)
        held = np.searchsorted(recording.tick, [g["end_tick"] for g in recording.meta["arms"][row]])
        top.plot(*framed(at, tip).T, color=colour, lw=1.4, label=name)
        top.plot(*framed(at, tip[held.clip(max=len(tip) - 1)]).T, "o", color=colour, ms=4)
        top.plot(*framed(at, base[:1]).T, "+", color=colour, ms=10, mew=1.4)
        for joint, panel in enumerate(panels):
            if "joint" in recording.arrays:  # the first record is taken before any is measured
                turned = np.degrees(recording.arrays["joint"][1:, row, joint])
                panel.plot(recording.time[1:], turned, color=colour, lw=1.2)
    top.set(xlabel="x (m)", ylabel="y (m)", aspect="equal", adjustable="datalim")
    for joint, panel in enumerate(panels, 1):
        panel.set_ylabel(f"joint {joint} (deg)")
        panel.yaxis.set_major_locator(MaxNLocator(8, steps=[1, 1.5, 3, 4.5, 9, 10]))
    for axes in (top, *panels):
        axes.grid(color="#DDDDDD", lw=0.6)
    panels[-1].set_xlabel("time (s)")
    panels[-1].set_xlim(0.0, max(float(recording.time[-1]) for _, recording in recordings))
    figure.align_ylabels(panels)
    figure.legend(loc="upper left", bbox_to_anchor=(TIPS[0], 0.905), ncols=5, columnspacing=1.6)
    figure.text(TIPS[0], 0.955, title, size=15, weight="bold", va="center")
    if len(arms) > len(ROBOTS):
        told = f"the first {len(ROBOTS)} of {len(arms)} arms"
        figure.text(0.985, 0.955, told, color=GREY, va="center", ha="right")
    return figure


def ends(recording: Recording, row: int) -> tuple[Array, Array]:
    """(T, 2) m, field frame: an arm's base and its tip."""
    lengths = recording.scenario.arms[row].lengths
    links = recording.links[:, row, :, :3].astype(float)
    ahead = np.stack((np.cos(links[..., 2]), np.sin(links[..., 2])), axis=-1)
    base = links[:, 0, :2] - lengths[0] / 2 * ahead[:, 0]
    return base, links[:, 2, :2] + lengths[2] / 2 * ahead[:, 2]
