"""Garcia-Sillas' Table 1 and equations (4) to (17): a leg, an omni wheel, the three wheels."""

from math import radians

import numpy as np

from soccersim.kinematics import garcia
from soccersim.reproduce.entries import Part, entries_section
from soccersim.reproduce.garcia_motion import DISTANCE, RADIUS
from soccersim.reproduce.section import Cell, Section
from soccersim.reproduce.tables import table

ROLLER = 0.01  # m, ours
SIZES = (
    f"R = {RADIUS} m, r = {ROLLER} m, L = {DISTANCE} m, all ours: the paper prints no sizes. m/s, "
    "rad/s; w_ix is of motor i, w_ir of its rollers, w_iz about its contact."
)
TWIST = ("v_cx", "v_cy", "omega_c")
WHEEL = ("w_ix", "w_ir", "w_iz")
NAMES = ("(15)", "(16)", "(17)")


def leg() -> Section:
    """(4) to (8), of wheel 2."""
    theta, pivot = radians(garcia.AXES_DEG[1]), garcia.pivots(DISTANCE)[1]
    eq5 = garcia.eq5(theta, pivot, pivot)
    steered = eq5 @ garcia.eq7(RADIUS)
    parts = [
        Part("(4)", ("omega_c",), garcia.EQ4, eq5[2:, 2:], {0: "(5) has omega_i - beta_i'"}),
        Part(
            "(8)",
            TWIST,
            garcia.eq8(theta, pivot, RADIUS),
            steered[:, :2],
            {1: "(5) x (6) has -p_ix"},
        ),
    ]
    notes = (
        SIZES,
        "For wheel 2, at 60 degrees. The columns are omega_i and beta_i' in (4), w_ix and "
        "omega_i in (8). Ours of (4) is row 3 of (5), ours of (8) is (5) times (6).",
    )
    title = "Equations (4) to (8): one leg"
    return entries_section("equations-4-8", title, ("1", "2"), parts, notes=notes)


def table_1() -> Section:
    """The angles of the wheels, and what (15) to (17) say they are."""
    rows: list[list[Cell]] = []
    marks = {}
    cells = table("garcia-table1").rows
    for wheel in (1, 2, 3):
        named = {row["parameter"]: row for row in cells if row["wheel"] == wheel}
        alpha, beta, gamma = (_number(named[key]["value"]) for key in ("alpha", "beta", "gamma"))
        ours = gamma
        if named["gamma"]["misprint"]:
            ours = _number(named["gamma"]["corrected"])
            marks[len(rows)] = "(15) has theta_1 = 180"
        turns = (alpha + beta + gamma) % 360, (alpha + beta + ours) % 360
        rows.append([wheel, alpha, beta, gamma, turns[0], ours, turns[1]])
    columns = (
        *("wheel", "paper alpha (deg)", "paper beta (deg)", "paper gamma (deg)"),
        *("theta by (3) (deg)", "ours gamma (deg)", "ours theta (deg)"),
    )
    note = "With theta_1 = 0 columns 1 and 2 of (15) have their signs reversed, column 3 has not."
    return Section(
        "table-1", "Table 1: where the wheels point", columns, rows, marks, notes=(note,)
    )


def omni_wheel() -> Section:
    """(13) and (14): (5) times the wheel's matrix, with the 1 in row 4 and in row 3."""
    parts = []
    right = garcia.wheel_jacobians(RADIUS, ROLLER, DISTANCE)
    pivots = garcia.pivots(DISTANCE)
    for name, angle, pivot, ours in zip(NAMES, garcia.AXES_DEG, pivots, right, strict=True):
        printed = garcia.eq5(radians(angle), pivot, pivot) @ garcia.eq13(RADIUS, ROLLER)
        wrong = np.abs(printed - ours).max(axis=1).nonzero()[0]
        why = {int(i): "w_iz reversed" for i in wrong}
        parts.append(Part(f"for {name}", TWIST, printed, ours, why))
    notes = (
        "(13) has its row 3 zero and w_iz in row 4, as if the leg were steered: (5) times it has "
        "column 3 reversed. Ours has w_iz in row 3, which gives the paper's own (15) to (17). "
        "Entries (1, 3) and (2, 3) of (14) are printed lambda_i and -lambda_i, vectors; they "
        "are lambda_iy and -lambda_ix.",
    )
    title = "Equations (13) and (14): an omni wheel, by (5) times (13)"
    return entries_section("equations-13-14", title, WHEEL, parts, notes=notes)


def three_wheels() -> Section:
    """(15) to (17)."""
    printed = garcia.eq15_to_17(RADIUS, ROLLER, DISTANCE)
    right = garcia.wheel_jacobians(RADIUS, ROLLER, DISTANCE)
    why: list[dict[int, str]] = [{}, {1: "(2, 2): + r sqrt3/2"}, {}]
    parts = [
        Part(name, TWIST, paper, ours, reasons)
        for name, paper, ours, reasons in zip(NAMES, printed, right, why, strict=True)
    ]
    note = "Ours are (5) times (13) mended. (18) has the entry of (16) right."
    title = "Equations (15) to (17): the wheels' Jacobians"
    return entries_section("equations-15-17", title, WHEEL, parts, notes=(SIZES, note))


def _number(cell: object) -> float:
    return float(cell) if isinstance(cell, float) else 0.0
