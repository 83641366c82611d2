"""A keeper's arm: stretch to the side where a shot will pass, for as long as the league allows."""

from typing import NamedTuple

import numpy as np

from soccersim.control.reach import ReachProgress, set_out
from soccersim.geometry import rotate
from soccersim.kernel import inner
from soccersim.spec.scenario import Scenario
from soccersim.state import LINKS, Array, Whole


class Guard(NamedTuple):
    """Postures, bounds and memory of the arms that guard; `robot` is -1 for the others."""

    robot: Whole  # (A,) row of the keeper
    folded: Array  # (A, 3) joint angles, rad
    stretched: Array  # (A, 3) to block on the left; the right is its mirror
    body: Array  # (A,) m to each side that the robot covers by itself
    covers: Array  # (A,) m to the side that the stretched arm covers
    sees: Array  # (A,) s ahead
    longest: Whole  # (A,) ticks stretched at most, the way out and back included
    rest: Whole  # (A,) ticks folded after that
    until: Whole  # (A,) tick at which to fold; -1: folded
    free: Whole  # (A,) tick from which it may stretch again


def build_guard(scenario: Scenario) -> Guard:
    """The guards of a scenario."""
    count, hz = len(scenario.arms), scenario.timing.physics_hz
    names = [player.name for player in scenario.robots]
    guard = Guard(
        robot=np.full(count, -1, np.int64),
        folded=np.zeros((count, LINKS)),
        stretched=np.zeros((count, LINKS)),
        body=np.zeros(count),
        covers=np.zeros(count),
        sees=np.zeros(count),
        longest=np.zeros(count, np.int64),
        rest=np.zeros(count, np.int64),
        until=np.full(count, -1, np.int64),
        free=np.zeros(count, np.int64),
    )
    for i, arm in enumerate(scenario.arms):
        spec = arm.guard
        if spec is None or arm.on is None:
            continue
        guard.robot[i] = names.index(arm.on)
        guard.folded[i], guard.stretched[i] = np.radians(spec.folded), np.radians(spec.stretched)
        guard.body[i], guard.covers[i], guard.sees[i] = spec.body, spec.covers, spec.sees
        guard.longest[i], guard.rest[i] = round(spec.longest * hz), round(spec.rest * hz)
    return guard


@inner
def keep(guard: Guard, progress: ReachProgress, pose: Array, ball: Array, tick: int) -> None:
    """Stretch or fold the guarding arms.

    pose (R, 3) is where the robots believe to be, ball (4,) x, y, vx, vy as they see it, both in
    the field frame. Folding begins early enough that the arm is back within its time.
    """
    for arm in range(guard.robot.shape[0]):
        robot = guard.robot[arm]
        if robot < 0:
            continue
        if guard.until[arm] >= 0:
            if tick >= guard.until[arm]:
                _go(progress, arm, guard.folded, 1.0, tick)
                guard.until[arm] = -1
                guard.free[arm] = tick + guard.rest[arm]
            continue
        if tick < guard.free[arm]:
            continue
        side = _threat(guard, pose, ball, arm, robot)
        if side != 0.0:
            _go(progress, arm, guard.stretched, side, tick)
            guard.until[arm] = tick + guard.longest[arm]


@inner
def _threat(guard: Guard, pose: Array, ball: Array, arm: int, robot: int) -> float:
    """1 or -1: a shot passes on the left or right, beyond the body and within the arm; else 0."""
    heading = pose[robot, 2]
    x, y = rotate(ball[0] - pose[robot, 0], ball[1] - pose[robot, 1], -heading)  # field to body
    vx, vy = rotate(ball[2], ball[3], -heading)
    if vx > -0.5 or x < 0.0 or x > -vx * guard.sees[arm]:
        return 0.0
    passes = y - vy * x / vx
    if abs(passes) < guard.body[arm] or abs(passes) > guard.covers[arm]:
        return 0.0
    return 1.0 if passes > 0.0 else -1.0


@inner
def _go(progress: ReachProgress, arm: int, posture: Array, side: float, tick: int) -> None:
    """Send the arm to a posture, mirrored for the right."""
    for joint in range(LINKS):
        progress.target[arm, joint] = side * posture[arm, joint]
    set_out(progress, arm, tick)
