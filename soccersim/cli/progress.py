"""A progress bar for what takes long; nothing for what does not."""

import time
from types import TracebackType
from typing import Self

PATIENCE = 1.0  # s before a bar appears


class Bar:
    """Shows on standard error how far a task is, once it has taken a second.

    >>> with Bar("simulating") as bar:
    ...     bar(0.5)
    """

    def __init__(self, task: str) -> None:
        self._task = task
        self._start = time.monotonic()
        self._bar: object = None

    def __call__(self, share: float) -> None:
        """The share done, 0 to 1."""
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

        if self._bar is None and time.monotonic() - self._start > PATIENCE:
            columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
            self._bar = Progress(*columns, console=Console(stderr=True), transient=True)
            self._bar.start()
            self._row = self._bar.add_task(self._task, total=1.0)
        if isinstance(self._bar, Progress):
            self._bar.update(self._row, completed=share)

    def count(self, done: int, total: int) -> None:
        """So many of all are done."""
        self(done / total)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        stop = getattr(self._bar, "stop", None)
        if stop:
            stop()
