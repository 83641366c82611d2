"""The planar arm beside Dasmahapatra's tables: which rows hold, and by which formulae."""

from math import degrees, hypot, pi, remainder

import numpy as np
import pytest

from soccersim.kinematics import PlanarArm
from soccersim.kinematics.papers import dasmahapatra_inverse
from soccersim.reproduce.tables import table


def apart(q, other):
    """The greatest angle between two sets of angles, mod 2 pi."""
    return max(abs(remainder(a - b, 2 * pi)) for a, b in zip(q, other, strict=True))


def columns(name, *wanted, corrected=False):
    """(50, n) of a table's columns."""
    paper = table(f"dasmahapatra-{name}")
    return np.column_stack([paper.numbers(column, corrected=corrected) for column in wanted])


def forward_rows(*, corrected=False):
    """(50, 2) of x, y in cm: Table 1's, and the arm's for the same joints."""
    links = columns("table1", "l1", "l2", "l3")
    q = np.radians(columns("table1", "theta1", "theta2", "theta3"))
    ours = [PlanarArm(link).forward(angles)[:2] for link, angles in zip(links, q, strict=True)]
    return columns("table1", "x", "y", corrected=corrected), np.array(ours)


def inverse_rows(*, corrected=False):
    """Table 2 row by row: number, arm, pose, joints, in cm and radians."""
    links = columns("table2", "l1", "l2", "l3")
    q = np.radians(columns("table2", "theta1", "theta2", "theta3"))
    tips = columns("table2", "x", "y", corrected=corrected)
    for row, (link, angles, tip) in enumerate(zip(links, q, tips, strict=True), 1):
        yield row, PlanarArm(link), (*tip, angles.sum()), angles


def rows_nearer_than(limit_deg, solve, *, corrected=False):
    """The rows of Table 2 for which one of solve's answers is the printed one, mod 360 deg."""
    return [
        row
        for row, arm, pose, q in inverse_rows(corrected=corrected)
        if any(degrees(apart(answer, q)) < limit_deg for answer in solve(arm, pose))
    ]


def literally(arm, pose):
    return [dasmahapatra_inverse(arm.lengths, pose)]


def test_table_1_holds_within_a_micrometre_but_for_the_two_misprints():
    printed, ours = forward_rows()
    off = (np.abs(printed - ours) > 1e-4).any(axis=1).nonzero()[0] + 1
    assert len(printed) == 50
    assert off.tolist() == [24, 25]
    assert off.tolist() == [row["no"] for row in table("dasmahapatra-table1").misprints]


def test_table_1_holds_in_every_row_once_the_misprints_are_mended():
    printed, ours = forward_rows(corrected=True)
    assert np.abs(printed - ours).max() < 1e-4
    assert np.abs(printed - ours)[[23, 24], [0, 1]].max() < 5e-6


def test_the_literal_arc_cosines_reproduce_35_rows_of_table_2():
    rows = rows_nearer_than(0.01, literally)
    assert rows == [*range(1, 24), *range(25, 37)]


def test_the_literal_arc_cosines_miss_row_24_by_its_misprint_alone():
    assert 24 in rows_nearer_than(0.04, literally)
    assert 24 in rows_nearer_than(0.001, literally, corrected=True)


def test_the_literal_arc_cosines_miss_the_target_in_13_rows_and_take_the_other_elbow_in_one():
    missed = {}
    for row, arm, pose, _ in inverse_rows():
        x, y, _ = arm.forward(dasmahapatra_inverse(arm.lengths, pose))
        missed[row] = hypot(x - pose[0], y - pose[1])
    far = [row for row in missed if missed[row] > 0.01]
    assert far == [37, 38, 39, 40, *range(42, 51)]
    assert (min(missed[row] for row in far), max(missed.values())) == pytest.approx(
        (0.67, 51.45), abs=0.005
    )


def test_both_elbows_reproduce_49_rows_of_table_2_and_all_50_once_row_24_is_mended():
    every = list(range(1, 51))
    rows = rows_nearer_than(6e-4, PlanarArm.inverse)
    assert rows == [row for row in every if row != 24]
    assert rows_nearer_than(6e-4, PlanarArm.inverse, corrected=True) == every


def test_table_2_bends_the_elbow_one_way_up_to_row_40_and_then_the_other():
    one = rows_nearer_than(6e-4, lambda arm, pose: arm.inverse(pose)[:1], corrected=True)
    other = rows_nearer_than(6e-4, lambda arm, pose: arm.inverse(pose)[1:], corrected=True)
    assert (one, other) == ([*range(1, 41)], [*range(41, 51)])


def test_the_papers_formulae_have_no_answer_out_of_reach():
    with pytest.raises(ValueError, match="domain"):
        dasmahapatra_inverse((8, 5, 3), (17, 0, 0))
