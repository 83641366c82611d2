"""Encoders count whole edges of a turning wheel, and miss some of them."""

from fractions import Fraction
from math import comb, pi, sqrt

import numpy as np
import pytest
from factory import robot
from hypothesis import example, given, settings
from hypothesis import strategies as st

from soccersim.sensing.encoder import binomial, build_encoders, read_encoders
from soccersim.sensing.noise import NoiseSource
from soccersim.state import new_readings, new_truth

HZ = 500  # ticks a second
QUANTUM = 600 / 270  # rpm of one pulse in 100 ms
draws = st.floats(0, 1, exclude_max=True)
chances = st.fractions(0, 1, max_denominator=50)
shares = st.floats(0.001, 0.999)


class Wheels:
    """The driven wheels of robots whose angles a test sets, with their encoders."""

    def __init__(self, *models, seed=0):
        size = len(models), max(len(model.drive.azimuth_deg) for model in models)
        self.encoders, self.per_count = build_encoders(models, size[1], HZ, seed)
        self.source = NoiseSource(models, size[1], HZ, seed)
        self.truth, self.readings = new_truth(size[0], *size), new_readings(*size)
        self.tick = 0

    def at(self, angle):
        """Counts once the wheels have come to these angles, at the next tick."""
        self.truth.wheel_angle[:] = angle
        self.source.prepare(self.tick, self.tick + 1)
        noise = self.source.noise
        read_encoders(self.encoders, self.readings, self.truth, noise, self.tick, 1 / HZ)
        self.tick += 1
        return self.readings.counts.copy()


def with_encoder(**encoder):
    """A robot whose encoder is read at every tick, real unless it says otherwise."""
    return robot(drive={"encoder": {"perfect": False, "rate_hz": HZ, **encoder}})


@given(st.lists(st.floats(-50, 50), min_size=1, max_size=20), st.integers(0, 1000))
@settings(max_examples=50)
def test_counts_are_whole_and_never_a_pulse_from_the_angle(angles, seed):
    wheels = Wheels(with_encoder(pulses_per_turn=270), seed=seed)
    assert (wheels.at(0.0) == 0).all()
    for angle in angles:
        counts = wheels.at(angle)
        assert (counts == np.round(counts)).all()
        assert (abs(counts - angle / (2 * pi) * 270) < 1).all()


@given(st.lists(st.floats(-500, 500), min_size=1, max_size=20), st.floats(-50, 50))
@settings(max_examples=50)
def test_forward_and_back_cancel_exactly(way, home):
    wheels = Wheels(with_encoder(decoding=4), seed=3)
    start = wheels.at(home)
    for angle in way:
        wheels.at(angle)
    assert (wheels.at(home) == start).all()


@pytest.mark.parametrize("decoding", [1, 2, 4])
def test_decoding_counts_each_pulse_so_often(decoding):
    wheels = Wheels(with_encoder(pulses_per_turn=7, decoding=decoding))
    turns = np.arange(0.0, 3.0, 0.01)
    counts = np.array([wheels.at(2 * pi * turn)[0, 0] for turn in turns])
    assert wheels.per_count[0, 0] == pytest.approx(2 * pi / (7 * decoding))
    assert set(np.diff(counts)) == {0.0, 1.0}
    assert wheels.at(2 * pi * 1000 + 1e-9)[0, 0] == 7 * decoding * 1000


def test_a_perfect_encoder_tells_the_angle_itself():
    wheels = Wheels(with_encoder(perfect=True, missed=0.5))
    for angle in (0.0, 0.1, -7.3, 123.456789):
        told = wheels.at(angle) * wheels.per_count
        assert told == pytest.approx(np.full((1, 3), angle), rel=1e-15)


def test_every_wheel_starts_at_a_phase_of_its_own():
    wheels = Wheels(*[with_encoder(pulses_per_turn=10)] * 50)
    first = np.zeros((50, 3))  # share of a pulse after which each wheel counts its first
    for share in np.linspace(0, 1, 101):
        counts = wheels.at(share * 2 * pi / 10)
        first[(counts > 0) & (first == 0)] = share
    assert len(np.unique(first)) > 70
    assert first.mean() == pytest.approx(0.5, abs=4 / sqrt(12 * 150))


def test_a_counter_is_read_at_its_own_rate():
    wheels = Wheels(with_encoder(rate_hz=100))
    counts = [wheels.at(tick * 1.0)[0, 0] for tick in range(20)]
    assert [tick for tick in range(1, 20) if counts[tick] != counts[tick - 1]] == [5, 10, 15]


@pytest.mark.parametrize("window", [0.002, 0.02, 0.1])
def test_the_speed_is_the_mean_over_the_window(window):
    wheels = Wheels(with_encoder(perfect=True, window=window))
    times = np.arange(200) / HZ
    for angle in 15.0 * times**2:  # a wheel that speeds up by 30 rad/s2
        wheels.at(angle)
    middle = times[-1] - window / 2
    assert wheels.readings.wheel_speed == pytest.approx(np.full((1, 3), 30.0 * middle))


