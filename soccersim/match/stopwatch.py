"""How long a team's turn takes, as another process sees it."""

import os
import time
from collections.abc import Hashable
from pathlib import Path

from soccersim.match.turn import DECIDE

DECISION = 1.0  # s of processor time that a decision may take
LOADING = 10.0  # s of it that import and init may take, each
WALL = 10.0  # s, whatever it does in them: sleeping, waiting, or on a machine with much other work
LOADING_WALL = 60.0
STALL = 600.0  # s in nobody's turn: not even a slow machine compiles as long


class Stopwatch:
    """Looks at a process now and then: has the turn it is in gone on for too long?"""

    def __init__(self, pid: int, thread: bool) -> None:
        """thread: only the time of its first thread counts, in which teams decide."""
        self.stat = Path(f"/proc/{pid}/task/{pid}/stat" if thread else f"/proc/{pid}/stat")
        self.turn: Hashable = None
        self.since = self.spent = 0.0

    def over(self, turn: Hashable, stage: int | None) -> str:
        """What limit the turn has broken, "" where none; stage None: it is no team's turn."""
        now, spent = time.monotonic(), self.processor_time()
        if turn != self.turn:
            self.turn, self.since, self.spent = turn, now, spent
            return ""
        waited, worked = now - self.since, spent - self.spent
        if stage is None:
            return f"nothing for {waited:.0f} s" if waited > STALL else ""
        most, wall = (DECISION, WALL) if stage == DECIDE else (LOADING, LOADING_WALL)
        if worked > most:
            return f"no end after {worked:.1f} s of processor time: at most {most:g}"
        if waited > wall:
            return f"no end after {waited:.0f} s: at most {wall:g}"
        return ""

    def processor_time(self) -> float:
        """Seconds of processor time until now; 0 where the system does not tell."""
        try:
            text = self.stat.read_text()
        except OSError:
            return 0.0
        fields = text.rpartition(")")[2].split()  # the name before may hold anything
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
