"""Who played the ball in a match, told from its recording: touches, kicks, who had it last.

A recording shows the ball every 20 ms or so. A robot touches it where their shells meet in a
record, where its contact sensor says so, where it kicks, and where the ball changes its velocity
between two records with the robot within reach. What is shorter and softer goes unseen; a ball
that comes off a post beside a robot may be taken for touched.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from soccersim.record.recording import Recording
from soccersim.sheet import PHASES

NEAR = 0.01  # m between shells that count as touching: gaps of the solver, rounded places
HIT = 0.3  # m/s by which a velocity changes between two records when something is hit
PLAY = PHASES.index("play")
RESTARTS = range(PHASES.index("kick_off"), PLAY)

Array = NDArray[Any]


class Touch(NamedTuple):
    """A robot has got the ball."""

    record: int
    robot: int  # row
    before: int  # the robot that had it before; -1: nobody since START
    left: int  # record in which that one touched it last


class Kick(NamedTuple):
    """A kicker fired with the ball before it."""

    tick: int
    record: int  # the first that shows the ball on its way
    robot: int  # row
    x: float  # the ball in that record, m and m/s; field frame
    y: float
    vx: float
    vy: float


@dataclass(frozen=True)
class BallPlay:
    """What was done with the ball in a match of T records, R robots and D decisions."""

    recording: Recording

    @cached_property
    def decision(self) -> Array:
        """(T,) int: the last decision at each record."""
        ticks = self.recording.arrays["decision_tick"]
        last: Array = np.searchsorted(ticks, self.recording.tick, side="right") - 1
        return last.clip(0)

    @cached_property
    def live(self) -> Array:
        """(T,) bool: the ball may be played: it is in play, or START was given for a restart."""
        arrays = self.recording.arrays
        phase = arrays["phase"]
        started = (arrays["started"] == 1) & (phase >= RESTARTS[0]) & (phase < PLAY)
        return self.at_records((phase == PLAY) | started)

    @cached_property
    def kicks(self) -> list[Kick]:
        """In order of time; one in the very last tick of a match is not known."""
        kicked, tick = self.recording.arrays["kicked"], self.recording.tick
        if len(kicked) < 2 or len(tick) == 0:
            return []
        fired = np.diff(kicked, axis=0) != 0
        found = []
        for decision, robot in np.argwhere(fired).tolist():
            at = int(kicked[decision + 1, robot])
            record = int(np.searchsorted(tick, at + 1))
            if at >= 0 and record < len(tick):
                x, y, _, vx, vy, _ = self.ball[record].tolist()
                found.append(Kick(at, record, robot, x, y, vx, vy))
        return sorted(found)

    @cached_property
    def touches(self) -> list[Touch]:
        """Whenever the ball changes from one robot to another, or gets a first one after START."""
        return self._story[0]

    @cached_property
    def holder(self) -> Array:
        """(T,) int: who touched the ball last since START, by row; -1: nobody."""
        return np.array(self._story[1], int)

    @property
    def ball(self) -> Array:
        """(T, 6): as Recording.ball."""
        ball = self.recording.ball
        return np.zeros((len(self.recording.tick), 6)) if ball is None else ball

    @cached_property
    def sides(self) -> list[int]:
        """Of each robot: 0 home, 1 away."""
        return [int(player.team == "away") for player in self.recording.scenario.robots]

    def at_records(self, rows: Array) -> Array:
        """Rows of decisions (D, ...), each repeated for the records up to the next (T, ...)."""
        found: Array = rows[self.decision] if len(rows) else rows
        return found

    @cached_property
    def _touching(self) -> Array:
        """(T, R) bool."""
        scenario, body = self.recording.scenario, self.recording.body
        if len(body) == 0 or scenario.ball is None:
            return np.zeros((len(body), len(self.sides)), bool)
        radius = np.array([player.model.radius for player in scenario.robots])
        away = body[:, : len(radius), :2] - self.ball[:, None, :2]
        gap = np.hypot(away[..., 0], away[..., 1]) - radius - scenario.ball.radius
        touching: Array = (gap < NEAR) | (self.at_records(self.recording.arrays["contact"]) == 1)
        self._add_hits(touching, gap)
        for kick in self.kicks:
            touching[kick.record] = False
            touching[kick.record, kick.robot] = True
        return touching

    def _add_hits(self, touching: Array, gap: Array) -> None:
        """Add touches between two records, which only the ball's velocity tells."""
        velocity, dt = self.ball[:, 3:5], np.diff(self.recording.time)
        change = np.hypot(*np.diff(velocity, axis=0).T)
        speed = np.hypot(*velocity.T)
        farthest = np.maximum(speed[1:], speed[:-1]) * dt + NEAR
        nearest = np.minimum(gap[1:], gap[:-1])
        robot = nearest.argmin(axis=1)
        hit = (change > HIT) & (nearest.min(axis=1) < farthest) & ~touching[1:].any(axis=1)
        record = np.nonzero(hit)[0]
        touching[record + 1, robot[record]] = True

    @cached_property
    def _story(self) -> tuple[list[Touch], list[int]]:
        """Who of several that touch has the ball: who had it before, else the first of them."""
        touches, holders = [], []
        holder, last = -1, 0
        moments = np.stack((self.live, self._touching.any(axis=1)), axis=1)
        for record, (live, any_one) in enumerate(moments.tolist()):
            if not live:
                holder = -1
            elif any_one:
                row = self._touching[record]
                if holder < 0 or not row[holder]:
                    robot = int(row.argmax())
                    touches.append(Touch(record, robot, holder, last))
                    holder = robot
                last = record
            holders.append(holder)
        return touches, holders
