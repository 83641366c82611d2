"""What the workers of a Dask cluster run for us: matches, and what tells whether they may.

Nothing of ours is imported before it is used: the scheduler, which plays no match, imports this
module too. A task is bytes to it, with all that a match needs: a worker keeps nothing of a run, so
one that has just come, or come again, needs no preparation.
"""

import os
import pickle
import zlib
from collections.abc import Callable
from contextlib import suppress
from threading import Lock, Thread
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from soccersim.regress.job import Played
    from soccersim.regress.leg import Leg

SEED = "PYTHONHASHSEED"  # the order of texts in sets, in the processes that a worker starts
LOADED = "code when it began"  # by its name in told(): it follows from all the others
ENDING = ("closing", "closed", "failed")  # states of a worker that ends

_settled: list[str] = []
_lock = Lock()


class Foreign(Exception):
    """Raised by a worker that would play other matches than the one who asks."""

    def __init__(self, worker: str, told: dict[str, str]) -> None:
        super().__init__(worker, told)
        self.worker, self.told = worker, told  # its address, and what it is


def packed(leg: "Leg", alone: bool) -> bytes:
    """A task: a leg with its bundles, and whether it is played alone; a sixth of its size."""
    return zlib.compress(pickle.dumps((leg, alone)))


def play(task: bytes, seed: str) -> "Played":
    """Play a match on this worker, in a thread of it; Foreign where it would be another one."""
    from distributed import get_worker

    from soccersim.regress.engine import engine
    from soccersim.regress.job import Unwanted, play_leg
    from soccersim.regress.room import room

    settle(seed)
    worker = get_worker()
    leg, alone = pickle.loads(zlib.decompress(task))
    if leg.engine != engine():
        raise Foreign(worker.address, told())
    wanted = wanted_of(worker)
    with room(alone, wanted) as here:
        if not here:
            raise Unwanted
        return play_leg(leg, alone, None, wanted)


def wanted_of(worker: Any) -> Callable[[], bool]:
    """Whether what this thread does is still wanted: Dask itself ends no thread.

    It is not when the run is over or its coordinator gone, whichever way, or the worker ends.
    """
    key, tasks = worker.get_current_task(), worker.state.tasks

    def wanted() -> bool:
        task = tasks.get(key)
        ended = worker.status.name in ENDING
        return task is not None and task.state != "cancelled" and not ended

    return wanted


def describe(seed: str) -> dict[str, str]:
    """What plays the matches on this worker, as told(), for a coordinator with this seed."""
    settle(seed)
    return told()


def told() -> dict[str, str]:
    """All that may change how a match comes out, by its name; engine() is the digest of it."""
    from soccersim import __version__
    from soccersim.record.digest import fingerprint
    from soccersim.regress.engine import engine, sources

    known = {"soccersim": __version__, "its code": sources()[:12], **fingerprint()}
    return {**known, SEED: hash_seed(), LOADED: engine()[:12]}


def hash_seed() -> str:
    """The seed that processes are started with; see processes.py."""
    return os.environ.get(SEED, "0")


def settle(seed: str) -> None:
    """Start processes with the coordinator's seed: Dask's nannies give workers one of their own.

    The first run that comes to a worker says which; processes that are there keep theirs.
    """
    from soccersim.regress.engine import engine

    with _lock:
        if not _settled:
            _settled.append(seed)
            os.environ[SEED] = seed
            engine.cache_clear()


def load(scenario: str) -> None:
    """Begin to load what matches need, in a thread: the first match finds some of it there."""
    from soccersim.problems import MachineError
    from soccersim.regress.ground import own_ground

    def loaded() -> None:
        with suppress(MachineError):  # the first match tells
            own_ground(scenario).start()

    Thread(target=loaded, daemon=True).start()
