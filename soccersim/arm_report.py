"""What arms and shots came to: their part of report.json."""

from math import cos, hypot, pi, sin
from typing import Any

import numpy as np

from soccersim.record import Recording
from soccersim.spec.arm import Arm
from soccersim.spec.scenario import Scenario


def arms(recording: Recording) -> list[dict[str, Any]]:
    """Each arm's goals: where the tip should be and where it truly was when its hold ended.

    Poses are from the arm's base: x, y of the tip in m and direction of the last link in rad.
    """
    scenario = recording.scenario
    return [
        {
            "name": arm.name,
            "goals": [
                _goal(scenario, arm, k, end) for k, end in enumerate(recording.meta["arms"][i])
            ],
        }
        for i, arm in enumerate(scenario.arms)
    ]


def _goal(scenario: Scenario, arm: Arm, k: int, end: dict[str, Any]) -> dict[str, Any]:
    target = scenario.coordinates.local(arm.reaches[k].to)
    tip = tip_from_base(scenario, arm, end["tip_link"], end["carrier"])
    return {
        "target": list(target),
        "tip": list(tip),
        "joints": end["joints"],
        "position_error": hypot(tip[0] - target[0], tip[1] - target[1]),
        "angle_error": abs((tip[2] - target[2] + pi) % (2 * pi) - pi),
        "time": end["end_tick"] / scenario.timing.physics_hz,
    }


def tip_from_base(
    scenario: Scenario, arm: Arm, link: list[float], carrier: list[float]
) -> tuple[float, float, float]:
    """The tip's pose seen from the first joint; link is the last link's middle on the field."""
    half = arm.lengths[-1] / 2
    tip = complex(link[0] + half * cos(link[2]), link[1] + half * sin(link[2]))
    x, y, heading = arm.base_pose(scenario.coordinates)
    base = complex(x, y)
    if arm.on:
        base = complex(*carrier[:2]) + base * complex(cos(carrier[2]), sin(carrier[2]))
        heading += carrier[2]
    seen = (tip - base) * complex(cos(heading), -sin(heading))
    return seen.real, seen.imag, link[2] - heading


def shots(recording: Recording) -> list[dict[str, Any]]:
    """For each start of the ball whether it ended in a goal, and on which side of the field."""
    scenario, ball = recording.scenario, recording.ball
    if scenario.ball is None or ball is None or not scenario.ball.shots:
        return []
    times = [0.0, *(shot.time for shot in scenario.ball.shots)]
    field, result = scenario.field, []
    for start, end in zip(times, [*times[1:], np.inf], strict=True):
        own = ball[(recording.time >= start) & (recording.time < end)]
        behind = np.abs(own[:, 0]) > field.half_length
        inside = behind & (np.abs(own[:, 1]) < field.goal.width / 2)
        inside &= np.abs(own[:, 0]) < field.half_length + field.goal.depth
        side = float(own[inside][0, 0]) if inside.any() else 0.0
        goal = "" if not inside.any() else ("away" if side > 0 else "home")
        result.append({"time": start, "goal": goal or None})
    return result
