"""Noise drawn in blocks ahead of the loop, one stream per robot and cause."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from soccersim.spec.robot import Robot
from soccersim.state import Array, Whole
from soccersim.streams import stream

BLOCK = 512  # samples drawn at once


class Noise(NamedTuple):
    """Numbers for the next samples; sample n of a sensor, or kick n, uses row n % BLOCK."""

    gyro_white: Array  # (BLOCK, R) standard normal
    gyro_walk: Array  # (BLOCK, R) standard normal
    missed: Array  # (BLOCK, R, W) uniform in [0, 1)
    kick: Array  # (BLOCK, R, 2) standard normal: of the speed, of the direction


@dataclass
class _KickSource:
    """One robot's kicks: they come when they come, so rows are drawn anew as they are used up."""

    generator: np.random.Generator
    rows: Array  # (BLOCK, 2) a view into Noise
    robot: int
    every: int  # ticks from kick to kick at least
    drawn: int = 0  # rows so far

    def prepare(self, kicks: int) -> None:
        """Have the rows of the next BLOCK kicks after so many."""
        new = np.arange(self.drawn, kicks + BLOCK)
        self.rows[new % BLOCK] = self.generator.standard_normal((len(new), 2))
        self.drawn = kicks + BLOCK


@dataclass
class _Source:
    """One stream and the columns it fills, a block for every BLOCK samples."""

    draw: Callable[[tuple[int, ...]], Array]
    columns: Array  # (BLOCK, ...) a view into Noise
    every: int  # ticks from sample to sample
    drawn: int = 0  # blocks so far


class NoiseSource:
    """Keeps the blocks filled; what is drawn does not depend on how a run is cut into pieces.

    kicks (R,) is how often each robot has kicked: the plant counts there while the run goes on.
    """

    def __init__(
        self,
        robots: Sequence[Robot],
        wheels: int,
        physics_hz: int,
        seed: int,
        kicks: Whole | None = None,
    ) -> None:
        count = len(robots)
        self.noise = Noise(
            np.zeros((BLOCK, count)),
            np.zeros((BLOCK, count)),
            np.zeros((BLOCK, count, wheels)),
            np.zeros((BLOCK, count, 2)),
        )
        self._kicks = np.zeros(count, np.int64) if kicks is None else kicks
        self._sources: list[_Source] = []
        self._kick_sources: list[_KickSource] = []
        for i, robot in enumerate(robots):
            if robot.kicker:
                every = max(1, round(robot.kicker.recharge * physics_hz))
                rows, generator = self.noise.kick[:, i], stream(seed, i, "kick")
                self._kick_sources.append(_KickSource(generator, rows, i, every))
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
        for kicker in self._kick_sources:
            kicker.prepare(int(self._kicks[kicker.robot]))
            end = min(end, tick + BLOCK * kicker.every)
        return end
