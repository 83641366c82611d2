"""Absolute encoders on the joints of arms, and the ball as a keeper's arm is shown it.

Both are without error (estimate): the arm's drives are the robot's most precise ones, and the
camera that sees the ball as robots do belongs to matches.
"""

from soccersim.kernel import inner
from soccersim.state import LINKS, Array, Readings, Truth, Whole


@inner
def read_joints(
    first: Whole, carrier: Whole, zero: Array, readings: Readings, truth: Truth
) -> None:
    """Each joint's angle and rate.

    first (A,) is the row of each arm's first link in truth.body, carrier (A,) the row of the robot
    that carries it (-1: the floor), zero (A, 3) the first joint's x, y and zero, rad.
    """
    for arm in range(first.shape[0]):
        before, before_rate = zero[arm, 2], 0.0
        if carrier[arm] >= 0:
            before += truth.body[carrier[arm], 2]
            before_rate = truth.body[carrier[arm], 5]
        for joint in range(LINKS):
            row = first[arm] + joint
            readings.joint[arm, joint] = truth.body[row, 2] - before
            readings.joint_rate[arm, joint] = truth.body[row, 5] - before_rate
            before, before_rate = truth.body[row, 2], truth.body[row, 5]


@inner
def see_ball(row: int, readings: Readings, truth: Truth) -> None:
    """Where the ball is and how fast."""
    readings.ball[0], readings.ball[1] = truth.body[row, 0], truth.body[row, 1]
    readings.ball[2], readings.ball[3] = truth.body[row, 3], truth.body[row, 4]
