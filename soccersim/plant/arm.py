"""Arms in the plant: links as bodies on pivots, joint torques on them, the base's share back.

Rows of truth.body: robots, ball, then three links an arm. A link's pose is that of its middle;
its heading is the direction it points to.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from soccersim.kernel import inner
from soccersim.spec.arm import Arm
from soccersim.spec.scenario import Scenario
from soccersim.state import LINKS, Array, Truth, Whole


class Arms(NamedTuple):
    """The arms of a scenario as built; A of them."""

    first: Whole  # (A,) row of the first link in truth.body
    carrier: Whole  # (A,) row of the robot that carries it; -1: the floor does
    base: Array  # (A, 3) first joint's x, y and zero: body frame of the carrier, or field frame
    length: Array  # (A, 3) m
    friction: Array  # (A, 3) N m s/rad
    torque: Array  # (A,) N m at most


def build_arms(scenario: Scenario) -> Arms:
    """The arms' arrays."""
    arms = scenario.arms
    count = len(arms)
    first_row = len(scenario.robots) + (scenario.ball is not None)
    names = [player.name for player in scenario.robots]
    built = Arms(
        np.arange(count, dtype=np.int64) * LINKS + first_row,
        np.array([names.index(arm.on) if arm.on else -1 for arm in arms], np.int64),
        np.array([arm.base_pose(scenario.coordinates) for arm in arms]).reshape(count, 3),
        np.array([arm.lengths for arm in arms], float).reshape(count, LINKS),
        np.array([[arm.joint.friction * i for i in carried(arm)] for arm in arms], float).reshape(
            count, LINKS
        ),
        np.array([arm.joint.torque for arm in arms], float),
    )
    return built


def link_masses(arm: Arm) -> tuple[float, ...]:
    """kg of each link."""
    return tuple(arm.mass_per_length * length for length in arm.lengths)


def carried(arm: Arm) -> list[float]:
    """kg m2 that each joint turns with the arm stretched: slender rods in a row."""
    inertias = []
    for joint in range(LINKS):
        reach, inertia = 0.0, 0.0
        for length, mass in list(zip(arm.lengths, link_masses(arm), strict=True))[joint:]:
            inertia += mass * length**2 / 12 + mass * (reach + length / 2) ** 2
            reach += length
        inertias.append(inertia)
    return inertias


def link_poses(
    arm: Arm, base: Sequence[float], angles: Sequence[float]
) -> list[tuple[float, float, float]]:
    """Middles and directions of the links for joint angles (rad), from the base on the field."""
    x, y, heading = base
    poses = []
    for length, angle in zip(arm.lengths, angles, strict=True):
        heading += angle
        half = np.array([np.cos(heading), np.sin(heading)]) * length / 2
        poses.append((float(x + half[0]), float(y + half[1]), heading))
        x, y = x + 2 * half[0], y + 2 * half[1]
    return poses


@inner
def turn_joints(arms: Arms, truth: Truth, wanted: Array, rate: Array) -> None:
    """Leave the joints' torques on the links, and on their carriers, in truth.wrench.

    wanted (A, 3) N m is what the joints are asked for; rate (A, 3) rad/s is how they turn.
    """
    for arm in range(arms.first.shape[0]):
        top = arms.torque[arm]
        for joint in range(LINKS):
            row = arms.first[arm] + joint
            torque = min(max(wanted[arm, joint], -top), top)
            torque -= arms.friction[arm, joint] * rate[arm, joint]
            truth.wrench[row, 0] = 0.0
            truth.wrench[row, 1] = 0.0
            truth.wrench[row, 2] = torque
            if joint > 0:
                truth.wrench[row - 1, 2] -= torque
            elif arms.carrier[arm] >= 0:
                truth.wrench[arms.carrier[arm], 2] -= torque
