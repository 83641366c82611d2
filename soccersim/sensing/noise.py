"""Noise drawn in blocks ahead of the loop, one stream per robot and cause."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from soccersim.spec.robot import Robot
from soccersim.state import Array
from soccersim.streams import stream

BLOCK = 512  # samples drawn at once


class Noise(NamedTuple):
    """Numbers for the next samples; sample n of a sensor uses row n % BLOCK."""

    gyro_white: Array  # (BLOCK, R) standard normal
    gyro_walk: Array  # (BLOCK, R) standard normal
    missed: Array  # (BLOCK, R, W) uniform in [0, 1)


@dataclass
class _Source:
    """One stream and the columns it fills, a block for every BLOCK samples."""

    draw: Callable[[tuple[int, ...]], Array]
    columns: Array  # (BLOCK, ...) a view into Noise
    every: int  # ticks from sample to sample
    drawn: int = 0  # blocks so far


class NoiseSource:
    """Keeps the blocks filled; what is drawn does not depend on how a run is cut into pieces."""

    def __init__(self, robots: Sequence[Robot], wheels: int, physics_hz: int, seed: int) -> None:
        count = len(robots)
        self.noise = Noise(
            np.zeros((BLOCK, count)), np.zeros((BLOCK, count)), np.zeros((BLOCK, count, wheels))
        )
        self._sources: list[_Source] = []
        for i, robot in enumerate(robots):
            if robot.gyro and not robot.gyro.perfect:
                every = physics_hz // robot.gyro.rate_hz
                for name, columns in (
                    ("white", self.noise.gyro_white[:, i]),
                    ("walk", self.noise.gyro_walk[:, i]),
                ):
                    normal = stream(seed, i, f"gyro.{name}").standard_normal
                    self._sources.append(_Source(normal, columns, every))
            first = 0
            for kind, wheel_set in (("drive", robot.drive), ("dead", robot.dead)):
                last = first + (len(wheel_set.azimuth_deg) if wheel_set else 0)
                encoder = wheel_set.encoder if wheel_set else None
                if encoder and encoder.missed:
                    uniform = stream(seed, i, f"encoder.{kind}").random
                    columns = self.noise.missed[:, i, first:last]
                    self._sources.append(_Source(uniform, columns, physics_hz // encoder.rate_hz))
                first = last

    def prepare(self, tick: int, end: int) -> int:
        """Draw what is needed from this tick on; returns the tick up to which it lasts, or end."""
        for source in self._sources:
            block = -(-tick // source.every) // BLOCK
            while source.drawn <= block:
                source.columns[:] = source.draw(source.columns.shape)
                source.drawn += 1
            end = min(end, (block + 1) * BLOCK * source.every)
        return end
