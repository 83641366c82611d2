"""A progress bar for what takes long; nothing for what does not."""

import sys
import time
from contextlib import ExitStack
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress

PATIENCE = 1.0  # s before a bar appears


class Bar(ExitStack[None]):
    """Shows on a terminal (standard error) how far a task is, once it has taken a second.

    >>> with Bar("simulating") as bar:
    ...     bar(0.5)
    """

    def __init__(self, task: str, patience: float = PATIENCE) -> None:
        super().__init__()
        self._task = task
        self._patience = patience
        self._start = time.monotonic()
        self._bar: Progress | None = None

    def __call__(self, share: float, task: str | None = None) -> None:
        """The share done, 0 to 1, and what the task is called now."""
        late = time.monotonic() - self._start > self._patience
        if self._bar is None and late and sys.stderr.isatty():
            self._bar = self.enter_context(_bar())
            self._row = self._bar.add_task(self._task, total=1.0)
        if self._bar:
            self._bar.update(self._row, completed=share, description=task)

    def count(self, done: int, total: int) -> None:
        """So many of all are done."""
        self(done / total)


def _bar() -> "Progress":
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}", markup=False), BarColumn(), TimeRemainingColumn())
    return Progress(*columns, console=Console(stderr=True), transient=True)
