"""Matches to be drawn: ten robots on loops pass a ball about, with all that a recording holds."""

from typing import Any

import numpy as np
from tape import RECORD_HZ, STRIDE, event, tape

from soccersim.record.recording import Recording
from soccersim.spec.load import load_scenario

SCRIPT = (  # seconds, phase, whose, started, what the referee says then
    (0.0, "kick_off", 0, 0, None),
    (3.0, "kick_off", 0, 1, None),
    (4.0, "play", -1, 1, None),
    (20.0, "stop", 1, 0, ("out", "away", "over the touch line, last touched by home-3")),
    (22.0, "throw_in", 1, 0, ("throw_in", "away", "throw-in of away")),
    (25.0, "throw_in", 1, 1, None),
    (26.0, "play", -1, 1, None),
    (40.0, "stop", 1, 0, ("goal", "home", "goal by home-4 for home, 1:0")),
    (42.0, "kick_off", 1, 0, ("kick_off", "away", "kick-off of away")),
    (45.0, "play", -1, 1, None),
    (52.0, "stop", 0, 0, ("pushing", "away", "away-2 pushes home-5 in its own penalty area")),
    (54.0, "penalty", 0, 1, ("penalty", "home", "penalty of home")),
    (56.0, "play", -1, 1, None),
)
HOLD, FLY = 2 * RECORD_HZ, RECORD_HZ  # records that a robot has the ball, and that it flies
ORDER = (1, 3, 4, 2, 7, 8, 6, 9, 2, 1)  # who gets it


def match(
    seconds: float = 60.0,
    name: str = "msl-match",
    home: str = "roles",
    away: str = "chaser",
    score: tuple[int, int] = (0, 0),
    talk: bool = True,
    **more: Any,
) -> Recording:
    """A match whose script begins anew each minute; ends change at half time.

    score: before it. talk: with labels and notes. more: as tape() takes it.
    """
    field = load_scenario(name).field
    time = np.arange(0, seconds, 1 / RECORD_HZ)
    robots = np.zeros((len(time), 10, 3))
    for i in range(10):
        phase, pace = 2 * np.pi * i / 10, 0.11 + 0.02 * (i % 5)
        robots[:, i, 0] = 0.46 * field.length * np.sin(pace * time + phase)
        robots[:, i, 1] = 0.44 * field.width * np.sin(1.7 * pace * time + 2.6 * phase)
        robots[:, i, 2] = 0.6 * time * (-1) ** i + phase
    ball, holder, kicks = _passed_about(robots)
    believed = robots.copy()
    believed[:, 3, :2] += 0.9
    decided = _decided(time[::STRIDE], score, holder[::STRIDE], ball[::STRIDE])
    said = _said(robots[::STRIDE], ball[::STRIDE]) if talk else {}
    settings = (f"match.home.strategy={home}", f"match.away.strategy={away}")
    told = {"kicks": kicks, "events": _events(seconds), **decided, **said, **more}
    settings += tuple(told.pop("settings", ()))
    return tape(robots, ball, believed, scenario=name, settings=settings, **told)


def _passed_about(robots: Any) -> tuple[Any, Any, list[tuple[int, int]]]:
    """The ball's way, who has it (-1: it flies), and the kicks."""
    count = len(robots)
    heading = robots[..., 2]
    mouth = robots[..., :2] + 0.36 * np.stack((np.cos(heading), np.sin(heading)), axis=-1)
    ball, holder, kicks = np.zeros((count, 2)), np.full(count, -1), []
    for turn, start in enumerate(range(0, count, HOLD + FLY)):
        robot, after = ORDER[turn % len(ORDER)], ORDER[(turn + 1) % len(ORDER)]
        held = slice(start, start + HOLD)
        ball[held], holder[held] = mouth[held, robot], robot
        left, caught = start + HOLD, start + HOLD + FLY
        if left < count:
            kicks.append((left, robot))
            way = np.linspace(0, 1, FLY + 1)[1 : count - left + 1, None]
            target = mouth[min(caught, count - 1), after]
            ball[left:caught] = ball[left - 1] + way * (target - ball[left - 1])
    return ball, holder, kicks


def _decided(time: Any, score: tuple[int, int], holder: Any, ball: Any) -> dict[str, Any]:
    """The rows of the decisions."""
    count = len(time)
    row = np.searchsorted([line[0] for line in SCRIPT], time % 60.0, side="right") - 1
    contact = np.zeros((count, 10))
    contact[holder >= 0, holder[holder >= 0]] = 1
    in_play = np.ones((count, 10))
    in_play[(time % 60.0) > 10.0, -1] = 0
    seen = np.zeros((count, 2, 5))
    seen[:, 0, :2], seen[:, 1, :2] = ball + 0.15, ball - 0.4
    seen[:, :, 4] = 0.08
    seen[(time % 7) < 1, 1] = np.nan
    sighted = ball[:, None] + 0.3 * np.random.default_rng(1).standard_normal((count, 10, 2))
    sighted[:, 4] = np.nan
    sighted[(time % 5) < 1, 3] = np.nan
    goals = np.floor((time + 20.0) / 60.0)
    return {
        "phase": [SCRIPT[i][1] for i in row],
        "whose": [SCRIPT[i][2] for i in row],
        "started": [SCRIPT[i][3] for i in row],
        "contact": contact,
        "in_play": in_play,
        "ball_believed": seen,
        "ball_sighted": sighted,
        "score": np.array(score) + np.stack((goals, 0 * goals), axis=1),
        "direction": np.where(2 * time < time[-1], 1, -1),
    }


def _events(seconds: float) -> list[dict[str, Any]]:
    return [
        event(60.0 * minute + line[0], *line[4])
        for minute in range(int(seconds // 60) + 1)
        for line in SCRIPT
        if line[4] and 60.0 * minute + line[0] < seconds
    ]


def _said(robots: Any, ball: Any) -> dict[str, Any]:
    """Labels that stay, and notes that go with the ball."""
    labels = [[0, row, text] for row, text in enumerate(("keeper", "defend", "support", "press"))]
    labels += [[0, row, f"chase {row}"] for row in range(5, 10)]
    notes: list[list[Any]] = []
    for decision in range(0, len(ball), 5):
        x, y = ball[decision].tolist()
        (u, v), (p, q) = robots[decision, [2, 7], :2].tolist()
        line, text, circle = (
            ["line", u, v, x, y],
            ["text", u, v, "goes for it"],
            ["circle", x, y, 1.0],
        )
        notes.append([decision, 0, [line, text, circle]])
        notes.append([decision, 1, [["line", p, q, x, y], ["circle", p, q, 2.0]]])
    return {"labels": labels, "notes": notes}
