"""Where a team believes the ball to be: one track per team, from the sightings of all its robots.

Between sightings the ball slides, then rolls out, as in docs/models.md, 3.5. A ball that turns up
where it could not have gone by itself was kicked: the track then takes up the new velocity at once
instead of slowly, and knows that the ball's turning has yet to catch up.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np

from soccersim.estimation.track import Sighting, blur, far_off, jolt, see, start
from soccersim.kernel import inner
from soccersim.state import Array, Whole

TEAMS = 2
UNSEEN = -1
LONG_AGO = -1_000_000_000  # a tick
PLACED = 0.01  # m and m/s, standard deviations of a ball that the referee puts down
UNKNOWN_SPEED = 4.0  # m/s, standard deviation when all that is known is one sighting
KICK_SPEED = 8.0  # m/s, standard deviation of what a kick or a bounce changes
CALM, LIVELY = 0.3, 2.5  # m/s a root second: left alone; near a robot or just kicked (estimates)
NEAR = 0.7  # m from a robot's centre: it may be pushed or held
AFTER_KICK = 0.25  # s in which the velocity is still being found out
PLAIN, ODD = 40.0, 14.0  # squared deviations: a kick at once; a kick if the next frame says so too
GAIN = 1.5  # m/s: a change of velocity that only a kick or a bounce can bring about so fast
FOLLOW = 0.25  # of the way a frame that a rolling ball's turning is taken to follow its velocity
CAUGHT_UP = 0.2  # m/s between velocity and turning: it rolls
FASTEST = 20.0  # m/s: a ball that turns up farther away was carried, not kicked


class BallTracks(NamedTuple):
    """Row HOME, row AWAY."""

    state: Array  # (2, 4) x, y, vx, vy; field frame
    cov: Array  # (2, 4, 4)
    turning: Array  # (2, 2) velocity at which its turning would carry it; field frame
    slides: Whole  # (2,) 1: the turning has not caught up with the velocity
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
        turning=np.zeros((TEAMS, 2)),
        slides=np.zeros(TEAMS, np.int64),
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
    tracks.turning[:] = 0.0
    tracks.slides[:] = tracks.odd[:] = 0
    tracks.time[:] = tracks.seen[:] = max(tick, 0)
    tracks.since[:] = tick
    tracks.kicked[:] = LONG_AGO


@inner
def gone_on(tracks: BallTracks, slot: int, tick: int) -> tuple[float, float, float, float]:
    """Where a team's ball is at a tick, and how fast, if nobody touches it: x, y, vx, vy."""
    state, seconds = tracks.state[slot], (tick - tracks.time[slot]) * tracks.tick
    part, ax, ay = _slide(tracks, slot, seconds)
    x = state[0] + part * (state[2] + 0.5 * part * ax)
    y = state[1] + part * (state[3] + 0.5 * part * ay)
    vx, vy, seconds = state[2] + part * ax, state[3] + part * ay, seconds - part
    speed = sqrt(vx * vx + vy * vy)
    if speed == 0.0:
        return x, y, 0.0, 0.0
    left = speed - tracks.rolling * seconds
    if left > 0.0:
        way, left = 0.5 * (speed + left) * seconds / speed, left / speed
        return x + way * vx, y + way * vy, left * vx, left * vy
    way = 0.5 * speed / tracks.rolling
    return x + way * vx, y + way * vy, 0.0, 0.0


@inner
def _slide(tracks: BallTracks, slot: int, seconds: float) -> tuple[float, float, float]:
    """For how long of the next so many seconds the ball slides, and its acceleration then."""
    if tracks.slides[slot] == 0:
        return 0.0, 0.0, 0.0
    ux = tracks.state[slot, 2] - tracks.turning[slot, 0]
    uy = tracks.state[slot, 3] - tracks.turning[slot, 1]
    slip = sqrt(ux * ux + uy * uy)
    if slip == 0.0:
        return 0.0, 0.0, 0.0
    whole = tracks.shell * slip / (tracks.sliding * (1.0 + tracks.shell))
    return min(whole, seconds), -tracks.sliding * ux / slip, -tracks.sliding * uy / slip


@inner
def expect(tracks: BallTracks, slot: int, tick: int, crowded: bool) -> None:
    """Move a track on to the tick of a frame; crowded: a robot is near the ball."""
    state, seconds = tracks.state[slot], (tick - tracks.time[slot]) * tracks.tick
    part, ax, ay = _slide(tracks, slot, seconds)
    state[0], state[1], state[2], state[3] = gone_on(tracks, slot, tick)
    tracks.turning[slot, 0] -= part * ax / tracks.shell
    tracks.turning[slot, 1] -= part * ay / tracks.shell
    lively = crowded or (tick - tracks.kicked[slot]) * tracks.tick < AFTER_KICK
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
    dx, dy = surest.x - state[0], surest.y - state[1]
    if sqrt(dx * dx + dy * dy) > FASTEST * seconds + sqrt(surest.along + surest.across):
        tracks.seen[slot] = UNSEEN
    else:
        tracks.kicked[slot] = tracks.time[slot]
        jolt(cov, seconds, KICK_SPEED * KICK_SPEED)


@inner
def notice(tracks: BallTracks, slot: int, tick: int, sighting: Sighting) -> None:
    """Take in one sighting; the first ever, or after a jump, starts the track."""
    state, cov = tracks.state[slot], tracks.cov[slot]
    if tracks.seen[slot] == UNSEEN:
        variance = max(sighting.along, sighting.across)
        start(state, cov, sighting.x, sighting.y, variance, UNKNOWN_SPEED)
        tracks.time[slot] = tick
        tracks.turning[slot, 0] = tracks.turning[slot, 1] = 0.0
        tracks.slides[slot] = 0
    else:
        see(state, cov, sighting)
    tracks.seen[slot] = tick


@inner
def settle(tracks: BallTracks, slot: int) -> None:
    """After a frame's sightings: does the ball slide or roll?

    A velocity that has changed a lot was changed by a kick or a bounce, which leave the turning as
    it was. A rolling ball's turning follows its velocity.
    """
    turning = tracks.turning[slot]
    ux, uy = tracks.state[slot, 2] - turning[0], tracks.state[slot, 3] - turning[1]
    slip = ux * ux + uy * uy
    if tracks.slides[slot] == 0 and slip > GAIN * GAIN:
        tracks.slides[slot] = 1
        tracks.kicked[slot] = tracks.time[slot]
    elif slip < CAUGHT_UP * CAUGHT_UP:
        tracks.slides[slot] = 0
    if tracks.slides[slot] == 0:
        turning[0] += FOLLOW * ux
        turning[1] += FOLLOW * uy
