"""What the referee says: events that are written down, and rulings that are carried out."""

from dataclasses import dataclass, field
from typing import Any

from soccersim.referee.phases import Phase

SIDES = ("home", "away")
Place = tuple[float, float]  # x, y, m; field frame
Pose = tuple[float, float, float]  # x, y, heading; field frame


@dataclass(frozen=True, slots=True)
class Event:
    """One decision of the referee."""

    tick: int
    time: float  # s since the match began
    kind: str  # goal, no_goal, out, a foul's name, a restart's name, start, in_play, repair...
    rule: str  # the section it rests on
    x: float  # m, where; field frame
    y: float
    robots: tuple[str, ...]  # by name: who did it, then whom it was done to
    side: str | None  # home or away: whose goal or restart it is, or whose doing it was
    text: str

    def document(self) -> dict[str, Any]:
        """For JSON."""
        return {
            "tick": self.tick,
            "time": round(self.time, 3),
            "kind": self.kind,
            "rule": self.rule,
            "place": [round(self.x, 3), round(self.y, 3)],
            "robots": list(self.robots),
            "side": self.side,
            "text": self.text,
        }


@dataclass(frozen=True, slots=True)
class Call:
    """A whistle: why the game is stopped, and how it goes on."""

    kind: str
    rule: str
    text: str
    at: Place  # of the offence, or where the ball went out
    restart: Phase
    whose: int | None  # slot that restarts; None: nobody's
    ball: Place  # where the restart is
    robots: tuple[int, ...] = ()  # rows
    side: int | None = None  # slot that the event is about
    goal: int | None = None  # slot that scored


@dataclass(slots=True)
class Ruling:
    """What is to be done now."""

    events: list[Event] = field(default_factory=list)
    ball: Place | None = None  # put it there, at rest
    robots: dict[int, Pose] = field(default_factory=dict)  # row: put it there, at rest
    halted: tuple[int, ...] = ()  # rows whose motors stand still
    out: tuple[int, ...] = ()  # rows that are off the field
