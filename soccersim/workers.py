"""Processes that work side by side, and end at once when the user stops or something fails."""

import multiprocessing
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from contextlib import contextmanager
from types import TracebackType
from typing import Any, Self

from soccersim.problems import MachineError


class Workers:
    """So many processes, started when there is work.

    >>> with Workers(2) as pool:
    ...     reports = list(pool.map(run_seed, texts, seeds))
    """

    def __init__(self, jobs: int) -> None:
        # spawn: the same on every system, and no threads or locks are inherited half-way
        context = multiprocessing.get_context("spawn")
        self._others = set(multiprocessing.active_children())
        self._pool = ProcessPoolExecutor(jobs, mp_context=context)

    def map(self, function: Callable[..., Any], *arguments: Iterable[Any]) -> Iterator[Any]:
        """function over arguments, in their order; it must be importable, its results small."""
        with deaf():  # the processes start here
            results = self._pool.map(function, *arguments)
        return _told(results)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._pool.shutdown(wait=kind is None, cancel_futures=True)
        if kind is not None:
            for process in set(multiprocessing.active_children()) - self._others:
                process.terminate()


def _told(results: Iterator[Any]) -> Iterator[Any]:
    """The same, with a process that was killed told in our words."""
    try:
        yield from results
    except BrokenExecutor as error:
        wrong = "a process ended before its work was done: the memory may be full, use fewer --jobs"
        raise MachineError(wrong) from error


@contextmanager
def deaf() -> Iterator[None]:
    """Processes started within never hear Ctrl-C, which a terminal sends to all; this one does.

    So it is the one that ends them, and nothing is printed but what it says.
    """
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    old = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, old)
