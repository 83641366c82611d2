"""What a team answered, checked: numbers for its robots, words and lines for the frames."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from numbers import Real
from typing import Any

from soccersim.problems import one_line
from soccersim.strategy.api import Circle, Command, Line, Text

FASTEST = 1000.0  # m/s, rad/s: asked for more, it is taken as this; no robot comes near
LONGEST_LABEL = 24  # characters; what is longer is cut
LONGEST_TEXT = 48
MOST_NOTES = 24  # of a team at one decision; what is over is dropped
FARTHEST = 1000.0  # m, of a note; it is moved to there
NOTES = {Line: ("x1", "y1", "x2", "y2"), Circle: ("x", "y", "radius"), Text: ("x", "y")}

Order = tuple[float, float, float, float, bool]
Mark = tuple[str | float, ...]  # "line", x1, y1, x2, y2; "circle", x, y, radius; "text", x, y, text


@dataclass(frozen=True, slots=True)
class Answer:
    """A whole and valid answer, as plain numbers and texts."""

    orders: list[Order]  # vx, vy, omega (body frame), kick m/s, dribble: one a robot
    labels: list[str]  # one a robot
    notes: list[Mark]  # team frame, m


def answer_of(result: Any, count: int) -> Answer:
    """The answer in what decide() returned for so many robots; ValueError tells what is wrong."""
    if type(result) is not list and type(result) is not tuple:
        result = listed(result, count)
    if len(result) != count:
        raise ValueError(f"decide() returned {some(len(result))} for {count} robots")
    orders: list[Order] = []
    labels: list[str] = []
    notes: list[Mark] = []
    for row, command in enumerate(result):
        if not isinstance(command, Command):
            raise ValueError(f"{place(row)} is {what(command)}, not a Command")
        vx, vy, omega, kick = command.vx, command.vy, command.omega, command.kick
        dribble, label = command.dribble, command.label
        if not (
            type(vx) is type(vy) is type(omega) is type(kick) is float
            and -FASTEST < vx < FASTEST
            and -FASTEST < vy < FASTEST
            and -FASTEST < omega < FASTEST
            and 0.0 <= kick < FASTEST
        ):
            vx, vy, omega, kick = (
                number(getattr(command, name), f"{name} of {place(row)}", FASTEST)
                for name in ("vx", "vy", "omega", "kick")
            )
            if kick < 0:
                raise ValueError(f"kick of {place(row)} is {kick:g} m/s: 0 is no kick")
        if type(dribble) is not bool:
            dribble = switch(dribble, f"dribble of {place(row)}")
        orders.append((vx, vy, omega, kick, dribble))
        labels.append(words(label, f"label of {place(row)}", LONGEST_LABEL) if label != "" else "")
        if command.notes != ():
            notes += marks(command.notes, f"notes of {place(row)}")
    return Answer(orders, labels, notes[:MOST_NOTES])


def place(row: int) -> str:
    """How messages name the answer for a robot."""
    return f"command {row + 1} of decide()"


def some(count: int) -> str:
    """1 command, 3 commands."""
    return f"{count} command{'' if count == 1 else 's'}"


def what(value: object) -> str:
    """What a wrong value is, in words: None, the text "abc", a list, an array of shape (5, 3)."""
    if value is None or isinstance(value, bool):
        return repr(value)
    if isinstance(value, str):
        return f'the text "{one_line(value)}"'
    if isinstance(value, type):
        return f"the class {one_line(value.__name__)}"
    kind = type(value).__name__
    shape = getattr(value, "shape", None)
    if isinstance(shape, tuple):
        return f"a numpy {kind} of shape {shape}"
    if isinstance(value, Real):
        return one_line(f"the number {value!r}")
    return f"{'an' if kind[:1].lower() in 'aeiou' else 'a'} {one_line(kind)}"


def listed(result: Any, count: int) -> Sequence[Any]:
    """A sequence of another kind as a list."""
    if isinstance(result, Sequence) and not isinstance(result, str | bytes | bytearray):
        if len(result) != count:
            raise ValueError(f"decide() returned {some(len(result))} for {count} robots")
        return [result[row] for row in range(count)]
    alone = ": put it into a list" if isinstance(result, Command) else ""
    raise ValueError(f"decide() returned {what(result)}, not a list of {some(count)}{alone}")


def number(value: Any, name: str, most: float) -> float:
    """A finite number within -+most."""
    kind = type(value)
    if kind is not float and kind is not int and (kind is bool or not isinstance(value, Real)):
        raise ValueError(f"{name} is {what(value)}, not a number")
    try:
        exact = float(value)
    except OverflowError:
        raise ValueError(f"{name} is too large for a number") from None
    if not isfinite(exact):
        raise ValueError(f"{name} is {exact}: it must be a finite number")
    return min(max(exact, -most), most)


def switch(value: Any, name: str) -> bool:
    """True or False, also numpy's, and 1 or 0."""
    if type(value).__name__ == "bool" and getattr(value, "shape", None) == ():
        return bool(value)
    if isinstance(value, Real) and value in (0, 1):
        return bool(value)
    raise ValueError(f"{name} is {what(value)}, not True or False")


def words(value: Any, name: str, longest: int) -> str:
    """A text in one line, cut."""
    if not isinstance(value, str):
        raise ValueError(f"{name} is {what(value)}, not a text")
    return one_line(str(value[: longest + 1]), longest)[:longest]


def marks(notes: Any, name: str) -> list[Mark]:
    """The first notes of a command as plain tuples."""
    if not isinstance(notes, Sequence) or isinstance(notes, str | bytes | bytearray):
        raise ValueError(f"{name} is {what(notes)}, not a list of Line, Circle or Text")
    return [mark(notes[row], name) for row in range(min(len(notes), MOST_NOTES))]


def mark(note: Any, name: str) -> Mark:
    """One note as a plain tuple."""
    for kind, places in NOTES.items():
        if isinstance(note, kind):
            of = kind.__name__
            numbers = [number(getattr(note, p), f"{p} of a {of}", FARTHEST) for p in places]
            if isinstance(note, Text):
                return ("text", *numbers, words(note.text, "text of a Text", LONGEST_TEXT))
            return (of.lower(), *numbers)
    raise ValueError(f"one of the {name} is {what(note)}, not a Line, Circle or Text")
