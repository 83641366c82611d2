"""Garcia-Sillas' equations: what is printed, what is right, and the two motions simulated."""

from math import cos, sin

import latex
import numpy as np
import paper_text as paper
import pytest

from soccersim import load_scenario
from soccersim.kinematics import OmniBase, garcia, papers
from soccersim.reproduce import garcia as reproduction
from soccersim.reproduce import garcia_motion
from soccersim.reproduce.garcia_motion import DISTANCE, RADIUS
from soccersim.reproduce.garcia_wheels import ROLLER
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import forward, inverse, rotation
from soccersim.reproduce.tables import table

SIZES = (RADIUS, ROLLER, DISTANCE)
NAMES = {"R": RADIUS, "r": ROLLER, "L": DISTANCE, "a": 2 * 3**0.5}
BASE = OmniBase.general((180, 60, -60), DISTANCE, RADIUS, (90, -30, -150), roller_radius=ROLLER)
SPEEDS = np.array((3.0, -7.0, 11.0))  # rad/s of the motors, no two alike

with_papers = pytest.mark.skipif(
    not paper.FOLDER.is_dir(), reason="the papers' texts are not beside this checkout"
)


def exactly(value):
    return pytest.approx(np.array(value), rel=0, abs=1e-12)


def wrong_entries(printed, ours):
    """(row, column) from 1 where the two differ."""
    return [tuple(entry) for entry in np.argwhere(np.abs(printed - ours) > 1e-12) + 1]


@pytest.fixture(scope="module")
def jacobians():
    return garcia.wheel_jacobians(*SIZES)


@pytest.fixture(scope="module")
def body(jacobians):
    """Motors to the body's twist, without slip."""
    return garcia.composite(jacobians) @ garcia.no_slip(garcia.slip_operator(jacobians))


@pytest.fixture(scope="module")
def sections():
    with Lab(jobs=1, seeds=2) as lab:
        return {section.key: section for section in reproduction.sections(lab)}


# What is printed


@with_papers
@pytest.mark.parametrize("number", [15, 16, 17, 18, 19, 29, 30])
def test_matrices_are_as_printed(number):
    ours = {
        **{15 + i: matrix for i, matrix in enumerate(garcia.eq15_to_17(*SIZES))},
        18: garcia.eq18(*SIZES),
        19: garcia.eq19(*SIZES),
        29: papers.garcia_eq29(RADIUS, DISTANCE),
        30: papers.garcia_eq30(RADIUS),
    }
    blocks = latex.matrices(latex.numbered(paper.text(paper.GARCIA), number))
    matrix = blocks[1] if number in (29, 30) else blocks[0]
    assert latex.values(matrix, NAMES) == exactly(ours[number])


@with_papers
def test_leg_and_wheel_matrices_are_as_printed():
    theta, contact, pivot = 0.7, (0.3, -0.4), (0.11, 0.13)
    names = dict(
        zip(
            ("c_i", "s_i", "r_i", "p_{ix}", "p_{iy}", "\\lambda_{ix}", "\\lambda_{iy}"),
            (cos(theta), sin(theta), RADIUS, *contact, *pivot),
            strict=True,
        )
    )
    text = paper.text(paper.GARCIA)
    matrix = {n: latex.matrices(latex.numbered(text, n)) for n in (5, 6, 7, 8, 13)}
    assert latex.values(matrix[5][1], names) == exactly(garcia.eq5(theta, contact, pivot))
    assert latex.values(matrix[6][0], names) == exactly(garcia.eq7(RADIUS)[:, :2])
    assert latex.values(matrix[7][0], names) == exactly(garcia.eq7(RADIUS))
    assert latex.values(matrix[8][0], names) == exactly(garcia.eq8(theta, contact, RADIUS))
    assert latex.values(matrix[13][0], NAMES) == exactly(garcia.eq13(RADIUS, ROLLER))


@with_papers
def test_formulae_20_to_28_are_as_printed():
    text = paper.text(paper.GARCIA)
    names = {f"\\omega_{{{i + 1}x}}": float(SPEEDS[i]) for i in range(3)} | NAMES
    names["\\omega_{2y}"] = float(SPEEDS[1])
    right = [latex.numbered(text, n).split("=")[1] for n in range(20, 29)]
    names["\\omega_{1z}"] = latex.value(right[3], names)
    printed = [latex.value(side, names) for side in right]
    ours = np.vstack((garcia.eq20_to_25(*SIZES), garcia.eq26_to_28(RADIUS, DISTANCE)))
    assert printed == exactly(ours @ SPEEDS)


