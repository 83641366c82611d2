"""The notes of both teams: their kinds and words as they change, their places as channels.

A team may draw lines that follow the ball, anew at every decision. Told in words they would take
more room than all poses together.
"""

from bisect import bisect_right
from typing import Any

import numpy as np

from soccersim.record.recording import Recording
from soccersim.render.page.pack import Array

NUMBERS = {"line": 4, "circle": 3, "text": 2}  # of each kind: x, y, and so on
PLACE = 0.01  # m, to which they are told

Notes = list[list[Any]]  # each: its kind, its numbers, of a text the words


def noted(recording: Recording, slot: int, decisions: list[int]) -> list[Notes]:
    """What stands on the field at each of these decisions."""
    rows = [row for row in (recording.match or {})["notes"] if row[1] == slot]
    changes = [row[0] for row in rows]
    found = (bisect_right(changes, decision) - 1 for decision in decisions)
    return [rows[at][2] if at >= 0 else [] for at in found]


def kinds(notes: Notes) -> list[list[str]]:
    """Kind of each note, and the words of a text."""
    return [[note[0], *note[1 + NUMBERS[note[0]] :]] for note in notes]


def places(told: list[Notes]) -> Array:
    """(T, n): the numbers of all notes of a moment one after the other, then NaN."""
    rows = [[n for note in notes for n in note[1 : 1 + NUMBERS[note[0]]]] for notes in told]
    table = np.full((len(rows), max(map(len, rows), default=0)), np.nan)
    for row, numbers in zip(table, rows, strict=True):
        row[: len(numbers)] = numbers
    return table
