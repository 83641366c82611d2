"""What the referee sees every tick: touches of the ball, the ball over a line, robots that shove.

`watch` runs inside the loop and only notes facts; the judge reads them at every decision.
"""

from itertools import product
from math import sqrt
from typing import NamedTuple

import numpy as np

from soccersim.kernel import inner
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Truth, Whole

TOUCH = 5e-3  # m between surfaces that count as touching: solver and dribbler leave gaps
RELEASE = 0.2  # s without touching after which a robot has let go (ours)
LOG = 64  # touches kept between two decisions: a ball between two robots makes about twenty
NEVER = -(10**9)  # a tick long before the match

GOAL, GOAL_LINE, TOUCH_LINE = 1.0, 2.0, 3.0  # where the ball went out


class Watch(NamedTuple):
    """Facts and the figures that they need; all places in the field frame, m."""

    ball: int  # row in truth.body
    dt: float  # s a tick
    release: int  # ticks
    lines: int  # 1: a ball over a line is out
    half_length: float  # to where the centre of a ball wholly over the goal line is
    half_width: float
    goal: float  # half the width between the posts
    push_limit: float  # m, 0: pushing is not watched
    active: Whole  # (R,)  1: in play; the judge writes it
    reach: Array  # (R,)  distance of centres at which robot and ball touch
    held: Whole  # (R,)  1: its dribbler holds the ball; these two are handling's own arrays
    kicked: Whole  # (R,)  tick of its last kick: the ball need not touch its shell for that
    touched: Whole  # (R,)  tick of the robot's last touch
    caught: Array  # (R, 2)  the robot where its present contact with the ball began
    kicker: Array  # (R, 2)  the robot at its last touch
    latest: Whole  # (1,)  who touched the ball last; -1: nobody
    last: Array  # (2,)  the ball at the last touch
    log: Array  # (LOG, 6)  robot, tick, ball x, y, how far it rolled free, who had it before
    logged: Whole  # (1,)  touches so far; touch k stands in row k % LOG
    out: Array  # (5,)  tick (-1: in play), where it went out, ball x, y, who touched it last
    pairs: Whole  # (P, 2)  robots of home with robots of away
    near: Array  # (P,)  distance of centres at which they touch
    met: Whole  # (P,)  tick of their last contact
    contact: Whole  # (1,)  tick of the last contact of any pair
    shove: Array  # (P,)  m that home shoved away in this contact; negative: away shoved home
    pushed: Array  # (5,)  tick (-1: none), pusher, pushed, x, y of the contact


def build_watch(scenario: Scenario) -> Watch:
    """Nothing seen yet; without a match there is nothing to see."""
    rules, field = scenario.match.rules if scenario.match else None, scenario.field
    ball_radius = scenario.ball.radius if scenario.ball else 0.0
    radius = [player.model.radius for player in scenario.robots]
    sides: dict[str, list[int]] = {"home": [], "away": []}
    for row, player in enumerate(scenario.robots):
        sides[player.team].append(row)
    pairs = [*product(sides["home"], sides["away"])]
    robots, z = len(radius), np.zeros
    return Watch(
        ball=robots,
        dt=scenario.dt,
        release=round(RELEASE / scenario.dt),
        lines=int(rules.lines) if rules else 0,
        half_length=field.half_length + ball_radius,
        half_width=field.half_width + ball_radius,
        goal=field.goal.width / 2,
        push_limit=rules.pushing or 0.0 if rules else 0.0,
        active=np.ones(robots, np.int64),
        reach=np.array(radius) + (ball_radius + TOUCH),
        held=z(robots, np.int64),
        kicked=np.full(robots, NEVER),
        touched=np.full(robots, NEVER),
        caught=z((robots, 2)),
        kicker=z((robots, 2)),
        latest=np.array([-1]),
        last=z(2),
        log=z((LOG, 6)),
        logged=z(1, np.int64),
        out=np.array([-1.0, 0.0, 0.0, 0.0, -1.0]),
        pairs=np.array(pairs, np.int64).reshape(-1, 2),
        near=np.array([radius[i] + radius[j] + TOUCH for i, j in pairs], float),
        met=np.full(len(pairs), NEVER),
        contact=np.array([NEVER]),
        shove=z(len(pairs)),
        pushed=np.array([-1.0, -1.0, -1.0, 0.0, 0.0]),
    )


