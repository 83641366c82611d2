"""A rate gyro: scale error, offset that wanders, white noise, steps and a full scale."""

from collections.abc import Sequence
from math import floor, radians, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.kernel import kernel
from soccersim.sensing.noise import BLOCK, Noise
from soccersim.spec.robot import Robot
from soccersim.state import Array, Readings, Truth, Whole
from soccersim.streams import stream


class Gyros(NamedTuple):
    """Constants and memory of all gyros; `every` is 0 where a robot has none."""

    every: Whole  # (R,) ticks from sample to sample
    scale: Array  # (R,) 1 + relative error
    white: Array  # (R,) rad/s, standard deviation of a sample
    walk: Array  # (R,) rad/s, standard deviation of the offset's step from sample to sample
    step: Array  # (R,) rad/s of one output step; 0: continuous
    full_scale: Array  # (R,) rad/s
    offset: Array  # (R,) rad/s, wanders
    heading: Array  # (R,) rad, true heading at the last sample


def build_gyros(robots: Sequence[Robot], physics_hz: int, seed: int) -> Gyros:
    """The gyros of all robots, each with its own scale error and offset drawn."""
    count = len(robots)
    gyros = Gyros(np.zeros(count, np.int64), np.ones(count), *(np.zeros(count) for _ in range(6)))
    gyros.full_scale[:] = np.inf
    for i, robot in enumerate(robots):
        spec = robot.gyro
        if spec is None:
            continue
        gyros.every[i] = physics_hz // spec.rate_hz
        if spec.perfect:
            continue
        scale, offset = stream(seed, i, "gyro.build").standard_normal(2)
        gyros.scale[i] = 1.0 + spec.scale_sd * scale
        gyros.offset[i] = radians(spec.bias_deg_s + spec.bias_sd_deg_s * offset)
        # a one-sided density n sampled at f has a standard deviation of n sqrt(f / 2)
        gyros.white[i] = radians(spec.noise_deg_s_rthz) * sqrt(spec.rate_hz / 2)
        gyros.walk[i] = radians(spec.walk_deg_s_rts) / sqrt(spec.rate_hz)
        gyros.step[i] = radians(spec.resolution_deg_s)
        gyros.full_scale[i] = radians(spec.full_scale_deg_s)
    return gyros


@kernel
def read_gyros(
    gyros: Gyros, readings: Readings, truth: Truth, noise: Noise, tick: int, dt: float
) -> None:
    """Rate, and the angle the robot sums from it, of the gyros that are due at this tick.

    A sample is the mean rate since the last one, as behind the chip's low-pass filter.
    """
    for robot in range(gyros.every.shape[0]):
        every = gyros.every[robot]
        if every == 0 or tick % every != 0:
            continue
        span = every * dt
        heading = truth.body[robot, 2]
        rate = (heading - gyros.heading[robot]) / span if tick > 0 else 0.0
        gyros.heading[robot] = heading
        row = (tick // every) % BLOCK
        gyros.offset[robot] += gyros.walk[robot] * noise.gyro_walk[row, robot]
        rate = gyros.scale[robot] * rate + gyros.offset[robot]
        rate += gyros.white[robot] * noise.gyro_white[row, robot]
        step = gyros.step[robot]
        if step > 0.0:
            rate = floor(rate / step + 0.5) * step
        rate = min(max(rate, -gyros.full_scale[robot]), gyros.full_scale[robot])
        readings.gyro[robot] = rate
        if tick > 0:
            readings.gyro_angle[robot] += rate * span
