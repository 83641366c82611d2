"""What each robot shall do, leg by leg, and how far it has come, by its own belief."""

from math import pi, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.control.profile import profile_at
from soccersim.geometry import wrap_angle
from soccersim.kernel import inner, kernel
from soccersim.spec.player import Leg, Player
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Command, Estimate, Whole

TARGET, PWM, WHEEL_SPEEDS, TWIST = 0, 1, 2, 3  # kinds of leg


class Plan(NamedTuple):
    """The legs of all robots, L at most."""

    every: Whole  # (R,) ticks from control step to control step
    legs: Whole  # (R,) how many; 0: stand still
    repeat: Whole  # (R,) 1: start again after the last
    kind: Whole  # (R, L) TARGET, PWM, WHEEL_SPEEDS or TWIST
    value: Array  # (R, L, max(3, W)) target x, y, heading in the field frame, or what to hold
    as_written: Whole  # (R, L) 1: turn as far as the numbers say
    ticks: Whole  # (R, L) time-out of a target, or how long to hold
    profiled: Whole  # (R,) 1: the set-point moves within the limits
    pushed: Whole  # (R,) 1: a hand moves the robot, its motors are idle
    distance: Array  # (R,) m, of arrival
    angle: Array  # (R,) rad, of arrival
    dwell: Whole  # (R,) ticks to stay within both
    limits: Array  # (R, 4) speed, acceleration, turn rate, turn acceleration of the profile


class Progress(NamedTuple):
    """Where each robot is in its plan."""

    leg: Whole  # (R,) the leg it is on; equal to `legs` when it is through
    since: Whole  # (R,) tick at which the leg, or else the last one, began; -1: not begun
    within: Whole  # (R,) tick since which it has been within the arrival's bounds; -1: it is not
    ended: Whole  # (R,) 1: a leg ended in this step, `ended_leg` with `ended_reached`
    ended_leg: Whole  # (R,)
    ended_reached: Whole  # (R,)
    start: Array  # (R, 3) believed pose at the leg's start; field frame
    goal: Array  # (R, 3) its target, the heading unwrapped
    written: Array  # (R,) its heading as the plan has it
    motion: Array  # (R, 3) velocity of the set-point, field frame; the controller's feed-forward


def build_plan(scenario: Scenario, wheels: int) -> Plan:
    """The plan of every robot, in SI on the field."""
    robots = scenario.robots
    steps = max([1, *(len(p.path or p.open_loop or ()) for p in robots)])
    n, whole = len(robots), np.int64
    plan = Plan(
        every=np.zeros(n, whole),
        legs=np.zeros(n, whole),
        repeat=np.zeros(n, whole),
        kind=np.zeros((n, steps), whole),
        value=np.zeros((n, steps, max(3, wheels))),
        as_written=np.zeros((n, steps), whole),
        ticks=np.zeros((n, steps), whole),
        profiled=np.zeros(n, whole),
        pushed=np.zeros(n, whole),
        distance=np.zeros(n),
        angle=np.zeros(n),
        dwell=np.zeros(n, whole),
        limits=np.ones((n, 4)),
    )
    for i, player in enumerate(robots):
        control = player.model.control
        plan.every[i] = scenario.every(control.rate_hz)
        plan.legs[i] = len(player.path or player.open_loop or ())
        plan.repeat[i] = player.repeat
        plan.pushed[i] = player.pushed_by is not None
        plan.profiled[i] = player.pushed_by is not None or control.profile == "trapezoid"
        plan.distance[i] = control.arrival.distance
        plan.angle[i] = control.arrival.angle_deg * pi / 180
        dwell = player.pushed_by.settle if player.pushed_by else control.arrival.dwell
        plan.dwell[i] = round(dwell * scenario.timing.physics_hz)
        plan.limits[i] = _limits(player)
        for k, leg in enumerate(player.path or ()):
            _plan_leg(plan, scenario, i, k, leg, leg.timeout or control.arrival.timeout)
        for k, phase in enumerate(player.open_loop or ()):
            plan.ticks[i, k] = max(1, round(phase.seconds * scenario.timing.physics_hz))
            for kind, held in (
                (PWM, phase.pwm),
                (WHEEL_SPEEDS, phase.wheel_speeds),
                (TWIST, phase.twist),
            ):
                if held is not None:
                    plan.kind[i, k] = kind
                    plan.value[i, k, : len(held)] = held
    return plan


def _plan_leg(plan: Plan, scenario: Scenario, i: int, k: int, leg: Leg, timeout: float) -> None:
    plan.value[i, k, :3] = scenario.coordinates.field_pose(leg.to)
    plan.as_written[i, k] = leg.turn == "as_written"
    plan.ticks[i, k] = max(1, round(timeout * scenario.timing.physics_hz))


def _limits(player: Player) -> tuple[float, float, float, float]:
    """Speed, acceleration, turn rate and turn acceleration of the moving set-point."""
    hand, limits = player.pushed_by, player.model.control.limits
    if hand:
        return hand.speed, hand.acceleration, hand.turn_rate, 2.0 * hand.turn_rate
    return (
        limits.speed,
        limits.acceleration or 1.0,
        limits.turn_rate,
        limits.turn_acceleration or 1.0,
    )


def new_progress(start: Array) -> Progress:
    """Nobody has begun; start (R, 3) is where the robots stand."""
    count, whole = len(start), np.int64
    return Progress(
        leg=np.zeros(count, whole),
        since=np.full(count, -1, whole),
        within=np.full(count, -1, whole),
        ended=np.zeros(count, whole),
        ended_leg=np.zeros(count, whole),
        ended_reached=np.zeros(count, whole),
        start=np.zeros_like(start),
        goal=start.copy(),
        written=start[:, 2].copy(),
        motion=np.zeros_like(start),
    )


