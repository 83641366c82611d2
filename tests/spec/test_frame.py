"""Units and frames: what an author writes, where it lies on the field, and back."""

from math import cos, hypot, pi, radians, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim import load_scenario
from soccersim.spec.frame import Coordinates, Frame, Units

numbers = st.floats(-1000, 1000)
frames = st.builds(
    Coordinates,
    st.builds(
        Units, length=st.sampled_from(["m", "cm", "mm"]), angle=st.sampled_from(["rad", "deg"])
    ),
    st.builds(
        Frame,
        origin=st.tuples(numbers, numbers),
        rotation_deg=st.floats(-720, 720),
        mirror_y=st.booleans(),
        heading=st.sampled_from(["ccw", "cw"]),
    ),
)


def test_without_units_and_frame_it_is_the_field_in_metres_and_degrees():
    at = Coordinates(Units(), Frame())
    assert at.field_pose((1.5, -2.0, 90.0)) == (1.5, -2.0, pi / 2)


@pytest.mark.parametrize(("length", "metres"), [("m", 1), ("cm", 0.01), ("mm", 0.001)])
@pytest.mark.parametrize(("angle", "size"), [("rad", 1), ("deg", pi / 180)])
def test_units_are_those_of_poses(length, metres, angle, size):
    at = Coordinates(Units(length=length, angle=angle), Frame())
    assert at.field_pose((3.0, 4.0, 2.0)) == pytest.approx((3 * metres, 4 * metres, 2 * size))
    assert at.field_vector(3.0, 4.0) == pytest.approx((3 * metres, 4 * metres))


def test_the_origin_is_in_metres_whatever_the_units():
    at = Coordinates(Units(length="mm"), Frame(origin=(1.0, 2.0)))
    assert at.field_pose((500.0, 0.0, 0.0)) == (1.5, 2.0, 0.0)


def test_a_turned_frame_turns_places_directions_and_headings():
    at = Coordinates(Units(), Frame(rotation_deg=90))
    assert at.field_pose((1.0, 0.0, 0.0)) == pytest.approx((0.0, 1.0, pi / 2))
    assert at.field_pose((0.0, 1.0, 45.0)) == pytest.approx((-1.0, 0.0, 3 * pi / 4))
    assert at.field_vector(1.0, 0.0) == pytest.approx((0.0, 1.0))


def test_utamas_frame_has_y_ahead_and_a_compass_that_turns_clockwise():
    at = load_scenario("defender").coordinates
    assert at.field_pose((0.0, 2000.0, 0.0)) == pytest.approx((-1.5, -0.5, -pi / 2))
    assert at.field_pose((-2500.0, 2000.0, 7.41)) == pytest.approx(
        (-1.5, 2.0, -pi / 2 - radians(7.41))
    )


def test_idris_frame_is_mirrored():
    at = load_scenario("idris-table6").coordinates
    x, y, heading = at.field_pose((10.0, 20.0, 90.0))
    assert (x, y) == pytest.approx((0.2, 0.1))  # y ahead, x to the right turned about: mirrored
    assert heading == pytest.approx(0.0)


@given(at=frames, x=numbers, y=numbers, heading=numbers)
def test_a_pose_comes_back_from_the_field(at, x, y, heading):
    framed = at.framed((x, y, heading))
    assert at.from_field(at.to_field(framed)) == pytest.approx(framed, abs=1e-9)


@given(at=frames, a=st.tuples(numbers, numbers), b=st.tuples(numbers, numbers))
def test_distances_are_kept(at, a, b):
    (ax, ay, _), (bx, by, _) = at.field_pose((*a, 0.0)), at.field_pose((*b, 0.0))
    apart = hypot(a[0] - b[0], a[1] - b[1]) * at.metres
    assert hypot(ax - bx, ay - by) == pytest.approx(apart, abs=1e-9)


@given(at=frames, heading=st.floats(-360, 360))
def test_headings_grow_as_the_author_says_seen_from_above(at, heading):
    first, second = (at.field_pose((0.0, 0.0, h))[2] for h in (heading, heading + 1.0))
    assert (second > first) == (at.turns > 0)


@given(at=frames, vx=numbers, vy=numbers)
def test_a_vector_is_the_way_from_one_place_to_another(at, vx, vy):
    (ax, ay, _), (bx, by, _) = at.field_pose((0.0, 0.0, 0.0)), at.field_pose((vx, vy, 0.0))
    assert at.field_vector(vx, vy) == pytest.approx((bx - ax, by - ay), abs=1e-6)


def test_a_rotation_is_counter_clockwise():
    at = Coordinates(Units(), Frame(rotation_deg=30))
    assert at.field_vector(1, 0) == pytest.approx((cos(radians(30)), sin(radians(30))))
