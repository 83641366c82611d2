"""A hand that pushes a robot along marks on the floor, as Idris' team did for Table 6."""

from typing import NamedTuple

from soccersim.kernel import inner
from soccersim.state import Array, Truth, Whole

STIFFNESS = 100.0  # 1/s2 per kg: the robot lags 4 mm, 9 mm while it speeds up (estimate)
DAMPING = 20.0  # 1/s per kg: twice the root of the stiffness, no swinging


class Hand(NamedTuple):
    """Which robots are pushed."""

    pushes: Whole  # (R,) 1: a hand is on this robot
    mass: Array  # (R, 3) kg, kg, kg m2


@inner
def push_robots(hand: Hand, reference: Array, motion: Array, truth: Truth) -> None:
    """Leave in truth.push a spring and damper from each pushed robot to its moving mark.

    reference (R, 3) and motion (R, 3) are the mark's pose and velocity in the field frame. The
    hand sees the floor, so it works on the truth.
    """
    for robot in range(hand.pushes.shape[0]):
        if hand.pushes[robot] == 0:
            continue
        for k in range(3):
            ahead = reference[robot, k] - truth.body[robot, k]
            faster = motion[robot, k] - truth.body[robot, 3 + k]
            truth.push[robot, k] = hand.mass[robot, k] * (STIFFNESS * ahead + DAMPING * faster)
