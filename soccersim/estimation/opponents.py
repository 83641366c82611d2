"""The opponents a team knows of: tracks that sightings are given to, the nearest one each.

Opponents look alike: which of them a robot sees is not known, only that it sees two of them at
two places.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np

from soccersim.estimation.track import Sighting, blur, see, start
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
    taken: Whole  # (2, M) who gave the track its last sighting: frame * robots + robot
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
        taken=np.full((TEAMS, slots), FREE),
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
def meet(opponents: Opponents, slot: int, tick: int, by: int, sighting: Sighting) -> None:
    """Give a sighting to its track; `by` names frame and robot, which sees nobody twice."""
    x, y = sighting.x, sighting.y
    nearest, least, free = FREE, 0.0, FREE
    for k in range(opponents.most[slot]):
        if opponents.seen[slot, k] == FREE:
            free = k
        elif opponents.taken[slot, k] != by:
            far = _distance(opponents.state[slot, k], x, y)
            if nearest == FREE or far < least:
                nearest, least = k, far
    if nearest != FREE:
        cov = opponents.cov[slot, nearest]
        spread = sqrt(cov[0, 0] + cov[1, 1] + sighting.along + sighting.across)
        if least < GATE + GATE_SD * spread:
            see(opponents.state[slot, nearest], cov, sighting)
            opponents.seen[slot, nearest], opponents.taken[slot, nearest] = tick, by
            return
    if free != FREE:
        variance = max(sighting.along, sighting.across)
        start(opponents.state[slot, free], opponents.cov[slot, free], x, y, variance, UNKNOWN_SPEED)
        opponents.seen[slot, free], opponents.taken[slot, free] = tick, by


@inner
def join(opponents: Opponents, slot: int) -> None:
    """Where two tracks have come to lie on one robot, keep the surer."""
    for k in range(opponents.most[slot]):
        for j in range(k):
            if opponents.seen[slot, k] == FREE or opponents.seen[slot, j] == FREE:
                continue
            state = opponents.state[slot, k]
            if _distance(opponents.state[slot, j], state[0], state[1]) < ONE:
                a, b = opponents.cov[slot, k], opponents.cov[slot, j]
                surer = a[0, 0] + a[1, 1] < b[0, 0] + b[1, 1]
                opponents.seen[slot, j if surer else k] = FREE


@inner
def _distance(state: Array, x: float, y: float) -> float:
    return sqrt((state[0] - x) * (state[0] - x) + (state[1] - y) * (state[1] - y))
