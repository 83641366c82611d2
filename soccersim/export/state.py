"""The numbers of each robot and of the game at some records, under the names of docs/export.md."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.export.frames import placed
from soccersim.export.remarks import label_table
from soccersim.record.recording import Recording
from soccersim.sheet import PHASES
from soccersim.touches import BallPlay

SIDES = ("home", "away")
WHEELS = ("wheel_speed", "wheel_setpoint", "slip", "load", "counts", "pwm")
DIGITS = 9

Array = NDArray[Any]


def wheel_counts(recording: Recording) -> list[int]:
    """How many wheels each robot has, driven and dead."""
    models = [player.model for player in recording.scenario.robots]
    dead = [len(model.dead.azimuth_deg) if model.dead else 0 for model in models]
    return [len(model.drive.azimuth_deg) + more for model, more in zip(models, dead, strict=True)]


def errors(true: Array, believed: Array) -> tuple[Array, Array]:
    """How far belief lies from truth: distance, and believed less true angle, -pi to pi."""
    off = believed[..., :3] - true[..., :3]
    return np.hypot(off[..., 0], off[..., 1]), (off[..., 2] + np.pi) % (2 * np.pi) - np.pi


def body_twist(body: Array) -> Array:
    """(..., 3) vx, vy, omega in the body frame, of bodies (..., 6) in the field frame."""
    c, s = np.cos(body[..., 2]), np.sin(body[..., 2])
    vx, vy = body[..., 3], body[..., 4]
    return np.stack((c * vx + s * vy, c * vy - s * vx, body[..., 5]), axis=-1)


def states(recording: Recording, part: slice) -> list[list[dict[str, Any]]]:
    """For each of these records and each robot what is known of it, ready for JSON."""
    robots = len(recording.scenario.robots)
    body = recording.body[part, :robots].astype(float)
    belief = recording.estimate[part].astype(float)
    far, turned = errors(body, belief)
    tables = {
        "true": _named(body[..., :3], "x", "y", "heading"),
        "believed": _named(belief, "x", "y", "heading"),
        "error": _named(np.stack((far, turned), axis=-1), "position", "heading"),
        "twist": _named(body_twist(body), "vx", "vy", "omega"),
        **(_match(recording, part) if recording.match else _run(recording, part)),
    }
    keys = list(tables)
    return [
        [dict(zip(keys, robot, strict=True)) for robot in zip(*record, strict=True)]
        for record in zip(*tables.values(), strict=True)
    ]


def _run(recording: Recording, part: slice) -> dict[str, Any]:
    arrays = {key: array[part] for key, array in recording.arrays.items()}
    told: dict[str, Any] = {"leg": arrays["leg"].tolist()}
    told["reference"] = _named(arrays["reference"], "x", "y", "heading")
    told |= _recorded(recording, arrays)
    return told


def _recorded(recording: Recording, arrays: dict[str, Array]) -> dict[str, Any]:
    """The groups of arrays that the scenario's `record` names."""
    told: dict[str, Any] = {}
    counts = wheel_counts(recording)
    if "command" in arrays:
        told["command"] = _named(arrays["command"], "vx", "vy", "omega")
    for key in WHEELS:
        if key in arrays:
            rows = _rounded(arrays[key])
            told[key] = [[w[:n] for w, n in zip(row, counts, strict=True)] for row in rows]
    if "gyro" in arrays:
        told["gyro"] = _rounded(arrays["gyro"])
    return told


def _match(recording: Recording, part: slice) -> dict[str, Any]:
    decision = BallPlay(recording).decision[part]
    orders = recording.arrays["orders"][decision].astype(float)
    arrays = {k: recording.arrays[k][part] for k in (*WHEELS, "gyro") if k in recording.arrays}
    return {
        "command": _named(orders[..., :3], "vx", "vy", "omega"),
        "kick": _rounded(orders[..., 3]),
        "dribble": (orders[..., 4] > 0).tolist(),
        "in_play": (recording.arrays["in_play"][decision] > 0).tolist(),
        "label": label_table(recording)[decision].tolist(),
        **_recorded(recording, arrays),
    }


def game(recording: Recording, part: slice) -> list[list[tuple[str, Any]]]:
    """Of a match, at each of these records: its state, and where each team believed the ball."""
    if not recording.match:
        return []
    decision, arrays = BallPlay(recording).decision[part], recording.arrays
    balls = arrays["ball_believed"][decision].astype(float)
    rows = []
    for row, at in enumerate(decision.tolist()):
        whose = int(arrays["whose"][at])
        home, away = arrays["score"][at].tolist()
        state = {
            "phase": PHASES[arrays["phase"][at]],
            "whose": SIDES[whose] if whose >= 0 else "",
            "started": bool(arrays["started"][at]),
            "score": {"home": home, "away": away},
        }
        seen = [
            (f"/{side}/ball", placed(np.array([[x, y, 0.0]]))[0])
            for side, (x, y, *_) in zip(SIDES, balls[row].tolist(), strict=True)
            if x == x  # not NaN
        ]
        rows.append([("/game", state), *seen])
    return rows


def _named(table: Array, *names: str) -> list[list[dict[str, Any]]]:
    """Rows (n, R, len(names)) as mappings, None for NaN."""
    return [[dict(zip(names, values, strict=True)) for values in row] for row in _rounded(table)]


def _rounded(table: Array) -> list[Any]:
    """Numbers ready for JSON, None for NaN."""
    if table.dtype.kind != "f":
        return list(table.tolist())
    near = np.round(table.astype(float), DIGITS) + 0.0  # no -0.0
    unknown = np.isnan(near)
    if not unknown.any():
        return list(near.tolist())
    mixed = near.astype(object)
    mixed[unknown] = None
    return list(mixed.tolist())