@inner
def watch(w: Watch, truth: Truth, tick: int) -> None:
    """Note what happened in this tick; after the bodies have moved."""
    see_touches(w, truth, tick)
    if w.out[0] < 0.0:
        see_lines(w, truth, tick)
    if w.push_limit > 0.0:
        see_contacts(w, truth, tick)


@inner
def see_touches(w: Watch, truth: Truth, tick: int) -> None:
    """Who touches the ball: the one who had it keeps it while he touches it."""
    x, y = truth.body[w.ball, 0], truth.body[w.ball, 1]
    latest, holder, least = w.latest[0], -1, 1.0
    again = 0
    for robot in range(w.reach.shape[0]):
        dx, dy, reach = truth.body[robot, 0] - x, truth.body[robot, 1] - y, w.reach[robot]
        gap = dx * dx + dy * dy - reach * reach
        in_mouth = w.held[robot] == 1 or w.kicked[robot] == tick - 1
        if (gap < 0.0 or in_mouth) and w.active[robot] == 1:
            if tick - w.touched[robot] > w.release:
                w.caught[robot, 0], w.caught[robot, 1] = truth.body[robot, 0], truth.body[robot, 1]
                if robot == latest:
                    again = 1
            w.touched[robot] = tick
            w.kicker[robot, 0], w.kicker[robot, 1] = truth.body[robot, 0], truth.body[robot, 1]
            if robot == latest or (holder != latest and gap < least) or holder < 0:
                holder, least = robot, gap
    if holder < 0:
        return
    if holder != latest or again == 1:
        rolled_x, rolled_y = x - w.last[0], y - w.last[1]
        entry = w.logged[0] % LOG
        w.log[entry, 0], w.log[entry, 1] = holder, tick
        w.log[entry, 2], w.log[entry, 3] = x, y
        w.log[entry, 4] = sqrt(rolled_x * rolled_x + rolled_y * rolled_y)
        w.log[entry, 5] = latest
        w.logged[0] += 1
        w.latest[0] = holder
    w.last[0], w.last[1] = x, y


@inner
def see_lines(w: Watch, truth: Truth, tick: int) -> None:
    """Whether the whole ball is over a line, and where."""
    x, y = truth.body[w.ball, 0], truth.body[w.ball, 1]
    kind = 0.0
    if abs(x) > w.half_length:
        if abs(y) < w.goal:
            kind = GOAL
        elif w.lines == 1:
            kind = GOAL_LINE
    elif w.lines == 1 and abs(y) > w.half_width:
        kind = TOUCH_LINE
    if kind > 0.0:
        w.out[0], w.out[1], w.out[2], w.out[3], w.out[4] = tick, kind, x, y, w.latest[0]


@inner
def see_contacts(w: Watch, truth: Truth, tick: int) -> None:
    """How far opponents in contact shove each other: the one who moves into the other pushes."""
    for pair in range(w.near.shape[0]):
        i, j = w.pairs[pair, 0], w.pairs[pair, 1]
        nx, ny = truth.body[j, 0] - truth.body[i, 0], truth.body[j, 1] - truth.body[i, 1]
        near = w.near[pair]
        apart = nx * nx + ny * ny
        if apart >= near * near or w.active[i] == 0 or w.active[j] == 0 or apart == 0.0:
            continue
        if tick - w.met[pair] > w.release:
            w.shove[pair] = 0.0
        w.met[pair] = w.contact[0] = tick
        apart = sqrt(apart)
        home = (truth.body[i, 3] * nx + truth.body[i, 4] * ny) / apart  # m/s towards away
        away = (truth.body[j, 3] * nx + truth.body[j, 4] * ny) / apart
        if home > 0.0 and away > 0.0:
            w.shove[pair] += min(home, away) * w.dt
        elif home < 0.0 and away < 0.0:
            w.shove[pair] += max(home, away) * w.dt
        if w.pushed[0] < 0.0 and abs(w.shove[pair]) > w.push_limit:
            pusher, pushed = (i, j) if w.shove[pair] > 0.0 else (j, i)
            w.pushed[0], w.pushed[1], w.pushed[2] = tick, pusher, pushed
            w.pushed[3] = (truth.body[i, 0] + truth.body[j, 0]) / 2.0
            w.pushed[4] = (truth.body[i, 1] + truth.body[j, 1]) / 2.0
