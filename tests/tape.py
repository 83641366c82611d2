"""Matches made by hand: what a match's recording holds, without playing one."""

from typing import Any

import numpy as np

from soccersim.record.recording import Recording
from soccersim.sheet import PHASES
from soccersim.spec.load import load_scenario

RECORD_HZ, DECIDE_HZ, PHYSICS_HZ = 50, 25, 500
EVERY, STRIDE = (
    PHYSICS_HZ // RECORD_HZ,
    RECORD_HZ // DECIDE_HZ,
)  # ticks a record, records a decision
CARRIED = 30.0  # m/s; what is faster has been put there


def tape(
    robots: Any,
    ball: Any,
    believed: Any = None,
    kicks: list[tuple[int, int]] | None = None,
    scenario: str = "msl-match",
    settings: tuple[str, ...] = (),
    **told: Any,
) -> Recording:
    """Ways of the robots (T, R, 3) and the ball (T, 2); kicks: record and robot of each.

    told: any array of decisions, a phase by its name (else the ball is in play), and the lists of
    the meta document: events, faults, labels, notes.
    """
    robots = np.asarray(robots, float)
    records, count = robots.shape[:2]
    spec = load_scenario(scenario, settings=[f"duration={max(records, 1) / RECORD_HZ}", *settings])
    bodies = np.zeros((records, count + 1, 6), np.float32)
    bodies[:, :count, :3] = robots
    bodies[:, count, :2] = ball
    if records > 1:
        velocity = np.diff(bodies[:, :, :2], axis=0) * RECORD_HZ
        velocity[np.abs(velocity).max(axis=2) > CARRIED] = 0.0
        bodies[:-1, :, 3:5], bodies[-1, :, 3:5] = velocity, velocity[-1]
    arrays = {
        "tick": np.arange(records) * EVERY,
        "chain": np.zeros((records, 4), np.uint8),
        "body": bodies,
        "estimate": (robots if believed is None else np.asarray(believed)).astype(np.float32),
        **_decisions(records, count, kicks or [], told),
    }
    match = {
        "home": spec.match.home.strategy if spec.match else "",
        "away": spec.match.away.strategy if spec.match else "",
        "score": arrays["score"][-1].tolist() if records else [0, 0],
        **{key: told.get(key, []) for key in ("events", "faults", "labels", "notes")},
    }
    meta = {
        "format": 2,
        "soccersim": "0",
        "scenario": spec.model_dump(mode="json"),
        "seed": 3,
        "digest": "0" * 64,
        "physics_hz": PHYSICS_HZ,
        "ticks": records * EVERY,
        "platform": {},
        "legs": [[] for _ in range(count)],
        "arms": [],
        "match": match | told.get("match", {}),
    }
    return Recording(meta, arrays)


def _decisions(
    records: int, robots: int, kicks: list[tuple[int, int]], told: dict[str, Any]
) -> dict[str, Any]:
    """A row for every other record."""
    at = np.arange(0, records, STRIDE)
    count = len(at)
    kicked = np.full((count, robots), -1, np.int32)
    for record, robot in kicks:
        kicked[at > record, robot] = record * EVERY
    rows = {
        "decision_tick": at * EVERY,
        "orders": np.zeros((count, robots, 5), np.float32),
        "in_play": np.ones((count, robots), np.uint8),
        "contact": np.zeros((count, robots), np.uint8),
        "kicked": kicked,
        "ball_believed": np.full((count, 2, 5), np.nan, np.float32),
        "ball_sighted": np.full((count, robots, 2), np.nan, np.float32),
        "phase": np.full(count, PHASES.index("play"), np.uint8),
        "whose": np.full(count, -1, np.int8),
        "started": np.ones(count, np.uint8),
        "score": np.zeros((count, 2), np.uint8),
        "direction": np.ones(count, np.int8),
    }
    for key in rows.keys() & told.keys():
        value = told[key]
        if key == "phase":
            names = [value] * count if isinstance(value, str) else value
            value = [PHASES.index(name) for name in names]
        rows[key] = np.broadcast_to(value, rows[key].shape).astype(rows[key].dtype)
    return rows


def event(seconds: float, kind: str, side: str | None, text: str) -> dict[str, Any]:
    """A decision of the referee."""
    return {
        "tick": round(seconds * PHYSICS_HZ),
        "time": seconds,
        "kind": kind,
        "rule": "Law 0",
        "place": [0.0, 0.0],
        "robots": [],
        "side": side,
        "text": text,
    }
