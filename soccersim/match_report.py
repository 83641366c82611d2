"""What a match came to, from its recording: goals, shots, passes, possession, restarts, distances.

Seconds, metres, metres a second. A team's numbers stand under `home` and `away`.
"""

from collections import Counter
from math import hypot
from pathlib import PurePath
from typing import Any

import numpy as np

from soccersim.record.recording import Recording
from soccersim.sheet import PHASES
from soccersim.shots import passes, shots
from soccersim.touches import PLAY, RESTARTS, Array, BallPlay

SIDES = ("home", "away")
CARRIED = 10.0  # m/s; faster, a robot did not drive: the referee carried it
GENERIC = ("strategy", "team", "main", "__init__")  # names of files that tell nothing

Document = dict[str, Any]


def match_report(recording: Recording) -> Document:
    """The report of one match, ready for JSON; docs/recording.md tells its keys."""
    match, play = recording.match, BallPlay(recording)
    if match is None:
        raise ValueError(f"{recording.scenario.name} is no match")
    hz = float(recording.meta["physics_hz"])
    driven, names = distances(recording), team_names(recording)
    passed, shot = passes(play), shots(play)
    restarted, possession = restarts(recording), possessions(play)
    document: Document = {
        "scenario": recording.scenario.name,
        "seed": recording.meta["seed"],
        "digest": recording.digest,
        "duration": recording.duration,
        "score": match["score"],
        "in_play": share(recording.arrays["phase"] == PLAY),
        "ball": ball_speeds(play),
        "goals": [event for event in match["events"] if event["kind"] == "goal"],
        "shots": [
            {
                "time": kick.tick / hz,
                "side": SIDES[play.sides[kick.robot]],
                "robot": recording.scenario.robots[kick.robot].name,
                "speed": hypot(kick.vx, kick.vy),
                "on_goal": on_goal,
            }
            for kick, on_goal in shot
        ],
        "dropped_balls": restarted[2]["dropped_ball"],
        "events": dict(Counter(event["kind"] for event in match["events"])),
        "faults": match["faults"],
    }
    for slot, side in enumerate(SIDES):
        rows = [row for row, own in enumerate(play.sides) if own == slot]
        ours = [on_goal for kick, on_goal in shot if kick.robot in rows]
        document[side] = {
            "name": names[slot],
            "strategy": match[side],
            "possession": possession[slot],
            "shots": len(ours),
            "on_goal": sum(ours),
            "passes": sum(touch.robot in rows for touch in passed),
            "kicks": sum(kick.robot in rows for kick in play.kicks),
            "restarts": dict(restarted[slot]),
            "distance": {recording.scenario.robots[row].name: driven[row] for row in rows},
        }
    return document


def summary(report: Document) -> list[str]:
    """The report in a few lines of text."""
    sides = [report[side] for side in SIDES]
    home, away = report["score"]
    names = [shortened(side["name"], 15) for side in sides]
    rows = [
        ("", *names),
        ("possession", *(percent(side["possession"]) for side in sides)),
        ("shots (on goal)", *(f"{side['shots']} ({side['on_goal']})" for side in sides)),
        ("passes", *(side["passes"] for side in sides)),
        ("kicks", *(side["kicks"] for side in sides)),
        ("driven, m", *(f"{sum(side['distance'].values()):.0f}" for side in sides)),
    ]
    for kind in PHASES[RESTARTS[0] : PLAY]:
        given = [side["restarts"].get(kind, 0) for side in sides]
        if any(given):
            rows.append((kind.replace("_", " "), *given))
    lines = [f"{sides[0]['name']} {home} : {away} {sides[1]['name']}"]
    lines += [f"{word:15}{first!s:>16}{second!s:>16}".rstrip() for word, first, second in rows]
    if report["dropped_balls"]:
        lines.append(f"dropped balls  {report['dropped_balls']:>16}")
    lines.append(f"in play        {percent(report['in_play']):>16} of {report['duration']:.0f} s")
    ball = report["ball"]
    lines.append(f"ball           {ball['mean']:>12.1f} m/s on average, {ball['top']:.1f} at most")
    return lines


def percent(share: float | None) -> str:
    """A share in words; - where there is none."""
    return "-" if share is None else f"{100 * share:.0f} %"


def shortened(text: str, length: int) -> str:
    """The text, or its beginning with an ellipsis."""
    return text if len(text) <= length else text[: length - 1] + "…"


def team_names(recording: Recording) -> tuple[str, str]:
    """What the teams are called on pictures: the file's or the class's name, without folders."""
    match = recording.match or {}
    home, away = (team_name(match.get(side, side)) for side in SIDES)
    return home, away


def team_name(strategy: str) -> str:
    """A short name for a strategy named by bundled name, file, `file.py:Class` or module."""
    place, colon, kind = strategy.rpartition(":") if ":" in strategy[2:] else (strategy, "", "")
    path = PurePath(place.replace("\\", "/"))
    name = path.name.removesuffix(".py")
    if name in GENERIC and path.parent.name:
        name = path.parent.name
    elif not path.name.endswith(".py"):
        name = name.rpartition(".")[2] or name
    return f"{name}:{kind}" if colon and kind.lower() not in (*GENERIC, name.lower()) else name


def possessions(play: BallPlay) -> tuple[float | None, float | None]:
    """Of the time since somebody touched the ball, the share in which each side touched it last.

    Only while the ball may be played. None where nobody ever touched it.
    """
    away = np.array([*play.sides, 0])[play.holder] == 1
    had = play.holder >= 0
    if not had.any():
        return None, None
    of_away = float(away[had].mean())
    return 1.0 - of_away, of_away


def share(chosen: Array) -> float:
    """The share of decisions that are chosen; 0 of none."""
    return float(chosen.mean()) if len(chosen) else 0.0


def restarts(recording: Recording) -> list[Counter[str]]:
    """How often each kind was given to home, to away and to nobody, those taken again included."""
    phase, whose = recording.arrays["phase"].tolist(), recording.arrays["whose"].tolist()
    counts: list[Counter[str]] = [Counter(), Counter(), Counter()]
    before = (-1, -1)
    for now in zip(phase, whose, strict=True):
        if now != before and now[0] in RESTARTS:
            counts[now[1]][PHASES[now[0]]] += 1
        before = now
    return counts


def distances(recording: Recording) -> list[float]:
    """How far each robot drove or was pushed; being carried by the referee does not count."""
    places = recording.body[:, : len(recording.scenario.robots), :2].astype(float)
    steps = np.linalg.norm(np.diff(places, axis=0), axis=2)
    farthest = CARRIED * np.diff(recording.time)[:, None]
    return [float(d) for d in np.where(steps < farthest, steps, 0.0).sum(axis=0)]


def ball_speeds(play: BallPlay) -> dict[str, float]:
    """The mean speed while the ball may be played, and the highest."""
    speed = np.hypot(*play.ball[play.live, 3:5].T.astype(float))
    found = {"mean": speed.mean(), "top": speed.max()} if len(speed) else {"mean": 0.0, "top": 0.0}
    return {key: float(value) for key, value in found.items()}
