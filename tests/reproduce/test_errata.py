"""docs/errata.md: every erratum has a test that exists, and the quoted words are printed."""

import ast
import re
from math import cos, pi, radians, sin, sqrt
from pathlib import Path

import numpy as np
import paper_text as paper
import pytest

from soccersim import load_scenario
from soccersim.geometry import rotate
from soccersim.kinematics import papers
from soccersim.kinematics.papers import MIRROR_Y
from soccersim.reproduce.matrices import forward, inverse, rotation
from soccersim.reproduce.tables import names, table

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "errata.md").read_text(encoding="utf-8")
COLUMNS = ["Where", "Printed", "Right", "Proof", "Test"]
FILES = {  # heading: the paper's text
    "Idris et al.": paper.IDRIS,
    "Utama et al.": paper.UTAMA,
    "Dasmahapatra": paper.ARM,
    "The four-wheel note": "four-wheel-omni-note.txt",
    "Garcia-Sillas et al.": paper.GARCIA,
}
LEAST = {"Idris et al.": 20, "Utama et al.": 11, "Dasmahapatra": 10, "The four-wheel note": 10}
with_papers = pytest.mark.skipif(
    not paper.FOLDER.is_dir(), reason="the papers' texts are not beside this checkout"
)


def exactly(value):
    return pytest.approx(np.array(value), rel=0, abs=1e-12)


def errata():
    """(heading, cells) of every row of the page's tables."""
    found = []
    for part in re.split(r"^## ", PAGE, flags=re.M)[1:]:
        heading = part.splitlines()[0]
        lines = re.findall(r"^\| (.*) \|$", part, re.M)
        rows = [[cell.strip() for cell in line.split(" | ")] for line in lines]
        assert rows[0] == COLUMNS
        found += [(heading, row) for row in rows[1:]]
    return found


# The page


def test_the_page_has_the_errata_of_all_five_papers():
    headings = [heading for heading, _ in errata()]
    for heading in FILES:
        assert headings.count(heading) >= LEAST.get(heading, 16)
    assert all(len(row) == len(COLUMNS) and all(row) for _, row in errata())


@pytest.mark.parametrize(
    ("where", "cell"), [(f"{heading} {row[0]}", row[4]) for heading, row in errata()]
)
def test_every_erratum_has_tests_that_exist(where, cell):
    tests = re.findall(r"`(.+?)`", cell)
    assert tests, where
    assert re.fullmatch(r"(`[^`]+` ?)+", cell), where
    for test in tests:
        file, name = test.split("::")
        tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        functions = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
        assert functions.count(name) == 1, test
        assert name.startswith("test_")


def test_every_misprint_of_the_tables_of_arm_and_garcia_is_on_the_page():
    places = {heading: [row[0] for h, row in errata() if h == heading] for heading in FILES}
    for number in (1, 2):
        for row in table(f"dasmahapatra-table{number}").misprints:
            axis = row["misprint"].upper()
            assert f"Table {number}, row {row['no']:g}, {axis}" in places["Dasmahapatra"]
    assert "Table 1, gamma_1" in places["Garcia-Sillas et al."]
    assert {name for name in names() if table(name).misprints} == {
        *("dasmahapatra-table1", "dasmahapatra-table2", "garcia-table1"),
        *("idris-summaries", "idris-table6", "utama-square"),
    }


@with_papers
@pytest.mark.parametrize("heading", FILES)
def test_words_in_quotation_marks_are_printed(heading):
    text = " ".join(paper.text(FILES[heading]).split())
    quoted = [
        words
        for where, row in errata()
        if where == heading
        for words in re.findall(r'"(.+?)"', f"{row[1]} {row[3]}")
    ]
    assert quoted
    for words in quoted:
        assert words.replace("\\*", "*") in text.replace("\\*", "*"), words


# Idris


@pytest.mark.parametrize("theta", np.radians((0, 37, 122, -80)))
def test_idris_4_has_its_row_of_y_reversed(theta):
    s, c = sin(theta), cos(theta)
    right = np.array((2 * c / 3, -c / 3 - s / sqrt(3), -c / 3 + s / sqrt(3)))
    assert papers.idris_eq4(theta, 1, 1)[1] == exactly(-right)
    assert (rotation(theta) @ forward(papers.IDRIS_EQ4))[1] == exactly(papers.RADIUS * right)


def test_idris_4_takes_angular_speeds_and_divides_by_3_l():
    one = papers.idris_eq4(0.4, 0.05, 0.19)
    assert papers.idris_eq4(0.4, 0.10, 0.19) == exactly(2 * one)
    assert papers.idris_eq4(0.4, 0.05, 0.38) == exactly(one * [[1], [1], [0.5]])
    rim = 0.05 * 7.0  # m/s of wheels that turn at 7 rad/s
    assert (one @ np.full(3, 7.0))[2] == pytest.approx(rim / 0.19)


