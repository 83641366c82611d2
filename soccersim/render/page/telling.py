"""The events of a page: what its time line marks, its list tells and its keys jump to."""

from math import degrees, hypot
from typing import Any

from soccersim.arm_report import arms, shots
from soccersim.match_report import SIDES
from soccersim.record.recording import Recording
from soccersim.render.cells import angle_text, distance_text
from soccersim.render.story import QUIET, Story

Event = dict[str, Any]
HIDDEN, ASIDE, MAIN = range(3)  # of no interest; in the list; jumped to
HUM = {"start", "in_play"}  # events that follow every restart
SHOT = "shot"


def match_events(recording: Recording, story: Story) -> list[Event]:
    """What the referee decided, forfeits and shots, in order of time."""
    events = [
        {
            "time": event["time"],
            "kind": event["kind"],
            "side": SIDES.index(event["side"]) if event["side"] in SIDES else None,
            "text": event["text"],
            "rule": event["rule"],
            "place": event["place"],
            "level": _level(event["kind"]),
        }
        for event in story.events
    ]
    faults = [] if recording.match is None else recording.match["faults"]
    for fault in faults:
        text = f"{fault['side']} forfeits the match: {fault['kind'].replace('_', ' ')}"
        events.append(_event(fault["tick"] / story.hz, "fault", text, SIDES.index(fault["side"])))
    return sorted([*events, *_shots(recording, story)], key=lambda event: event["time"])


def run_events(recording: Recording) -> list[Event]:
    """How each robot's legs and each arm's poses ended, and what became of shots."""
    hz, events = float(recording.meta["physics_hz"]), []
    for player, legs in zip(recording.scenario.robots, recording.legs, strict=True):
        for number, leg in enumerate(legs, 1):
            text = f"{player.name}: leg {number} {_ended(leg)}"
            side = int(player.team == "away")
            kind = "reached" if leg["reached"] else "missed"
            events.append(_event(leg["end_tick"] / hz, kind, text, side, leg["truth"][:2]))
    for arm in arms(recording):
        for number, goal in enumerate(arm["goals"], 1):
            off = _off(goal["position_error"], degrees(goal["angle_error"]))
            text = f"{arm['name']}: pose {number} held, off by {off}"
            events.append(_event(goal["time"], "reached", text, None))
    for number, shot in enumerate(shots(recording), 1):
        end = f"into the goal of {shot['goal']}" if shot["goal"] else "no goal"
        if shot["time"] <= recording.duration:
            events.append(_event(shot["time"], SHOT, f"shot {number}: {end}", None))
    return sorted(events, key=lambda event: event["time"])


def _ended(leg: dict[str, Any]) -> str:
    """A leg's end in words."""
    target, truth = leg["target"], leg["truth"]
    if target is None:
        return "driven"
    turned = (degrees(truth[2] - target[2]) + 180) % 360 - 180
    word = "reached" if leg["reached"] else "timed out"
    return f"{word}, off by {_off(hypot(truth[0] - target[0], truth[1] - target[1]), turned)}"


def _off(distance: float, turned: float) -> str:
    """A distance in m and an angle in degrees, in words; a number stays beside its unit."""
    return f"{distance_text(distance)} and {angle_text(turned)}".replace(" ", "\u00a0", 1)


def _shots(recording: Recording, story: Story) -> list[Event]:
    """Kicks that were shots."""
    events = []
    for slot in (0, 1):
        tried = set(story.shots.records[slot])
        on_goal = set(story.on_goal.records[slot])
        for kick in story.kicks:
            if kick.record in tried and story.sides[kick.robot] == slot:
                who = recording.scenario.robots[kick.robot].name
                goal = " on goal" if kick.record in on_goal else ""
                text = f"shot{goal} by {who}, {hypot(kick.vx, kick.vy):.1f} m/s"
                events.append(_event(kick.tick / story.hz, SHOT, text, slot, [kick.x, kick.y]))
    return events


def _event(
    time: float, kind: str, text: str, side: int | None, place: list[float] | None = None
) -> Event:
    return {
        "time": time,
        "kind": kind,
        "side": side,
        "text": text,
        "rule": "",
        "place": place,
        "level": MAIN,
    }


def _level(kind: str) -> int:
    if kind in HUM:
        return HIDDEN
    return ASIDE if kind in QUIET else MAIN