@with_papers
def test_sign_of_equation_4_is_as_printed():
    assert "\\omega_c = \\dot{\\beta}_i - \\omega_i" in paper.text(paper.GARCIA)
    assert garcia.EQ4.tolist() == [[-1, 1]]


# What is right


def test_the_equations_sizes_are_those_of_the_simulated_robot():
    robot = load_scenario("linear").robots[0].model
    assert robot.drive.base.jacobian == exactly(BASE.jacobian)
    assert robot.drive.base.rolling_radius == exactly(BASE.rolling_radius)
    assert garcia_motion.BASE.jacobian == exactly(BASE.jacobian)


def test_a_wheel_rolls_as_fast_as_the_body_moves_above_its_contact(jacobians):
    twist = np.array((0.4, -0.7, 1.3))
    for angle, (x, y), jacobian in zip(
        garcia.AXES_DEG, garcia.pivots(DISTANCE), jacobians, strict=True
    ):
        motor, roller, turn = np.linalg.solve(jacobian, twist)
        above = twist[:2] + twist[2] * np.array((-y, x))
        rolled = rotation(np.radians(angle))[:2, :2] @ (ROLLER * roller, -RADIUS * motor)
        assert rolled == exactly(above)
        assert turn == pytest.approx(1.3)


def test_equation_4_contradicts_row_3_of_5():
    row = garcia.eq5(0.7, (0.3, -0.4), (0.11, 0.13))[2, 2:]
    assert row == exactly((1, -1))
    assert garcia.EQ4[0] == exactly(-row)


def test_equation_8_has_the_wrong_sign_before_p_ix():
    theta, contact = 0.7, (0.3, -0.4)
    right = garcia.eq5(theta, contact, contact) @ garcia.eq7(RADIUS)[:, :2]
    printed = garcia.eq8(theta, contact, RADIUS)
    assert wrong_entries(printed, right) == [(2, 2)]
    assert printed[1, 1] == -right[1, 1] == contact[0]


def test_equation_13_turns_the_leg_instead_of_the_wheel(jacobians):
    for angle, pivot, right in zip(
        garcia.AXES_DEG, garcia.pivots(DISTANCE), jacobians, strict=True
    ):
        leg = garcia.eq5(np.radians(angle), pivot, pivot)
        printed = leg @ garcia.eq13(RADIUS, ROLLER)
        assert leg @ garcia.omni_wheel(RADIUS, ROLLER) == exactly(right)
        assert printed == exactly(right * (1, 1, -1))


def test_table_1_turns_wheel_1_half_round_and_with_it_two_columns_of_15(jacobians):
    (row,) = table("garcia-table1").misprints
    assert (row["wheel"], row["parameter"], row["value"], row["corrected"]) == (1, "gamma", 180, 0)
    (x, y), theta = garcia.pivots(DISTANCE)[0], np.radians(180 + 180)
    printed = garcia.wheel_jacobian(theta, (x, y), RADIUS, ROLLER)
    assert printed == exactly(jacobians[0] * (-1, -1, 1))
    assert garcia.eq15_to_17(*SIZES)[0] == exactly(jacobians[0])


def test_equation_14_has_the_components_of_lambda_in_its_third_column(jacobians):
    for (x, y), jacobian in zip(garcia.pivots(DISTANCE), jacobians, strict=True):
        assert jacobian[:, 2] == exactly((y, -x, 1))


def test_equations_15_to_17_have_one_wrong_entry(jacobians):
    printed = garcia.eq15_to_17(*SIZES)
    assert wrong_entries(printed, jacobians) == [(2, 2, 2)]
    assert printed[1, 1, 1] == pytest.approx(-jacobians[1, 1, 1])


def test_equation_18_is_the_least_squares_solution_of_10(jacobians):
    j = garcia.composite(jacobians)
    assert garcia.eq18(*SIZES) == exactly(j)
    spoilt = garcia.composite(garcia.eq15_to_17(*SIZES))
    assert wrong_entries(garcia.eq18(*SIZES), spoilt) == [(2, 5)]
    speeds = np.random.default_rng(1).normal(size=9)
    a, b = garcia.stacked(jacobians)
    best = np.linalg.norm(a @ j @ speeds - b @ speeds)
    for nudge in np.eye(3) * 1e-3:
        assert np.linalg.norm(a @ (j @ speeds + nudge) - b @ speeds) > best


