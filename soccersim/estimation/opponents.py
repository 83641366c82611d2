"""The opponents a team knows of: tracks that sightings are given to, the nearest one each.

Opponents look alike: which of them a robot sees is not known, only that it sees two of them at
two places.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np

from soccersim.estimation.track import Sighting, blur, see, sighting_of, start
from soccersim.kernel import inner
from soccersim.state import Array, Whole

TEAMS = 2
FREE = -1
MEMORY = 1.0  # s after which an opponent that nobody sees is forgotten (as Falcons')
UNKNOWN_SPEED = 1.5  # m/s, standard deviation of an opponent's velocity at first sight
WANDER = 1.2  # m/s a root second: opponents change their minds (estimate)
GATE = 0.5  # m: a sighting within it, and GATE_SD deviations, is of the same robot
GATE_SD = 3.0
ONE = 0.3  # m: two tracks this near are one robot; two robots' shells keep 0.4 m apart or more


class Opponents(NamedTuple):
    """Row HOME, row AWAY; M is the most opponents a team has."""

    state: Array  # (2, M, 4) x, y, vx, vy; field frame
    cov: Array  # (2, M, 4, 4)
    seen: Whole  # (2, M) tick of the last sighting; -1: no track here
    given: Whole  # (2, M) bit i: robot i gave the track a sighting of the last frame
    time: Whole  # (2,) tick of the states
    since: Whole  # (2,) frames of this tick and earlier show robots where they no longer are
    most: Whole  # (2,) how many opponents there are
    memory: int  # ticks after which one that is not seen is forgotten
    tick: float  # s


def build_opponents(counts: tuple[int, int], dt: float) -> Opponents:
    """Nobody seen; counts are how many opponents HOME and AWAY have."""
    slots = max(*counts, 1)
    return Opponents(
        state=np.zeros((TEAMS, slots, 4)),
        cov=np.zeros((TEAMS, slots, 4, 4)),
        seen=np.full((TEAMS, slots), FREE),
        given=np.zeros((TEAMS, slots), np.int64),
        time=np.zeros(TEAMS, np.int64),
        since=np.full(TEAMS, FREE),
        most=np.array(counts, np.int64),
        memory=round(MEMORY / dt),
        tick=dt,
    )


@inner
def drive_on(opponents: Opponents, slot: int, tick: int) -> None:
    """Move all tracks of a team on to the tick of a frame; forget the ones long unseen."""
    seconds = (tick - opponents.time[slot]) * opponents.tick
    opponents.time[slot] = tick
    for k in range(opponents.most[slot]):
        opponents.given[slot, k] = 0
        if opponents.seen[slot, k] == FREE:
            continue
        if tick - opponents.seen[slot, k] > opponents.memory:
            opponents.seen[slot, k] = FREE
            continue
        state = opponents.state[slot, k]
        state[0] += seconds * state[2]
        state[1] += seconds * state[3]
        blur(opponents.cov[slot, k], seconds, WANDER)


@inner
def meet(opponents: Opponents, slot: int, tick: int, robot: int, sights: Array, count: int) -> None:
    """Give a robot's sightings of one frame to the tracks, the nearest pair first.

    sights (S, 6) are as Sighting has them, count how many of them; the robot sees nobody twice.
    """
    left = count
    while left > 0:
        at, track = _nearest(opponents, slot, robot, sights, left)
        if at == FREE:
            break
        see(opponents.state[slot, track], opponents.cov[slot, track], sighting_of(sights[at]))
        _mark(opponents, slot, track, robot, tick)
        left -= 1
        for k in range(sights.shape[1]):
            sights[at, k] = sights[left, k]
    for at in range(left):
        _start_track(opponents, slot, tick, robot, sighting_of(sights[at]))


@inner
def _nearest(
    opponents: Opponents, slot: int, robot: int, sights: Array, left: int
) -> tuple[int, int]:
    """The sighting and the track that lie nearest together, if near enough to be one; else FREE."""
    best, track, least = FREE, FREE, 0.0
    for k in range(opponents.most[slot]):
        if opponents.seen[slot, k] == FREE or opponents.given[slot, k] >> robot & 1:
            continue
        cov = opponents.cov[slot, k]
        for at in range(left):
            far = _distance(opponents.state[slot, k], sights[at, 0], sights[at, 1])
            spread = sqrt(cov[0, 0] + cov[1, 1] + sights[at, 4] + sights[at, 5])
            if far < GATE + GATE_SD * spread and (best == FREE or far < least):
                best, track, least = at, k, far
    return best, track


@inner
def _start_track(
    opponents: Opponents, slot: int, tick: int, robot: int, sighting: Sighting
) -> None:
    """Somebody new, if any track is free."""
    for k in range(opponents.most[slot]):
        if opponents.seen[slot, k] == FREE:
            state, cov = opponents.state[slot, k], opponents.cov[slot, k]
            variance = max(sighting.along, sighting.across)
            start(state, cov, sighting.x, sighting.y, variance, UNKNOWN_SPEED)
            opponents.given[slot, k] = 0
            _mark(opponents, slot, k, robot, tick)
            return


@inner
def _mark(opponents: Opponents, slot: int, track: int, robot: int, tick: int) -> None:
    opponents.given[slot, track] |= 1 << robot
    opponents.seen[slot, track] = tick


@inner
def join(opponents: Opponents, slot: int) -> None:
    """Where two tracks have come to lie on one robot, keep the surer.

    They are two robots all the same if somebody has seen both in this frame.
    """
    for k in range(opponents.most[slot]):
        for j in range(k):
            if opponents.seen[slot, k] == FREE or opponents.seen[slot, j] == FREE:
                continue
            if opponents.given[slot, k] & opponents.given[slot, j]:
                continue
            state = opponents.state[slot, k]
            if _distance(opponents.state[slot, j], state[0], state[1]) < ONE:
                a, b = opponents.cov[slot, k], opponents.cov[slot, j]
                surer = a[0, 0] + a[1, 1] < b[0, 0] + b[1, 1]
                opponents.seen[slot, j if surer else k] = FREE


@inner
def _distance(state: Array, x: float, y: float) -> float:
    return sqrt((state[0] - x) * (state[0] - x) + (state[1] - y) * (state[1] - y))
