"""Plays the legs of a run on a Dask cluster that is there: pool.py's Pool on other machines.

Dask gives a match whose worker is lost to another worker, three times; then it is Lost, and the
runner sees on. A match may thus be played twice, but a leg has one future and gives one row. What
Dask does not do: it ends no match that nobody wants any more (remote.py does), and it does not know
which workers would play other matches than this machine (crew.py does).
"""

import asyncio
import logging
import sys
import time
import warnings
from collections.abc import Callable
from concurrent.futures import CancelledError as Cancelled
from concurrent.futures import Future
from typing import Any, Self

from soccersim.problems import InputError, MachineError, Problem, one_line
from soccersim.regress.crew import Crew
from soccersim.regress.job import Lost, Played, Unwanted
from soccersim.regress.leg import Leg
from soccersim.regress.remote import Foreign, packed, play
from soccersim.regress.scheduler import address_of, compare

CONNECT = 5.0  # s that a scheduler may take to answer
PATIENCE = 60.0  # s without any worker: then the run ends, and goes on another time
BEAT = 2.0  # s from one look at the workers to the next
Say = Callable[[str], None]


def say(line: str) -> None:
    """Tell the user a line."""
    print(line, file=sys.stderr, flush=True)


def cluster_pool(address: str, scenario: str, say: Say = say) -> "DaskPool":
    """The pool of a cluster. address: tcp://HOST:PORT, or file:PATH of a scheduler file.

    scenario: JSON, for which the workers load all ahead. InputError where the address is none, or
    dask is not installed; MachineError where no scheduler answers.
    """
    try:
        from distributed import Client
        from distributed.versions import VersionMismatchWarning
    except ImportError as error:
        wrong = "--scheduler needs dask: pip install 'soccersim[cluster]'"
        raise InputError(Problem(wrong)) from error
    where = address_of(address)
    warnings.simplefilter("ignore", VersionMismatchWarning)  # we tell of it ourselves
    for name in ("distributed", "distributed.client", "distributed.core"):
        logging.getLogger(name).setLevel(logging.CRITICAL)  # and of what is lost
    try:
        client: Any = Client(where, timeout=CONNECT, set_as_default=False)  # type: ignore[no-untyped-call]
    except ValueError as error:
        raise InputError(Problem(f"--scheduler {address}: {error}")) from error
    except (OSError, TimeoutError) as error:
        wrong = f"no Dask scheduler answers at {where} within {CONNECT:g} s"
        raise MachineError(f"{wrong}: is it running? can this machine reach it?") from error
    return DaskPool(client, scenario, say)


class DaskPool:
    """A cluster; it follows its workers as they come and go.

    >>> with cluster_pool("tcp://10.0.0.1:8786", scenario) as pool:
    ...     rows = [row for _, row in run(legs, store, pool)]
    """

    quiet = False  # a match is alone on its machine (room.py); the others need not wait for it

    def __init__(self, client: Any, scenario: str, say: Say, patience: float = PATIENCE) -> None:
        """client: closed with the pool. patience: s without a worker that the run waits for one."""
        self.client, self.patience = client, patience
        self.crew = Crew(client, scenario, say)
        self.failure: Exception | None = None  # of all that is played here, now and later
        self._loop = client.loop.asyncio_loop
        self._playing: set[asyncio.Task[Any]] = set()
        self._bound: dict[Any, frozenset[str]] = {}  # Dask's futures: only these workers play them
        self._watch: Future[None] | None = None

    @property
    def width(self) -> int:
        """The matches that are played at a time, now."""
        return self.crew.width

    def submit(self, leg: Leg, alone: bool) -> "Future[Played]":
        """Play a leg on any worker. MachineError where the cluster is gone."""
        if self.failure:
            raise self.failure
        return asyncio.run_coroutine_threadsafe(self._play(packed(leg, alone)), self._loop)

    async def _play(self, task: bytes) -> Played:
        me = asyncio.current_task()
        if me:
            self._playing.add(me)
            me.add_done_callback(self._playing.discard)
        try:
            while True:
                try:
                    return await self._once(task)
                except Foreign as foreign:
                    self.crew.judge(foreign.worker, foreign.told)
                except ImportError:
                    await asyncio.sleep(BEAT)  # of a worker that has just come: the crew meets it
        except asyncio.CancelledError:
            if self.failure:
                raise self.failure from None
            raise

    async def _once(self, task: bytes) -> Played:
        """Have it played by whom Dask chooses among those that play our matches."""
        from distributed import KilledWorker
        from distributed.comm.core import CommClosedError
        from distributed.scheduler import NoValidWorkerError

        while not self.crew.good:  # the watch ends that
            await asyncio.sleep(BEAT / 4)
        only = frozenset(self.crew.good) if self.crew.foreign else None
        future = self.client.submit(
            play, task, self.crew.seed, pure=False, workers=only and sorted(only)
        )
        if only:
            self._bound[future] = only
        try:
            played: Played = await future
        except (KilledWorker, NoValidWorkerError, CommClosedError, Cancelled, Unwanted) as error:
            if self.client.status != "running":
                raise self._fail("is gone") from None
            raise Lost(f"its worker was lost: {one_line(str(error), 200)}") from error
        finally:
            self._bound.pop(future, None)
            future.release()  # nobody wants it any more: its worker hears of that
        return played

    async def _follow(self) -> None:
        """See who comes and goes, as long as the pool is open."""
        seen = time.monotonic()
        while not self.failure:
            await asyncio.sleep(BEAT)
            try:
                await self.crew.look()
            except OSError:
                if self.client.status != "running":
                    self._fail("is gone")
                continue
            for future, only in list(self._bound.items()):
                if only.isdisjoint(self.crew.good):
                    await self.client.cancel([future])  # Dask would wait for these workers
            if self.crew.good:
                seen = time.monotonic()
            elif time.monotonic() > seen + self.patience:
                self._fail("has no worker any more")

    def _fail(self, what: str) -> Exception:
        """End all that is played here: what the run keeps is whole, it goes on another time."""
        told = f"{self._where()} {what}; what was played is kept: the same command goes on"
        self.failure = self.failure or MachineError(told)
        for task in self._playing:
            task.cancel()
        return self.failure

    def _where(self) -> str:
        return f"the Dask scheduler at {self.client.scheduler.address}"

    def __enter__(self) -> Self:
        """Meet the workers; InputError where one would play other matches, MachineError if none."""
        try:
            compare(self.client)
            self._run(self._gather())
        except BaseException:
            self.close()
            raise
        self._watch = asyncio.run_coroutine_threadsafe(self._follow(), self._loop)
        return self

    async def _gather(self) -> None:
        """Wait for the first workers, and see that all play as this machine does."""
        end = time.monotonic() + self.patience
        while True:
            await self.crew.look()
            self.crew.refuse()
            if self.crew.good:
                self.crew.met = True
                return
            if time.monotonic() > end:
                raise MachineError(f"{self._where()} has no worker: start one, `dask worker`")
            await asyncio.sleep(BEAT / 4)

    def _run(self, work: Any) -> Any:
        """Do it in the client's thread, and wait for that."""
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End what is still played, and leave nothing: the cluster stays."""
        if self._watch:
            self._watch.cancel()
        self.client.close(timeout=CONNECT)
