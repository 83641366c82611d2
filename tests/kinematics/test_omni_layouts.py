"""What a base refuses, and that it stays what it was made."""

import numpy as np
import pytest

from soccersim.kinematics import OmniBase

AZIMUTHS = (30, 150, 270)


@pytest.fixture
def four_wheels():
    return OmniBase.tangential((45, 135, 225, 315), distance=0.2, wheel_radius=0.05)


def test_a_base_cannot_be_changed():
    base = OmniBase.tangential()
    with pytest.raises(AttributeError):
        base.distance = np.ones(3)
    for array in (base.azimuth, base.jacobian, base.inverse_jacobian, base.transverse):
        assert array.dtype == np.float64
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


def test_a_base_keeps_its_own_copy_of_what_it_was_given():
    distance = np.full(3, 0.19)
    base = OmniBase.tangential(distance=distance)
    distance[:] = 5.0
    assert base.distance == pytest.approx(0.19)
    assert distance.flags.writeable


@pytest.mark.parametrize(
    ("layout", "cause"),
    [
        ({"azimuths_deg": (0, 180)}, "2 wheels cannot drive .* give 3 or more"),
        ({"azimuths_deg": 90}, "1 wheels cannot drive"),
        ({"wheel_radius": (0.05, 0, 0.05)}, "wheel_radius must be positive"),
        ({"wheel_radius": -0.05}, "wheel_radius must be positive"),
        ({"roller_radius": 0}, "roller_radius must be positive"),
        ({"distance": -0.19}, "distance must not be negative"),
        ({"distance": float("nan")}, "distance must be finite"),
        ({"azimuths_deg": (0, 120, float("inf"))}, "azimuth must be finite"),
        ({"pivots": np.full((3, 2), np.nan)}, "pivot must be finite"),
        ({"pivots": (1, 2, 3)}, r"pivot must have shape \(3, 2\)"),
        ({"distance": (0.1, 0.2)}, "distance must be 3 numbers"),
        ({"roller_angles_deg": 90}, r"within \+-90 deg"),
        ({"directions_deg": 20}, "parallel lines .* turn the direction"),
        ({"directions_deg": (20, 200, 20)}, "parallel lines"),
        ({"azimuths_deg": (0, 0, 0)}, "parallel lines"),
        ({"directions_deg": AZIMUTHS}, r"all meet at \(0, 0\) m, .* turn one wheel's direction"),
        ({"distance": 0}, r"all meet at \(0, 0\) m"),
        ({"azimuths_deg": (90, -90, 0), "directions_deg": (-45, 45, 0)}, r"meet at \(0.19, 0\) m"),
    ],
)
def test_a_layout_that_cannot_drive_says_why_in_one_line(layout, cause):
    given = {"azimuths_deg": AZIMUTHS, "distance": 0.19, "wheel_radius": 0.05} | layout
    with pytest.raises(ValueError, match=cause) as error:
        OmniBase.general(**given)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_a_toy_and_a_lorry_pass_the_same_test_of_rank(size):
    """Wheels all but radial are refused when next to nothing turns the base, whatever its size."""

    def base(off_deg):
        directions = np.add(AZIMUTHS, off_deg)
        return OmniBase.general(AZIMUTHS, 0.19 * size, 0.05 * size, directions_deg=directions)

    assert base(0.01).wheels == 3
    with pytest.raises(ValueError, match="all meet"):
        base(1e-5)


@pytest.mark.parametrize(
    ("ask", "cause"),
    [
        (lambda base: base.wheel_speeds((1, 2)), "twist must be 3 numbers"),
        (lambda base: base.wheel_speeds((1, 2, 3), (1, 1, 1, 1)), "need pivots"),
        (lambda base: base.twist((1, 2, 3)), "wheel_speeds must be 4 numbers"),
        (lambda base: base.twist((1, 2, 3, 4), (1, 1, -1, 1)), "weights must be finite"),
        (lambda base: base.twist((1, 2, 3, 4), (0, 0, 0, 0)), "not all 0"),
        (lambda base: base.twist((1, 2, 3, 4), (1, 1, 0, 0)), "all meet"),
        (lambda base: base.twist((1, 2, 3, 4), (1, 0, 1, 0)), "parallel"),
        (lambda base: base.roller_speeds((1, 2, 3)), "no roller_radius is known"),
    ],
)
def test_a_question_that_makes_no_sense_is_refused(four_wheels, ask, cause):
    with pytest.raises(ValueError, match=cause):
        ask(four_wheels)
