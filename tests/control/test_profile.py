"""Rest to rest along a line: how long it takes, and where one is meanwhile."""

from math import exp, inf, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim.control.profile import motor_line_time, profile_at, profile_time

distances = st.floats(1e-3, 50)
limits = st.floats(0.05, 10)


def at(times, *line):
    return np.array([profile_at(t, *line) for t in times]).T


def test_times_of_idris_table_7():
    """model.md, check 15: v = 2.775 m/s and a = 1.0 m/s2 for 4.5 and 3 m."""
    assert profile_time(4.5, 2.775, 1.0) == pytest.approx(4.243, abs=5e-4)
    assert profile_time(3.0, 2.775, 1.0) == pytest.approx(3.464, abs=5e-4)


def test_times_with_and_without_a_cruise():
    assert profile_time(4.0, 1.0, 2.0) == pytest.approx(4.0 / 1.0 + 1.0 / 2.0)
    assert profile_time(0.5, 1.0, 2.0) == pytest.approx(2 * sqrt(0.5 / 2.0))
    assert profile_time(0.5, 1.0, 2.0) == profile_time(0.5, 1.0 + 1e-12, 2.0)
    assert profile_time(0.0, 1.0, 2.0) == 0.0


@given(distances, limits, limits)
def test_from_rest_to_rest_over_the_distance(distance, speed, acceleration):
    line = distance, speed, acceleration
    total = profile_time(*line)
    assert profile_at(0.0, *line) == (0.0, 0.0)
    assert profile_at(total, *line) == (distance, 0.0)
    assert profile_at(2 * total, *line) == (distance, 0.0)
    assert profile_at(0.5 * total, *line)[0] == pytest.approx(0.5 * distance)
    assert profile_at(total * (1 - 1e-9), *line)[0] == pytest.approx(distance)


@given(distances, limits, limits)
def test_neither_limit_is_passed_and_one_is_always_used(distance, speed, acceleration):
    line = distance, speed, acceleration
    times = np.linspace(0, profile_time(*line), 1001)
    place, rate = at(times, *line)
    step = times[1]
    assert (np.diff(place) >= 0).all()
    assert rate.max() <= speed * (1 + 1e-9)
    assert abs(np.diff(rate)).max() <= acceleration * step * (1 + 1e-6)
    assert np.diff(place) / step == pytest.approx(
        0.5 * (rate[1:] + rate[:-1]), abs=0.5 * acceleration * step
    )
    ramping = abs(np.diff(rate)) > 0.999 * acceleration * step
    cruising = rate[1:] > 0.999 * speed
    assert (ramping | cruising).sum() >= 997  # all but where one gives way to the other


@given(distances, limits, limits, st.floats(0, 1))
def test_braking_mirrors_starting(distance, speed, acceleration, share):
    line = distance, speed, acceleration
    total = profile_time(*line)
    there, back = profile_at(share * total, *line), profile_at((1 - share) * total, *line)
    assert there[0] == pytest.approx(distance - back[0], abs=1e-9 * distance)
    assert there[1] == pytest.approx(back[1], abs=1e-6 * speed)


def driven(speed, acceleration, turned, dt=1e-4):
    """Where a motor's line stops: full voltage until `turned` m, then full reverse, to rest."""
    x = v = t = 0.0
    decay = exp(-acceleration * dt / speed)
    while v >= 0.0:
        end = speed if x < turned else -speed  # the speed that the voltage leads to
        x += end * dt + (v - end) * speed / acceleration * (1 - decay)
        v = end + (v - end) * decay
        t += dt
    return x, t


def test_quickest_line_of_idris_motors():
    """model.md, check 16: 4.5 m in 2.838 s with v = 2.775 and a0 = mu g / 2 at mu = .6."""
    assert motor_line_time(4.5, 2.775, 2.943) == pytest.approx(2.838, rel=0.01)
    low, high = 0.0, 4.5
    for _ in range(20):  # where to reverse so as to stop at 4.5 m
        middle = 0.5 * (low + high)
        if driven(2.775, 2.943, middle)[0] < 4.5:
            low = middle
        else:
            high = middle
    x, t = driven(2.775, 2.943, low)
    assert x == pytest.approx(4.5, abs=1e-3)
    assert t == pytest.approx(motor_line_time(4.5, 2.775, 2.943), rel=1e-3)


def test_a_motor_s_line_lies_between_its_limits():
    assert motor_line_time(4.5, 1e4, 2.943) == pytest.approx(2 * sqrt(4.5 / 2.943), rel=1e-4)
    assert motor_line_time(1e6, 2.775, 2.943) == pytest.approx(1e6 / 2.775, rel=1e-3)
    assert motor_line_time(1e6, 2.775, 2.943) < inf
    for distance in (0.01, 0.3, 4.5, 20.0):
        bang_bang = profile_time(distance, 2.775, 2.943)
        assert motor_line_time(distance, 2.775, 2.943) > min(bang_bang, distance / 2.775)
        assert motor_line_time(distance, 2.775, 2.943) >= 2 * sqrt(distance / 2.943)
