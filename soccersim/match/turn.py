"""Whose code is running: a few bytes that another process may look at.

When a match's process hangs or dies, they tell whose turn it was, and what it leaves behind.
"""

import struct
from dataclasses import dataclass
from mmap import mmap

HOME, AWAY = 0, 1
SIDES = ("home", "away")
NOBODY = 255  # no team's: ours
IMPORT, INIT, DECIDE = 0, 1, 2  # what was asked of the team
STAGES = ("import", "init", "decide")
FORM = struct.Struct("<BBBBIqdii")
SIZE = FORM.size


@dataclass(frozen=True, slots=True)
class State:
    """What the bytes say."""

    slot: int  # HOME, AWAY or NOBODY
    stage: int  # IMPORT, INIT or DECIDE
    score: tuple[int, int]  # home, away
    serial: int  # grows with every turn that begins or ends
    tick: int
    share: float  # of the match that is played
    processes: tuple[int, int]  # ids of the teams' own processes, which lead groups; 0: none


class Turn:
    """Writes the bytes into a buffer: shared memory, or none that anybody sees."""

    def __init__(self, buffer: bytearray | memoryview | mmap | None = None) -> None:
        self.buffer = bytearray(SIZE) if buffer is None else buffer
        self.serial, self.tick, self.share = 0, 0, 0.0
        self.score = (0, 0)
        self.processes = [0, 0]
        self.end()

    def begin(self, slot: int, stage: int) -> None:
        """From now on it is a team's turn."""
        self._write(slot, stage)

    def end(self) -> None:
        """From now on it is ours."""
        self._write(NOBODY, 0)

    def process(self, slot: int, pid: int) -> None:
        """A team's own process has started, or ended (0)."""
        self.processes[slot] = pid
        self.end()

    def _write(self, slot: int, stage: int) -> None:
        self.serial = (self.serial + 1) & 0xFFFFFFFF
        home, away = self.score
        FORM.pack_into(
            self.buffer,
            0,
            slot,
            stage,
            min(home, 255),
            min(away, 255),
            self.serial,
            self.tick,
            self.share,
            *self.processes,
        )


def read_turn(buffer: bytes | bytearray | memoryview | mmap) -> State:
    """What a buffer that a Turn writes says now."""
    slot, stage, home, away, serial, tick, share, *processes = FORM.unpack_from(buffer, 0)
    return State(slot, stage, (home, away), serial, tick, share, (processes[0], processes[1]))