@kernel
def follow(
    plan: Plan, progress: Progress, estimate: Estimate, command: Command, tick: int, dt: float
) -> None:
    """End the legs that are over, begin the next, and set the set-points of this step."""
    for robot in range(plan.every.shape[0]):
        progress.ended[robot] = 0
        if tick % plan.every[robot] != 0 or plan.legs[robot] == 0:
            continue
        if progress.since[robot] >= 0 and progress.leg[robot] < plan.legs[robot]:
            _end_leg(plan, progress, estimate, robot, tick)
        if progress.since[robot] < 0:
            _begin_leg(plan, progress, estimate, robot, tick)
        # one that is through goes on to its last target, and stays there
        leg = min(progress.leg[robot], plan.legs[robot] - 1)
        if plan.kind[robot, leg] == TARGET:
            _set_reference(plan, progress, command, robot, (tick - progress.since[robot]) * dt)
        else:
            for k in range(3):
                command.reference[robot, k] = np.nan


@inner
def finished(plan: Plan, progress: Progress) -> bool:
    """Whether every robot that has a plan is through with it."""
    for robot in range(plan.every.shape[0]):  # noqa: SIM110 (numba)
        if progress.leg[robot] < plan.legs[robot]:
            return False
    return True


@inner
def _begin_leg(plan: Plan, progress: Progress, estimate: Estimate, robot: int, tick: int) -> None:
    """Note the start, and which of the headings alike is meant."""
    leg = progress.leg[robot]
    progress.since[robot] = tick
    progress.within[robot] = -1
    heading = plan.value[robot, leg, 2]
    turned = progress.goal[robot, 2] + heading - progress.written[robot]
    progress.written[robot] = heading
    for k in range(3):
        # a hand goes from mark to mark on the floor, a robot from where it believes to be
        pushed = plan.pushed[robot] == 1
        progress.start[robot, k] = progress.goal[robot, k] if pushed else estimate.pose[robot, k]
        progress.goal[robot, k] = plan.value[robot, leg, k]
    if plan.as_written[robot, leg] == 1:
        progress.goal[robot, 2] = turned
    else:
        here = progress.start[robot, 2]
        progress.goal[robot, 2] = here + wrap_angle(heading - here)


@inner
def _end_leg(plan: Plan, progress: Progress, estimate: Estimate, robot: int, tick: int) -> None:
    """Go on where the target has been held long enough, or the time is up."""
    leg = progress.leg[robot]
    spent = tick - progress.since[robot]
    reached = False
    if plan.kind[robot, leg] == TARGET:
        if not _arrived(plan, progress, estimate, robot, spent):
            progress.within[robot] = -1
        elif progress.within[robot] < 0:
            progress.within[robot] = tick
        held = tick - progress.within[robot]
        reached = progress.within[robot] >= 0 and held >= plan.dwell[robot]
    else:
        reached = spent >= plan.ticks[robot, leg]
    if reached or spent >= plan.ticks[robot, leg]:
        progress.ended[robot] = 1
        progress.ended_leg[robot] = leg
        progress.ended_reached[robot] = 1 if reached else 0
        progress.leg[robot] = leg + 1
        if plan.repeat[robot] == 1 and progress.leg[robot] == plan.legs[robot]:
            progress.leg[robot] = 0
        if progress.leg[robot] < plan.legs[robot]:
            progress.since[robot] = -1


@inner
def _arrived(plan: Plan, progress: Progress, estimate: Estimate, robot: int, spent: int) -> bool:
    """Whether the robot believes itself at the target; a pushed one is there when its hand is."""
    if plan.pushed[robot] == 1:
        mx, my, mw = progress.motion[robot, 0], progress.motion[robot, 1], progress.motion[robot, 2]
        return bool(spent > plan.every[robot] and mx == 0.0 and my == 0.0 and mw == 0.0)
    dx = progress.goal[robot, 0] - estimate.pose[robot, 0]
    dy = progress.goal[robot, 1] - estimate.pose[robot, 1]
    turn = progress.goal[robot, 2] - estimate.pose[robot, 2]
    near = plan.distance[robot]
    return bool(dx * dx + dy * dy <= near * near and abs(turn) <= plan.angle[robot])


@inner
def _set_reference(plan: Plan, progress: Progress, command: Command, robot: int, t: float) -> None:
    """The set-point at t seconds into the leg, and its velocity."""
    dx = progress.goal[robot, 0] - progress.start[robot, 0]
    dy = progress.goal[robot, 1] - progress.start[robot, 1]
    turn = progress.goal[robot, 2] - progress.start[robot, 2]
    share, rate, turned, turning = 1.0, 0.0, 1.0, 0.0
    if plan.profiled[robot] == 1:
        length = sqrt(dx * dx + dy * dy)
        speed, grow = plan.limits[robot, 0], plan.limits[robot, 1]
        if length > 0.0:
            share, rate = profile_at(t, length, speed, grow)
            share, rate = share / length, rate / length
        if turn != 0.0:
            speed, grow = plan.limits[robot, 2], plan.limits[robot, 3]
            turned, turning = profile_at(t, abs(turn), speed, grow)
            turned, turning = turned / abs(turn), turning / abs(turn)
    command.reference[robot, 0] = progress.start[robot, 0] + share * dx
    command.reference[robot, 1] = progress.start[robot, 1] + share * dy
    command.reference[robot, 2] = progress.start[robot, 2] + turned * turn
    progress.motion[robot, 0] = rate * dx
    progress.motion[robot, 1] = rate * dy
    progress.motion[robot, 2] = turning * turn
