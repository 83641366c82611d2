"""Where a team believes the ball to be: one track per team, from the sightings of all its robots.

Between sightings the ball rolls out. A ball that turns up where it could not have rolled was
kicked: the track then takes up the new velocity at once instead of slowly, and reckons with the
ball's sliding before it rolls.
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
CALM, LIVELY = 0.3, 2.5  # m/s a root second: left alone; near a robot or just kicked (estimates)
NEAR = 0.7  # m from a robot's centre: it may be pushed or held
AFTER_KICK = 0.2  # s in which a kick may still be going on
FASTEST = 20.0  # m/s: a ball that turns up farther away was carried, not kicked
LONG_AGO = -1_000_000_000  # a tick
PLAIN, ODD = 40.0, 14.0  # squared deviations: a kick at once; a kick if the next frame says so too


class BallTracks(NamedTuple):
    """Row HOME, row AWAY."""

    state: Array  # (2, 4) x, y, vx, vy; field frame
    cov: Array  # (2, 4, 4)
    time: Whole  # (2,) tick of the state
    seen: Whole  # (2,) tick of the last sighting; -1: never
    since: Whole  # (2,) frames of this tick and earlier show the ball where it no longer is
    odd: Whole  # (2,) 1: the last frame's sighting was odd
    kicked: Whole  # (2,) tick of the frame that showed the last kick
    rolling: float  # m/s2, deceleration of a rolling ball
    sliding: float  # m/s2, of a sliding one
    shell: float  # moment of inertia over m r2
    tick: float  # s


def build_ball_tracks(rolling: float, sliding: float, shell: float, dt: float) -> BallTracks:
    """Nobody has seen it; the rest is as in BallTracks."""
    return BallTracks(
        state=np.zeros((TEAMS, 4)),
        cov=np.zeros((TEAMS, 4, 4)),
        time=np.zeros(TEAMS, np.int64),
        seen=np.full(TEAMS, UNSEEN),
        since=np.full(TEAMS, UNSEEN),
        odd=np.zeros(TEAMS, np.int64),
        kicked=np.full(TEAMS, LONG_AGO),
        rolling=rolling,
        sliding=sliding,
        shell=shell,
        tick=dt,
    )


def put_down(tracks: BallTracks, x: float, y: float, tick: int) -> None:
    """The referee put the ball down for all to see, at rest, after the frame of this tick."""
    tracks.state[:] = (x, y, 0.0, 0.0)
    tracks.cov[:] = PLACED * PLACED * np.eye(4)
    tracks.time[:] = tracks.seen[:] = max(tick, 0)
    tracks.since[:] = tick
    tracks.odd[:] = 0
    tracks.kicked[:] = LONG_AGO


@inner
def gone_on(tracks: BallTracks, slot: int, tick: int) -> tuple[float, float, float, float]:
    """Where a team's ball is at a tick, and how fast, if nobody touches it: x, y, vx, vy.

    It slows down by sliding as long as its turning has not caught up since the kick.
    """
    state, seconds = tracks.state[slot], (tick - tracks.time[slot]) * tracks.tick
    x, y, vx, vy = state[0], state[1], state[2], state[3]
    speed = sqrt(vx * vx + vy * vy)
    if speed == 0.0:
        return x, y, 0.0, 0.0
    way, left = 0.0, speed
    since = (tracks.time[slot] - tracks.kicked[slot]) * tracks.tick
    slides = (tracks.shell * speed / tracks.sliding - since) / (1.0 + tracks.shell)
    if slides > 0.0:
        part = min(slides, seconds)
        left = speed - tracks.sliding * part
        way, seconds = 0.5 * (speed + left) * part, seconds - part
    if left > tracks.rolling * seconds:
        way += seconds * (left - 0.5 * tracks.rolling * seconds)
        left -= tracks.rolling * seconds
    else:
        way, left = way + 0.5 * left * left / tracks.rolling, 0.0
    return x + way / speed * vx, y + way / speed * vy, left / speed * vx, left / speed * vy


@inner
def expect(tracks: BallTracks, slot: int, tick: int, crowded: bool) -> None:
    """Roll a track on to the tick of a frame; crowded: a robot is near the ball."""
    state, seconds = tracks.state[slot], (tick - tracks.time[slot]) * tracks.tick
    lively = crowded or (tick - tracks.kicked[slot]) * tracks.tick < AFTER_KICK
    state[0], state[1], state[2], state[3] = gone_on(tracks, slot, tick)
    blur(tracks.cov[slot], seconds, LIVELY if lively else CALM)
    tracks.time[slot] = tick


@inner
def doubt(tracks: BallTracks, slot: int, surest: Sighting, seconds: float) -> None:
    """Look at the surest sighting of a frame before any is taken in: was the ball kicked?

    The frame before was taken so many seconds earlier, and the kick at any time since.
    """
    state, cov = tracks.state[slot], tracks.cov[slot]
    off = far_off(state, cov, surest)
    kicked = off > PLAIN or (off > ODD and tracks.odd[slot] == 1)
    tracks.odd[slot] = 1 if off > ODD and not kicked else 0
    if not kicked:
        return
    tracks.kicked[slot] = tracks.time[slot]
    dx, dy = surest.x - state[0], surest.y - state[1]
    if sqrt(dx * dx + dy * dy) > FASTEST * seconds + sqrt(surest.along + surest.across):
        tracks.seen[slot] = UNSEEN
    else:
        jolt(cov, seconds, KICK_SPEED * KICK_SPEED)


@inner
def notice(tracks: BallTracks, slot: int, tick: int, sighting: Sighting) -> None:
    """Take in one sighting; the first ever, or after a jump, starts the track."""
    state, cov = tracks.state[slot], tracks.cov[slot]
    if tracks.seen[slot] == UNSEEN:
        variance = max(sighting.along, sighting.across)
        start(state, cov, sighting.x, sighting.y, variance, UNKNOWN_SPEED)
        tracks.time[slot] = tick
    else:
        see(state, cov, sighting)
    tracks.seen[slot] = tick
