"""What changes during a run: arrays of float64, a row per robot, allocated once.

R robots, B bodies (the robots, then the ball), W wheels (of each robot the driven ones first,
then the dead ones; columns a robot lacks stay 0). The tuple's name says who may see it.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Whole = NDArray[np.int64]

LINKS = 3  # of an arm, and joints


class Truth(NamedTuple):
    """What is so. Only the plant, the sensors, the referee and the recorder see it."""

    body: Array  # (B, 6)  x, y, heading, vx, vy, omega; field frame
    wrench: Array  # (B, 3)  fx, fy, torque that the tick gives each body; field frame
    push: Array  # (R, 3)  fx, fy, torque of a hand on the robot; field frame
    acceleration: Array  # (R, 2)  low-passed, m/s2; body frame
    wheel_angle: Array  # (R, W)  rad
    wheel_speed: Array  # (R, W)  rad/s
    slip: Array  # (R, W)  rim minus floor along the wheel, m/s
    load: Array  # (R, W)  N
    ball_roll: Array  # (2,)  velocity at which the ball's turning would carry it; field frame


class Readings(NamedTuple):
    """What the sensors say."""

    counts: Array  # (R, W)  whole pulses since the start (any number where perfect)
    wheel_speed: Array  # (R, W)  rad/s, from the pulses of the window
    gyro: Array  # (R,)  rad/s
    gyro_angle: Array  # (R,)  rad, the gyro's rates summed by the robot
    joint: Array  # (A, 3)  rad, angles of the arms' joints
    joint_rate: Array  # (A, 3)  rad/s
    ball: Array  # (4,)  x, y, vx, vy as a keeper's arm is shown it; field frame
    contact: Whole  # (R,)  1: the ball is in the robot's mouth


class Estimate(NamedTuple):
    """What a robot believes."""

    pose: Array  # (R, 3)  x, y, heading (unwrapped); field frame
    twist: Array  # (R, 3)  vx, vy, omega; body frame
    counts: Array  # (R, W)  pulses at the last step
    gyro_angle: Array  # (R,)  at the last step


class Command(NamedTuple):
    """What a robot wants."""

    reference: Array  # (R, 3)  set-point x, y, heading; field frame; nan: none
    twist: Array  # (R, 3)  vx, vy, omega; body frame
    wheel_speed: Array  # (R, W)  rad/s
    pwm: Whole  # (R, W)  -255..255
    kick: Array  # (R,)  m/s, as soon as the ball is in the mouth; 0: no
    dribble: Whole  # (R,)  1: hold the ball in the mouth


def new_truth(bodies: int, robots: int, wheels: int) -> Truth:
    """Everything at rest at the origin."""
    z = np.zeros
    per_wheel = (robots, wheels)
    return Truth(
        body=z((bodies, 6)),
        wrench=z((bodies, 3)),
        push=z((robots, 3)),
        acceleration=z((robots, 2)),
        wheel_angle=z(per_wheel),
        wheel_speed=z(per_wheel),
        slip=z(per_wheel),
        load=z(per_wheel),
        ball_roll=z(2),
    )


def new_readings(robots: int, wheels: int, arms: int = 0) -> Readings:
    """Nothing counted, nothing felt."""
    z, per_wheel, per_joint = np.zeros, (robots, wheels), (arms, LINKS)
    return Readings(
        counts=z(per_wheel),
        wheel_speed=z(per_wheel),
        gyro=z(robots),
        gyro_angle=z(robots),
        joint=z(per_joint),
        joint_rate=z(per_joint),
        ball=z(4),
        contact=z(robots, np.int64),
    )


def new_estimate(robots: int, wheels: int) -> Estimate:
    """At the origin, at rest."""
    return Estimate(
        np.zeros((robots, 3)), np.zeros((robots, 3)), np.zeros((robots, wheels)), np.zeros(robots)
    )


def new_command(robots: int, wheels: int) -> Command:
    """Nothing wanted."""
    return Command(
        np.full((robots, 3), np.nan),
        np.zeros((robots, 3)),
        np.zeros((robots, wheels)),
        np.zeros((robots, wheels), np.int64),
        np.zeros(robots),
        np.zeros(robots, np.int64),
    )
