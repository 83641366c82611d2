"""Plays the legs of a run that are not in the store yet, and brings their rows as they come.

A match that ends in doubt (a deadline, the memory, a crash: a busy machine may bring them about) is
played again when alone, before a team is blamed. What the machine fails to play is tried again
too, and then void: never a team's loss. Only a disk that cannot be written ends the run.
"""

import time
from collections import deque
from collections.abc import Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field, replace

from soccersim.match.faults import CRASH
from soccersim.problems import MachineError
from soccersim.regress.job import Lost, Played, void_row
from soccersim.regress.leg import Leg
from soccersim.regress.pool import Pool
from soccersim.regress.recordings import Recordings
from soccersim.regress.row import Row
from soccersim.regress.store import Store

TRIES = 5  # of a leg that the machine fails to play
KILLS = 3  # times alone that a team's process has to be killed before the team is blamed
PAUSE = 0.2  # s before it is tried again; longer each time
LONGEST = 5.0
AHEAD = 4  # times as many legs as are played at a time: so far beyond the first that is missing
BEAT = 1.0  # s after which Ctrl-C is heard at the latest, where waiting does not hear it


@dataclass
class Task:
    """A match that has to be played."""

    leg: Leg
    places: list[tuple[int, Leg]] = field(default_factory=list)  # in the order of legs: the same
    alone: str = ""  # why it has to be alone; "": it has not
    tries: int = 0  # that came to nothing
    check: bool = False  # its row is there: all that is asked is whether it comes out the same


def run(
    legs: Iterable[Leg], store: Store, pool: Pool, *, ahead: int = 0, twice: int = 0
) -> Generator[tuple[Leg, Row], None, None]:
    """The rows of these legs, in the order in which they come: stored ones at once.

    Legs are begun in their order, `ahead` beyond the first that is missing at most. Of every
    `twice` legs one is played again, so that the store finds teams that do not play the same match
    twice. Whoever has seen enough closes the generator, then the pool. InputError where a
    strategy is not there, MachineError where the disk is full; what is in the store stays, and
    the same call goes on from there.
    """
    runner = Runner(store, pool, enumerate(legs), ahead, twice)
    try:
        yield from runner.rows()
    finally:
        runner.stop()


class Runner:
    """One call of run()."""

    def __init__(
        self, store: Store, pool: Pool, legs: Iterator[tuple[int, Leg]], ahead: int, twice: int
    ) -> None:
        self.store, self.pool, self.legs = store, pool, legs
        self.ahead, self.twice = ahead, twice
        self.recordings = Recordings(store.path)
        self.running: dict[Future[Played], Task] = {}
        self.later: deque[Task] = deque()  # what has to be alone
        self.checks: deque[Task] = deque()
        self.known: dict[str, Task] = {}  # by key: begun, and not over
        self.begun = self.whole = 0  # legs: begun; over, from the first on without a gap
        self.over: set[int] = set()  # those that are over beyond
        self.more = True  # whether there may be more legs

    def rows(self) -> Iterator[tuple[Leg, Row]]:
        """What run() brings."""
        while True:
            yield from self._begin()
            if not self.running:
                return
            done, _ = wait(self.running, BEAT, FIRST_COMPLETED)
            for future in [each for each in self.running if each in done]:  # as they were begun
                yield from self._end(self.running.pop(future), future)

    def stop(self) -> None:
        """Begin no more."""
        for future in self.running:
            future.cancel()

    def _begin(self) -> Iterator[tuple[Leg, Row]]:
        """Give the pool what it has room for; rows of legs that are in the store."""
        while self.later and not (self.pool.quiet and self.running):
            task = self.later.popleft()
            if task.tries:
                time.sleep(min(PAUSE * 2**task.tries, LONGEST))
            self._submit(task)
        if self.pool.quiet and (self.later or any(t.alone for t in self.running.values())):
            return
        while len(self.running) <= self.pool.width:  # one more: nobody waits for the store
            if self.checks:
                self._submit(self.checks.popleft())
                continue
            ahead = self.ahead or AHEAD * max(self.pool.width, 1)
            if not self.more or self.begun >= self.whole + ahead:
                return
            yield from self._next()

    def _next(self) -> Iterator[tuple[Leg, Row]]:
        """Begin the next leg; its row if it is in the store."""
        found = next(self.legs, None)
        if found is None:
            self.more = False
            return
        at, leg = found
        self.begun += 1
        if leg.key in self.known:
            self.known[leg.key].places.append(found)
        elif row := self.store.row(leg.key):
            self._count(at)
            yield leg, row
        else:
            self.known[leg.key] = Task(leg, [found])
            self._submit(self.known[leg.key])

    def _submit(self, task: Task) -> None:
        self.running[self.pool.submit(task.leg, bool(task.alone))] = task

    def _end(self, task: Task, future: "Future[Played]") -> Iterator[tuple[Leg, Row]]:
        """What has become of a match; rows, if it is over."""
        failure: MachineError | None = None
        try:
            played = future.result()
        except MachineError as error:
            failure, played = error, Played(None, str(error))
        except Lost as error:
            played = Played(None, str(error))
        row = played.row
        if task.check:
            if row and not played.doubt:
                self.store.add(row)
        elif row and played.doubt and not task.alone:
            self._retry(task, played.doubt)
        elif task.tries + 1 < most_tries(row):
            task.tries += 1
            self._retry(task, played.doubt)
        elif failure:
            raise failure
        else:
            yield from self._keep(task, row or void_row(task.leg, played.doubt), played.recording)

    def _retry(self, task: Task, why: str) -> None:
        """Play it alone, when there is time for that."""
        task.alone = task.alone or why or "it was not played to its end"
        self.later.append(task)

    def _keep(self, task: Task, row: Row, recording: bytes) -> Iterator[tuple[Leg, Row]]:
        """A match is over: its recording first, so that no row names one that is not there."""
        name = self.recordings.keep(task.leg, recording) if recording else ""
        overhead = row.overhead + self.store.seconds  # the store's is that of the row before
        row = replace(row, again=task.alone, recording=name, overhead=overhead)
        self.store.add(row)
        del self.known[row.key]
        if self.twice and task.places[0][0] % self.twice == 0 and not row.void:
            self.checks.append(Task(task.leg, check=True))
        for at, leg in task.places:
            self._count(at)
            yield leg, row

    def _count(self, at: int) -> None:
        """A leg is over."""
        self.over.add(at)
        while self.whole in self.over:
            self.over.remove(self.whole)
            self.whole += 1


def most_tries(row: Row | None) -> int:
    """How often a match that came to this is played before that counts.

    A team whose process was killed may have had no part in it: a system whose memory is full does
    so too.
    """
    if row is None:
        return TRIES
    killed = any(fault["kind"] == CRASH and "SIGKILL" in fault["detail"] for fault in row.faults)
    return KILLS if killed else 1
