"""The papers' matrices: what each prints, what that does to a robot, and what is right."""

from math import cos, degrees, radians, sin, sqrt

import numpy as np
import pytest

from soccersim.kinematics import papers
from soccersim.kinematics.papers import MIRROR_Y

R, L = 0.05, 0.19
r, l = 0.025, 0.08  # noqa: E741

every_heading = pytest.mark.parametrize(
    "theta", [radians(angle) for angle in (0, 7, -30, 45, 90, 122, -135, 180, 271, 400)]
)


def exactly(value):
    return pytest.approx(np.array(value), rel=0, abs=1e-12)


def rotation(theta):
    """Body to field, for a twist."""
    c, s = cos(theta), sin(theta)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def forward(base):
    """Wheel speeds in rad/s to the body twist."""
    return base.inverse_jacobian * base.rolling_radius


def inverse(base):
    """Body twist to wheel speeds in rad/s."""
    return base.jacobian / base.rolling_radius[:, None]


# Idris


def test_idris_4_cannot_tell_wheels_2_and_3_apart_at_heading_zero():
    assert np.linalg.det(papers.idris_eq4(0, 1, 1)) == exactly(0)
    assert np.linalg.det(papers.idris_eq4(radians(-30), 1, 1)) == exactly(0)
    assert np.linalg.matrix_rank(papers.idris_eq4(0, R, L)) == 2


@every_heading
def test_idris_4_determinant_over_the_headings(theta):
    det = np.linalg.det(papers.idris_eq4(theta, R, L))
    assert det == exactly((2 * cos(2 * theta + radians(30)) - sqrt(3)) / 9 * R**3 / L)


@every_heading
def test_idris_4_with_one_entry_mended_is_the_mirrored_base(theta):
    mended = papers.idris_eq4(theta, R, L)
    mended[0, 1] = R * (-cos(theta) / sqrt(3) + sin(theta) / 3)
    assert mended == exactly(MIRROR_Y @ rotation(theta) @ forward(papers.IDRIS_EQ4))


@every_heading
def test_idris_5_with_its_last_column_mended_is_the_mirrored_base(theta):
    mended = papers.idris_eq5(theta)
    mended[:, 2] = L
    assert mended / R == exactly(inverse(papers.IDRIS_EQ5) @ rotation(-theta) @ MIRROR_Y)


@every_heading
def test_idris_5_turns_the_robot_at_a_fraction_of_the_commanded_rate(theta):
    to_field = MIRROR_Y @ rotation(theta) @ papers.IDRIS_EQ5.inverse_jacobian
    done = to_field @ papers.idris_eq5(theta)  # m/s along the wheels
    assert done == exactly(np.diag((1, 1, 1 / (3 * L))))


@every_heading
def test_idris_4_and_5_mended_still_are_not_of_one_robot(theta):
    one = MIRROR_Y @ rotation(theta) @ forward(papers.IDRIS_EQ4)
    other = inverse(papers.IDRIS_EQ5) @ rotation(-theta) @ MIRROR_Y
    swap = 2 * theta + radians(60)
    expected = [[sin(swap), cos(swap), 0], [cos(swap), -sin(swap), 0], [0, 0, 1]]
    assert one @ other == exactly(expected)


# Utama


@every_heading
def test_utama_1_drives_cos_theta_times_the_command_turned_by_minus_theta(theta):
    done = forward(papers.UTAMA_DRIVE) @ papers.utama_eq1(theta, R, L)
    executed = cos(theta) * rotation(-theta)
    executed[2, 2] = 1
    assert done == exactly(executed)


def test_utama_1_at_the_strikers_heading_is_slow_and_askew():
    done = forward(papers.UTAMA_DRIVE) @ papers.utama_eq1(radians(15.18), R, L) @ (1, 0, 0)
    assert np.hypot(*done[:2]) == pytest.approx(0.965, abs=5e-4)
    assert degrees(np.arctan2(done[1], done[0])) == pytest.approx(-15.18)


def test_utama_1_cannot_move_at_90_degrees():
    assert np.linalg.matrix_rank(papers.utama_eq1(radians(90), R, L)) == 1


@every_heading
def test_utama_1_with_the_whole_rotation_drives_what_is_commanded(theta):
    mended = papers.utama_eq1(theta, R, L) @ np.diag((1 / cos(theta), 1 / cos(theta), 1))
    assert mended @ rotation(theta) == pytest.approx(inverse(papers.UTAMA_DRIVE))


@every_heading
def test_utama_2_determinant_over_the_headings(theta):
    det = np.linalg.det(papers.utama_eq2(theta, r, l))
    assert det == exactly(2 * sqrt(3) * (1 - 4 * sin(theta) ** 2) / 27 * r**3 / l)


