"""The arms' part of the loop: sense, decide, pursue, note, turn the joints."""

from typing import Any, NamedTuple

import numpy as np

from soccersim.control.guard import Guard, build_guard, keep
from soccersim.control.reach import ReachPlan, ReachProgress, build_reach, pursue
from soccersim.kernel import inner
from soccersim.plant.arm import Arms, build_arms, turn_joints
from soccersim.sensing.joints import read_joints, see_ball
from soccersim.spec.scenario import Scenario
from soccersim.state import LINKS, Array, Estimate, Readings, Truth, Whole


class Limbs(NamedTuple):
    """All arms of a scenario: as built, their plans, and how their goals ended."""

    arms: Arms
    plan: ReachPlan
    progress: ReachProgress
    guard: Guard
    ball: int  # row of the ball in truth.body; -1: none
    end_tick: Whole  # (A, T) tick at which each hold ended; -1: it has not
    end_tip: Array  # (A, T, 3) last link's middle and direction then; field frame
    end_base: Array  # (A, T, 3) the carrier's pose then; field frame; 0 on the floor
    end_joint: Array  # (A, T, 3) joint angles, rad


def build_limbs(scenario: Scenario) -> Limbs:
    """The arms at rest at their start."""
    plan, progress = build_reach(scenario)
    per_goal = plan.goal.shape
    ends = (np.zeros(per_goal) for _ in range(3))
    return Limbs(
        build_arms(scenario),
        plan,
        progress,
        build_guard(scenario),
        len(scenario.robots) if scenario.ball else -1,
        np.full(per_goal[:2], -1, np.int64),
        *ends,
    )


@inner
def move_arms(
    limbs: Limbs, truth: Truth, readings: Readings, estimate: Estimate, tick: int, dt: float
) -> None:
    """One tick of all arms; leaves the joints' torques in truth.wrench."""
    arms = limbs.arms
    if arms.first.shape[0] == 0:
        return
    read_joints(arms.first, arms.carrier, arms.base, readings, truth)
    if limbs.ball >= 0:
        see_ball(limbs.ball, readings, truth)
        keep(limbs.guard, limbs.progress, estimate.pose, readings.ball, tick)
    pursue(limbs.plan, limbs.progress, readings.joint, readings.joint_rate, tick, dt)
    _note(limbs, truth, readings, tick)
    turn_joints(arms, truth, limbs.progress.torque, readings.joint_rate)


@inner
def _note(limbs: Limbs, truth: Truth, readings: Readings, tick: int) -> None:
    """Write down the goals whose hold ended in this tick."""
    for arm in range(limbs.end_tick.shape[0]):
        goal = limbs.progress.ended[arm]
        if goal < 0:
            continue
        limbs.end_tick[arm, goal] = tick
        row, carrier = limbs.arms.first[arm] + LINKS - 1, limbs.arms.carrier[arm]
        for k in range(3):
            limbs.end_tip[arm, goal, k] = truth.body[row, k]
            limbs.end_joint[arm, goal, k] = readings.joint[arm, k]
            if carrier >= 0:
                limbs.end_base[arm, goal, k] = truth.body[carrier, k]


def ends(limbs: Limbs) -> list[list[dict[str, Any]]]:
    """For the meta data of a recording: each arm's goals whose holds ended, field frame, SI."""
    return [
        [
            {
                "end_tick": int(limbs.end_tick[arm, k]),
                "tip_link": limbs.end_tip[arm, k].tolist(),
                "carrier": limbs.end_base[arm, k].tolist(),
                "joints": limbs.end_joint[arm, k].tolist(),
            }
            for k in range(int(limbs.plan.goals[arm]))
            if limbs.end_tick[arm, k] >= 0
        ]
        for arm in range(len(limbs.plan.goals))
    ]
