"""Where the legs of a run are played, several at a time."""

from concurrent.futures import Future, ThreadPoolExecutor
from typing import Protocol, Self

from soccersim.regress.ground import Ground
from soccersim.regress.job import Played, play_leg
from soccersim.regress.leg import Leg


class Pool(Protocol):
    """What a run needs of it: concurrent.futures' Futures, from here or from a cluster."""

    @property
    def width(self) -> int:
        """Legs that it plays at a time; on a cluster that may change."""

    @property
    def quiet(self) -> bool:
        """Whether a leg is alone only where nothing else of the run is played."""

    def submit(self, leg: Leg, alone: bool) -> "Future[Played]":
        """Play a leg: what play_leg returns or raises."""


class LocalPool:
    """This machine: a thread for each match that is played, which watches its process.

    >>> with LocalPool(2, scenario) as pool:
    ...     rows = [row for _, row in run(legs, store, pool)]
    """

    quiet = True

    def __init__(self, jobs: int, ground: Ground) -> None:
        """ground: closed with the pool."""
        self.width, self.ground = jobs, ground
        self._threads = ThreadPoolExecutor(jobs, "match")

    def submit(self, leg: Leg, alone: bool) -> "Future[Played]":
        """Play a leg as soon as a thread is free."""
        return self._threads.submit(play_leg, leg, alone, self.ground)

    def __enter__(self) -> Self:
        """Load all that matches need; MachineError where no process can be started."""
        try:
            self.ground.start()
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End what is still played, and leave nothing."""
        self.ground.stopping.set()
        self._threads.shutdown(wait=True, cancel_futures=True)
        self.ground.close()
