"""Garcia-Sillas' linear and rotational motion simulated, and Figures 6 and 7 redrawn."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle

from soccersim.geometry import se2_arc
from soccersim.kinematics import OmniBase, papers
from soccersim.record import Recording
from soccersim.reproduce.figures import GREY, PAPER, TRUE, Figure, axes, canvas
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import SAME, forward
from soccersim.reproduce.section import Cell, Section
from soccersim.simulation import Simulation
from soccersim.spec.load import load_scenario
from soccersim.state import Array

RADIUS, DISTANCE = 0.05, 0.18  # m, of the robot `garcia`; the paper prints none
BASE = OmniBase.general((180, 60, -60), DISTANCE, RADIUS, directions_deg=(90, -30, -150))
STEADY = 3.0  # s after which the wheels hold their speeds
QUANTITIES = ("v_x (m/s)", "v_y (m/s)", "omega (rad/s)", "x (m)", "y (m)", "turned (deg)")
COLUMNS = ("", "paper (29)", "ours (29)", "physics", "physics - ours", "physics, believed")
TWIST_COLOURS = (TRUE, "#009E73", "#D55E00")


@dataclass(frozen=True)
class Motion:
    """The first phase of an open-loop run: wheel speeds held, and what came of it."""

    wheels: Array  # (3,) rad/s, held
    seconds: float
    time: Array  # (T,) s, from the start to the end of the phase
    pose: Array  # (T, 3) from the start pose, heading unwrapped
    twist: Array  # (T, 3) body frame
    believed: Array  # (3,) pose at the end, from the start pose
    size: float  # m, the robot's radius

    @property
    def steady(self) -> Array:
        """(3,) mean body twist once the wheels hold their speeds."""
        mean: Array = self.twist[self.time >= STEADY].mean(axis=0)
        return mean


def sections(lab: Lab) -> Iterator[Section]:
    """Linear, then rotational movement."""
    linear, rotation = simulate("linear"), simulate("rotation")
    lab.told(0.9)
    yield compared(
        "figure-6",
        "Linear movement, Figure 6: wheels 2 and 3 constant, wheel 1 zero",
        linear,
        "Wheels 2 and 3 at 10 and -10 rad/s: opposite, as equal ones would turn the robot. With "
        "(29) as printed these speeds move nothing.",
    )
    yield compared(
        "figure-7",
        "Rotational movement, Figure 7: all wheels equal and constant",
        rotation,
        "5 rad/s. With (29) as printed the robot would drive a circle, and with (28) as printed "
        "turn the other way at a third of the rate. Positive wheels turn it clockwise.",
    )


def simulate(scenario: str) -> Motion:
    """A run of an open-loop scenario of one robot that starts at rest with heading 0."""
    recording = Simulation(load_scenario(scenario)).run()
    phase = recording.scenario.robots[0].open_loop[0]  # type: ignore[index]
    ticks = recording.tick <= recording.legs[0][0]["end_tick"]
    return Motion(
        wheels=np.array(phase.wheel_speeds, dtype=np.float64),
        seconds=phase.seconds,
        time=recording.time[ticks],
        pose=from_start(recording.body[ticks, 0, :3], recording),
        twist=in_body(recording.body[ticks, 0]),
        believed=from_start(np.array(recording.legs[0][0]["odometry"]), recording),
        size=recording.scenario.robots[0].model.radius,
    )


def from_start(poses: Array, recording: Recording) -> Array:
    """(..., 3) poses less the first one, whose heading is 0; headings unwrapped."""
    away: Array = poses - recording.body[0, 0, :3]
    return away


def in_body(body: Array) -> Array:
    """(T, 3) twists in the body frame, of (T, 6) poses and velocities in the field frame."""
    vx, vy, c, s = body[:, 3], body[:, 4], np.cos(body[:, 2]), np.sin(body[:, 2])
    return np.column_stack((c * vx + s * vy, c * vy - s * vx, body[:, 5]))


def predicted(matrix: Array, motion: Motion) -> Array:
    """(6,) steady twist, and the pose after the phase, at these speeds from the first moment."""
    twist = matrix @ motion.wheels
    way = twist * motion.seconds
    return np.array([*twist, *se2_arc(*way), np.degrees(way[2])])


def compared(key: str, title: str, motion: Motion, about: str) -> Section:
    """Twist and pose by (29) as printed, by (29) mended, and as simulated."""
    printed = predicted(papers.garcia_eq29(RADIUS, DISTANCE), motion)
    ours = predicted(forward(BASE), motion)
    end = motion.pose[-1]
    physics = np.array([*motion.steady, *end[:2], np.degrees(end[2])])
    x, y, heading = motion.believed
    believed = [None] * 3 + [round(float(v), 4) + 0.0 for v in (x, y, np.degrees(heading))]
    rows: list[list[Cell]] = [
        [name, *(round(float(value), 4) + 0.0 for value in (p, o, q, q - o)), b]
        for name, p, o, q, b in zip(QUANTITIES, printed, ours, physics, believed, strict=True)
    ]
    wrong = np.flatnonzero(np.abs(printed - ours) > SAME)
    return Section(
        key,
        title,
        COLUMNS,
        rows,
        {int(i): "(1, 3) of (29)" for i in wrong},
        notes=(
            f"{about} The speeds are ours, as are R = {RADIUS} m and L = {DISTANCE} m: the paper "
            "prints none.",
            f"Twist: the mean from {STEADY:g} to {motion.seconds:g} s; pose: after "
            f"{motion.seconds:g} s, by (29) from the first moment at full speed. Physics (seed 1): "
            "motors spin the wheels up, which slip at first, and rubber creeps while it pushes. "
            "Believed: by the encoders, blind to that slip, and by the gyro, whose scale is off by "
            "1 % (estimate, one standard deviation).",
        ),
        figure=lambda: drawn(title, motion, printed, ours),
    )


def drawn(title: str, motion: Motion, printed: Array, ours: Array) -> Figure:
    """The robot from above every second, and its twist over time."""
    with canvas(11.0, 4.4, 1, 2, width_ratios=(1.25, 1)) as (figure, (left, right)):
        axes(left, "x (m)", "y (m)", f"{title.split(':')[0]}, at 0 to {motion.seconds:g} s")
        left.plot(*motion.pose[:, :2].T, color=TRUE, lw=1.8)
        away = bool(np.hypot(*motion.pose[-1, :2]) > motion.size)
        for second in range(int(motion.seconds) + 1):
            pose = motion.pose[np.searchsorted(motion.time, second - 1e-9)]
            _draw_robot(left, pose, motion.size, second, away)
        left.set_aspect("equal", adjustable="datalim")
        axes(right, "time (s)", "m/s, rad/s", "Body twist: physics, and by (29)")
        for k, name in enumerate(("v_x", "v_y", "omega")):
            right.plot(motion.time, motion.twist[:, k], color=TWIST_COLOURS[k], lw=1.6, label=name)
        end = motion.seconds
        right.hlines(ours[:3], 0.0, end, GREY, "dashed", label="(29) mended", lw=1.2)
        right.hlines(printed[:3], 0.0, end, PAPER, "dotted", label="(29) as printed", lw=1.2)
        right.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=5)
    return figure


def _draw_robot(on: Axes, pose: Array, size: float, second: int, away: bool) -> None:
    """Heading at a second, fainter the earlier; where the robot moves away, all of it."""
    middle, turn = complex(pose[0], pose[1]), np.exp(1j * pose[2])
    alpha = 0.35 + 0.12 * second
    if away or second == 0:
        on.add_patch(Circle((middle.real, middle.imag), size, fill=False, ec=GREY, alpha=alpha))
        for contact, direction in zip(BASE.contact, BASE.direction, strict=True):
            centre = middle + turn * complex(*contact)
            half = RADIUS * turn * np.exp(1j * direction)
            ends = np.array((centre - half, centre + half))
            on.plot(ends.real, ends.imag, color=TRUE, alpha=alpha, lw=3.5, solid_capstyle="butt")
    front = middle + 0.9 * size * turn
    arrow = {"arrowstyle": "->", "color": TRUE, "alpha": alpha}
    on.annotate("", (front.real, front.imag), (middle.real, middle.imag), arrowprops=arrow)
    told = middle + 1.18 * size * (1j if away else turn)
    on.plot(told.real, told.imag, "")  # keeps the text within the axes
    on.text(told.real, told.imag, f"{second} s", ha="center", va="center", fontsize=8)
