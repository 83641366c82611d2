"""Garcia-Sillas' two motions simulated, beside what (29) as printed and mended says of them."""

import numpy as np
import pytest

from soccersim.kinematics import garcia, papers
from soccersim.reproduce import garcia_motion
from soccersim.reproduce.garcia_motion import BASE, DISTANCE, RADIUS
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.matrices import forward


def exactly(value):
    return pytest.approx(np.array(value), rel=0, abs=1e-12)


@pytest.fixture(scope="module")
def sections():
    with Lab(jobs=1, seeds=2) as lab:
        return {section.key: section for section in garcia_motion.sections(lab)}


def test_the_linear_motion_is_straight_and_a_little_slower_than_without_slip():
    motion = garcia_motion.simulate("linear")
    assert motion.wheels.tolist() == [0, 10, -10]
    ideal = forward(BASE) @ motion.wheels
    assert ideal == exactly((2 * RADIUS * 10 / 3**0.5, 0, 0))
    assert 0.99 * ideal[0] < motion.steady[0] < ideal[0]
    assert np.abs(motion.steady[1:]) == pytest.approx([0, 0], abs=1e-3)
    assert 0.95 < motion.pose[-1, 0] / (5 * ideal[0]) < 1
    assert np.abs(motion.pose[:, 1]).max() < 2e-3


def test_the_rotation_is_on_the_spot_and_clockwise():
    motion = garcia_motion.simulate("rotation")
    assert motion.wheels.tolist() == [5, 5, 5]
    rate = -RADIUS * 5 / DISTANCE
    assert motion.steady[2] == pytest.approx(rate, rel=0.01)
    assert np.hypot(*motion.pose[:, :2].T).max() < 2e-3
    assert motion.pose[-1, 2] == pytest.approx(5 * rate, rel=0.01)


def test_equal_wheels_2_and_3_do_not_go_straight():
    assert forward(BASE) @ (0, 10, 10) == exactly(
        (0, -2 * RADIUS * 10 / 3, -2 * RADIUS * 10 / (3 * DISTANCE))
    )


def test_equation_29_as_printed_stands_still_in_figure_6_and_drives_a_circle_in_figure_7(sections):
    printed = papers.garcia_eq29(RADIUS, DISTANCE)
    assert printed @ (0, 10, -10) == exactly((0, 0, 0))
    assert printed @ (5, 5, 5) == exactly((10 * RADIUS / 3**0.5, 0, -5 * RADIUS / DISTANCE))
    linear = {row[0]: row[1:5] for row in sections["figure-6"].rows}
    paper_x, ours_x, physics_x, less = linear["x (m)"]
    assert paper_x == 0
    assert ours_x == pytest.approx(2.8868)
    assert physics_x - ours_x == pytest.approx(less, abs=2e-4)


def test_equation_28_as_printed_turns_the_other_way_at_a_third_of_the_rate():
    printed = garcia.eq26_to_28(RADIUS, DISTANCE)[2] @ (5, 5, 5)
    assert printed == pytest.approx(-(forward(BASE) @ (5, 5, 5))[2] / 3)


@pytest.mark.parametrize("key", ["figure-6", "figure-7"])
def test_figures_are_drawn(sections, key, tmp_path):
    sections[key].figure().savefig(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 20_000


def test_a_robot_that_drives_ahead_has_its_velocity_along_its_heading():
    body = np.array([[0, 0, np.pi / 2, 0, 2, 0.5], [0, 0, np.pi, -3, 0, 0]])
    assert garcia_motion.in_body(body) == exactly([[2, 0, 0.5], [3, 0, 0]])
