"""A seat is where a team sits: it is asked at every decision, and answers."""

import os
from collections.abc import Callable
from time import thread_time
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from soccersim.match import turn as turns
from soccersim.match.faults import (
    BAD_COMMAND,
    DEADLINE,
    EXCEPTION,
    IMPORT,
    INIT,
    Forfeit,
    blamed,
)
from soccersim.match.memory import lift_limit
from soccersim.match.stopwatch import DECISION
from soccersim.match.turn import DECIDE, Turn
from soccersim.problems import InputError
from soccersim.strategy.api import Pitch, view_of
from soccersim.strategy.check import Answer, answer_of
from soccersim.strategy.load import Origin, load_team, make_team
from soccersim.streams import stream

STILL = (0.0, 0.0, 0.0, 0.0, False)
Floats = NDArray[np.float64]
T = TypeVar("T")


class Seat(Protocol):
    """One team, in this process, in another, or on a tape."""

    def ask(self, sheet: Floats) -> None:
        """Hand over what the team is told; both teams are asked before one answers."""

    def answer(self) -> Answer:
        """What it answers; Forfeit where it does wrong."""

    def close(self) -> None:
        """The match is over."""


class LocalSeat:
    """A team whose code runs in this process, in its turn."""

    def __init__(
        self,
        slot: int,
        origin: Origin,
        options: dict[str, Any],
        pitch: Pitch,
        seed: int,
        turn: Turn,
        clock: Callable[[], float] = thread_time,
    ) -> None:
        """Loads the strategy and makes it: Forfeit where its code does not let that happen.

        clock: s, what a decision may take DECISION of.
        """
        self.slot, self.pitch, self.turn, self.clock = slot, pitch, turn, clock
        self.count = len(pitch.bodies)
        self.sheet: list[float] = []
        self.process = os.getpid()
        kind = self._run(turns.IMPORT, IMPORT, lambda: load_team(origin))
        rng = stream(seed, slot, "strategy")
        self.strategy = self._run(turns.INIT, INIT, lambda: make_team(kind, rng, options))

    def ask(self, sheet: Floats) -> None:
        """Keep the sheet until it is this team's turn."""
        self.sheet = sheet.tolist()

    def answer(self) -> Answer:
        """Let the team decide."""
        answer = self._run(DECIDE, EXCEPTION, self._decide)
        if isinstance(answer, Forfeit):
            raise answer
        return answer

    def close(self) -> None:
        """Nothing to end."""

    def _decide(self) -> Answer | Forfeit:
        """All that may run the team's code, looking at what it returned and forgetting it too."""
        view = view_of(self.sheet, self.pitch)
        start = self.clock()
        result = self.strategy.decide(view)
        spent = self.clock() - start
        if spent > DECISION:
            return Forfeit(DEADLINE, f"a decision took {spent:.2f} s of processor time")
        try:
            return answer_of(result, self.count)
        except ValueError as error:
            return Forfeit(BAD_COMMAND, str(error))

    def _run(self, stage: int, kind: str, code: Callable[[], T]) -> T:
        """Run the team's code in its turn; whatever it raises is its fault."""
        self.turn.begin(self.slot, stage)
        try:
            return code()
        except BaseException as error:
            if isinstance(error, InputError) and raised_by_the_loader(error):
                raise
            if isinstance(error, MemoryError):
                lift_limit()
            forfeit = blamed(error, kind)
        finally:
            if os.getpid() != self.process:  # a child that it forked and did not end
                os._exit(0)
            self.turn.end()
        raise forfeit  # here, so that all the error held is free again


def raised_by_the_loader(error: BaseException) -> bool:
    """Whether it was our loader that found no strategy there: nothing that a team's code did."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    name = trace.tb_frame.f_globals.get("__name__") if trace else None
    return bool(name == load_team.__module__)


class LostSeat:
    """A team that could not be loaded: it has lost before the match begins."""

    def __init__(self, forfeit: Forfeit) -> None:
        self.forfeit = forfeit

    def ask(self, sheet: Floats) -> None:
        """There is nobody to tell."""

    def answer(self) -> Answer:
        """Forfeit, as it did when it was loaded."""
        raise self.forfeit

    def close(self) -> None:
        """Nothing to end."""


class TapeSeat:
    """A team as it was recorded: the same orders again."""

    def __init__(self, orders: NDArray[np.float32]) -> None:
        """orders (D, n, 5): vx, vy, omega, kick, dribble of its robots at each decision."""
        self.orders = orders
        self.decision = 0

    def ask(self, sheet: Floats) -> None:
        """A tape needs no telling."""

    def answer(self) -> Answer:
        """The recorded orders of this decision; nothing after the last."""
        rows = self.orders[self.decision : self.decision + 1].tolist()
        self.decision += 1
        orders = [(vx, vy, w, kick, hold > 0) for vx, vy, w, kick, hold in (rows or [[]])[0]]
        return Answer(orders or [STILL] * self.orders.shape[1], [""] * self.orders.shape[1], [])

    def close(self) -> None:
        """Nothing to end."""
