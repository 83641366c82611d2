"""Odometry: pulses to a displacement by forward kinematics, displacements to a pose on SE(2).

Only the drawn dimensions are known here, never those as built: that is what makes it drift.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from soccersim.geometry import rotate, se2_arc
from soccersim.kernel import kernel
from soccersim.spec.robot import Robot
from soccersim.state import Array, Estimate, Readings, Whole


class Odometry(NamedTuple):
    """How the robots reckon."""

    every: Whole  # (R,) ticks from step to step
    per_count: Array  # (R, 3, W) displacement (m, m, rad) in the body frame of one count
    per_turn: Array  # (R, 2) m in the body frame of one radian told by the gyro
    gyro: Whole  # (R,) 1: the turn is the gyro's
    midpoint: Whole  # (R,) 1: straight along the mean heading instead of an arc


def build_odometry(robots: Sequence[Robot], count_angle: Array, physics_hz: int) -> Odometry:
    """The matrices; count_angle (R, W) is the radians of one count."""
    robots_n, wheels = count_angle.shape
    whole = np.zeros((3, robots_n), np.int64)
    per_count, per_turn = np.zeros((robots_n, 3, wheels)), np.zeros((robots_n, 2))
    for i, robot in enumerate(robots):
        spec, base = robot.odometry, robot.odometry_wheels.base
        first = 0 if spec.wheels == "drive" else len(robot.drive.azimuth_deg)
        at = slice(first, first + base.wheels)
        metres = base.rolling_radius * count_angle[i, at]
        if spec.heading == "gyro":
            # the turn is known: least squares for the translation alone
            moves = np.linalg.pinv(base.jacobian[:, :2])
            per_count[i, :2, at] = moves * metres
            per_turn[i] = -moves @ base.jacobian[:, 2]
        else:
            per_count[i, :, at] = base.inverse_jacobian * metres
        whole[:, i] = (
            physics_hz // robot.control.rate_hz,
            spec.heading == "gyro",
            spec.integrate == "midpoint",
        )
    return Odometry(whole[0].copy(), per_count, per_turn, whole[1].copy(), whole[2].copy())


@kernel
def reckon(
    odometry: Odometry, estimate: Estimate, readings: Readings, tick: int, dt: float
) -> None:
    """Move the estimates of the robots that are due by what was counted since their last step."""
    for robot in range(odometry.every.shape[0]):
        if tick % odometry.every[robot] != 0:
            continue
        dx = dy = turn = 0.0
        for wheel in range(readings.counts.shape[1]):
            gained = readings.counts[robot, wheel] - estimate.counts[robot, wheel]
            estimate.counts[robot, wheel] = readings.counts[robot, wheel]
            dx += odometry.per_count[robot, 0, wheel] * gained
            dy += odometry.per_count[robot, 1, wheel] * gained
            turn += odometry.per_count[robot, 2, wheel] * gained
        if odometry.gyro[robot] == 1:
            turn = readings.gyro_angle[robot] - estimate.gyro_angle[robot]
            dx += odometry.per_turn[robot, 0] * turn
            dy += odometry.per_turn[robot, 1] * turn
        estimate.gyro_angle[robot] = readings.gyro_angle[robot]
        span = odometry.every[robot] * dt
        estimate.twist[robot, 0] = dx / span
        estimate.twist[robot, 1] = dy / span
        estimate.twist[robot, 2] = turn / span
        advance(estimate.pose, robot, dx, dy, turn, odometry.midpoint[robot] == 1)


@kernel
def advance(pose: Array, robot: int, dx: float, dy: float, turn: float, midpoint: bool) -> None:
    """Add a displacement, given in the body frame, to a pose in the field frame."""
    if midpoint:
        mx, my = rotate(dx, dy, pose[robot, 2] + 0.5 * turn)
    else:
        ax, ay = se2_arc(dx, dy, turn)
        mx, my = rotate(ax, ay, pose[robot, 2])
    pose[robot, 0] += mx
    pose[robot, 1] += my
    pose[robot, 2] += turn
