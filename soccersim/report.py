"""What a run came to, leg by leg, beside the paper's numbers: the content of report.json.

Poses are in the scenario's frame: metres and radians, headings counter-clockwise and unwrapped.
Errors are distances and magnitudes of angles.
"""

from math import hypot, pi
from typing import Any

import numpy as np

from soccersim.arm_report import arms, shots
from soccersim.record import Recording
from soccersim.spec.frame import Coordinates, Vector
from soccersim.spec.player import Paper
from soccersim.spec.scenario import Scenario

Leg = dict[str, Any]
ERRORS = {  # key: the two poses it compares, position first, then heading
    "odometry_error": ("odometry", "target"),
    "truth_error": ("truth", "target"),
    "drift": ("truth", "odometry"),
    "odometry_heading_error": ("odometry", "target"),
    "truth_heading_error": ("truth", "target"),
    "heading_drift": ("truth", "odometry"),
}


def report(recording: Recording) -> dict[str, Any]:
    """The report of one run, ready for JSON."""
    scenario = recording.scenario
    return {
        "scenario": scenario.name,
        "seed": recording.meta["seed"],
        "digest": recording.digest,
        "duration": recording.duration,
        "frame": {
            "length": "m",
            "angle": "rad",
            "heading": "ccw",
            "origin": list(scenario.frame.origin),
            "rotation": scenario.coordinates.rotation,
            "mirror_y": scenario.frame.mirror_y,
        },
        "robots": robots(recording),
        "arms": arms(recording),
        "shots": shots(recording),
    }


def robots(recording: Recording) -> list[dict[str, Any]]:
    """Each robot's name and legs."""
    scenario = recording.scenario
    return [
        {
            "name": player.name,
            "legs": [_leg(scenario, i, k, leg) for k, leg in enumerate(recording.legs[i])],
        }
        for i, player in enumerate(scenario.robots)
    ]


def _leg(scenario: Scenario, robot: int, k: int, leg: Leg) -> Leg:
    at = scenario.coordinates
    path = scenario.robots[robot].path
    paper = path[k].paper if path else None
    poses = {
        "target": list(at.framed(path[k].to)) if path else None,
        "odometry": list(at.from_field(leg["odometry"])),
        "truth": list(at.from_field(leg["truth"])),
    }
    return {
        **poses,
        **errors(poses),
        "time": (leg["end_tick"] - leg["start_tick"]) / scenario.timing.physics_hz,
        "reached": leg["reached"],
        "paper": _paper(paper, poses["target"], at) if paper else None,
    }


def errors(poses: dict[str, Any]) -> Leg:
    """The six errors between target, odometry and truth; None where a pose is not known."""
    result: Leg = {}
    for key, (one, other) in ERRORS.items():
        a, b = poses.get(one), poses.get(other)
        if a is None or b is None:
            result[key] = None
        elif "heading" not in key:
            result[key] = hypot(a[0] - b[0], a[1] - b[1])
        elif a[2] is None or b[2] is None:
            result[key] = None
        else:
            result[key] = abs((a[2] - b[2] + pi) % (2 * pi) - pi)
    return result


def _paper(paper: Paper, target: Any, at: Coordinates) -> Leg:
    """The paper's numbers as printed, in the units and the frame of the report."""
    poses = {
        "target": target,
        "odometry": _framed(paper.odometry, at),
        "truth": _framed(paper.truth, at),
    }
    return {**poses, **errors(poses), "time": paper.time, "source": paper.source}


def _framed(pose: tuple[float, float, float | None] | None, at: Coordinates) -> list[Any] | None:
    if pose is None:
        return None
    x, y, heading = pose
    framed: Vector = at.framed((x, y, heading or 0.0))
    return [framed[0], framed[1], None if heading is None else framed[2]]


def bands(runs: list[list[dict[str, Any]]]) -> list[dict[str, Any]]:
    """Over the robots of several runs: 5, 50 and 95 % of every error and time of each leg."""
    result = []
    for i, first in enumerate(runs[0]):
        legs = []
        for k, leg in enumerate(first["legs"]):
            alike = [run[i]["legs"][k] for run in runs if k < len(run[i]["legs"])]
            legs.append(
                {key: _band(alike, key) for key in (*ERRORS, "time") if leg[key] is not None}
            )
            legs[-1]["reached"] = sum(other["reached"] for other in alike) / len(runs)
        result.append({"name": first["name"], "legs": legs})
    return result


def _band(legs: list[Leg], key: str) -> list[float]:
    return [float(v) for v in np.percentile([leg[key] for leg in legs], (5, 50, 95))]
