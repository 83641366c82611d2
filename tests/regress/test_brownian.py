"""A Brownian motion between two bounds, against a second formula; the estimate after a stop."""

from math import cos, exp, expm1, isfinite, log, pi, sin
from statistics import NormalDist

import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim.regress.brownian import Walk, falls_to_zero, log_phi, median_unbiased

WALKS = [
    Walk(-2.94, 2.94, 0.01, 0.04),
    Walk(-2.94, 2.94, -0.02, 0.04),
    Walk(-1.0, 3.0, 1e-9, 0.04),
    Walk(-1.0, 3.0, 0.05, 0.04),
]
ENDS = [(100, 0.5), (50, "upper"), (200, "lower"), (400, 1.0), (30, 0.0)]


def by_eigenfunctions(walk, time, level):
    """The same probability by the walk's eigenfunctions, and the gambler's ruin for ever after."""
    width, start, lean = walk.upper - walk.lower, -walk.lower, walk.drift / walk.variance
    top = level - walk.lower
    ruin = expm1(-2 * lean * width) - expm1(-2 * lean * start)
    chance = ruin / expm1(-2 * lean * width)  # absorbed below, sooner or later
    for n in range(1, 400):
        k = n * pi / width
        decay = (k * k * walk.variance + walk.drift**2 / walk.variance) / 2
        left = exp(-decay * time - lean * start) * sin(k * start) * 2 / width
        below = k - exp(lean * top) * (k * cos(k * top) - lean * sin(k * top))
        chance += left * below / (lean * lean + k * k)  # afloat below the level
        chance -= left * walk.variance / 2 * k / decay  # afloat, and absorbed below later
    return chance


@pytest.mark.parametrize("walk", WALKS)
@pytest.mark.parametrize(("time", "level"), ENDS)
def test_images_and_eigenfunctions_agree(walk, time, level):
    level = getattr(walk, level) if isinstance(level, str) else level
    assert walk.ends_worse(time, level) == pytest.approx(
        by_eigenfunctions(walk, time, level), abs=1e-9
    )


def test_in_the_long_run_it_is_the_gamblers_ruin():
    # Wald: with the drift of the upper hypothesis the lower bound is met with chance beta
    bound = log(0.95 / 0.05)
    assert Walk(-bound, bound, 0.02, 0.04).ends_worse(1e9, bound) == pytest.approx(0.05)
    assert Walk(-bound, bound, -0.02, 0.04).ends_worse(1e9, -bound) == pytest.approx(0.95)


@given(
    st.floats(-1e5, 1e5),
    st.floats(1e-9, 1e3),
    st.floats(1e-3, 1e7),
    st.floats(0, 1),
    st.floats(0.2, 7),
    st.floats(0.2, 7),
)
def test_any_walk_ends_worse_with_a_probability(drift, variance, time, part, below, above):
    walk = Walk(-below, above, drift * variance, variance)
    assert 0 <= walk.ends_worse(time, -below + part * (above + below)) <= 1


@given(st.floats(-3, 3), st.floats(-3, 3), st.floats(1, 1000))
def test_the_stronger_the_drift_the_rarer_a_worse_end(one, other, time):
    weak, strong = sorted((one, other))
    chances = [
        Walk(-2.9, 2.9, lean * 0.04, 0.04).ends_worse(time, level)
        for lean in (weak, strong)
        for level in (-2.9, -1.0, 1.0, 2.9)
    ]
    assert all(a >= b - 1e-9 for a, b in zip(chances[:4], chances[4:], strict=True))
    assert chances[4:] == sorted(chances[4:])  # and the higher the level, the more ends are worse


def test_the_estimate_after_an_open_end_is_the_mean_and_after_a_stop_it_is_nearer_to_none():
    def walk(effect):
        return Walk(-3.0, 3.0, effect, 1.0)

    wide = median_unbiased(lambda effect: Walk(-300.0, 300.0, effect, 1.0), 4.0, 1.0, -9, 9)
    assert wide.value == pytest.approx(1 / 4)
    assert wide.high - wide.value == pytest.approx(NormalDist().inv_cdf(0.975) / 2, abs=1e-6)
    assert wide.value - wide.low == pytest.approx(NormalDist().inv_cdf(0.975) / 2, abs=1e-6)
    stopped = median_unbiased(walk, 4.0, 3.0, -9, 9)
    assert stopped.low < 0.25 < stopped.value < 3 / 4 < stopped.high


@given(st.floats(-1e4, 1e2))
def test_the_tail_of_the_normal_distribution_is_smooth_to_its_end(x):
    assert isfinite(log_phi(x))
    assert log_phi(x) <= log_phi(x + 0.01) <= 0
    slope = (log_phi(x + 1e-3) - log_phi(x - 1e-3)) / 2e-3
    if x < -1:
        assert -x * (1 - 1e-6) < slope < (-x - 1 / x) * (1 + 1e-6)  # Mills' ratio


def test_a_falling_function_is_followed_to_zero_or_to_the_nearer_end():
    assert falls_to_zero(lambda x: 2 - x, -10, 10) == pytest.approx(2)
    assert falls_to_zero(lambda x: 1.0, -10, 10) == pytest.approx(10)
    assert falls_to_zero(lambda x: -1.0, -10, 10) == pytest.approx(-10)
