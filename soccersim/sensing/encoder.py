"""Incremental encoders: whole pulses of each wheel's turning, some of them missed."""

from collections.abc import Sequence
from math import floor, pi
from typing import NamedTuple

import numpy as np

from soccersim.kernel import inner, kernel
from soccersim.sensing.noise import BLOCK, Noise
from soccersim.spec.robot import Robot
from soccersim.state import Array, Readings, Truth, Whole
from soccersim.streams import stream

TURN = 2.0 * pi
FAINT = 1e-18  # of the likeliest outcome: outcomes less likely are left out


class Encoders(NamedTuple):
    """Constants and memory of all encoders; `every` is 0 where a wheel has none."""

    every: Whole  # (R, W) ticks from reading to reading
    edges: Array  # (R, W) counts a turn
    phase: Array  # (R, W) share of a count at which each wheel starts
    perfect: Whole  # (R, W) 1: no whole pulses, the exact angle
    missed: Array  # (R, W) chance that an edge is not counted
    window: Whole  # (R, W) readings over which the speed is told
    passed: Array  # (R, W) edges that have passed, counted or not
    lost: Array  # (R, W) edges not counted, signed
    history: Array  # (R, W, K) counts of the last readings, a ring


def build_encoders(
    robots: Sequence[Robot], wheels: int, physics_hz: int, seed: int
) -> tuple[Encoders, Array]:
    """The encoders of all robots, and the (R, W) radians of one count (0: no encoder)."""
    shape = (len(robots), wheels)
    longest = 1
    z = np.zeros
    every, perfect, window = z(shape, np.int64), z(shape, np.int64), np.ones(shape, np.int64)
    edges, phase, missed = z(shape), z(shape), z(shape)
    for i, robot in enumerate(robots):
        first = 0
        for kind, wheel_set in (("drive", robot.drive), ("dead", robot.dead)):
            at = slice(first, first + (len(wheel_set.azimuth_deg) if wheel_set else 0))
            first = at.stop
            encoder = wheel_set.encoder if wheel_set else None
            if encoder is None:
                continue
            every[i, at] = physics_hz // encoder.rate_hz
            edges[i, at] = encoder.edges_per_turn
            perfect[i, at] = encoder.perfect
            missed[i, at] = 0.0 if encoder.perfect else encoder.missed
            window[i, at] = max(1, round(encoder.window * encoder.rate_hz))
            phase[i, at] = stream(seed, i, f"encoder.{kind}.phase").random(at.stop - at.start)
            longest = max(longest, int(window[i, at].max()))
    per_count = np.where(edges > 0, TURN / np.maximum(edges, 1), 0.0)
    memory = (z(shape), z(shape), z((*shape, longest)))
    return Encoders(every, edges, phase, perfect, missed, window, *memory), per_count


@kernel
def read_encoders(
    encoders: Encoders, readings: Readings, truth: Truth, noise: Noise, tick: int, dt: float
) -> None:
    """Counts and window speeds of the encoders that are due at this tick."""
    for robot in range(encoders.every.shape[0]):
        for wheel in range(encoders.every.shape[1]):
            every = encoders.every[robot, wheel]
            if every == 0 or tick % every != 0:
                continue
            turns = truth.wheel_angle[robot, wheel] / TURN
            counts = turns * encoders.edges[robot, wheel]
            if encoders.perfect[robot, wheel] == 0:
                draw = noise.missed[(tick // every) % BLOCK, robot, wheel]
                passed = floor(counts + encoders.phase[robot, wheel])
                counts = _counted(encoders, robot, wheel, float(passed), draw)
            readings.counts[robot, wheel] = counts
            window = encoders.window[robot, wheel]
            slot = (tick // every) % window
            gained = counts - encoders.history[robot, wheel, slot]
            encoders.history[robot, wheel, slot] = counts
            span = window * every * dt
            speed = gained * TURN / (encoders.edges[robot, wheel] * span)
            readings.wheel_speed[robot, wheel] = speed


@inner
def _counted(encoders: Encoders, robot: int, wheel: int, passed: float, draw: float) -> float:
    """The counter's value: edges that passed, less those missed."""
    new = passed - encoders.passed[robot, wheel]
    encoders.passed[robot, wheel] = passed
    chance = encoders.missed[robot, wheel]
    if chance > 0.0 and new != 0.0:
        missed = float(binomial(abs(new), chance, draw))
        encoders.lost[robot, wheel] += missed if new > 0.0 else -missed
    return float(passed - encoders.lost[robot, wheel])


@kernel
def binomial(trials: float, chance: float, draw: float) -> int:
    """How many of the trials happen, from one uniform draw: the inverse of the distribution.

    Probabilities stand here as multiples of the likeliest one's: nothing underflows.
    """
    if chance >= 1.0:
        return int(trials)
    odds = chance / (1.0 - chance)
    likeliest = min(floor((trials + 1.0) * chance), trials)
    total = weight = 1.0
    hits = float(likeliest)
    while hits < trials and weight > FAINT:
        weight *= (trials - hits) / (hits + 1.0) * odds
        hits += 1.0
        total += weight
    weight, hits = 1.0, float(likeliest)
    while hits > 0.0 and weight > FAINT:
        weight *= hits / ((trials - hits + 1.0) * odds)
        hits -= 1.0
        total += weight
    below = weight
    while below <= draw * total and hits < trials:
        weight *= (trials - hits) / (hits + 1.0) * odds
        hits += 1.0
        below += weight
    return int(hits)