@pytest.mark.parametrize("theta", np.radians((0, 37, 122)))
def test_idris_4_and_5_are_of_one_robot_once_two_wheels_change_places_and_the_frame_turns(theta):
    one = MIRROR_Y @ rotation(theta) @ forward(papers.IDRIS_EQ4)
    other = inverse(papers.IDRIS_EQ5) @ rotation(-theta) @ MIRROR_Y
    places = np.eye(3)[[1, 0, 2]]
    turned = rotation(theta) @ rotation(radians(30)) @ rotation(-theta)
    product = MIRROR_Y @ turned @ MIRROR_Y @ one @ places @ other
    assert product == exactly(np.eye(3))
    assert np.abs(one @ other - np.eye(3)).max() > 0.1


def test_idris_encoder_speeds_are_not_whole_pulses_in_a_tenth_of_a_second():
    step = 600 / 270
    speeds = np.concatenate([table(f"idris-table{n}").numbers("encoder") for n in (2, 3, 4)])
    speeds = speeds[speeds > 0]
    whole = np.abs(speeds - np.round(speeds / step) * step) < 0.05 + 1e-9
    assert (len(speeds), whole.sum()) == (78, 3)
    assert len(speeds) * 0.1 / step == pytest.approx(3.51)


def test_idris_three_motors_are_suspiciously_alike():
    speeds = np.array([table(f"idris-table{n}").numbers("real") for n in (2, 3, 4)])
    spread = speeds.std(axis=0, ddof=1)[1:]
    assert len(spread) == 26
    assert spread.mean() == pytest.approx(0.42, abs=0.005)
    assert (speeds.max(axis=0) - speeds.min(axis=0)).max() == pytest.approx(3.5)


def _summed_up(place, column):
    (row,) = [
        row
        for row in table("idris-summaries").rows
        if (row["place"], row["table"], row["column"]) == (place, 5, column)
    ]
    return row["printed"]


def test_idris_text_gives_the_right_wheels_mileage_error_as_the_lefts():
    for said, meant in (("left", "right"), ("right", "left"), ("back", "back")):
        text = _summed_up("text", said)
        assert text == pytest.approx(_summed_up("table", meant), rel=2e-3)
        if said != meant:
            assert abs(text / _summed_up("table", said) - 1) > 0.1


def test_idris_theta_error_is_cut_off_in_the_abstract():
    printed = [
        row["printed"]
        for row in table("idris-summaries").rows
        if (row["table"], row["column"]) == (6, "theta")
    ]
    assert printed == [0.265778, 0.26, 0.26]
    assert round(printed[0], 2) == 0.27


def test_idris_lost_rotation_takes_the_field_into_the_robots_frame():
    theta = pi / 2  # as in (3)
    s, c = sin(theta), cos(theta)
    lost = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    assert lost @ (0, 1, 0) == exactly((1, 0, 0))  # the field's y lies ahead of the robot
    assert lost == exactly(rotation(-theta))
    assert (lost @ (0.3, -0.7, 1.1))[:2] == exactly(rotate(0.3, -0.7, -theta))


def test_the_head_of_idris_table_7_is_garbled():
    (remark,) = [remark for remark in table("idris-table7").remarks if "1111e (S)" in remark]
    assert "heading" in remark


# Utama


def test_utama_2_takes_the_radius_for_r_and_rad_per_s():
    turn, radius, distance = 2 * pi, 0.025, 0.08  # one turn a second of each wheel
    told = papers.utama_eq2(0.0, radius, distance) @ np.full(3, turn)
    rim = 2 * pi * radius
    assert told[2] == exactly(rim / distance)
    in_turns = papers.utama_eq2(0.0, radius, distance) @ np.ones(3)
    assert in_turns[2] * turn == exactly(rim / distance)
    swapped = papers.utama_eq2(0.0, distance, distance) @ np.full(3, turn)
    assert swapped[2] / told[2] == pytest.approx(distance / radius)


def test_utamas_second_leg_of_the_square_goes_left():
    (row,) = table("utama-square").misprints
    assert (row["leg"], row["direction"], row["corrected"]) == (2, "right", "left")
    first, second, *_ = load_scenario("square").robots[0].path
    assert (first.to[0], first.to[1] > 0) == (0, True)  # his y is forward, his x to the right
    assert second.to[0] < 0


def test_utamas_lengths_in_cm_fit_no_field():
    points = table("utama-points")
    longest = max(np.hypot(points.numbers("x"), points.numbers("y")))
    field = load_scenario("one-of-everything", settings=["field=msl"]).field
    assert longest / 100 > 3 * field.length
    assert longest / 1000 < load_scenario("striker").field.length
    assert points.units["x"] == "mm"


# Garcia-Sillas


@with_papers
def test_garcia_does_not_list_munoz_2010():
    text, references = paper.text(paper.GARCIA).split("## References")
    assert text.count("Muñoz, 2010") == 2
    assert re.findall(r"Muñoz.*?\((\d{4})\)", references) == ["2003"]
