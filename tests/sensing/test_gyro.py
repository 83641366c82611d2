"""A gyro tells the turning rate, a little wrong; its rates summed make the heading drift.

The error model fitted to Idris' Table 1 (model.md, second half of check 17) is not built yet.
"""

from math import degrees, pi, radians, sqrt

import numpy as np
import pytest
from factory import robot
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.sensing.gyro import build_gyros, read_gyros
from soccersim.sensing.noise import NoiseSource
from soccersim.state import new_readings, new_truth

HZ = 100  # ticks a second: a tick is a sample
QUIET = {
    "perfect": False,
    "scale_sd": 0.0,
    "bias_sd_deg_s": 0.0,
    "walk_deg_s_rts": 0.0,
    "noise_deg_s_rthz": 0.0,
    "resolution_deg_s": 0.0,
}


class Turntable:
    """Robots on a turntable, each with a gyro."""

    def __init__(self, model, count=1, start=0.0, seed=0, hz=HZ):
        models = [model] * count
        self.gyros, self.hz = build_gyros(models, hz, seed), hz
        self.source = NoiseSource(models, 3, hz, seed)
        self.truth, self.readings = new_truth(count, count, 3), new_readings(count, 3)
        self.truth.body[:, 2] = start
        self.tick = 0
        self.sample()

    def sample(self):
        self.source.prepare(self.tick, self.tick + 1)
        noise = self.source.noise
        read_gyros(self.gyros, self.readings, self.truth, noise, self.tick, 1 / self.hz)
        self.tick += 1
        return self.readings.gyro.copy()

    def turn(self, *angles):
        """The rates told while the table turns by these angles, one a sample."""
        rates = []
        for angle in angles:
            self.truth.body[:, 2] += angle
            rates.append(self.sample())
        return np.array(rates)

    @property
    def angle(self):
        return self.readings.gyro_angle


def with_gyro(**gyro):
    return robot(gyro={**QUIET, **gyro})


@given(st.lists(st.floats(-0.1, 0.1), min_size=1, max_size=50), st.floats(-10, 10))
@settings(max_examples=50)
def test_a_perfect_gyro_tells_the_turn_exactly(angles, start):
    table = Turntable(robot(), start=start)
    rates = table.turn(*angles)
    assert rates[:, 0] / HZ == pytest.approx(np.array(angles), abs=1e-14)
    assert table.angle[0] == pytest.approx(sum(angles), abs=1e-13)


def test_a_robot_that_starts_turned_has_not_turned():
    table = Turntable(robot(), start=2.0)
    assert (table.readings.gyro[0], table.angle[0]) == (0.0, 0.0)


def test_a_sample_is_the_mean_rate_since_the_last():
    table = Turntable(robot(gyro={"rate_hz": 100}), hz=500)
    told = table.turn(*np.arange(10) * 1e-3)[:, 0]
    assert told[4] == pytest.approx(0.010 * 100)  # 0 + 1 + 2 + 3 + 4 mrad in 10 ms
    assert told[9] == pytest.approx(0.035 * 100)
    assert (told[5:9] == told[4]).all()


def test_heading_of_a_still_robot_after_a_minute():
    """model.md, check 17: noise of density n leaves n sqrt(T / 2) after T seconds."""
    model = with_gyro(noise_deg_s_rthz=0.005, resolution_deg_s=1 / 131)
    table = Turntable(model, count=200, seed=17)
    table.turn(*np.zeros(60 * HZ))
    spread = degrees(table.angle.std())
    assert 0.020 <= spread <= 0.035
    assert spread == pytest.approx(0.005 * sqrt(60 / 2), rel=0.2)
    assert abs(degrees(table.angle.mean())) < 4 * 0.0274 / sqrt(200)


def test_noise_of_a_sample_does_not_depend_on_the_sample_before():
    rates = Turntable(with_gyro(noise_deg_s_rthz=0.005), count=50).turn(*np.zeros(1000))
    assert degrees(rates.std()) == pytest.approx(0.005 * sqrt(HZ / 2), rel=0.02)
    assert abs(np.corrcoef(rates[:-1].ravel(), rates[1:].ravel())[0, 1]) < 0.02
    assert abs(np.corrcoef(rates[:, 0], rates[:, 1])[0, 1]) < 4 / sqrt(1000)


def test_a_scale_error_s_gives_360_s_degrees_a_turn():
    table = Turntable(with_gyro(scale_sd=0.02), count=300)
    scale_errors = table.gyros.scale - 1
    assert scale_errors.std() == pytest.approx(0.02, rel=0.15)
    table.turn(*np.full(500, 2 * pi / 500))
    assert np.degrees(table.angle) - 360 == pytest.approx(360 * scale_errors, abs=1e-9)


def test_what_calibration_leaves_turns_a_still_robot_steadily():
    table = Turntable(with_gyro(bias_deg_s=0.5, bias_sd_deg_s=0.03), count=300)
    table.turn(*np.zeros(10 * HZ))
    drift = np.degrees(table.angle) / 10
    assert drift == pytest.approx(np.degrees(table.gyros.offset))
    assert drift.mean() == pytest.approx(0.5, abs=4 * 0.03 / sqrt(300))
    assert drift.std() == pytest.approx(0.03, rel=0.15)


@pytest.mark.parametrize("rate_hz", [50, 100])
def test_the_offset_walks_by_the_root_of_time(rate_hz):
    model = robot(gyro={**QUIET, "walk_deg_s_rts": 0.01, "rate_hz": rate_hz})
    table = Turntable(model, count=400, seed=2)
    table.turn(*np.zeros(9 * HZ))
    assert np.degrees(table.readings.gyro).std() == pytest.approx(0.01 * sqrt(9), rel=0.12)
    # the heading is the walk's integral: its variance is w2 T3 / 3
    assert np.degrees(table.angle).std() == pytest.approx(0.01 * sqrt(9**3 / 3), rel=0.12)


@given(st.floats(-240, 240), st.floats(1e-3, 2))
@settings(max_examples=60)
def test_rates_come_in_whole_steps_at_most_half_a_step_off(rate, step):
    table = Turntable(with_gyro(resolution_deg_s=step))
    told = np.degrees(table.turn(radians(rate) / HZ))[0, 0]
    assert told / step == pytest.approx(round(told / step), abs=1e-6)
    assert abs(told - rate) <= step / 2 * (1 + 1e-9)


@given(st.floats(-2000, 2000), st.floats(100, 1000))
@settings(max_examples=60)
def test_no_rate_beyond_the_full_scale(rate, full_scale):
    table = Turntable(with_gyro(full_scale_deg_s=full_scale))
    told = np.degrees(table.turn(radians(rate) / HZ))[0, 0]
    assert told == pytest.approx(min(max(rate, -full_scale), full_scale), abs=1e-9)


def test_a_robot_spun_too_fast_loses_its_heading():
    table = Turntable(with_gyro(full_scale_deg_s=250))
    table.turn(*np.full(HZ, radians(300) / HZ))
    assert degrees(table.angle[0]) == pytest.approx(250)
