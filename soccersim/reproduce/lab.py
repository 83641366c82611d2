"""Runs scenarios over many seeds for the reproductions, on all cores, with one progress bar."""

import os
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any, Self

from soccersim.repeat import run_seed
from soccersim.spec.load import load_scenario
from soccersim.workers import Workers

SEEDS = 200  # runs behind a median and its 5-95 % band


class Lab:
    """A pool of processes that is started when first used; results do not depend on its size.

    >>> with Lab(jobs=2) as lab:
    ...     runs = lab.runs("defender", seeds=range(200))
    """

    def __init__(
        self,
        jobs: int | None = None,
        seeds: int = SEEDS,
    ) -> None:
        self.seeds = range(seeds)
        self.progress: Callable[[float], None] | None = None
        self._jobs = jobs or os.cpu_count() or 1
        self._workers: Workers | None = None

    def runs(self, scenario: str, settings: Sequence[str] = ()) -> list[dict[str, Any]]:
        """The short report (seed, digest, duration, robots) of every seed, in order."""
        document = load_scenario(scenario, settings=settings).model_dump_json()
        return self.map(run_seed, [document] * len(self.seeds), self.seeds)

    def map(self, function: Callable[..., Any], *arguments: Sequence[Any]) -> list[Any]:
        """function over arguments, in order; function must be importable, its results small."""
        if self._jobs == 1:
            return [function(*row) for row in zip(*arguments, strict=True)]
        if self._workers is None:
            self._workers = Workers(self._jobs).__enter__()
        return list(self._workers.map(function, *arguments))

    def told(self, share: float) -> None:
        """Tell the progress bar how much of all is done."""
        if self.progress:
            self.progress(share)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._workers:
            self._workers.__exit__(kind, error, trace)
