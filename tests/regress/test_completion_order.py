"""Why pairs are judged in the order of their numbers: matches that end early come in first.

False PASS of 2,000 runs between two equal teams, by goals, hypotheses 0 and 50 nElo, losses three
times slower than wins:

    workers                    1     16     64    128
    in the order of numbers   .031   .031   .031   .031
    in the order of ends      .031   .045   .157   .739
"""

import numpy as np
import pytest
from synthetic_matches import WORLDS, ended, ends, outcomes, play

from soccersim.regress.rules import Sprt

RULE = Sprt(0, 50, closing=False)


@pytest.fixture(scope="module")
def equals():
    return play(WORLDS["lively"], 0, "goals", 2000, 400, seed=5)


def passed(x):
    return (ends(x, "goals", RULE)[1] == 1).mean()


def test_in_the_order_of_numbers_equals_pass_rarely(equals):
    assert passed(outcomes(equals.legs, "goals")) == pytest.approx(0.031, abs=0.0005)


@pytest.mark.parametrize(("workers", "rate"), [(1, 0.031), (16, 0.045), (64, 0.157), (128, 0.739)])
def test_in_the_order_of_ends_they_pass_the_more_the_more_workers(equals, workers, rate):
    order = ended(equals, workers).argsort(axis=1, kind="stable")
    came = np.take_along_axis(outcomes(equals.legs, "goals"), order, axis=1)
    assert passed(came) == pytest.approx(rate, abs=0.0005)


def test_losses_take_three_times_as_long_as_wins(equals):
    time, legs = equals.time, equals.legs
    assert time[legs < 0].mean() == pytest.approx(3 * time[legs > 0].mean(), rel=0.01)


def test_workers_share_the_work_and_one_keeps_the_order(equals):
    alone, many = ended(equals, 1), ended(equals, 64)
    assert (np.diff(alone, axis=1) > 0).all()
    assert alone[:, -1] == pytest.approx(equals.time.sum(axis=(1, 2)))
    assert (many.max(axis=1) < alone[:, -1] / 50).all()
    assert (many.max(axis=1) > alone[:, -1] / 64).all()
