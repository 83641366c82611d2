"""What arms shall reach: inverse kinematics ahead, a profile for all joints at once, joint PIDs."""

from math import cos, degrees, radians
from typing import NamedTuple

import numpy as np

from soccersim.control.profile import profile_at, profile_time
from soccersim.kernel import inner
from soccersim.kinematics import PlanarArm
from soccersim.spec.arm import Arm, Reach
from soccersim.spec.scenario import Scenario
from soccersim.state import LINKS, Array, Whole

TURN = 360.0


class ReachPlan(NamedTuple):
    """Goals and gains of A arms, T goals at most."""

    goals: Whole  # (A,) how many
    goal: Array  # (A, T, 3) joint angles, rad
    hold: Whole  # (A, T) ticks
    limits: Array  # (A, 2) rad/s and rad/s2 of the joint that turns farthest
    gains: Array  # (A, 3) kp 1/s2, ki 1/s3, kd 1/s, of every joint
    mass: Array  # (A, 3) kg of the links
    length: Array  # (A, 3) m
    torque: Array  # (A,) N m at most


class ReachProgress(NamedTuple):
    """Where each arm is in its plan."""

    at: Whole  # (A,) goal it is on; equal to `goals` when it is through
    since: Whole  # (A,) tick at which it set out; -1: not yet
    ended: Whole  # (A,) goal whose hold ended in this tick, or -1
    start: Array  # (A, 3) joint angles it set out from
    target: Array  # (A, 3) joint angles it goes to
    sums: Array  # (A, 3) integrals of the error, rad s
    wanted: Array  # (A, 3) angular acceleration asked of the joints, rad/s2
    torque: Array  # (A, 3) asked for, N m
    reference: Array  # (A, 3) rad


def build_reach(scenario: Scenario) -> tuple[ReachPlan, ReachProgress]:
    """The plan of every arm, its inverse kinematics solved."""
    arms = scenario.arms
    count, most = len(arms), max([1, *(len(arm.reaches) for arm in arms)])
    goal, hold = np.zeros((count, most, LINKS)), np.zeros((count, most), np.int64)
    start = np.array([np.radians(arm.start_deg) for arm in arms]).reshape(count, LINKS)
    for i, arm in enumerate(arms):
        here = tuple(start[i])
        for k, reach in enumerate(arm.reaches):
            here = goal[i, k] = solution(scenario, arm, reach, here)
            hold[i, k] = round(reach.hold * scenario.timing.physics_hz)
    drives = [arm.joint for arm in arms]
    lengths = np.array([arm.lengths for arm in arms], float).reshape(count, LINKS)
    plan = ReachPlan(
        goals=np.array([len(arm.reaches) for arm in arms], np.int64),
        goal=goal,
        hold=hold,
        limits=np.array([(d.speed, d.acceleration) for d in drives], float).reshape(count, 2),
        gains=np.array([(d.kp, d.ki, d.kd) for d in drives], float).reshape(count, 3),
        mass=lengths * np.array([arm.mass_per_length for arm in arms]).reshape(count, 1),
        length=lengths,
        torque=np.array([d.torque for d in drives], float),
    )
    idle = np.full(count, -1, np.int64)
    z = np.zeros((count, LINKS))
    progress = ReachProgress(
        at=np.zeros(count, np.int64),
        since=idle,
        ended=idle.copy(),
        start=start.copy(),
        target=start.copy(),
        sums=z,
        wanted=z.copy(),
        torque=z.copy(),
        reference=start.copy(),
    )
    return plan, progress


def solution(
    scenario: Scenario, arm: Arm, reach: Reach, here: tuple[float, ...]
) -> tuple[float, ...]:
    """Joint angles for a pose: the elbow asked for, turned as near to `here` as whole turns allow.

    ValueError where the pose is out of reach; spec.scenario refuses those before.
    """
    framed = scenario.coordinates.local(reach.to)
    found = PlanarArm(arm.lengths).inverse(framed)
    if not found:
        raise ValueError(str(PlanarArm(arm.lengths).reach_problem(framed)))
    if reach.elbow != "near":
        sign = 1.0 if reach.elbow == "up" else -1.0
        found = [q for q in found if q[1] * sign >= 0.0] or found
    near = [tuple(_nearest(a, b) for a, b in zip(q, here, strict=True)) for q in found]
    return min(near, key=lambda q: max(abs(a - b) for a, b in zip(q, here, strict=True)))


def _nearest(angle: float, here: float) -> float:
    """The same angle but for whole turns, nearest to here."""
    turns = round(degrees(here - angle) / TURN)
    return angle + radians(TURN * turns)


