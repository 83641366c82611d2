"""What teams said in a match: labels behind their robots, notes on the field, where they change."""

from collections.abc import Iterator
from itertools import groupby, pairwise
from math import pi
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.export.frames import MAP, stamp
from soccersim.export.primitives import Entity, arc, entity, line, lying, scene, words
from soccersim.match_report import SIDES
from soccersim.record.recording import Recording
from soccersim.render import look

BEHIND = 1.7  # radii from a robot's middle to its label: its name stands above it
LETTER = 0.75  # height of a label's letters, in radii
NOTE_LETTER = 0.2  # m
ABOVE = 0.05, 0.6  # m, of lines above the floor, and of words: above the robots
THICK = 0.02  # m

Message = tuple[int, str, Any]  # tick, topic, content
Row = list[Any]  # decision, robot or slot, what was said


def label_table(recording: Recording) -> NDArray[np.object_]:
    """(D, R) str: the label of each robot from each decision on."""
    decisions, robots = recording.arrays["orders"].shape[:2]
    table = np.full((decisions, robots), "", object)
    said: list[list[tuple[int, str]]] = [[] for _ in range(robots)]
    for decision, robot, text in recording.match["labels"] if recording.match else ():
        said[robot].append((decision, text))
    for robot, own in enumerate(said):
        for (begin, text), (end, _) in pairwise([*own, (decisions, "")]):
            table[begin:end, robot] = text
    return table


def labels(recording: Recording, names: list[str], first: int) -> Iterator[Message]:
    """All labels at a tick, and again where one changes; names: of the robots, as ROS has them.

    Whoever jumps about in the log is told a topic's last message alone, so each is complete.
    """
    hz, robots = int(recording.meta["physics_hz"]), recording.scenario.robots
    said = [""] * len(robots)
    for tick, changed in groupby(_changes(recording, "labels", first), itemgetter(0)):
        for _, robot, text in changed:
            said[robot] = text.strip()
        at, shown = stamp(tick, hz), []
        for player, name, text in zip(robots, names, said, strict=True):
            if text:
                radius, ink = player.model.radius, look.tint(player.team)
                place = lying((-BEHIND * radius, 0), 2 * radius)
                word = words(text, place, LETTER * radius, ink)
                shown.append(entity(name, f"{name}/base_link", at, texts=[word]))
        yield tick, "/labels", scene(shown, at)


def notes(recording: Recording, first: int) -> Iterator[Message]:
    """The notes of both teams at a tick, and then each team's where they change."""
    hz = int(recording.meta["physics_hz"])
    for tick, slot, said in _changes(recording, "notes", first):
        at, side = stamp(tick, hz), SIDES[slot]
        yield tick, f"/{side}/notes", scene([_drawn(said, side, at)] if said else [], at)


def _drawn(said: list[Any], side: str, at: Any) -> Entity:
    """All notes of a team."""
    ink, (low, high) = look.tint(side), ABOVE
    texts, lines = [], []
    for kind, *numbers in said:
        if kind == "text":
            x, y, text = numbers
            texts.append(words(text, lying((x, y), high), NOTE_LETTER, ink))
        elif kind == "line":
            x, y, to_x, to_y = numbers
            lines.append(line([(x, y), (to_x, to_y)], THICK, ink, low))
        elif kind == "circle":
            x, y, radius = numbers
            lines.append(line(arc((x, y), radius, 0, 2 * pi), THICK, ink, low))
    return entity(side, MAP, at, lines=lines, texts=texts)


def _changes(recording: Recording, what: str, first: int) -> Iterator[tuple[int, int, Any]]:
    """Tick, robot or slot, and what it said from then on; of what came before only the last."""
    ticks = recording.arrays["decision_tick"].tolist() if recording.match else []
    rows: list[Row] = recording.match[what] if recording.match else []
    before = {whose: said for decision, whose, said in rows if ticks[decision] <= first}
    for whose, said in sorted(before.items()):
        if said:
            yield first, whose, said
    for decision, whose, said in rows:
        if ticks[decision] > first:
            yield ticks[decision], whose, said
