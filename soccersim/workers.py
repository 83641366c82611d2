"""Processes that work side by side, and end at once when the user stops or something fails.

Each has a thread here that hands it one task after the other. There are no locks between
processes, so that none can be left locked by one that is killed.
"""

import os
import pickle
from collections.abc import Callable, Iterable, Iterator
from queue import Empty, SimpleQueue
from subprocess import PIPE
from threading import Thread
from types import TracebackType
from typing import Any, NamedTuple, Self

from soccersim.problems import MachineError
from soccersim.processes import Process, end, start, take_pipes

DONE, RAISED, DIED = range(3)  # what becomes of a task
Reply = tuple[int, int, Any]  # number of the task, what became of it, its result or error


class Task(NamedTuple):
    """A call to be made in another process, and who wants to know what it returns."""

    number: int
    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    replies: "SimpleQueue[Reply]"


class Workers:
    """So many processes, started when there is work.

    >>> with Workers(2) as pool:
    ...     reports = list(pool.map(run_seed, texts, seeds))
    """

    def __init__(self, jobs: int) -> None:
        self._jobs = jobs
        self._processes: list[Process] = []
        self._threads: list[Thread] = []
        self._tasks: SimpleQueue[Task | None] = SimpleQueue()

    def map(self, function: Callable[..., Any], *arguments: Iterable[Any]) -> Iterator[Any]:
        """function over arguments, in their order; it must be importable, its results small."""
        calls = list(zip(*arguments, strict=False))
        replies: SimpleQueue[Reply] = SimpleQueue()
        for number, call in enumerate(calls):
            self._tasks.put(Task(number, function, call, replies))
        while len(self._processes) < min(self._jobs, len(calls)):
            self._start()
        return _in_order(replies, len(calls))

    def _start(self) -> None:
        process = start("soccersim.workers", stdout=PIPE)
        self._processes.append(process)
        self._threads.append(Thread(target=_serve, args=(process, self._tasks), daemon=True))
        self._threads[-1].start()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Wait for what is being worked on; on an error end it instead."""
        _empty(self._tasks)
        for _ in self._threads:
            self._tasks.put(None)
        for thread in self._threads if kind is None else ():
            thread.join()
        for process in self._processes:
            end(process)
        for thread in self._threads:
            thread.join()


def _empty(tasks: "SimpleQueue[Task | None]") -> None:
    """Take out what nobody has begun."""
    try:
        while True:
            tasks.get_nowait()
    except Empty:
        return


def _in_order(replies: "SimpleQueue[Reply]", count: int) -> Iterator[Any]:
    """The results by their numbers, each as soon as it and those before it are there."""
    there: dict[int, Any] = {}
    for wanted in range(count):
        while wanted not in there:
            number, became, value = replies.get()
            if became == DIED:
                wrong = "a process ended before its work was done: "
                raise MachineError(wrong + "the memory may be full, use fewer --jobs")
            there[number] = became, value
        became, value = there.pop(wanted)
        if became == RAISED:
            raise value
        yield value


def _serve(process: Process, tasks: "SimpleQueue[Task | None]") -> None:
    """Hand tasks to a process, as long as there are some and it lives."""
    if process.stdin is None or process.stdout is None:
        return
    with process.stdout, open(process.stdout.fileno(), "rb", closefd=False) as answers:
        while task := tasks.get():
            try:
                text = memoryview(pickle.dumps((task.function, task.arguments)))
                while text:
                    text = text[os.write(process.stdin.fileno(), text) :]
                became, value = pickle.load(answers)
            except (OSError, EOFError, ValueError, pickle.UnpicklingError):
                became, value = DIED, None
            except Exception as error:  # what cannot be pickled
                became, value = RAISED, error
            task.replies.put((task.number, became, value))
            if became == DIED:
                return


def main() -> None:
    """What each of the processes does: one task after the other, until there are no more."""
    source, sink = take_pipes()
    with os.fdopen(source, "rb") as tasks, os.fdopen(sink, "wb") as answers:
        while True:
            try:
                function, arguments = pickle.load(tasks)
            except EOFError:
                return
            answers.write(_reply(function, arguments))
            answers.flush()


def _reply(function: Callable[..., Any], arguments: tuple[Any, ...]) -> bytes:
    """What a call leads to, ready to be sent."""
    try:
        return pickle.dumps((DONE, function(*arguments)))
    except Exception as error:
        try:
            data = pickle.dumps((RAISED, error))
            pickle.loads(data)
        except Exception:  # an error that cannot be sent, or not be put together again
            data = pickle.dumps((RAISED, RuntimeError(f"{type(error).__name__}: {error}")))
        return data
