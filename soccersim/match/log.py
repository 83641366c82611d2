"""What is written down of a match besides the simulation's records: a row a decision."""

from math import nan
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from soccersim.match.faults import TeamFault
from soccersim.record.compact import rounded
from soccersim.referee.events import Event
from soccersim.sheet import BALL, BALL_KNOWN, OPPONENTS_KNOWN, PHASES
from soccersim.spec.scenario import Scenario
from soccersim.strategy.check import Answer, Mark

if TYPE_CHECKING:
    from soccersim.match.game import Game


class MatchLog:
    """Collects the arrays and lists of a match; docs/recording.md tells them."""

    def __init__(self, scenario: Scenario) -> None:
        robots = len(scenario.robots)
        self.orders = np.zeros((robots, 5), np.float32)  # last; vx, vy, omega, kick, dribble
        self.events: list[Event] = []
        self.rows: dict[str, list[Any]] = {key: [] for key in ROWS}
        self.labels: list[list[Any]] = []  # [decision, robot, text], where one changes
        self.notes: list[list[Any]] = []  # [decision, slot, [note...]], the same; field frame
        self._labels = [""] * robots
        self._notes: list[list[Mark]] = [[], []]

    def add(self, tick: int, game: "Game", answers: list[Answer]) -> None:
        """One decision, just sent."""
        referee, m, rows = game.referee, game.simulation.machine, self.rows
        decision = len(rows["decision_tick"])
        rows["decision_tick"].append(tick)
        rows["orders"].append(self.orders)
        rows["in_play"].append(np.array(referee.in_play, np.uint8))
        rows["contact"].append(m.readings.contact.astype(np.uint8))
        rows["kicked"].append(m.handling.kicked.astype(np.int32))
        rows["ball_believed"].append([_ball(game.sheets[i], referee.direction[i]) for i in (0, 1)])
        rows["ball_sighted"].append(game.perception.sighted().astype(np.float32))
        rows["phase"].append(PHASES.index(referee.phase))
        rows["whose"].append(-1 if referee.whose is None else referee.whose)
        rows["started"].append(referee.started)
        rows["score"].append(referee.score)
        rows["direction"].append(referee.direction[0])
        for slot, answer in enumerate(answers):
            for robot, label in zip(game.rows[slot], answer.labels, strict=True):
                if label != self._labels[robot]:
                    self._labels[robot] = label
                    self.labels.append([decision, robot, label])
            if answer.notes != self._notes[slot]:
                self._notes[slot] = answer.notes
                side = float(referee.direction[slot])
                self.notes.append([decision, slot, [_on_field(n, side) for n in answer.notes]])

    def arrays(self) -> dict[str, Any]:
        """Everything that has a row a decision."""
        arrays = {}
        for key, (kind, shape) in ROWS.items():
            rows = self.rows[key]
            whole = [len(self.orders) if n < 0 else n for n in shape]
            arrays[key] = rounded(key, np.array(rows, kind).reshape(len(rows), *whole))
        return arrays

    def document(
        self, game: "Game", score: tuple[int, int], faults: list[TeamFault]
    ) -> dict[str, Any]:
        """What else is told of the match, as JSON."""
        match = game.scenario.match
        teams = {"home": match.home.strategy, "away": match.away.strategy} if match else {}
        return {
            **teams,
            "score": list(score),
            "events": [event.document() for event in self.events],
            "faults": [fault.document() for fault in faults],
            "labels": self.labels,
            "notes": self.notes,
        }


ROWS: dict[str, tuple[Any, tuple[int, ...]]] = {  # array: its numbers, shape of a row; -1: robots
    "decision_tick": (np.int64, ()),
    "orders": (np.float32, (-1, 5)),
    "in_play": (np.uint8, (-1,)),
    "contact": (np.uint8, (-1,)),
    "kicked": (np.int32, (-1,)),
    "ball_believed": (np.float64, (2, 5)),
    "ball_sighted": (np.float32, (-1, 2)),
    "phase": (np.uint8, ()),
    "whose": (np.int8, ()),
    "started": (np.uint8, ()),
    "score": (np.uint8, (2,)),
    "direction": (np.int8, ()),
}


def _ball(sheet: NDArray[np.float64], side: float) -> list[float]:
    """Where a team believed the ball to be: x, y, vx, vy in the field frame, age; or all NaN."""
    if not sheet[BALL_KNOWN]:
        return [nan] * 5
    *moves, age = sheet[BALL:OPPONENTS_KNOWN].tolist()
    return [*(float(side) * number for number in moves), age]


def _on_field(note: Mark, side: float) -> list[Any]:
    """A note of the team frame in the field frame."""
    kind, *numbers = note
    places = 4 if kind == "line" else 2
    turned = [side * float(n) for n in numbers[:places]]
    return [kind, *(round(n, 3) for n in turned), *numbers[places:]]
