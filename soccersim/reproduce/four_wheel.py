"""The note on four omni wheels again: its matrices and lines, and a planned path followed."""

from collections.abc import Iterator

import numpy as np

from soccersim.kinematics import OmniBase, papers
from soccersim.reproduce import four_wheel_path
from soccersim.reproduce.entries import Part, entries_section
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import forward, inverse
from soccersim.reproduce.section import Section
from soccersim.state import Array

RADIUS, DISTANCE = 0.05, 0.20  # m, of the robot `four-wheel`; the note prints none
BASE = OmniBase.tangential((45, 315, 225, 135), DISTANCE, RADIUS)
GENERIC_DEG = (40.0, 320.0, 220.0, 140.0)  # on the diagonals sines are cosines, which hides a slip

TWIST = ("v_x", "v_y", "omega_z")
WHEELS = ("w1", "w2", "w3", "w4")
SIZES = (
    f"Wheels of {RADIUS} m radius, {DISTANCE} m from the centre, at 45, 315, 225 and 135 degrees, "
    "as the columns of the first matrix stand; the note prints no sizes."
)
MECANUM = (
    "+-1 is the pattern of mecanum wheels. Omni wheels at 45 degrees have sqrt2 in the forward "
    "matrix and 1/sqrt2 in the inverse one."
)


def sections(lab: Lab) -> Iterator[Section]:
    """The matrices in the note's order, their products, and the path."""
    yield forward_matrix()
    yield expanded_lines()
    yield inverse_matrix()
    yield wheel_lines()
    yield last_matrix()
    yield products()
    lab.told(0.1)
    yield four_wheel_path.followed(lab)
    lab.told(1.0)


def forward_matrix() -> Section:
    """The first matrix."""
    unit = 4 / RADIUS
    part = Part(
        "",
        TWIST,
        unit * papers.note_forward(RADIUS, DISTANCE),
        unit * forward(BASE),
        {0: "lacks a sqrt2", 1: "lacks a sqrt2"},
    )
    notes = (
        SIZES,
        MECANUM,
        "The text has wheels positive when they turn clockwise, but all positive they turn the "
        "robot counter-clockwise, as its omega_z has it.",
    )
    title = "Forward kinematics: the first matrix, in units of r/4"
    return entries_section("forward", title, WHEELS, [part], notes=notes)


def expanded_lines() -> Section:
    """The lines drawn from the first matrix."""
    unit, own = 4 / RADIUS, papers.note_forward(RADIUS, DISTANCE)
    part = Part(
        "",
        ("v_x", "v_y", "v_x again"),
        unit * papers.note_expanded(RADIUS),
        unit * own[[0, 1, 1]],
        {
            0: "row 1 with its signs reversed",
            1: "the yaw rate's sum, not row 2",
        },
    )
    notes = (
        "Ours here are rows 1, 2 and 2 of the note's own first matrix. The third line is v_y, "
        "though called v_x; the line of the yaw rate, r/(4 L) times the sum, is missing.",
    )
    title = "Forward kinematics: the lines drawn from the matrix, in units of r/4"
    return entries_section("lines", title, WHEELS, [part], notes=notes)


def inverse_matrix() -> Section:
    """The inverse matrix."""
    part = Part(
        "",
        WHEELS,
        RADIUS * papers.note_inverse(RADIUS, DISTANCE),
        RADIUS * inverse(BASE),
        {
            0: "lacks a 1/sqrt2",
            1: "lacks a 1/sqrt2",
            2: "v_x has the wrong sign; lacks a 1/sqrt2",
            3: "lacks a 1/sqrt2",
        },
    )
    title = "Inverse kinematics: the matrix, in units of 1/r"
    return entries_section("inverse", title, TWIST, [part], notes=(SIZES, MECANUM))


def wheel_lines() -> Section:
    """The speed of each rim, before the note simplifies it."""
    azimuths = np.radians(GENERIC_DEG)
    ours = np.column_stack((-np.sin(azimuths), np.cos(azimuths)))
    second = float(azimuths[1])
    literally = papers.note_wheels((*azimuths[:2], second, second))
    parts = [
        Part(
            "alpha_2 where printed",
            WHEELS,
            literally,
            ours,
            {3: "v_x sin + v_y cos of 360 deg - alpha_4"},
        ),
        Part(
            "each its own alpha",
            WHEELS,
            papers.note_wheels(tuple(azimuths)),
            ours,
            {2: "- v_y sin(270 deg - alpha_3)", 3: "v_y cos(360 deg - alpha_4)"},
        ),
    ]
    notes = (
        "Wheels at 40, 320, 220 and 140 degrees: at 45 degrees sines are cosines, which hides "
        "faults. What the note simplifies the lines to, -v_x sin + v_y cos, is right, but does "
        "not follow from those of wheels 3 and 4. With alpha_2 the line of wheel 3 comes out "
        "right, but only where alpha_2 + alpha_3 is 540 degrees. None has the L omega_z of "
        "the matrix.",
    )
    title = "Inverse kinematics: the line of each wheel"
    return entries_section("wheels", title, TWIST[:2], parts, notes=notes)


def last_matrix() -> Section:
    """The matrix of alpha_1 at the note's end."""
    unit = 4 / RADIUS
    why = "lacks a factor of -2"
    part = Part(
        "",
        TWIST,
        unit * papers.note_last(np.pi / 4, RADIUS, DISTANCE),
        unit * forward(BASE),
        {0: why, 1: why},
    )
    notes = (
        "alpha_1 is 45 degrees. The f_i are not told; here they are the wheels' rad/s. Rows 1 and "
        "2 want r/2 for r/4, and their signs are opposite to those of the first matrix.",
    )
    title = "The last matrix, in units of r/4"
    return entries_section("last", title, WHEELS, [part], notes=notes)


def products() -> Section:
    """What the matrices make of each other, and of a command."""
    printed = papers.note_inverse(RADIUS, DISTANCE)
    both = papers.note_forward(RADIUS, DISTANCE)
    mended = printed.copy()
    mended[2] *= (-1, 1, 1)
    identity = np.eye(3)
    less = "0.707 of what it is"
    spoilt = "by the sign in row 3 of the inverse"
    parts = [
        Part(
            "forward x inverse", TWIST, both @ printed, identity, {0: spoilt, 1: spoilt, 2: spoilt}
        ),
        Part("the same, row 3 mended", TWIST, both @ mended, identity),
        _told("told by the first matrix", both, {0: less, 1: less}),
        _told(
            "told by the last matrix",
            papers.note_last(np.pi / 4, RADIUS, DISTANCE),
            {0: "half of it, backwards", 1: "half of it, to the wrong side"},
        ),
        Part(
            "driven by the inverse",
            TWIST,
            forward(BASE) @ printed,
            identity,
            {
                0: "0.707 of the command",
                1: "1.41 times the command, and askew",
                2: "turns when told to go ahead",
            },
        ),
        Part(
            "the same, row 3 mended",
            TWIST,
            forward(BASE) @ mended,
            identity,
            {0: "1.41 times the command", 1: "1.41 times the command"},
        ),
    ]
    notes = (
        "Told: what a matrix says of how a robot on omni wheels moves. Driven: how such a robot "
        "moves when the matrix turns its wheels. Our forward and inverse matrices give the "
        "identity.",
    )
    title = "What the matrices do: each of these must be the identity"
    return entries_section("products", title, TWIST, parts, notes=notes, show_ours=False)


def _told(name: str, matrix: Array, why: dict[int, str]) -> Part:
    """What a forward matrix tells of a twist."""
    return Part(name, TWIST, matrix @ inverse(BASE), np.eye(3), why)