@pytest.mark.parametrize("psi_deg", [30, -30, 150, -150])
def test_utama_2_is_singular_at_these_headings(psi_deg):
    assert np.linalg.det(papers.utama_eq2(radians(psi_deg), 1, 1)) == exactly(0)


@every_heading
def test_utama_2_with_two_signs_mended_is_the_encoder_base(theta):
    mended = papers.utama_eq2(theta, r, l)
    mended[1, 1:] *= -1
    assert mended == exactly(rotation(theta) @ forward(papers.UTAMA_ENCODERS_EQ2))


@every_heading
def test_utama_2_as_printed_mixes_sideways_with_the_rest(theta):
    """The row of y that its odometry would report for a field twist."""
    seen = papers.utama_eq2(theta, r, l) @ inverse(papers.UTAMA_ENCODERS_EQ2) @ rotation(-theta)
    row = (-2 * sin(2 * theta) / 3, (1 - 4 * sin(theta) ** 2) / 3, 4 * l * cos(theta) / 3)
    assert seen[1] == exactly(row)
    assert seen[[0, 2]] == exactly([[1, 0, 0], [0, 0, 1]])


def test_utamas_two_placings_of_the_encoders_differ_in_the_sign_of_psi_alone():
    clockwise = np.diag((1.0, 1.0, -1.0))
    assert forward(papers.UTAMA_ENCODERS) == exactly(clockwise @ forward(papers.UTAMA_ENCODERS_EQ2))


def test_utamas_drive_and_encoder_wheels_are_not_the_same_wheels():
    mixed = forward(papers.UTAMA_ENCODERS_EQ2) @ inverse(papers.UTAMA_DRIVE)
    assert np.abs(mixed - np.eye(3)).max() > 0.1


# The four-wheel note


def test_the_notes_forward_times_inverse_halves_x():
    product = papers.note_forward(R, L) @ papers.note_inverse(R, L)
    printed = [[1 / 2, 0, 0], [1 / 2, 1, 0], [-1 / (2 * L), 0, 1]]
    assert product == exactly(printed)


def mended_note_inverse():
    mended = papers.note_inverse(R, L)
    mended[2] = np.array((1, -1, L)) / R
    return mended


def test_the_notes_forward_undoes_its_inverse_once_row_3_is_mended():
    assert papers.note_forward(R, L) @ mended_note_inverse() == exactly(np.eye(3))


def test_the_note_is_the_omni_base_but_for_sqrt2():
    both = np.diag((sqrt(2), sqrt(2), 1))
    assert both @ papers.note_forward(R, L) == exactly(forward(papers.NOTE))
    assert mended_note_inverse() == exactly(inverse(papers.NOTE) @ both)


# Garcia-Sillas


def mended_garcia_29():
    mended = papers.garcia_eq29(R, L)
    mended[0, 2] *= -1
    return mended


def test_garcia_29_loses_a_motion():
    assert np.linalg.matrix_rank(papers.garcia_eq29(R, L)) == 2
    assert np.linalg.matrix_rank(mended_garcia_29()) == 3


def test_garcia_29_mended_is_the_base():
    assert mended_garcia_29() == exactly(forward(papers.GARCIA))


def test_garcia_30_mended_undoes_29_mended_and_is_the_base():
    mended = papers.garcia_eq30(R)
    mended[:, 2] *= L
    assert mended == exactly(inverse(papers.GARCIA))
    assert mended @ mended_garcia_29() == exactly(np.eye(3))


def test_garcia_30_as_printed_turns_about_a_metre_instead_of_the_base():
    done = forward(papers.GARCIA) @ papers.garcia_eq30(R)
    assert done == exactly(np.diag((1, 1, 1 / L)))


def test_garcia_rollers_turn_as_equations_20_to_22_say():
    one, two, three = 3.0, -7.0, 11.0
    base = papers.GARCIA
    assert base.roller_radius is not None
    rollers = base.roller_speeds(base.twist((one, two, three)))
    differences = np.array((three - two, one - three, two - one))
    assert rollers == exactly(R * differences / (base.roller_radius * sqrt(3)))


# Mecanum


def test_mecanum_matches_the_textbook():
    """Modern Robotics, eq. (13.10); its wheels 3 and 4 are rear right and rear left."""
    x, y = papers.MECANUM_HALF_LENGTH, papers.MECANUM_HALF_WIDTH
    book = np.array([[1, -1, -x - y], [1, 1, x + y], [1, -1, x + y], [1, 1, -x - y]]) / R
    assert inverse(papers.MECANUM)[[0, 1, 3, 2]] == exactly(book)
