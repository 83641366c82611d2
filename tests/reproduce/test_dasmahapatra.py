"""Dasmahapatra's arm: the tables row by row, and the equations on the way to the inverse."""

from math import cos, radians, sin

import latex
import numpy as np
import paper_text as paper
import pytest

from soccersim.kinematics import PlanarArm
from soccersim.reproduce import dasmahapatra
from soccersim.reproduce.dasmahapatra_inverse import targets
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.tables import table

with_papers = pytest.mark.skipif(
    not paper.FOLDER.is_dir(), reason="the papers' texts are not beside this checkout"
)


@pytest.fixture(scope="module")
def sections():
    with Lab(jobs=1, seeds=2) as lab:
        return {section.key: section for section in dasmahapatra.sections(lab)}


def column(section, title):
    i = list(section.columns).index(title)
    return [row[i] for row in section.rows]


def rows_of(section):
    """The marked rows as the table numbers them."""
    return [section.rows[i][0] for i in sorted(section.marks)]


# The equations


@with_papers
@pytest.mark.parametrize(
    ("number", "sign"), [("2.11a", 1), ("2.12a", None), ("2.11b", 1), ("2.12b", None)]
)
def test_sums_of_angles_are_as_printed(number, sign):
    one, two = 0.4, 0.9
    names = {"C_1": cos(one), "S_1": sin(one), "C_2": cos(two), "S_2": sin(two)}
    lengths = {"l_1": 3.0, "l_2": 2.0}
    lines = [line for line in paper.text(paper.ARM).splitlines() if f"({number})" in line]
    side = lines[0].split("=")[1].split("\\quad")[0].replace("$", "")
    c12, s12 = cos(one + two), sin(one + two)
    if sign:
        c12 = cos(one) * cos(two) + sign * sin(one) * sin(two)
    expected = {
        "2.11a": c12,
        "2.12a": s12,
        "2.11b": 3 * cos(one) + 2 * c12,
        "2.12b": 3 * sin(one) + 2 * s12,
    }
    assert latex.value(side, names | lengths) == pytest.approx(expected[number], abs=1e-12)


def test_c12_is_the_cosine_of_a_sum_not_of_a_difference(sections):
    shown = {(row[0], row[1]): row[2:] for row in sections["equations"].rows}
    assert shown["(2.11a)", "C12"] == pytest.approx([cos(radians(12)), cos(radians(108))], abs=1e-4)
    m = 10 * cos(radians(60)) + 8 * cos(radians(108))
    assert shown["(2.11b)", "m"][1] == pytest.approx(m, abs=1e-3)
    assert shown["(2.11c)", "m"] == pytest.approx([m, m], abs=1e-3)
    assert sorted(sections["equations"].marks) == [1, 2]


# Table 1


def test_table_1_marks_rows_24_and_25_and_no_other(sections):
    first = sections["table-1"]
    assert len(first.rows) == 50
    assert rows_of(first) == [24, 25]
    assert first.summary[0].ours == 48
    off = np.array([[row[5], row[8]] for row in first.rows])
    assert off[23].tolist() == pytest.approx([62.34, 0.036], abs=0.01)
    assert off[24].tolist() == pytest.approx([0.144, 7.914], abs=0.01)
    assert np.abs(np.delete(off, [23, 24], axis=0)).max() < 1


def test_table_1_tells_paper_ours_and_their_difference(sections):
    for row in sections["table-1"].rows:
        _, links, angles, paper_x, our_x, x_off, paper_y, our_y, y_off = row
        assert 1e4 * (paper_x - our_x) == pytest.approx(x_off, abs=1e-3)
        assert 1e4 * (paper_y - our_y) == pytest.approx(y_off, abs=1e-3)
        lengths = [float(text) for text in links.split(",")]
        tip = PlanarArm(tuple(lengths)).forward([radians(float(a)) for a in angles.split(",")])
        assert (our_x, our_y) == pytest.approx(tip[:2])


def test_37_rows_of_table_1_are_right_to_the_last_digit(sections):
    assert sections["table-1"].summary[1].ours == 37


