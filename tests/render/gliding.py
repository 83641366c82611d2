"""Recordings made without a simulation: robots glide along their paths and believe they arrive."""

import numpy as np

from soccersim.record import Recording
from soccersim.spec.scenario import Scenario

HZ, RECORD_HZ = 500, 50
MODEL = {
    "drive": {"azimuth_deg": [30, 150, 270], "distance": 0.19, "radius": 0.05, "encoder": {}},
    "odometry": {"heading": "wheels"},
}
MSL = {
    "length": 22.0, "width": 14.0, "goal": {"width": 2.4, "depth": 0.6},
    "penalty_area": {"depth": 2.25, "width": 6.9}, "goal_area": {"depth": 0.75, "width": 3.9},
    "penalty_mark": 3.6, "centre_circle": 2.0, "corner_arc": 0.75,
}  # fmt: skip
KRSBI = {
    "length": 12.0, "width": 8.0, "line_width": 0.1, "goal": {"width": 2.0},
    "penalty_area": {"depth": 1.5, "width": 5.0}, "goal_area": {"depth": 0.5, "width": 3.0},
    "penalty_mark": 2.0, "centre_circle": 1.33, "corner_arc": 0.5,
}  # fmt: skip


def player(name, start, path=(), **more):
    legs = [{"to": leg} if isinstance(leg, list) else leg for leg in path]
    return {"name": name, "model": MODEL, "start": start} | ({"path": legs} if legs else {}) | more


def scenario(*robots, **more):
    return {"version": 1, "name": "synthetic", "field": KRSBI, "robots": list(robots), **more}


def synthetic(spec, leg_seconds=4.0, lost=(), slip=0.97, turned=0.06, laps=1):
    """A recording of robots that glide along their paths and believe that they arrive.

    Truth is the estimate scaled by slip and turned about the start, leg by leg; the legs
    numbered in lost stop half-way.
    """
    checked = Scenario.model_validate(spec)
    runs = [
        _glide(checked, robot, leg_seconds, lost, slip, turned, laps) for robot in checked.robots
    ]
    length = max(len(run[0]) for run in runs)
    estimate, truth, reference, leg = (
        np.stack([_held(run[k], length) for run in runs], axis=1) for k in range(4)
    )
    body = np.concatenate((truth, np.zeros_like(truth)), axis=2)
    if checked.ball:
        body = np.concatenate((body, _rolling(checked, length)[:, None]), axis=1)
    tick = np.arange(length) * (HZ // RECORD_HZ)
    meta = {
        "format": 1, "scenario": spec, "seed": 3, "digest": "0" * 64, "physics_hz": HZ,
        "ticks": int(tick[-1]), "legs": [run[4] for run in runs],
    }  # fmt: skip
    arrays = {"tick": tick, "body": body, "estimate": estimate, "reference": reference, "leg": leg}
    return Recording(meta, arrays)


def _glide(checked, robot, seconds, lost, slip, turned, laps):
    at, n = checked.coordinates, int(seconds * RECORD_HZ)
    start = np.array(at.field_pose(robot.start))
    stops = [np.array(at.field_pose(leg.to)) for leg in robot.path or ()] * laps
    open_loop = not stops
    stops = stops or [start + np.array(way) for way in ((1.5, 0.3, 3.5), (2.0, 1.5, 7.5))]
    believed, true, wanted, number, legs = [start], [start], [stops[0]], [0], []
    for k, stop in enumerate(stops):
        share = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, n + 1)[1:])
        way = share[:, None] * (stop - believed[-1]) * (0.5 if k in lost else 1.0)
        turn = turned * (-1) ** k * np.hypot(*way[-1, :2]) / 2
        c, s = slip * np.cos(turn), slip * np.sin(turn)
        there = way @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + share[:, None] * (0, 0, turn)
        base, truth = believed[-1], true[-1]
        believed += list(base + way)
        true += list(truth + there)
        wanted += [stop] * n
        number += [k] * n
        legs.append({
            "start_tick": k * n * 10, "end_tick": (k + 1) * n * 10,
            "reached": not open_loop and k not in lost,
            "target": None if open_loop else stop.tolist(),
            "odometry": believed[-1].tolist(), "truth": true[-1].tolist(),
        })  # fmt: skip
    wanted = np.array(wanted) * (np.nan if open_loop else 1.0)
    return np.array(believed), np.array(true), wanted, np.array(number), legs


def _held(rows, length):
    return np.concatenate((rows, np.repeat(rows[-1:], length - len(rows), axis=0)))


def _rolling(checked, length):
    x, y = checked.coordinates.field_pose((*checked.ball.at, 0.0))[:2]
    t = np.linspace(0, 6, length)
    zero = 0 * t
    return np.column_stack((x + 3 * np.sin(t), y + 2 * np.sin(2.3 * t), zero, zero, zero, zero))


DEFENDER = scenario(
    player(
        "utama", [0, 0, 0],
        [
            {"to": [0, 2000, 0],
             "paper": {"odometry": [20.2, 2003, 0], "truth": [30, 1981, None]}},
            {"to": [-2500, 2000, 0],
             "paper": {"odometry": [-2468, 2031, 0], "truth": [-2301, 2050, 7.41]}},
        ],
    ),
    name="defender", units={"length": "mm"},
    frame={"origin": [-4.0, -1.0], "rotation_deg": -90, "heading": "cw"},
)  # fmt: skip
MIRRORED = scenario(
    player("idris", [0, 0, 30], [[1, 0, 45], [1, 2, 90], [0, 0, 0]]),
    frame={"origin": [1.0, 2.0], "rotation_deg": 20, "mirror_y": True},
)
OPEN_LOOP = scenario(
    player("garcia", [0, 0, 30], open_loop=[{"seconds": 4, "twist": [0.4, 0, 1]}] * 2)
)
SQUARE = scenario(
    player("utama", [0, 0, 0], [[2, 0, 0], [2, 2, 90], [0, 2, 180], [0, 0, 270]], repeat=True)
)
ROLES = scenario(
    player("defender", [-4, -1, 0], [[-2, -1, 0], [-2, 2, 0]], number=2),
    player("midfielder", [-3, -2, 0], [[0, -3, 0], [1, 0, 90]], number=5),
    player("striker", [0, 1, 0], [[3, 1, 0], [4, -1, -90]], number=9, team="away"),
    ball={"at": [0.5, 0.0]},
)
KICKABOUT = scenario(
    *(
        player(f"robot {i}", [2 * i - 9, (-1) ** i * 2, 0],
               [[(7 * i + 5 * k) % 18 - 9, (5 * i + 4 * k) % 11 - 5, 60 * k] for k in range(1, 5)],
               number=i + 1)
        for i in range(10)
    ),
    name="kickabout", field=MSL, ball={"at": [0, 0]},
)  # fmt: skip
ALL = {
    "defender": DEFENDER, "mirrored": MIRRORED, "open loop": OPEN_LOOP,
    "square": SQUARE, "roles": ROLES, "kickabout": KICKABOUT,
}  # fmt: skip