def test_idris_rpm_over_a_tenth_of_a_second():
    """model.md, check 9: errors of one window are triangular, rms q / sqrt 6."""
    model = with_encoder(pulses_per_turn=270, window=0.1, rate_hz=10)
    rng = np.random.default_rng(9)
    rpm = rng.uniform(20, 530, (100, 3))
    wheels = Wheels(*[model] * 100, seed=9)
    told = []
    for tick in range(30 * HZ // 10 + 1):
        wheels.at(rpm * 2 * pi / 60 * tick / HZ)
        if tick and tick % (HZ // 10) == 0:
            told.append(wheels.readings.wheel_speed * 60 / (2 * pi))
    told = np.array(told)
    assert told / QUANTUM == pytest.approx(np.round(told / QUANTUM), abs=1e-9)
    errors = told - rpm
    assert sqrt((errors**2).mean()) == pytest.approx(0.907, abs=0.05)
    assert abs(errors).max() < 2.23


def test_idris_table_5():
    """model.md, check 10: thirty distances rolled by hand, 0.1164 cm a pulse."""
    centimetres = np.arange(10.0, 101.0, 10.0)
    model = with_encoder(pulses_per_turn=270)
    for seed in range(50):
        wheels = Wheels(*[model] * 10, seed=seed)
        pulses = wheels.at((centimetres / 100 / 0.05)[:, None])
        errors = pulses * 0.1164 - centimetres[:, None]
        assert (abs(errors) <= 2 * 0.1164).all()
        assert (abs(errors) / centimetres[:, None]).mean() <= 0.002
        assert set(pulses[-1]) <= {859, 860}


@given(st.integers(0, 60), chances, draws)
@example(60, Fraction(1, 2), 0.0)
@example(60, Fraction(49, 50), 1 - 2**-53)
def test_binomial_is_the_inverse_of_the_exact_distribution(trials, chance, draw):
    hits = binomial(float(trials), float(chance), draw)
    below = sum(comb(trials, k) * chance**k * (1 - chance) ** (trials - k) for k in range(hits + 1))
    here = comb(trials, hits) * chance**hits * (1 - chance) ** (trials - hits)
    assert 0 <= hits <= trials
    assert float(below - here) <= draw + 1e-12
    assert float(below) >= draw - 1e-12


@pytest.mark.parametrize(("trials", "chance"), [(3100, 0.5), (50_000, 0.9), (10**6, 1e-3)])
def test_binomial_of_very_many_edges_does_not_underflow(trials, chance):
    draws = (np.arange(2000) + 0.5) / 2000
    hits = np.array([binomial(float(trials), chance, draw) for draw in draws])
    assert (np.diff(hits) >= 0).all()
    assert hits.mean() == pytest.approx(trials * chance, abs=0.05 * sqrt(trials))
    assert hits.var() == pytest.approx(trials * chance * (1 - chance), rel=0.02)


def test_missed_edges_have_the_binomial_s_mean_and_variance():
    wheels = Wheels(*[with_encoder(pulses_per_turn=100, missed=0.05)] * 100, seed=1)
    passed = 20  # edges a reading
    lost = []
    before = np.zeros((100, 3))
    for reading in range(1, 101):
        counts = wheels.at(2 * pi * passed * reading / 100 + 1e-9)
        lost.append(passed - (counts - before))
        before = counts
    lost = np.array(lost[1:])
    assert lost.min() == 0
    assert lost.mean() == pytest.approx(passed * 0.05, abs=4 * sqrt(0.95 / lost.size))
    assert lost.var() == pytest.approx(passed * 0.05 * 0.95, rel=0.03)
    again = np.corrcoef(lost[:-1].ravel(), lost[1:].ravel())[0, 1]
    assert abs(again) < 4 / sqrt(lost.size)  # one reading knows nothing of the next


@given(shares, st.booleans())
@settings(max_examples=30)
def test_missed_edges_only_ever_shorten_the_way(missed, backwards):
    wheels = Wheels(with_encoder(missed=missed), seed=5)
    sign = -1 if backwards else 1
    counts = [sign * wheels.at(sign * 0.3 * reading).mean() for reading in range(60)]
    edges = 0.3 * 59 / (2 * pi) * 270
    assert (np.diff(counts) >= 0).all()
    assert counts[-1] <= edges + 1
    assert counts[-1] == pytest.approx((1 - missed) * edges, abs=5 * sqrt(edges))


def test_a_dead_encoder_never_counts():
    wheels = Wheels(with_encoder(missed=1.0))
    assert (wheels.at(0.0) == 0).all()
    assert (wheels.at(1000.0) == 0).all()