@inner
def pursue(
    plan: ReachPlan, progress: ReachProgress, angle: Array, rate: Array, tick: int, dt: float
) -> None:
    """Move on from held goals, and set the torques of this tick from the joints' readings."""
    for arm in range(plan.goals.shape[0]):
        progress.ended[arm] = -1
        if progress.since[arm] >= 0 and progress.at[arm] < plan.goals[arm]:
            _end(plan, progress, arm, tick, dt)
        if progress.since[arm] < 0 and progress.at[arm] < plan.goals[arm]:
            for joint in range(LINKS):
                progress.target[arm, joint] = plan.goal[arm, progress.at[arm], joint]
            set_out(progress, arm, tick)
        t = (tick - progress.since[arm]) * dt
        farthest = _farthest(progress, arm)
        share, pace = 1.0, 0.0  # at rest: hold the target
        if farthest > 0.0 and progress.since[arm] >= 0:
            share, pace = profile_at(t, farthest, plan.limits[arm, 0], plan.limits[arm, 1])
            share, pace = share / farthest, pace / farthest
        kp, ki, kd = plan.gains[arm, 0], plan.gains[arm, 1], plan.gains[arm, 2]
        for joint in range(LINKS):
            way = progress.target[arm, joint] - progress.start[arm, joint]
            progress.reference[arm, joint] = progress.start[arm, joint] + share * way
            error = progress.reference[arm, joint] - angle[arm, joint]
            wanted = kp * error + kd * (pace * way - rate[arm, joint])
            progress.wanted[arm, joint] = wanted + ki * progress.sums[arm, joint]
        if _torques(plan, progress, angle, arm):
            for joint in range(LINKS):
                error = progress.reference[arm, joint] - angle[arm, joint]
                progress.sums[arm, joint] += error * dt


@inner
def _torques(plan: ReachPlan, progress: ReachProgress, angle: Array, arm: int) -> bool:
    """Torques that give the joints the accelerations wanted; False where one passes its limit.

    The inertia of three slender rods in a row, without the terms in the rates squared, so that a
    joint's PID acts on what it turns at this moment. Source: Lynch & Park, Modern Robotics, 8.1.
    """
    within = True
    for joint in range(LINKS):
        progress.torque[arm, joint] = 0.0
    for link in range(LINKS):  # in directions of the links: moment that each of them needs
        moment = 0.0
        for other in range(LINKS):
            acceleration = 0.0
            for joint in range(other + 1):
                acceleration += progress.wanted[arm, joint]
            moment += _inertia(plan, angle, arm, link, other) * acceleration
        for joint in range(link + 1):
            progress.torque[arm, joint] += moment
    for joint in range(LINKS):
        within = within and abs(progress.torque[arm, joint]) < plan.torque[arm]
    return within


@inner
def _inertia(plan: ReachPlan, angle: Array, arm: int, link: int, other: int) -> float:
    """kg m2 that couples the turning of two links, both seen from the base."""
    near, far = min(link, other), max(link, other)
    beyond = 0.0
    for k in range(far + 1, LINKS):
        beyond += plan.mass[arm, k]
    a, b = float(plan.length[arm, near]), float(plan.length[arm, far])
    if near == far:
        return (float(plan.mass[arm, far]) / 3.0 + beyond) * a * a
    turned = 0.0
    for joint in range(near + 1, far + 1):
        turned += angle[arm, joint]
    return (float(plan.mass[arm, far]) / 2.0 + beyond) * a * b * cos(turned)


@inner
def set_out(progress: ReachProgress, arm: int, tick: int) -> None:
    """Begin a move from where the set-point stands to progress.target."""
    progress.since[arm] = tick
    for joint in range(LINKS):
        progress.start[arm, joint] = progress.reference[arm, joint]


@inner
def _farthest(progress: ReachProgress, arm: int) -> float:
    """How far the joint turns that turns farthest, rad."""
    farthest = 0.0
    for joint in range(LINKS):
        farthest = max(farthest, abs(progress.target[arm, joint] - progress.start[arm, joint]))
    return farthest


@inner
def _end(plan: ReachPlan, progress: ReachProgress, arm: int, tick: int, dt: float) -> None:
    """Note that a goal has been held long enough, and go on."""
    goal = progress.at[arm]
    farthest = _farthest(progress, arm)
    moving = 0.0
    if farthest > 0.0:
        moving = profile_time(farthest, plan.limits[arm, 0], plan.limits[arm, 1])
    if (tick - progress.since[arm]) * dt >= moving + plan.hold[arm, goal] * dt:
        progress.ended[arm] = goal
        progress.at[arm] = goal + 1
        progress.since[arm] = -1


@inner
def through(plan: ReachPlan, progress: ReachProgress) -> bool:
    """Whether every arm has held its last goal."""
    for arm in range(plan.goals.shape[0]):  # noqa: SIM110 (numba)
        if progress.at[arm] < plan.goals[arm]:
            return False
    return True
