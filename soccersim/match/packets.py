"""What passes between a match and a team's own process: bytes, numbers and JSON, never a pickle.

Each packet has a head: its kind, and how long its body is. What a team's process sends is read
as if an enemy had written it.
"""

import json
import struct
from dataclasses import asdict
from math import isfinite
from typing import Any

from soccersim.match.faults import KINDS, last_lines
from soccersim.strategy.api import Area, Body, Pitch, Rules
from soccersim.strategy.check import (
    FARTHEST,
    FASTEST,
    LONGEST_LABEL,
    LONGEST_TEXT,
    MOST_NOTES,
    Answer,
    Mark,
    Order,
)

HEAD = struct.Struct("<BI")
SETUP, READY, ORDERS, WORDS, FAULT, MISTAKE = range(6)  # WORDS: orders, then new labels and notes
LONGEST = 64 * 1024  # bytes of a body that a team's process may send
NUMBERS = 5  # of an order: vx, vy, omega, kick, dribble 0 or 1
PLACES = {"line": 4, "circle": 3, "text": 2}  # numbers of a note


def packet(kind: int, body: bytes = b"") -> bytes:
    """Head and body."""
    return HEAD.pack(kind, len(body)) + body


def document(kind: int, value: Any) -> bytes:
    """A packet of JSON."""
    return packet(kind, json.dumps(value).encode())


class Writer:
    """Makes packets of answers; labels and notes go with them only where they have changed."""

    def __init__(self, count: int) -> None:
        self.form = struct.Struct(f"<{NUMBERS * count}d")
        self.labels: list[str] = [""] * count
        self.notes: list[Mark] = []

    def packet(self, answer: Answer) -> bytes:
        """The next answer."""
        numbers = self.form.pack(*[number for order in answer.orders for number in order])
        if answer.labels == self.labels and answer.notes == self.notes:
            return packet(ORDERS, numbers)
        self.labels, self.notes = answer.labels, answer.notes
        return packet(WORDS, numbers + json.dumps([self.labels, self.notes]).encode())


class Reader:
    """Reads answers; ValueError where the bytes are none."""

    def __init__(self, count: int) -> None:
        self.form = struct.Struct(f"<{NUMBERS * count}d")
        self.count = count
        self.labels: list[str] = [""] * count
        self.notes: list[Mark] = []

    def answer(self, kind: int, body: bytes) -> Answer:
        """What the next packet says."""
        size = self.form.size
        if kind == WORDS and len(body) > size:
            self.labels, self.notes = self.words(body[size:])
        elif kind != ORDERS or len(body) != size:
            raise ValueError(f"a packet of kind {kind} with {len(body)} bytes")
        return Answer(orders(self.form.unpack_from(body)), self.labels, self.notes)

    def words(self, body: bytes) -> tuple[list[str], list[Mark]]:
        """Labels and notes, checked again."""
        labels, notes = strict(body)
        listed(labels, self.count, self.count)
        for label in labels:
            text(label, LONGEST_LABEL)
        listed(notes, 0, MOST_NOTES)
        return labels, [mark(note) for note in notes]


def orders(numbers: tuple[float, ...]) -> list[Order]:
    """The orders of these numbers, which lie within the bounds that an answer's have."""
    real = all(map(isfinite, numbers)) and max(numbers) <= FASTEST and min(numbers) >= -FASTEST
    kicks, dribbles = numbers[3::NUMBERS], numbers[4::NUMBERS]
    if not real or min(kicks) < 0.0 or not {0.0, 1.0}.issuperset(dribbles):
        raise ValueError("orders that no robot can be given")
    moves = (numbers[0::NUMBERS], numbers[1::NUMBERS], numbers[2::NUMBERS])
    return list(zip(*moves, kicks, map(bool, dribbles), strict=True))


def strict(body: bytes) -> Any:
    """The value of a JSON text; ValueError for anything else, whatever it is."""
    try:
        return json.loads(body)
    except RecursionError:
        raise ValueError("JSON of too many levels") from None


def listed(value: Any, least: int, most: int) -> None:
    """ValueError if this is no list of so many."""
    if not isinstance(value, list) or not least <= len(value) <= most:
        raise ValueError("a list of another length")


def text(value: Any, longest: int) -> str:
    """A text in one line, no longer than this."""
    if not isinstance(value, str) or len(value) > longest or not value.isprintable():
        raise ValueError("a text that is none")
    return value


def mark(note: Any) -> Mark:
    """A note, as strategy/check.py makes them."""
    listed(note, 1, 5)
    kind, *rest = note
    places = PLACES.get(kind if isinstance(kind, str) else "")
    if places is None or len(rest) != places + (kind == "text"):
        raise ValueError("a note of no kind")
    for number in rest[:places]:
        real = isinstance(number, float) and isfinite(number)
        if not real or not -FARTHEST <= number <= FARTHEST:
            raise ValueError("a note that is nowhere")
    return (kind, *rest[:places], *(text(word, LONGEST_TEXT) for word in rest[places:]))


def fault(body: bytes) -> tuple[str, str]:
    """Kind and detail of a fault that the team's process tells of itself."""
    told = strict(body)
    listed(told, 2, 2)
    kind, detail = told
    if kind not in KINDS or not isinstance(detail, str):
        raise ValueError("a fault of no kind")
    return kind, last_lines(detail)


def mistakes(body: bytes) -> list[str]:
    """What the loader found wrong with the strategy's name, as problems' messages."""
    told = strict(body)
    listed(told, 1, 100)
    return [last_lines(str(line)) for line in told]


def pitch_document(pitch: Pitch) -> dict[str, Any]:
    """A pitch as JSON."""
    return asdict(pitch)


def pitch_from(told: dict[str, Any]) -> Pitch:
    """A pitch from its JSON."""
    areas = {key: told[key] and Area(**told[key]) for key in ("penalty_area", "goal_area")}
    bodies = tuple(Body(**body) for body in told["bodies"])
    return Pitch(**{**told, **areas, "rules": Rules(**told["rules"]), "bodies": bodies})
