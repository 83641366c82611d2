"""What the loop writes down: records at a fixed rate, and the end of every leg."""

from typing import NamedTuple

import numpy as np

from soccersim.kernel import inner
from soccersim.state import Array, Command, Estimate, Readings, Truth, Whole

RECORDS = 256  # of room in the log; the run is cut into pieces that fit


class Log(NamedTuple):
    """Records of the piece being run, and for each leg how it ended."""

    every: int  # ticks from record to record
    filled: Whole  # (1,) records so far
    tick: Whole  # (N,)
    body: Array  # (N, B, 6)
    estimate: Array  # (N, R, 3)
    reference: Array  # (N, R, 3)
    leg: Whole  # (N, R)
    wheel_angle: Array  # (N, R, W)
    wheel_speed: Array  # (N, R, W)
    slip: Array  # (N, R, W)
    load: Array  # (N, R, W)
    counts: Array  # (N, R, W)
    gyro: Array  # (N, R)
    command: Array  # (N, R, 3)
    wheel_setpoint: Array  # (N, R, W)
    pwm: Whole  # (N, R, W)
    joint: Array  # (N, A, 3)
    leg_ticks: Whole  # (R, L, 2) first and last tick; last -1: not ended
    leg_reached: Whole  # (R, L)
    leg_truth: Array  # (R, L, 3) true pose at the end; field frame
    leg_estimate: Array  # (R, L, 3) believed pose at the end


def new_log(every: int, bodies: int, robots: int, wheels: int, legs: int, arms: int) -> Log:
    """An empty log."""
    per_wheel = (RECORDS, robots, wheels)
    z, whole = np.zeros, np.int64
    ticks = z((robots, legs, 2), whole)
    ticks[:, :, 1] = -1
    return Log(
        every=every,
        filled=z(1, whole),
        tick=z(RECORDS, whole),
        body=z((RECORDS, bodies, 6)),
        estimate=z((RECORDS, robots, 3)),
        reference=z((RECORDS, robots, 3)),
        leg=z((RECORDS, robots), whole),
        wheel_angle=z(per_wheel),
        wheel_speed=z(per_wheel),
        slip=z(per_wheel),
        load=z(per_wheel),
        counts=z(per_wheel),
        gyro=z((RECORDS, robots)),
        command=z((RECORDS, robots, 3)),
        wheel_setpoint=z(per_wheel),
        pwm=z(per_wheel, whole),
        joint=z((RECORDS, arms, 3)),
        leg_ticks=ticks,
        leg_reached=z((robots, legs), whole),
        leg_truth=z((robots, legs, 3)),
        leg_estimate=z((robots, legs, 3)),
    )


@inner
def record(
    log: Log,
    truth: Truth,
    readings: Readings,
    estimate: Estimate,
    command: Command,
    leg: Whole,
    tick: int,
) -> None:
    """Write one record where one is due."""
    if tick % log.every != 0:
        return
    n = log.filled[0]
    log.filled[0] = n + 1
    log.tick[n] = tick
    for body in range(truth.body.shape[0]):
        for k in range(6):
            log.body[n, body, k] = truth.body[body, k]
    for arm in range(readings.joint.shape[0]):
        for k in range(3):
            log.joint[n, arm, k] = readings.joint[arm, k]
    for robot in range(leg.shape[0]):
        log.leg[n, robot] = leg[robot]
        log.gyro[n, robot] = readings.gyro[robot]
        for k in range(3):
            log.estimate[n, robot, k] = estimate.pose[robot, k]
            log.reference[n, robot, k] = command.reference[robot, k]
            log.command[n, robot, k] = command.twist[robot, k]
        for wheel in range(truth.wheel_speed.shape[1]):
            log.wheel_angle[n, robot, wheel] = truth.wheel_angle[robot, wheel]
            log.wheel_speed[n, robot, wheel] = truth.wheel_speed[robot, wheel]
            log.slip[n, robot, wheel] = truth.slip[robot, wheel]
            log.load[n, robot, wheel] = truth.load[robot, wheel]
            log.counts[n, robot, wheel] = readings.counts[robot, wheel]
            log.wheel_setpoint[n, robot, wheel] = command.wheel_speed[robot, wheel]
            log.pwm[n, robot, wheel] = command.pwm[robot, wheel]


@inner
def record_legs(
    log: Log,
    ended: Whole,
    ended_leg: Whole,
    reached: Whole,
    truth: Truth,
    estimate: Estimate,
    tick: int,
) -> None:
    """Note how the legs that end at this tick ended, the first time they are driven.

    ended, ended_leg, reached (R,): whether a leg of the robot ended, which one, and how.
    """
    for robot in range(ended.shape[0]):
        leg = ended_leg[robot]
        if ended[robot] == 0 or log.leg_ticks[robot, leg, 1] >= 0:
            continue
        log.leg_ticks[robot, leg, 1] = tick
        if leg + 1 < log.leg_ticks.shape[1]:
            log.leg_ticks[robot, leg + 1, 0] = tick
        log.leg_reached[robot, leg] = reached[robot]
        for k in range(3):
            log.leg_truth[robot, leg, k] = truth.body[robot, k]
            log.leg_estimate[robot, leg, k] = estimate.pose[robot, k]
