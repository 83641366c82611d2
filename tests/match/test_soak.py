"""The four teams against each other, on all fields: nothing breaks, nothing gets stuck."""

import os

import pytest
from soak import PAIRINGS, soak

from soccersim.workers import Workers


@pytest.mark.parametrize("number", range(0, 3 * len(PAIRINGS), 11))
def test_a_short_match_breaks_nothing(number):
    assert soak(number, 15.0) == ""


@pytest.mark.slow
def test_a_thousand_matches_break_nothing():
    with Workers(os.cpu_count() or 1) as pool:
        wrong = [told for told in pool.map(soak, range(1000), [60.0] * 1000) if told]
    assert wrong == []
