"""Matches made by hand: ten robots pass a ball about, with all that a match's recording holds."""

from typing import Any

import numpy as np
from synthetic import PHYSICS_HZ, RECORD_HZ

from soccersim.record.recording import Recording
from soccersim.sheet import PHASES
from soccersim.spec.load import load_scenario

DECIDE_HZ = 25
SCRIPT = (  # seconds, phase, whose, started, what the referee said before
    (0.0, "kick_off", 0, 0, None),
    (3.0, "kick_off", 0, 1, None),
    (4.0, "play", -1, 1, None),
    (20.0, "stop", 1, 0, ("out", 1, "over the touch line, last touched by home-3")),
    (22.0, "throw_in", 1, 0, ("throw_in", 1, "throw-in for away")),
    (25.0, "throw_in", 1, 1, None),
    (26.0, "play", -1, 1, None),
    (40.0, "stop", 1, 0, ("goal", 0, "goal by home-4 for home")),
    (42.0, "kick_off", 1, 0, ("kick_off", 1, "kick-off for away")),
    (45.0, "play", -1, 1, None),
    (52.0, "stop", 0, 0, ("pushing", 1, "away-2 pushes home-5 in its own penalty area")),
    (54.0, "penalty", 0, 1, ("penalty", 0, "penalty for home")),
    (56.0, "play", -1, 1, None),
)


