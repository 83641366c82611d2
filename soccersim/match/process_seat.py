"""A seat whose team runs in a process of its own: only numbers and texts of it come here."""

import os
import select
import time
from dataclasses import asdict
from pathlib import Path
from subprocess import PIPE
from typing import Any, NoReturn

from soccersim.match.endings import how_ended
from soccersim.match.faults import BAD_COMMAND, DEADLINE, EXIT, Forfeit
from soccersim.match.packets import (
    FAULT,
    HEAD,
    LONGEST,
    MISTAKE,
    READY,
    SETUP,
    Reader,
    document,
    fault,
    mistakes,
    pitch_document,
)
from soccersim.match.seats import Floats
from soccersim.match.stopwatch import Stopwatch
from soccersim.match.traces import ask_trace, read_trace
from soccersim.match.turn import DECIDE, IMPORT, Turn
from soccersim.problems import InputError, Problem
from soccersim.processes import end, end_group, has_ended, start
from soccersim.strategy.api import Pitch
from soccersim.strategy.check import Answer
from soccersim.strategy.load import Origin

BURIAL = 1.0  # s that a process may take to end once its pipe is closed
LOOK = 50  # ms from one look at the clock to the next, while a team decides


class ProcessSeat:
    """A team in a process of its own."""

    def __init__(
        self,
        slot: int,
        origin: Origin,
        options: dict[str, Any],
        pitch: Pitch,
        seed: int,
        turn: Turn,
        sheet: int,
        trace: Path,
    ) -> None:
        """Starts it; sheet: numbers of its sheets; trace: where it tells of a crash."""
        self.slot, self.turn, self.trace = slot, turn, trace
        self.reader = Reader(len(pitch.bodies))
        self.process = start("soccersim.match.team", [str(trace)], stdout=PIPE)
        turn.process(slot, self.process.pid)
        if not self.process.stdin or not self.process.stdout:
            raise OSError("a process without pipes")
        self.sink, self.source = self.process.stdin.fileno(), self.process.stdout.fileno()
        self.poll = select.poll()
        self.poll.register(self.source, select.POLLIN)
        self.stopwatch = Stopwatch(self.process.pid, thread=False)
        self.asked = 0
        self.data = b""
        self.lost: Forfeit | None = None
        setup = {
            "slot": slot,
            "origin": asdict(origin),
            "options": options,
            "pitch": pitch_document(pitch),
            "seed": seed,
            "sheet": 8 * sheet,
        }
        self._write(document(SETUP, setup))

    def ready(self) -> None:
        """Wait until the team is made: Forfeit where its code does not let that happen."""
        kind, body = self._receive(IMPORT)
        os.set_blocking(self.sink, False)
        if kind == MISTAKE:
            raise self._mistake(body)
        if kind != READY or body:
            raise self._fault(kind, body)

    def ask(self, sheet: Floats) -> None:
        """Send the sheet."""
        self.turn.end()  # whoever watches sees that the match goes on
        self.asked += 1
        self._write(sheet.astype("<f8", copy=False).tobytes())

    def answer(self) -> Answer:
        """Wait for the answer."""
        if self.lost:
            raise self.lost
        kind, body = self._receive(DECIDE)
        if kind == FAULT:
            raise self._fault(kind, body)
        try:
            return self.reader.answer(kind, body)
        except ValueError as error:
            raise self._nonsense(error) from error

    def close(self) -> None:
        """End the process, and all that it has started."""
        end(self.process)
        if self.process.stdout:
            self.process.stdout.close()
        self.turn.process(self.slot, 0)

    def _write(self, data: bytes) -> None:
        try:
            while data:
                data = data[os.write(self.sink, data) :]
        except BlockingIOError:  # it does not read, and answers nevertheless
            self.lost = self._nonsense(ValueError("answers to what it was not asked"))
        except OSError:
            pass  # it has ended: answer() finds out how

    def _receive(self, stage: int) -> tuple[int, bytes]:
        """The next packet: kind and body."""
        while True:
            if len(self.data) >= HEAD.size:
                kind, length = HEAD.unpack_from(self.data)
                if length > LONGEST:
                    raise self._nonsense(ValueError(f"a packet of {length} bytes"))
                size = HEAD.size + length
                if len(self.data) >= size:
                    body, self.data = self.data[HEAD.size : size], self.data[size:]
                    return kind, body
            some = self.poll.poll(LOOK)
            if self.data or not some:
                self._look(stage)
            if some:
                more = os.read(self.source, LONGEST)
                if not more:
                    self._ended()
                self.data += more

    def _look(self, stage: int) -> None:
        """Forfeit if it takes too long."""
        broken = self.stopwatch.over((self.asked, stage), stage)
        if broken:
            ask_trace(self.process.pid, self.trace)
            end_group(self.process.pid)
            raise Forfeit(DEADLINE, "\n".join(filter(None, (read_trace(self.trace), broken))))

    def _ended(self) -> NoReturn:
        """Nothing more will come: tell why."""
        last = time.monotonic() + BURIAL
        while not has_ended(self.process) and time.monotonic() < last:
            time.sleep(0.002)
        if not has_ended(self.process):
            raise Forfeit(EXIT, "closed the pipe that its answers come by")
        kind, told = how_ended(end(self.process))
        raise Forfeit(kind, "\n".join(filter(None, (read_trace(self.trace), told))))

    def _fault(self, kind: int, body: bytes) -> Forfeit:
        """What the process tells of itself."""
        try:
            if kind != FAULT:
                raise ValueError(f"a packet of kind {kind}")
            return Forfeit(*fault(body))
        except ValueError as error:
            return self._nonsense(error)

    def _mistake(self, body: bytes) -> Exception:
        """No such strategy is there."""
        try:
            return InputError([Problem(message) for message in mistakes(body)])
        except ValueError as error:
            return self._nonsense(error)

    def _nonsense(self, error: ValueError) -> Forfeit:
        """What a process does that does not keep to the way of answering."""
        end_group(self.process.pid)
        return Forfeit(BAD_COMMAND, f"its process sent what is no answer: {error}")
