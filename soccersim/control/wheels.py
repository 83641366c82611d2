"""Wheel control: a body twist to wheel speeds by inverse kinematics, wheel speeds to PWM.

A wheel with an encoder has a PI loop on top of the inverse PWM table; one without, as on Utama's
robot, is driven by the table alone.
"""

from collections.abc import Sequence
from math import floor
from typing import NamedTuple

import numpy as np

from soccersim.control.plan import PWM, WHEEL_SPEEDS, Plan, Progress
from soccersim.control.position import PositionLoop
from soccersim.kernel import inner, kernel
from soccersim.spec.motor import PWM_MAX, table_speeds
from soccersim.spec.robot import Robot
from soccersim.state import Array, Command, Readings, Whole


class WheelLoop(NamedTuple):
    """Gains, tables and memory of the driven wheels."""

    wheels: Whole  # (R,) how many are driven
    inverse: Array  # (R, W, 3) body twist to wheel speed, rad/s per m/s and rad/s
    table: Array  # (R, W, 256) rad/s of the unloaded wheel at PWM 0..255, as the robot knows it
    kp: Array  # (R,) PWM per rad/s; 0 with ki 0: the table alone
    ki: Array  # (R,) PWM per rad
    sums: Array  # (R, W) PWM


def build_wheel_loop(robots: Sequence[Robot], wheels: int) -> WheelLoop:
    """The loops at rest."""
    count = len(robots)
    driven = np.array([len(robot.drive.azimuth_deg) for robot in robots], np.int64)
    loop = WheelLoop(
        driven,
        np.zeros((count, wheels, 3)),
        np.zeros((count, wheels, PWM_MAX + 1)),
        np.zeros(count),
        np.zeros(count),
        np.zeros((count, wheels)),
    )
    for i, robot in enumerate(robots):
        base = robot.drive.base
        loop.inverse[i, : base.wheels] = base.jacobian / base.rolling_radius[:, None]
        loop.table[i, : base.wheels] = table_speeds(robot.drive.motor, base.wheels)
        if robot.control.wheel_loop == "pi":
            loop.kp[i], loop.ki[i] = robot.control.wheel.kp, robot.control.wheel.ki
    return loop


@kernel
def turn_wheels(
    loop: WheelLoop,
    position: PositionLoop,
    plan: Plan,
    progress: Progress,
    readings: Readings,
    command: Command,
    tick: int,
    dt: float,
) -> None:
    """Set wheel speeds and PWM of the robots that are due."""
    for robot in range(plan.every.shape[0]):
        if tick % plan.every[robot] != 0:
            continue
        leg = progress.leg[robot]
        on = leg < plan.legs[robot]
        if on and plan.kind[robot, leg] == PWM:
            for wheel in range(loop.wheels[robot]):
                command.pwm[robot, wheel] = int(plan.value[robot, leg, wheel])
            continue
        if on and plan.kind[robot, leg] == WHEEL_SPEEDS:
            for wheel in range(loop.wheels[robot]):
                command.wheel_speed[robot, wheel] = plan.value[robot, leg, wheel]
        else:
            position.saturated[robot] = _inverse_kinematics(loop, command, robot)
        if plan.pushed[robot] == 1:
            for wheel in range(loop.wheels[robot]):
                command.pwm[robot, wheel] = 0
        else:
            _wheel_pi(loop, readings, command, robot, plan.every[robot] * dt)


@inner
def _inverse_kinematics(loop: WheelLoop, command: Command, robot: int) -> int:
    """Wheel speeds for the twist, all scaled alike where one would pass its top; 1 if so."""
    vx, vy, omega = command.twist[robot, 0], command.twist[robot, 1], command.twist[robot, 2]
    excess = 1.0
    for wheel in range(loop.wheels[robot]):
        speed = loop.inverse[robot, wheel, 0] * vx + loop.inverse[robot, wheel, 1] * vy
        speed += loop.inverse[robot, wheel, 2] * omega
        command.wheel_speed[robot, wheel] = speed
        excess = max(excess, abs(speed) / loop.table[robot, wheel, PWM_MAX])
    if excess == 1.0:
        return 0
    for wheel in range(loop.wheels[robot]):
        command.wheel_speed[robot, wheel] /= excess
    return 1


@inner
def _wheel_pi(loop: WheelLoop, readings: Readings, command: Command, robot: int, dt: float) -> None:
    """PWM for the wanted speeds: the table's, and a PI that stops summing at full PWM."""
    for wheel in range(loop.wheels[robot]):
        wanted = command.wheel_speed[robot, wheel]
        error = wanted - readings.wheel_speed[robot, wheel]
        level = pwm_for(loop.table, robot, wheel, wanted)
        level += loop.kp[robot] * error + loop.sums[robot, wheel]
        inside = abs(level) <= PWM_MAX
        if inside or error * level < 0.0:
            loop.sums[robot, wheel] += loop.ki[robot] * error * dt
        level = min(max(level, -float(PWM_MAX)), float(PWM_MAX))
        # no PWM comes of what is no number: as an index it would lead anywhere
        command.pwm[robot, wheel] = floor(level + 0.5) if level == level else 0


@kernel
def pwm_for(table: Array, robot: int, wheel: int, speed: float) -> float:
    """The PWM at which the unloaded wheel turns with this speed: the table read backwards."""
    size = abs(speed)
    low, high = 0, PWM_MAX
    if size >= table[robot, wheel, high]:
        return float(PWM_MAX) if speed > 0.0 else -float(PWM_MAX)
    while high - low > 1:
        middle = (low + high) // 2
        if table[robot, wheel, middle] <= size:
            low = middle
        else:
            high = middle
    below, above = table[robot, wheel, low], table[robot, wheel, high]
    level = low + (size - below) / (above - below)
    return float(level if speed > 0.0 else -level)
