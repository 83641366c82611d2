"""Where a team believes the ball to be: one track per team, from the sightings of all its robots.

Between sightings the ball rolls out. A ball that turns up where it could not have rolled was
kicked: the track then takes up the new velocity at once instead of slowly.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np

from soccersim.estimation.track import Sighting, blur, far_off, jolt, see, start
from soccersim.kernel import inner
from soccersim.state import Array, Whole

TEAMS = 2
UNSEEN = -1
PLACED = 0.01  # m and m/s, standard deviations of a ball that the referee puts down
UNKNOWN_SPEED = 4.0  # m/s, standard deviation when all that is known is one sighting
KICK_SPEED = 8.0  # m/s, standard deviation of what a kick or a bounce changes
CALM, LIVELY = 0.4, 3.0  # m/s a root second: rolling freely; near a robot or just kicked
NEAR = 0.7  # m from a robot's centre: it may be pushed or held
AFTER_KICK = 0.7  # s of sliding after a kick, that rolling knows nothing of
PLAIN, ODD = 40.0, 14.0  # squared deviations: a kick at once; a kick if the next frame says so too


class BallTracks(NamedTuple):
    """Row HOME, row AWAY."""

    state: Array  # (2, 4) x, y, vx, vy; field frame
    cov: Array  # (2, 4, 4)
    time: Whole  # (2,) tick of the state
    seen: Whole  # (2,) tick of the last sighting; -1: never
    since: Whole  # (2,) frames of this tick and earlier show the ball where it no longer is
    odd: Whole  # (2,) 1: the last frame's sighting was odd
    lively: Whole  # (2,) tick up to which it may still slide
    rolling: float  # m/s2
    tick: float  # s


def build_ball_tracks(rolling: float, dt: float) -> BallTracks:
    """Nobody has seen it."""
    return BallTracks(
        state=np.zeros((TEAMS, 4)),
        cov=np.zeros((TEAMS, 4, 4)),
        time=np.zeros(TEAMS, np.int64),
        seen=np.full(TEAMS, UNSEEN),
        since=np.full(TEAMS, UNSEEN),
        odd=np.zeros(TEAMS, np.int64),
        lively=np.zeros(TEAMS, np.int64),
        rolling=rolling,
        tick=dt,
    )


def put_down(tracks: BallTracks, x: float, y: float, tick: int) -> None:
    """The referee put the ball down for all to see, at rest, after the frame of this tick."""
    tracks.state[:] = (x, y, 0.0, 0.0)
    tracks.cov[:] = PLACED * PLACED * np.eye(4)
    tracks.time[:] = tracks.seen[:] = max(tick, 0)
    tracks.since[:] = tick
    tracks.odd[:] = tracks.lively[:] = 0


@inner
def rolled(state: Array, seconds: float, rolling: float) -> tuple[float, float, float, float]:
    """Where a ball of state (4,) is after rolling on for so long, and how fast."""
    x, y, vx, vy = state[0], state[1], state[2], state[3]
    speed = sqrt(vx * vx + vy * vy)
    if speed == 0.0:
        return x, y, 0.0, 0.0
    left = speed - rolling * seconds
    if left <= 0.0:
        share = 0.5 * speed / rolling  # distance over speed
        return x + share * vx, y + share * vy, 0.0, 0.0
    share, slower = 0.5 * (speed + left) / speed * seconds, left / speed
    return x + share * vx, y + share * vy, slower * vx, slower * vy


@inner
def expect(tracks: BallTracks, slot: int, tick: int, crowded: bool) -> None:
    """Roll a track on to the tick of a frame; crowded: a robot is near the ball."""
    state, seconds = tracks.state[slot], (tick - tracks.time[slot]) * tracks.tick
    lively = crowded or tick < tracks.lively[slot]
    state[0], state[1], state[2], state[3] = rolled(state, seconds, tracks.rolling)
    blur(tracks.cov[slot], seconds, LIVELY if lively else CALM)
    tracks.time[slot] = tick


@inner
def doubt(tracks: BallTracks, slot: int, surest: Sighting, seconds: float) -> None:
    """Look at the surest sighting of a frame before any is taken in: was the ball kicked?

    The frame before was taken so many seconds earlier, and the kick at any time since.
    """
    off = far_off(tracks.state[slot], tracks.cov[slot], surest)
    kicked = off > PLAIN or (off > ODD and tracks.odd[slot] == 1)
    tracks.odd[slot] = 1 if off > ODD and not kicked else 0
    if kicked:
        jolt(tracks.cov[slot], seconds, KICK_SPEED * KICK_SPEED)
        tracks.lively[slot] = tracks.time[slot] + int(AFTER_KICK / tracks.tick)


@inner
def notice(tracks: BallTracks, slot: int, tick: int, sighting: Sighting) -> None:
    """Take in one sighting; the first ever starts the track."""
    state, cov = tracks.state[slot], tracks.cov[slot]
    if tracks.seen[slot] == UNSEEN:
        variance = max(sighting.along, sighting.across)
        start(state, cov, sighting.x, sighting.y, variance, UNKNOWN_SPEED)
        tracks.time[slot] = tick
    else:
        see(state, cov, sighting)
    tracks.seen[slot] = tick
