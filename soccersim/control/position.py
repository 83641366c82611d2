"""Position control: set-point against estimate, a PID per axis, limits that keep the direction.

The loop of Utama's Fig. 5, from (x, y, heading) to the body twist that inverse kinematics turns
into wheel speeds.
"""

from collections.abc import Sequence
from math import inf, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.control.plan import TARGET, TWIST, Plan, Progress
from soccersim.geometry import rotate
from soccersim.kernel import inner, kernel
from soccersim.spec.robot import Robot
from soccersim.state import Array, Command, Estimate, Whole

GAINS = ("kp", "ki", "kd")
BRAKING = 0.8  # of the acceleration limit is counted on to stop: the wheels answer late
CATCH_UP = 1.5  # times a profile's own accelerations, which alone would leave none to correct with


class PositionLoop(NamedTuple):
    """Gains and memory; axes are x, y, heading of the field frame."""

    kp: Array  # (R, 3) 1/s
    ki: Array  # (R, 3) 1/s2
    kd: Array  # (R, 3)
    limits: Array  # (R, 4) speed, acceleration, turn rate, turn acceleration; inf: none
    braking: Array  # (R, 2) m/s2 and rad/s2 with which an error can be slowed down for; inf: any
    sums: Array  # (R, 3) integrals of the error
    last: Array  # (R, 3) estimate at the last step
    velocity: Array  # (R, 3) asked for at the last step; field frame
    saturated: Whole  # (R,) 1: the wheels could not follow at the last step


def build_position_loop(robots: Sequence[Robot], start: Array) -> PositionLoop:
    """The loops at rest; start (R, 3) is where the robots believe to stand."""
    axes = [(r.control.x, r.control.y, r.control.heading) for r in robots]
    gains = [
        np.array([[getattr(pid, g) for pid in row] for row in axes]).reshape(-1, 3) for g in GAINS
    ]
    limits, braking = np.zeros((len(robots), 4)), np.zeros((len(robots), 2))
    for i, robot in enumerate(robots):
        most = robot.control.limits
        pace = np.array([most.acceleration or inf, most.turn_acceleration or inf])
        if robot.control.profile == "trapezoid":
            limits[i, 1::2], braking[i] = CATCH_UP * pace, (CATCH_UP - 1.0) * pace
        else:
            limits[i, 1::2], braking[i] = pace, BRAKING * pace
        limits[i, ::2] = most.speed, most.turn_rate
    kp, ki, kd = gains
    return PositionLoop(
        kp=kp,
        ki=ki,
        kd=kd,
        limits=limits,
        braking=braking,
        sums=np.zeros_like(start),
        last=start.copy(),
        velocity=np.zeros_like(start),
        saturated=np.zeros(len(robots), np.int64),
    )


@kernel
def seek(
    loop: PositionLoop,
    plan: Plan,
    progress: Progress,
    estimate: Estimate,
    command: Command,
    tick: int,
    dt: float,
) -> None:
    """Set command.twist of the robots that are due and are on their way to a target."""
    for robot in range(plan.every.shape[0]):
        if tick % plan.every[robot] != 0:
            continue
        leg = progress.leg[robot]
        if plan.legs[robot] > 0 and leg >= plan.legs[robot]:
            leg -= 1  # through: hold the last target
        kind = plan.kind[robot, leg]
        if plan.legs[robot] == 0:
            continue  # a strategy commands it, or nobody
        if plan.pushed[robot] == 1 or (kind != TARGET and progress.leg[robot] != leg):
            _stop(command, robot)
        elif kind == TARGET:
            _pid(loop, progress, estimate, command, robot, plan.every[robot] * dt)
        elif kind == TWIST:
            for k in range(3):
                command.twist[robot, k] = plan.value[robot, leg, k]


@inner
def _stop(command: Command, robot: int) -> None:
    for k in range(3):
        command.twist[robot, k] = 0.0


