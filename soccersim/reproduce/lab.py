"""Runs scenarios over many seeds for the reproductions, on all cores, with one progress bar."""

import os
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from typing import Any

from soccersim.repeat import run_seed
from soccersim.spec.load import load_scenario
from soccersim.workers import Workers

SEEDS = 200  # runs behind a median and its 5-95 % band


class Lab(ExitStack[None]):
    """A pool of processes that is started when first used; results do not depend on its size.

    >>> with Lab(jobs=2, seeds=200) as lab:
    ...     runs = lab.runs("defender")
    """

    def __init__(self, jobs: int | None = None, seeds: int = SEEDS) -> None:
        super().__init__()
        self.seeds = range(seeds)
        self.progress: Callable[[float], None] | None = None
        self._jobs = jobs or os.cpu_count() or 1
        self._workers: Workers | None = None

    def runs(self, scenario: str, settings: Sequence[str] = ()) -> list[dict[str, Any]]:
        """The short report (seed, digest, duration, robots) of every seed, in order."""
        return self.each(run_seed, load_scenario(scenario, settings=settings).model_dump_json())

    def each(self, function: Callable[[str, int], Any], text: str) -> list[Any]:
        """function(text, seed) of every seed, in order; text is a scenario as JSON."""
        return self.map(function, [text] * len(self.seeds), self.seeds)

    def map(self, function: Callable[..., Any], *arguments: Sequence[Any]) -> list[Any]:
        """function over arguments, in order; function must be importable, its results small."""
        if self._jobs == 1:
            return [function(*row) for row in zip(*arguments, strict=True)]
        if self._workers is None:
            self._workers = self.enter_context(Workers(self._jobs))
        return list(self._workers.map(function, *arguments))

    def told(self, share: float) -> None:
        """Tell the progress bar how much of all is done."""
        if self.progress:
            self.progress(share)