def match(
    seconds: float = 60.0,
    name: str = "msl-match",
    home: str = "roles",
    away: str = "chaser",
    score: tuple[int, int] = (0, 0),
    talk: bool = True,
    duration: float | None = None,
) -> Recording:
    """Robots on loops, a ball that goes from one to the next; ends change at half time.

    talk: with labels and notes. The script of the referee's decisions begins anew each minute.
    """
    settings = [f"duration={duration or seconds}", f"match.home.strategy={home}"]
    scenario = load_scenario(name, settings=[*settings, f"match.away.strategy={away}"])
    every = PHYSICS_HZ // RECORD_HZ
    time = np.arange(0, seconds, 1 / RECORD_HZ)
    robots = len(scenario.robots)
    field = scenario.field
    bodies = np.zeros((len(time), robots + 1, 6))
    random = np.random.default_rng(1)
    for i in range(robots):
        phase, pace = 2 * np.pi * i / robots, 0.11 + 0.02 * (i % 5)
        bodies[:, i, 0] = 0.46 * field.length * np.sin(pace * time + phase)
        bodies[:, i, 1] = 0.44 * field.width * np.sin(1.7 * pace * time + 2.6 * phase)
        bodies[:, i, 2] = 0.6 * time * (-1) ** i + phase
    holder, kicks = _pass_about(time, bodies, scenario.robots[0].model.radius + 0.12)
    bodies[1:, :, 3:5] = np.diff(bodies[:, :, :2], axis=0) * RECORD_HZ
    decisions = np.arange(0, len(time), RECORD_HZ // DECIDE_HZ)
    believed = bodies[:, :robots, :3] + 0.02 * random.standard_normal((1, robots, 3))
    believed[:, 3, :2] += 0.9
    arrays = {
        "tick": np.arange(len(time)) * every,
        "chain": np.zeros((len(time), 4), np.uint8),
        "body": bodies.astype(np.float32),
        "estimate": believed.astype(np.float32),
        **_decided(time[decisions], robots, score, (duration or seconds) / 2),
    }
    count = len(decisions)
    ball = bodies[decisions, robots][:, [0, 1, 3, 4]]
    seen = np.full((count, 2, 5), np.nan, np.float32)
    seen[:, 0, :4] = ball + 0.15
    seen[:, 1, :4] = ball - 0.4
    seen[:, :, 4] = 0.08
    seen[(time[decisions] % 7) < 1, 1] = np.nan
    contact = np.zeros((count, robots), np.uint8)
    held = np.nonzero(holder[decisions] >= 0)[0]
    contact[held, holder[decisions][held]] = 1
    kicked = np.full((count, robots), -1, np.int32)
    for record, robot in kicks:
        kicked[decisions > record, robot] = record * every
    arrays |= {"ball_believed": seen, "contact": contact, "kicked": kicked}
    said = _said(bodies[decisions], robots) if talk else {"labels": [], "notes": []}
    meta = {
        "format": 2,
        "soccersim": "0",
        "scenario": scenario.model_dump(mode="json"),
        "seed": 3,
        "digest": "0" * 64,
        "physics_hz": PHYSICS_HZ,
        "ticks": len(time) * every,
        "platform": {},
        "legs": [[] for _ in range(robots)],
        "arms": [],
        "match": {
            "home": home,
            "away": away,
            "score": arrays["score"][-1].tolist(),
            "events": _events(seconds),
            "faults": [],
            **said,
        },
    }
    return Recording(meta, arrays)


def _pass_about(time: Any, bodies: Any, reach: float) -> tuple[Any, list[tuple[int, int]]]:
    """Let the ball go from robot to robot, two seconds each and one on its way."""
    robots = bodies.shape[1] - 1
    holder = np.full(len(time), -1)
    kicks = []
    order = [1, 3, 4, 2, 7, 8, 6, 9, 2, 1]
    hold, fly = 2 * RECORD_HZ, RECORD_HZ
    for n, start in enumerate(range(0, len(time), hold + fly)):
        robot, after = order[n % len(order)], order[(n + 1) % len(order)]
        end = min(start + hold, len(time))
        span = slice(start, end)
        heading = bodies[span, robot, 2]
        toward = np.stack((np.cos(heading), np.sin(heading)), axis=1)
        bodies[span, robots, :2] = bodies[span, robot, :2] + reach * toward
        holder[span] = robot
        stop = min(end + fly, len(time))
        if end < len(time):
            kicks.append((end, robot))
            target = min(end + fly, len(time) - 1)
            t = bodies[target, after, 2]
            goal = bodies[target, after, :2] + reach * np.array((np.cos(t), np.sin(t)))
            way = np.linspace(0, 1, stop - end + 1)[1:, None]
            from_ = bodies[end - 1, robots, :2]
            bodies[end:stop, robots, :2] = from_ + way * (goal - from_)
    return holder, kicks


def _decided(time: Any, robots: int, score: tuple[int, int], half: float) -> dict[str, Any]:
    """What the referee said at each decision."""
    count = len(time)
    begins = np.array([row[0] for row in SCRIPT])
    row = np.searchsorted(begins, time % 60.0, side="right") - 1
    goals = np.array(score) + np.stack((np.floor((time + 20.0) / 60.0), np.zeros(count)), axis=1)
    in_play = np.ones((count, robots), np.uint8)
    in_play[(time % 60.0) > 10.0, -1] = 0
    return {
        "decision_tick": (time * PHYSICS_HZ).round().astype(np.int64),
        "orders": np.zeros((count, robots, 5), np.float32),
        "in_play": in_play,
        "phase": np.array([PHASES.index(SCRIPT[i][1]) for i in row], np.uint8),
        "whose": np.array([SCRIPT[i][2] for i in row], np.int8),
        "started": np.array([SCRIPT[i][3] for i in row], np.uint8),
        "score": goals.astype(np.uint8),
        "direction": np.where(time < half, 1, -1).astype(np.int8),
    }


def _events(seconds: float) -> list[dict[str, Any]]:
    events = []
    for minute in range(int(seconds // 60) + 1):
        for at, _, _, _, said in SCRIPT:
            time = 60.0 * minute + at
            if said and time < seconds:
                kind, side, text = said
                events.append(
                    {
                        "tick": round(time * PHYSICS_HZ),
                        "time": time,
                        "kind": kind,
                        "rule": "Law 0",
                        "place": [0.0, 0.0],
                        "robots": ["home-4"],
                        "side": ("home", "away")[side],
                        "text": text,
                    }
                )
    return events


def _said(bodies: Any, robots: int) -> dict[str, Any]:
    """Labels that stay, and notes that move with the ball."""
    labels = [[0, row, text] for row, text in enumerate(("keeper", "defend", "support", "press"))]
    labels += [[0, row, f"chase {row}"] for row in range(5, robots)]
    notes: list[list[Any]] = []
    for decision in range(0, len(bodies), 5):
        ball, robot, other = bodies[decision, -1], bodies[decision, 2], bodies[decision, 7]
        x, y = (round(float(v), 3) for v in ball[:2])
        u, v = (round(float(c), 3) for c in robot[:2])
        p, q = (round(float(c), 3) for c in other[:2])
        notes.append(
            [decision, 0, [["line", u, v, x, y], ["text", u, v, "goes for the ball"],
                           ["circle", x, y, 1.0]]]
        )  # fmt: skip
        notes.append([decision, 1, [["line", p, q, x, y], ["circle", p, q, 2.0]]])
    return {"labels": labels, "notes": notes}