def test_six_digits_and_a_0_are_printed_of_x_in_rows_12_to_14():
    first = table("dasmahapatra-table1")
    for row in (12, 13, 14):
        printed = first.printed[row - 1]["x"]
        ours = _tip(first, row)[0]
        assert printed == f"{ours:.5f}0"
        assert printed != f"{ours:.6f}"


def test_the_last_digit_is_cut_off_in_rows_42_and_44_to_49():
    first = table("dasmahapatra-table1")
    for row, axes in {42: "y", 44: "xy", 45: "x", 46: "xy", 47: "x", 48: "y", 49: "y"}.items():
        for axis in axes:
            printed = first.printed[row - 1][axis]
            decimals = len(printed.partition(".")[2])
            ours = _tip(first, row)["xy".index(axis)]
            assert printed != f"{ours:.{decimals}f}"
            cut = np.trunc(ours * 10**decimals) / 10**decimals
            assert float(printed) == pytest.approx(cut, abs=1.1 * 10**-decimals)
            assert abs(float(printed) - ours) <= 10**-decimals


def _tip(paper_table, row):
    cells = paper_table.rows[row - 1]
    arm = PlanarArm([cells[f"l{k}"] for k in (1, 2, 3)])
    return arm.forward([radians(cells[f"theta{k}"]) for k in (1, 2, 3)])


# Table 2


def test_both_branches_of_all_50_rows_hit_the_target(sections):
    for target, row in zip(targets(), sections["table-2"].rows, strict=True):
        for angles in (row[4:7], row[7:10]):
            x, y, _ = target.arm.forward([radians(angle) for angle in angles])
            assert (x, y) == pytest.approx(target.tip, abs=3e-3)
        assert row[5] + row[8] == pytest.approx(360, abs=2e-3)


def test_the_paper_takes_elbow_plus_up_to_row_40_and_then_elbow_minus(sections):
    second = sections["table-2"]
    assert column(second, "branch") == ["+"] * 40 + ["-"] * 10
    for row in second.rows:
        ours = row[4:7] if row[10] == "+" else row[7:10]
        assert ours == pytest.approx(row[1:4], abs=0.05 if row[0] == 24 else 2e-3)
    assert rows_of(second) == [24]


def test_49_rows_come_out_and_50_with_row_24_mended(sections):
    counts = [summary.ours for summary in sections["table-2"].summary]
    assert counts == [49, 50, 40, 10]


def test_the_formulae_give_35_rows_and_hit_37_targets(sections):
    formulae = sections["table-2-formulae"]
    given, hit, worst = formulae.summary
    assert (given.recomputed, hit.recomputed) == (35, 37)
    assert worst.recomputed == pytest.approx(51.45, abs=0.005)
    assert rows_of(formulae) == [24, 37, 38, 39, 40, *range(41, 51)]
    missing = [row[0] for row in formulae.rows if not row[9]]
    assert missing == [37, 38, 39, 40, *range(42, 51)]


def test_the_formulae_fail_where_the_papers_angles_leave_an_arc_cosines_range(sections):
    for row in sections["table-2-formulae"].rows:
        _, one, two, _, got_one, got_two, *_ = row
        assert 0 <= got_one <= 180
        assert 0 <= got_two <= 180
        if row[0] != 24:
            assert (one <= 180 and two <= 180) == (row[7] < 0.01)


def test_x_and_y_alone_leave_the_arm_free():
    target = targets()[17]
    solutions = {phi: target.arm.inverse((*target.tip, radians(phi))) for phi in (150, 216, 250)}
    assert all(len(found) == 2 for found in solutions.values())
    assert len({round(found[0][0], 3) for found in solutions.values()}) == 3


def test_every_row_has_a_cell_for_every_column(sections):
    for section in sections.values():
        assert {len(row) for row in section.rows} == {len(section.columns)}


def test_the_arms_are_drawn(sections, tmp_path):
    sections["table-2"].figure().savefig(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 50_000
