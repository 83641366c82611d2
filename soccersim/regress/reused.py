"""Processes that play match after match until one goes wrong: for systems that cannot fork.

What a team does to the interpreter stays until its process ends; a process in which a match
ended by a fault, or left a thread behind, plays no other.
"""

import json
from collections.abc import Sequence
from subprocess import DEVNULL, PIPE
from threading import Event, Lock, Thread
from typing import IO, Any

from soccersim.problems import MachineError
from soccersim.processes import Process, end, start

WORKER = "soccersim.regress.worker"
TRIES = 3  # workers that may end before they begin


class Reused:
    """Starts processes as processes.py does, or takes one that is free."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._free: list[Worker] = []
        self._all: list[Worker] = []

    def start(self) -> None:
        """Nothing to start ahead: each process loads what it needs at its first match."""

    def begin(self, module: str, arguments: Sequence[str], **_: Any) -> Process:
        """A process that does MODULE.play in the folder that is the argument."""
        for _try in range(TRIES):
            with self._lock:
                if not self._free:
                    self._free.append(Worker())
                    self._all.append(self._free[-1])
                worker = self._free.pop()
            if worker.ask(module, arguments[0]):
                return Lent(worker, self)
            self.bury(worker)
        raise MachineError("no process can be started")

    def close(self) -> None:
        """End them all."""
        with self._lock:
            for worker in self._all:
                end(worker.process)
            self._all, self._free = [], []

    def give_back(self, worker: "Worker") -> None:
        """It is free for another match."""
        with self._lock:
            self._free.append(worker)

    def bury(self, worker: "Worker") -> int:
        """End it, if it has not ended; its exit code."""
        with self._lock:
            if worker in self._all:
                self._all.remove(worker)
        return end(worker.process)


class Worker:
    """One such process, and the thread that hears when it is ready for more."""

    def __init__(self) -> None:
        self.process = start(WORKER, [], stdout=PIPE, stderr=DEVNULL)
        self.done = Event()
        Thread(target=self._listen, daemon=True).start()

    def ask(self, module: str, folder: str) -> bool:
        """Have it play a match; False where it has ended."""
        self.done.clear()
        try:
            if self.process.stdin:
                self.process.stdin.write(json.dumps([module, folder]).encode() + b"\n")
        except OSError:
            return False
        return True

    def _listen(self) -> None:
        if self.process.stdout:
            with self.process.stdout as pipe:
                while pipe.read(1):
                    self.done.set()


class Lent:
    """A worker for one match, as subprocess.Popen would show a process of its own."""

    stdin: IO[bytes] | None = None
    stdout: IO[bytes] | None = None

    def __init__(self, worker: Worker, source: Reused) -> None:
        self.worker, self.source = worker, source
        self.pid = worker.process.pid
        self.returncode: int | None = None

    def poll(self) -> int | None:
        """0 when the match is over; its exit code when it has ended instead."""
        if self.returncode is None and self.worker.done.is_set():
            self.returncode = 0
            self.source.give_back(self.worker)
        return self.worker.process.poll() if self.returncode is None else self.returncode

    def wait(self) -> int:
        """The same, when it is over."""
        if self.returncode is None:
            self.returncode = self.source.bury(self.worker)
        return self.returncode
