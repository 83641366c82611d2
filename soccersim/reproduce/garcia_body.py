"""Garcia-Sillas' equations (18) to (30): all wheels together, and what moves the body."""

from collections.abc import Mapping, Sequence

import numpy as np

from soccersim.kinematics import garcia, papers
from soccersim.reproduce.entries import Part, entries_section
from soccersim.reproduce.garcia_motion import DISTANCE, RADIUS
from soccersim.reproduce.garcia_wheels import ROLLER, TWIST, WHEEL
from soccersim.reproduce.matrices import SAME, significant
from soccersim.reproduce.section import Section, Summary
from soccersim.state import Array

MOTORS = ("w_1x", "w_2x", "w_3x")
AS_PRINTED = "recomputed: of the matrix as printed"


def composite() -> Section:
    """(18), which is (10)."""
    printed = garcia.eq18(RADIUS, ROLLER, DISTANCE)
    ours = garcia.composite(garcia.wheel_jacobians(RADIUS, ROLLER, DISTANCE))
    spoilt = garcia.composite(garcia.eq15_to_17(RADIUS, ROLLER, DISTANCE))
    off = np.argwhere(np.abs(spoilt - printed) > SAME) + 1
    places = " and ".join(f"({row}, {column})" for row, column in off)
    notes = (
        "Ours is (A'A)^-1 A'B of (9) and (10), solved with the right Jacobians: (18) is right, all "
        f"27 entries. With (16) as printed entry {places} would differ.",
    )
    title = "Equation (18): the composite least squares of (10)"
    return entries_section(
        "equation-18",
        title,
        WHEEL,
        _blocks(printed, ours, TWIST),
        [_rank("rank", None, printed, ours)],
        notes,
    )


def slip() -> Section:
    """(19), which is (11) times B."""
    printed = garcia.eq19(RADIUS, ROLLER, DISTANCE)
    ours = garcia.slip_operator(garcia.wheel_jacobians(RADIUS, ROLLER, DISTANCE))
    agreeing = garcia.no_slip(ours)
    why = {
        (1, 0): "(2, 1): -2R/3",
        (3, 2): "(4, 8): + r/6",
        (6, 2): "(7, 9): + L/sqrt3",
    }
    gives = [f"row {i + 1}" for i in range(9)]
    told = [float(np.abs(matrix @ agreeing).max()) for matrix in (printed, ours)]
    summary = [
        _rank("rank", 6.0, printed, ours, "the text has three rows that follow from the others"),
        Summary(
            "greatest slip told of wheels that agree (m/s for 1 rad/s)",
            0.0,
            recomputed=significant(told[0]),
            ours=significant(told[1]),
            note=AS_PRINTED,
        ),
    ]
    notes = (
        "Ours is Omega(A) B of (11) and (12), with the right Jacobians. Of rank 8 the printed one "
        "leaves one motion that it takes for free of slip, where a robot on the floor has three.",
    )
    title = "Equation (19): the slip operator"
    parts = _blocks(printed, ours, gives, why)
    return entries_section("equation-19", title, WHEEL, parts, summary, notes)


def free_speeds() -> Section:
    """(20) to (25): the speeds that no motor drives."""
    operator = garcia.slip_operator(garcia.wheel_jacobians(RADIUS, ROLLER, DISTANCE))
    ours = garcia.no_slip(operator)
    printed = garcia.eq20_to_25(RADIUS, ROLLER, DISTANCE)
    minus = "-R (sum)/(3 L)"
    parts = [
        Part("(20)-(22)", ("w_1r", "w_2r", "w_3r"), printed[:3], ours[1::3]),
        Part(
            "(23)-(25)",
            ("w_1z", "w_2z", "w_3z"),
            printed[3:],
            ours[2::3],
            dict.fromkeys(range(3), minus),
        ),
    ]
    notes = ("Ours are the speeds at which (12) is 0, with the right slip operator.",)
    title = "Equations (20) to (25): rollers, and the turn about each contact"
    return entries_section("equations-20-25", title, MOTORS, parts, notes=notes)


def motion() -> Section:
    """(26) to (28)."""
    why = {
        1: "2 w_1x - w_2x - w_3x",
        2: "w_1x + w_2x + w_3x",
    }
    part = Part("", TWIST, garcia.eq26_to_28(RADIUS, DISTANCE), body_motion(), why)
    notes = (
        "Ours is (18) at the speeds at which (12) is 0. (27) is printed with 2 w_2x - w_2y - w_3x; "
        "there is no w_2y: here it is w_2x.",
    )
    title = "Equations (26) to (28): the body's motion"
    return entries_section("equations-26-28", title, MOTORS, [part], notes=notes)


def final() -> Section:
    """(29), (30) and their products."""
    printed, back = papers.garcia_eq29(RADIUS, DISTANCE), papers.garcia_eq30(RADIUS)
    ours, identity = body_motion(), np.eye(3)
    turn = "(., 3): -L/R"
    product = "by (1, 3) of (29)"
    parts = [
        Part("(29)", TWIST, printed, ours, {0: "(1, 3): -R/sqrt3"}),
        Part("(30)", MOTORS, back, np.linalg.inv(ours), dict.fromkeys(range(3), turn)),
        Part(
            "(29) x (30)", TWIST, printed @ back, identity, {0: product, 2: "by column 3 of (30)"}
        ),
        Part("ours x (30)", TWIST, ours @ back, identity, {2: "turns 1/L times as fast"}),
    ]
    summary = [
        _rank("rank of (29)", 3.0, printed, ours, "(30) is called its inverse"),
        Summary(
            "determinant of (29)",
            None,
            recomputed=significant(np.linalg.det(printed)),
            ours=significant(np.linalg.det(ours)),
            note=AS_PRINTED,
        ),
    ]
    notes = (
        "Columns are w_1x to w_3x in (29), v_cx, v_cy, omega_c in (30) and in the products, which "
        "must be the identity. Ours of (29) is that of (26) to (28), from the chain of Jacobians.",
    )
    title = "Equations (29) and (30): the final Jacobian and its inverse"
    names = ("1", "2", "3")
    return entries_section("equations-29-30", title, names, parts, summary, notes)


def body_motion() -> Array:
    """(3, 3) what (26) to (29) should be: from the motors to the body's twist, without slip."""
    jacobians = garcia.wheel_jacobians(RADIUS, ROLLER, DISTANCE)
    return garcia.composite(jacobians) @ garcia.no_slip(garcia.slip_operator(jacobians))


def _rank(
    what: str, told: float | None, printed: Array, ours: Array, note: str = AS_PRINTED
) -> Summary:
    """The ranks of a matrix as printed and as it should be; `told` is what the paper says."""
    ranks = [float(np.linalg.matrix_rank(matrix)) for matrix in (printed, ours)]
    return Summary(what, told, recomputed=ranks[0], ours=ranks[1], note=note)


def _blocks(
    printed: Array,
    ours: Array,
    gives: Sequence[str],
    why: Mapping[tuple[int, int], str] | None = None,
) -> list[Part]:
    """A part for each wheel's three columns; `why` by row and wheel, from 0."""
    parts = []
    for wheel in range(3):
        columns = slice(3 * wheel, 3 * wheel + 3)
        reasons = {row: text for (row, at), text in (why or {}).items() if at == wheel}
        name = f"wheel {wheel + 1}"
        parts.append(Part(name, gives, printed[:, columns], ours[:, columns], reasons))
    return parts
