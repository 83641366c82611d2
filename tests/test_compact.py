"""A match's numbers come back from their file as they were kept."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from soccersim.record.compact import STEPS, packed, rounded, unpacked

places = st.floats(-30, 30) | st.just(float("nan"))


@given(arrays(np.float64, (7, 5), elements=places))
def test_what_is_rounded_comes_back_bit_by_bit(numbers):
    kept = rounded("ball_believed", numbers)
    steps = packed("ball_believed", kept)
    assert steps.dtype == np.int32
    again = unpacked("ball_believed", steps)
    assert again.dtype == np.float32
    np.testing.assert_array_equal(again, kept)


@given(arrays(np.float64, (3, 2, 6), elements=st.floats(-60, 60)))
def test_rounding_moves_nothing_by_more_than_half_a_step(bodies):
    off = np.abs(rounded("body", bodies) - bodies)
    assert (off <= np.array(STEPS["body"]) / 2 + 4e-6).all()  # and the float's own last bit


def test_a_ball_that_jumps_across_the_field_and_is_lost_comes_back():
    ball = np.full((4, 2, 5), np.nan)
    ball[1:3] = 31.9, -31.9, 12.0, -12.0, 0.04
    kept = rounded("ball_believed", ball)
    np.testing.assert_array_equal(unpacked("ball_believed", packed("ball_believed", kept)), kept)


def test_arrays_that_are_not_rounded_are_left_alone():
    ticks = np.arange(5)
    assert rounded("phase", ticks) is ticks
    assert packed("phase", ticks) is ticks
    assert unpacked("phase", ticks) is ticks