def test_equation_19_has_three_wrong_entries(jacobians):
    right, printed = garcia.slip_operator(jacobians), garcia.eq19(*SIZES)
    assert wrong_entries(printed, right) == [(2, 1), (4, 8), (7, 9)]
    assert right[1, 0] == pytest.approx(-2 * RADIUS / 3)
    assert right[3, 7] == pytest.approx(ROLLER / 6)
    assert right[6, 8] == pytest.approx(DISTANCE / 3**0.5)


def test_equation_19_as_printed_takes_one_motion_in_three_for_free_of_slip(jacobians):
    right, printed = garcia.slip_operator(jacobians), garcia.eq19(*SIZES)
    assert [np.linalg.matrix_rank(matrix) for matrix in (right, printed)] == [6, 8]
    for twist in np.eye(3):
        speeds = np.concatenate([np.linalg.solve(jacobian, twist) for jacobian in jacobians])
        assert right @ speeds == exactly(np.zeros(9))
        assert np.abs(printed @ speeds).max() > 1e-3


def test_no_slip_refuses_the_printed_operator():
    with pytest.raises(ValueError, match="1 speeds are free, not 3"):
        garcia.no_slip(garcia.eq19(*SIZES))


def test_equations_20_to_22_are_right(jacobians):
    speeds = garcia.no_slip(garcia.slip_operator(jacobians)) @ SPEEDS
    assert garcia.eq20_to_25(*SIZES)[:3] @ SPEEDS == exactly(speeds[1::3])
    assert BASE.roller_speeds(BASE.twist(SPEEDS)) == exactly(speeds[1::3])


def test_equations_23_to_25_turn_the_wrong_way(jacobians):
    speeds = garcia.no_slip(garcia.slip_operator(jacobians)) @ SPEEDS
    assert garcia.eq20_to_25(*SIZES)[3:] @ SPEEDS == exactly(-speeds[2::3])
    assert speeds[2::3] == exactly([BASE.twist(SPEEDS)[2]] * 3)


def test_equations_26_to_28_have_one_right_line(body):
    printed = garcia.eq26_to_28(RADIUS, DISTANCE)
    assert printed[0] == exactly(body[0])
    assert body[1] == exactly(RADIUS / 3 * np.array((2, -1, -1)))
    assert body[2] == exactly(-RADIUS / (3 * DISTANCE) * np.ones(3))
    assert printed[1] == exactly(RADIUS / 3 * np.array((0, 1, -1)))
    assert printed[2] == exactly(body[2] * (1, -1, -1))


def test_the_chain_of_jacobians_ends_in_the_general_wheel_model(body):
    assert body == exactly(forward(BASE))
    assert np.linalg.inv(body) == pytest.approx(inverse(BASE))


def test_equation_29_has_one_wrong_entry_and_30_a_wrong_column(body):
    assert wrong_entries(papers.garcia_eq29(RADIUS, DISTANCE), body) == [(1, 3)]
    back = papers.garcia_eq30(RADIUS)
    assert wrong_entries(back, np.linalg.inv(body)) == [(1, 3), (2, 3), (3, 3)]
    assert back * (1, 1, DISTANCE) == pytest.approx(np.linalg.inv(body))


# What the reproduction shows


def test_wrong_equations_are_marked_and_right_ones_are_not(sections):
    marked = {key: sorted(section.marks) for key, section in sections.items()}
    assert marked == {
        "equations-4-8": [0, 2],
        "table-1": [0],
        "equations-13-14": [1, 2, 3, 4, 5, 6, 7, 8],
        "equations-15-17": [4],
        "equation-18": [],
        "equation-19": [1, 21, 24],
        "equations-20-25": [3, 4, 5],
        "equations-26-28": [1, 2],
        "equations-29-30": [0, 3, 4, 5, 6, 8, 11],
        "figure-6": [0, 3],
        "figure-7": [0, 3, 4],
    }


def test_every_row_has_a_cell_for_every_column(sections):
    for section in sections.values():
        assert {len(row) for row in section.rows} == {len(section.columns)}
        assert all(section.marks.values())


def test_ranks_are_told(sections):
    summaries = {key: section.summary for key, section in sections.items() if section.summary}
    ranks = {key: (s[0].printed, s[0].recomputed, s[0].ours) for key, s in summaries.items()}
    assert ranks == {
        "equation-18": (None, 3, 3),
        "equation-19": (6, 8, 6),
        "equations-29-30": (3, 2, 3),
    }


def test_table_1_tells_where_the_wheels_point_as_printed_and_mended(sections):
    told = [row[:1] + row[3:] for row in sections["table-1"].rows]
    assert told == [[1, 180, 0, 0, 180], [2, 0, 60, 0, 60], [3, 0, 300, 0, 300]]
