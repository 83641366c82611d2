"""The four-wheel note: what is printed, what is right, and the planned path followed."""

import re
from math import pi, radians

import latex
import numpy as np
import paper_text as paper
import pytest

from soccersim import load_scenario
from soccersim.kinematics import OmniBase, papers
from soccersim.reproduce import four_wheel
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import forward, inverse

NOTE = "four-wheel-omni-note.txt"
RADIUS, DISTANCE = 0.05, 0.20
BASE = OmniBase.tangential((45, 315, 225, 135), DISTANCE, RADIUS)
AZIMUTHS = tuple(np.radians((40.0, 320.0, 220.0, 140.0)))
SEEDS = 12

with_papers = pytest.mark.skipif(
    not paper.FOLDER.is_dir(), reason="the papers' texts are not beside this checkout"
)


def exactly(value):
    return pytest.approx(np.array(value), rel=0, abs=1e-12)


@pytest.fixture(scope="module")
def sections():
    with Lab(jobs=1, seeds=SEEDS) as lab:
        return {section.key: section for section in four_wheel.sections(lab)}


def column(section, title):
    i = list(section.columns).index(title)
    return [row[i] for row in section.rows]


def mended_inverse():
    matrix = papers.note_inverse(RADIUS, DISTANCE)
    matrix[2] *= (-1, 1, 1)
    return matrix


# What is printed


@with_papers
def test_matrices_are_as_printed():
    blocks = latex.matrices(paper.text(NOTE))
    first = latex.values(blocks[1], {"L": DISTANCE})
    back = latex.values(blocks[4], {"L": DISTANCE})
    last = latex.values(blocks[7], {"l": DISTANCE, "\\alpha_1": 0.7, "\\pi": pi})
    assert RADIUS / 4 * first == exactly(papers.note_forward(RADIUS, DISTANCE))
    assert back / RADIUS == exactly(papers.note_inverse(RADIUS, DISTANCE))
    assert RADIUS / 4 * last == exactly(papers.note_last(0.7, RADIUS, DISTANCE))


@with_papers
def test_expanded_lines_are_as_printed():
    lines = re.findall(r"\[ (v_.)=\\frac\{r\}\{4\}\((.*?)\)", paper.text(NOTE))
    assert [name for name, _ in lines] == ["v_x", "v_y", "v_x"]
    signs = [re.findall(r"(-?)\\omega_\d", line) for _, line in lines]
    printed = [[-1 if sign else 1 for sign in row] for row in signs]
    assert RADIUS / 4 * np.array(printed) == exactly(papers.note_expanded(RADIUS))


@with_papers
def test_wheel_lines_are_as_printed():
    """Each as (v_x, v_y), the note's left side and what it simplifies it to."""
    text = paper.text(NOTE)
    left = re.findall(r"Roda \d : \$v_\{w\d\}=(.*?)\$", text)
    right = re.findall(r"\\to v_\{w\d\}=(.*?)\$", text)
    assert (len(left), len(right)) == (4, 3)
    names = {f"\\alpha_{i + 1}": angle for i, angle in enumerate(AZIMUTHS)}
    units = [{"v_x": 1.0, "v_y": 0.0}, {"v_x": 0.0, "v_y": 1.0}]
    sides = [
        [[latex.value(side, names | unit) for unit in units] for side in each]
        for each in (left, right)
    ]
    second = AZIMUTHS[1]
    assert sides[0] == exactly(papers.note_wheels((*AZIMUTHS[:2], second, second)))
    assert sides[1] == exactly([(-np.sin(a), np.cos(a)) for a in AZIMUTHS[1:]])


# What is right


def test_the_equations_sizes_are_those_of_the_simulated_robot():
    robot = load_scenario("four-wheel-path").robots[0].model.drive.base
    assert robot.jacobian == exactly(BASE.jacobian)
    assert robot.rolling_radius == exactly(BASE.rolling_radius)
    assert four_wheel.BASE.jacobian == exactly(BASE.jacobian)


def test_the_first_line_reverses_row_1_and_the_second_is_the_yaw_rates():
    first = papers.note_forward(RADIUS, DISTANCE)
    lines = papers.note_expanded(RADIUS)
    assert lines[0] == exactly(-first[0])
    assert lines[1] == exactly(DISTANCE * first[2])
    assert lines[2] == exactly(first[1])


