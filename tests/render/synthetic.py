"""Recordings made by hand: what a renderer sees of a run, without simulating one."""

from functools import cache
from math import cos, pi, sin
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from soccersim.record.recording import Recording

FIELDS = Path(__file__).parents[2] / "scenarios" / "fields"
PHYSICS_HZ, RECORD_HZ = 500, 50
ENCODER = {"pulses_per_turn": 400}
LAYOUTS: dict[str, dict[str, Any]] = {
    "three": {"drive": {"azimuth_deg": [60, 180, 300]}},
    "four": {"drive": {"azimuth_deg": [45, 135, 225, 315]}},
    "six": {
        "drive": {"azimuth_deg": [60, 180, 300]},
        "dead": {"azimuth_deg": [0, 120, 240], "distance": 0.08, "radius": 0.025},
    },
}


@cache
def field(name: str) -> dict[str, Any]:
    """One of the bundled fields."""
    found: dict[str, Any] = yaml.safe_load((FIELDS / f"{name}.yaml").read_text())
    return found


def model(layout: str = "three", radius: float = 0.25) -> dict[str, Any]:
    """A robot with perfect wheels."""
    drive = {"distance": 0.19, "radius": 0.05, "encoder": ENCODER, **LAYOUTS[layout]["drive"]}
    odometry = {"heading": "wheels"}
    rest = {key: LAYOUTS[layout][key] for key in LAYOUTS[layout] if key != "drive"}
    return {"radius": radius, "drive": drive, "odometry": odometry, **rest}


def recording(
    true: Any,
    believed: Any = None,
    ball: Any = None,
    layouts: tuple[str, ...] = ("three",),
    teams: tuple[str, ...] = ("home",),
    paths: Any = None,
    leg: Any = None,
    on: str = "krsbi",
    name: str = "synthetic",
    record_hz: int = RECORD_HZ,
) -> Recording:
    """Robots on ways (T, R, 3) and a ball on one (T, 2), all on the field in SI.

    `layouts` and `teams` are dealt out in turn; `paths` holds a list of targets a robot.
    """
    true = np.asarray(true, float)
    count, robots = true.shape[:2]
    bodies = np.zeros((count, robots + (ball is not None), 6))
    bodies[:, :robots, :3] = true
    scenario: dict[str, Any] = {
        "version": 1,
        "name": name,
        "units": {"length": "m", "angle": "rad"},
        "timing": {"physics_hz": PHYSICS_HZ, "record_hz": record_hz, "frames_hz": 25},
        "field": field(on),
        "robots": [
            {
                "name": f"robot {i + 1}",
                "team": teams[i % len(teams)],
                "number": i // len(teams) + 1,
                "model": model(layouts[i % len(layouts)]),
                "start": true[0, i].tolist(),
                **({"path": [{"to": list(to)} for to in paths[i]]} if paths else {}),
            }
            for i in range(robots)
        ],
        "record": [],
    }
    if ball is not None:
        bodies[:, robots, :2] = ball
        scenario["ball"] = {"at": bodies[0, robots, :2].tolist()}
    every = PHYSICS_HZ // record_hz
    arrays = {
        "tick": np.arange(count) * every,
        "body": bodies,
        "estimate": true.copy() if believed is None else np.asarray(believed, float),
        "reference": np.full((count, robots, 3), np.nan),
        "leg": np.zeros((count, robots), int) if leg is None else np.asarray(leg),
    }
    meta = {
        "format": 1,
        "scenario": scenario,
        "seed": 3,
        "digest": "0" * 64,
        "physics_hz": PHYSICS_HZ,
        "ticks": (count - 1) * every,
        "legs": [[] for _ in range(robots)],
    }
    return Recording(meta, arrays)


def standing(*poses: tuple[float, float, float], records: int = 5, **options: Any) -> Recording:
    """Robots that stand still."""
    return recording(np.tile(np.array(poses), (records, 1, 1)), **options)


def kickabout(robots: int = 10, seconds: float = 60.0, on: str = "msl") -> Recording:
    """Robots and a ball on loops over the whole field; belief drifts away from the truth."""
    time = np.arange(0, seconds + 1e-9, 1 / RECORD_HZ)
    size = field(on)
    ways, beliefs, paths = [], [], []
    legs = range(0, len(time), 250)
    for i in range(robots):
        phase, pace = 2 * pi * i / robots, 0.08 + 0.01 * (i % 5)
        x = 0.46 * size["length"] * np.sin(pace * time + phase)
        y = 0.46 * size["width"] * np.sin(1.7 * pace * time + 2.6 * phase)
        heading = 0.6 * time * (-1) ** i + phase
        ways.append(np.stack((x, y, heading), axis=1))
        drift = 0.012 * (1 + i % 4) * time
        off = (drift * cos(phase), drift * sin(phase), 0.004 * (i % 5 - 2) * time)
        beliefs.append(ways[-1] + np.stack(off, axis=1))
        paths.append([ways[-1][min(k + 250, len(time) - 1)].tolist() for k in legs])
    ball = np.stack(
        (0.4 * size["length"] * np.cos(time / 2), 0.4 * size["width"] * np.sin(time)), 1
    )
    leg = np.tile((np.arange(len(time)) // 250)[:, None], (1, robots))
    return recording(
        np.stack(ways, axis=1),
        np.stack(beliefs, axis=1),
        ball,
        layouts=("three", "four", "six"),
        teams=("home", "away"),
        paths=paths,
        leg=leg,
        on=on,
        name="kickabout",
    )
