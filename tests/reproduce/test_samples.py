"""How a paper's number is held against many of ours."""

import numpy as np
import pytest

from soccersim.reproduce.samples import (
    band,
    distance,
    held_against,
    inside,
    percentile,
    rounded,
)

HUNDRED = np.arange(101.0)


def test_the_band_is_the_median_and_5_to_95_percent():
    assert band(HUNDRED) == (50, 5, 95)


def test_a_number_within_the_rounding_of_its_print_lies_inside():
    samples = np.column_stack((HUNDRED, HUNDRED, HUNDRED, HUNDRED))
    paper = np.array([4.0, 4.8, 50.0, 95.2])
    assert inside(paper, samples).tolist() == [False, False, True, False]
    assert inside(paper, samples, rounding=0.25).tolist() == [False, True, True, True]


def test_the_percentile_counts_half_of_those_alike():
    assert percentile(50.0, HUNDRED) == pytest.approx(50)
    assert percentile(-1.0, HUNDRED) == 0
    assert percentile(200.0, HUNDRED) == 100


def test_the_reason_is_told_only_where_the_number_is_outside():
    inner = held_against("a", HUNDRED, printed=60.0, note="rule", outside="why")
    outer = held_against("a", HUNDRED, printed=99.0, note="rule", outside="why")
    assert (inner.inside, inner.note) == (True, "rule")
    assert (outer.inside, outer.note) == (False, "rule; why")


def test_a_recomputed_number_counts_before_a_misprinted_one():
    assert held_against("a", HUNDRED, printed=99.0, recomputed=60.0).inside


def test_poses_lie_apart_by_their_places_alone():
    assert distance(np.array([[3.0, 4.0, 9.0]]), np.zeros((1, 3))) == pytest.approx([5])


def test_floats_are_rounded_and_nothing_else():
    assert rounded([(1, 1.23456, "x", None, True)], 2) == [[1, 1.23, "x", None, True]]