def test_wheel_3_needs_a_minus_and_wheel_4_a_cosine():
    right = np.array([(-np.sin(a), np.cos(a)) for a in AZIMUTHS])
    printed = papers.note_wheels(AZIMUTHS)
    assert printed[:2] == exactly(right[:2])
    assert printed[2] == exactly(right[2] * (1, -1))
    assert printed[3] == exactly((right[3, 0], right[3, 0]))
    assert right == exactly(OmniBase.tangential(np.degrees(AZIMUTHS), 1, 1).jacobian[:, :2])


def test_with_alpha_2_wheel_3_is_right_where_the_two_angles_make_540_degrees():
    one, two, three, four = AZIMUTHS
    assert two + three == pytest.approx(radians(540))
    printed = papers.note_wheels((one, two, two, two))
    assert printed[2] == exactly((-np.sin(three), np.cos(three)))
    off = papers.note_wheels((one, two, two + 0.1, two))[2]
    assert np.abs(off - printed[2]).max() > 0.05
    assert np.abs(printed[3] - (-np.sin(four), np.cos(four))).max() > 1


def test_at_45_degrees_wheel_4s_sine_cannot_be_told_from_its_cosine():
    angles = BASE.azimuth
    assert papers.note_wheels(tuple(angles))[3] == exactly((-np.sin(angles[3]), np.cos(angles[3])))


def test_the_last_matrix_tells_half_the_speed_the_other_way():
    told = papers.note_last(radians(45), RADIUS, DISTANCE) @ inverse(BASE)
    assert told == exactly(np.diag((-0.5, -0.5, 1)))
    mended = papers.note_last(radians(45), RADIUS, DISTANCE) * [[-2], [-2], [1]]
    assert mended == exactly(forward(BASE))


def test_wheels_that_are_all_positive_turn_the_robot_counter_clockwise():
    assert papers.note_forward(RADIUS, DISTANCE) @ np.ones(4) == exactly((0, 0, RADIUS / DISTANCE))
    assert BASE.twist(np.ones(4)) == exactly((0, 0, RADIUS / DISTANCE))


def test_a_robot_turned_by_the_printed_inverse_goes_askew():
    driven = forward(BASE) @ papers.note_inverse(RADIUS, DISTANCE)
    half = 0.5**0.5
    askew = [[half, 0, 0], [half, 2 * half, 0], [-1 / (2 * DISTANCE), 0, 1]]
    assert driven == exactly(askew)
    assert forward(BASE) @ mended_inverse() == exactly(np.diag((2 * half, 2 * half, 1)))


# What the reproduction shows


def test_wrong_rows_are_marked_and_right_ones_are_not(sections):
    marked = {key: sorted(section.marks) for key, section in sections.items()}
    assert marked == {
        "forward": [0, 1],
        "lines": [0, 1],
        "inverse": [0, 1, 2, 3],
        "wheels": [3, 6, 7],
        "last": [0, 1],
        "products": [0, 1, 2, 6, 7, 9, 10, 12, 13, 14, 15, 16],
        "path": [],
    }


def test_every_row_has_a_cell_for_every_column(sections):
    for section in sections.values():
        assert {len(row) for row in section.rows} == {len(section.columns)}
        assert all(section.marks.values())


def test_printed_and_right_entries_stand_side_by_side(sections):
    forwards = sections["forward"]
    assert column(forwards, "paper w1") == [-1, 1, 5]
    assert column(forwards, "ours w1") == pytest.approx([-(2**0.5), 2**0.5, 5], abs=1e-3)
    products = sections["products"]
    assert [row[2:] for row in products.rows[:3]] == [[0.5, 0, 0], [0.5, 1, 0], [-2.5, 0, 1]]


def test_the_path_is_followed_as_believed_and_missed_in_truth(sections):
    path = sections["path"]
    assert column(path, "leg") == ["A to B", "B to C", "C to D", "D to E", "E to A"]
    assert max(column(path, "believed off by (mm)")) < 20
    off = column(path, "truly off by (mm)")
    assert off[0] < 20 < off[-1] < 400
    for row in path.rows:
        _, _, _, _, middle, low, high, heading, left, right = row
        assert low <= middle <= high
        assert left <= heading <= right
        assert -45 < left <= right < 45


def test_the_path_is_told_to_be_ours_and_physics(sections):
    path = sections["path"]
    assert "the path is ours" in path.title
    assert path.notes[0].startswith(f"Physics: {SEEDS} seeds")
    assert not any(s.fitted or s.printed is not None for s in path.summary)


def test_the_path_is_drawn(sections, tmp_path):
    sections["path"].figure().savefig(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 20_000
