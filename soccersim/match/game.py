"""The loop of a match.

    each decision:  play on -> perceive -> judge -> tell both teams -> let both decide -> radio

Between two decisions the compiled loop of simulation.py plays on without any Python.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from soccersim.control.orders import post
from soccersim.match.faults import Forfeit, TeamFault, forfeited
from soccersim.match.log import MatchLog
from soccersim.match.pitch import team_rows
from soccersim.match.seats import Seat
from soccersim.match.turn import SIDES, Turn
from soccersim.perception import Perception
from soccersim.record import Recording
from soccersim.record.compact import rounded
from soccersim.referee.events import Ruling
from soccersim.referee.judge import Referee
from soccersim.sheet import GOALS, HALF, LEFT, PHASE, PHASES, STARTED, TIME, WHOSE, sheet_size
from soccersim.simulation import Simulation
from soccersim.spec.scenario import Scenario
from soccersim.strategy.check import Answer

MOST = 30.0  # m/s, rad/s: a packet holds no more


class Result(NamedTuple):
    """How a match came out."""

    recording: Recording
    score: tuple[int, int]  # home, away
    faults: list[TeamFault]


class Game:
    """One match: `play()` does it all."""

    def __init__(self, scenario: Scenario, turn: Turn | None = None) -> None:
        match = scenario.match
        if match is None:
            raise ValueError(f"{scenario.name} has no `match`")
        self.scenario = scenario
        self.turn = turn or Turn()
        self.simulation = Simulation(scenario)
        self.perception = Perception(scenario)
        self.referee = Referee(scenario)
        self.rows = [team_rows(scenario, slot) for slot in (0, 1)]
        self.order = np.argsort(
            self.rows[0] + self.rows[1]
        )  # of the teams' rows, one after the other
        self.log = MatchLog(scenario)
        self.decide_every = scenario.every(match.decide_hz)
        self.beat = int(np.gcd(self.decide_every, self.perception.beat))
        self.sheets = [
            np.zeros(sheet_size(len(own), len(others)))
            for own, others in (self.rows, self.rows[::-1])
        ]
        if match.swap_ends:
            for row, (x, y, heading, *_) in enumerate(self._bodies()[:-1]):
                self._place_robot(row, (-x, -y, heading + np.pi))

    def play(
        self,
        seats: Sequence[Seat],
        progress: Callable[[float], None] | None = None,
        until: int | None = None,
    ) -> Result:
        """Play until the time is up, or the tick `until`, or a team forfeits; HOME's seat first."""
        simulation, score = self.simulation, None
        faults: list[TeamFault] = []
        while (tick := simulation.tick) != until:
            try:
                answers = self._beat(seats, tick)
            except Forfeits as forfeits:
                faults = forfeits.faults(tick)
                score = forfeits.score(self.referee.score)
                break
            if simulation.done:
                break
            if answers:
                self.log.add(tick, self, answers)
                if progress:
                    progress(tick / simulation.end)
            simulation.hurry(self.beat - tick % self.beat)
        return self._result(score or self.referee.score, faults)

    def _beat(self, seats: Sequence[Seat], tick: int) -> list[Answer] | None:
        """What happens between two pieces of play; what both teams answer, where they decide."""
        simulation, referee, m = self.simulation, self.referee, self.simulation.machine
        self.perception.step(
            m.truth, m.readings, m.estimate, tick, referee.in_play, referee.direction
        )
        if tick % self.decide_every != 0 and not simulation.done:  # the referee ends the match
            return None
        self.turn.tick, self.turn.share = tick, tick / simulation.end
        self._rule(tick)
        self.turn.score = referee.score
        if simulation.done:
            return None
        answers = self._ask(seats, tick)
        self._send(answers, tick)
        return answers

    def _rule(self, tick: int) -> None:
        """Let the referee judge, and do as it says."""
        simulation = self.simulation
        ruling: Ruling = self.referee.judge(tick, self._bodies(), simulation.machine.watch)
        for row, pose in ruling.robots.items():
            self._place_robot(row, pose)
        if ruling.ball:
            simulation.place_ball(*ruling.ball)
            self.perception.place_ball(*ruling.ball)
        simulation.machine.orders.halted[:] = 0
        for row in ruling.halted:
            simulation.machine.orders.halted[row] = 1
        self.log.events += ruling.events

    def _ask(self, seats: Sequence[Seat], tick: int) -> list[Answer]:
        """Tell both teams, then take their answers: HOME's first, though neither knows."""
        for slot, seat in enumerate(seats):
            self._fill(slot, tick)
            seat.ask(self.sheets[slot])
        answers, forfeits = [], {}
        for slot, seat in enumerate(seats):
            try:
                answers.append(seat.answer())
            except Forfeit as forfeit:
                forfeits[slot] = forfeit
        if forfeits:
            raise Forfeits(forfeits)
        return answers

    def _fill(self, slot: int, tick: int) -> None:
        """The sheet of one team."""
        sheet, referee = self.sheets[slot], self.referee
        sheet[TIME] = tick * self.scenario.dt
        sheet[PHASE] = PHASES.index(referee.phase)
        sheet[WHOSE] = -1.0 if referee.whose is None else float(referee.whose == slot)
        sheet[STARTED] = referee.started
        sheet[GOALS], sheet[GOALS + 1] = referee.score[slot], referee.score[1 - slot]
        sheet[LEFT] = (self.simulation.end - tick) * self.scenario.dt
        sheet[HALF] = referee.half
        self.perception.fill(sheet, slot, tick)

    def _send(self, answers: list[Answer], tick: int) -> None:
        """The orders on their way, as the packets hold them."""
        home, away = answers
        orders = np.array(home.orders + away.orders)[self.order]
        np.minimum(np.maximum(orders, -MOST, out=orders), MOST, out=orders)
        orders = rounded("orders", orders)
        self.log.orders = orders
        post(self.simulation.machine.orders, orders, tick)

    def _place_robot(self, row: int, pose: tuple[float, float, float]) -> None:
        self.simulation.place_robot(row, *pose)
        self.perception.place(row, pose)

    def _bodies(self) -> NDArray[np.float64]:
        """(R + 1, 6): the robots, then the ball."""
        rows = len(self.scenario.robots) + 1
        return self.simulation.machine.truth.body[:rows]

    def _result(self, score: tuple[int, int], faults: list[TeamFault]) -> Result:
        recording = self.simulation.recording()
        recording.arrays.update(self.log.arrays())
        recording.meta["match"] = self.log.document(self, score, faults)
        return Result(recording, score, faults)


class Forfeits(Exception):
    """Of one team, or of both at once."""

    def __init__(self, slots: dict[int, Forfeit]) -> None:
        super().__init__(slots)
        self.slots = slots

    def faults(self, tick: int) -> list[TeamFault]:
        """The same as the result tells it."""
        return [TeamFault(SIDES[i], each.kind, tick, each.detail) for i, each in self.slots.items()]

    def score(self, score: tuple[int, int]) -> tuple[int, int]:
        """That the match ends with; where both are at fault, as it stands."""
        return score if len(self.slots) == 2 else forfeited(score, *self.slots)