@inner
def _pid(
    loop: PositionLoop,
    progress: Progress,
    estimate: Estimate,
    command: Command,
    robot: int,
    dt: float,
) -> None:
    """The wanted velocity in the field frame, limited, turned into the body frame."""
    ex = command.reference[robot, 0] - estimate.pose[robot, 0]
    ey = command.reference[robot, 1] - estimate.pose[robot, 1]
    turn = command.reference[robot, 2] - estimate.pose[robot, 2]
    px, py, pw = loop.kp[robot, 0] * ex, loop.kp[robot, 1] * ey, loop.kp[robot, 2] * turn
    ease = _ease(sqrt(px * px + py * py), sqrt(ex * ex + ey * ey), loop.braking[robot, 0])
    turn_ease = _ease(abs(pw), abs(turn), loop.braking[robot, 1])
    wx = ease * px + _rest(loop, progress, estimate, robot, 0, dt)
    wy = ease * py + _rest(loop, progress, estimate, robot, 1, dt)
    ww = turn_ease * pw + _rest(loop, progress, estimate, robot, 2, dt)
    vx, vy, omega = limited(loop.limits, loop.velocity, robot, wx, wy, ww, dt)
    free = ease == 1.0 and turn_ease == 1.0 and vx == wx and vy == wy and omega == ww
    for k in range(3):
        error = command.reference[robot, k] - estimate.pose[robot, k]
        # anti-windup: no summing while a limit holds the command, save towards zero
        if (free and loop.saturated[robot] == 0) or error * loop.sums[robot, k] < 0.0:
            loop.sums[robot, k] += error * dt
        loop.last[robot, k] = estimate.pose[robot, k]
    loop.velocity[robot, 0], loop.velocity[robot, 1], loop.velocity[robot, 2] = vx, vy, omega
    # while this command holds the body goes on turning: aim at the middle of the step
    heading = estimate.pose[robot, 2] + 0.5 * estimate.twist[robot, 2] * dt
    bx, by = rotate(vx, vy, -heading)  # field to body
    command.twist[robot, 0], command.twist[robot, 1], command.twist[robot, 2] = bx, by, omega


@inner
def _rest(
    loop: PositionLoop, progress: Progress, estimate: Estimate, robot: int, k: int, dt: float
) -> float:
    """One axis without its proportional part: the set-point's own velocity, integral, derivative.

    The derivative acts on the measurement: a set-point that jumps gives no kick.
    """
    feed = progress.motion[robot, k]
    rate = (estimate.pose[robot, k] - loop.last[robot, k]) / dt
    damped = loop.kd[robot, k] * (feed - rate)
    return float(feed + loop.ki[robot, k] * loop.sums[robot, k] + damped)


@inner
def _ease(asked: float, error: float, braking: float) -> float:
    """The share of a proportional answer from which the robot can still stop at the target.

    Near the target all of it; farther off, where slowing down in proportion to the error would
    take more than the braking there is, the speed that falls by `braking` all the way.
    """
    if asked == 0.0 or asked * asked <= braking * error:
        return 1.0
    near = error * braking * error / (asked * asked)  # from here on in proportion
    return sqrt(braking * (2.0 * error - near)) / asked


@inner
def limited(
    limits: Array, last: Array, robot: int, vx: float, vy: float, omega: float, dt: float
) -> tuple[float, float, float]:
    """A velocity within speed and acceleration limits, its direction kept; field frame.

    limits (R, 4) as in PositionLoop, last (R, 3) the velocity asked for a step of dt before.
    """
    top, turn_top = limits[robot, 0], limits[robot, 2]
    speed = sqrt(vx * vx + vy * vy)
    if speed > top:
        vx, vy = vx * top / speed, vy * top / speed
    omega = min(max(omega, -turn_top), turn_top)
    dx, dy = vx - last[robot, 0], vy - last[robot, 1]
    change = sqrt(dx * dx + dy * dy)
    step = limits[robot, 1] * dt
    if change > step:
        vx = last[robot, 0] + dx * step / change
        vy = last[robot, 1] + dy * step / change
    turn_step = limits[robot, 3] * dt
    turned = last[robot, 2]
    return vx, vy, min(max(omega, turned - turn_step), turned + turn_step)
