"""The workers of a Dask cluster, as they come and go: which of them play our matches."""

import asyncio
from collections.abc import Callable, Mapping
from typing import Any

from soccersim.problems import InputError, Problem
from soccersim.regress.remote import LOADED, describe, hash_seed, load, told

PATIENCE = 30.0  # s that a worker may take to tell what it is: it imports all that it needs first


class Crew:
    """Used in the thread of Dask's client alone, but for its numbers."""

    def __init__(self, client: Any, scenario: str, say: Callable[[str], None]) -> None:
        """say: is told of the workers that do not count."""
        self.client, self.scenario, self.say = client, scenario, say
        self.ours = told()
        self.seed = hash_seed()
        self.good: dict[str, int] = {}  # by address: the matches that it plays at a time
        self.foreign: dict[str, str] = {}  # by address: why it plays none of ours
        self.met = False  # whether the first look is over: from then on foreign ones are told of

    @property
    def width(self) -> int:
        """The matches that are played at a time; 1 where there is nobody to play them."""
        return max(1, sum(list(self.good.values())))

    async def look(self) -> None:
        """See who is there; OSError where there is no scheduler any more."""
        threads: Mapping[str, int] = await self.client.scheduler.ncores(workers=None)
        self.foreign = {name: why for name, why in self.foreign.items() if name in threads}
        new = [name for name in threads if name not in self.good and name not in self.foreign]
        met = await self._meet(new) if new else []
        known = {*self.good, *met} - self.foreign.keys()
        self.good = {name: count for name, count in threads.items() if name in known}

    async def _meet(self, new: list[str]) -> list[str]:
        """Ask new ones what they are; those that play as this one does."""
        try:
            asked = self.client.run(describe, self.seed, workers=new, on_error="return")
            answers = await asyncio.wait_for(asked, PATIENCE)
        except TimeoutError:
            return []  # asked again at the next look
        for worker, answer in answers.items():
            if not isinstance(answer, OSError):  # one that has gone meanwhile
                self.judge(worker, answer)
        good = [worker for worker in answers if answers[worker] == self.ours]
        if good:
            await self.client.run(load, self.scenario, workers=good, on_error="ignore")
        return good

    def judge(self, worker: str, answer: Any) -> None:
        """Take note of a worker that has told what it is, if it would play other matches."""
        if answer == self.ours or worker in self.foreign:
            return
        self.foreign[worker] = why = unlike(answer, self.ours)
        self.good.pop(worker, None)
        if self.met:
            self.say(f"the worker {worker} {why}: it plays none of this run's matches")

    def refuse(self) -> None:
        """InputError if there are such: a problem for each way to be unlike us."""
        found: dict[str, list[str]] = {}
        for worker, why in self.foreign.items():
            found.setdefault(why, []).append(worker)
        if found:
            raise InputError([Problem(f"{named(who)} {why}") for why, who in found.items()])


def named(workers: list[str]) -> str:
    """The first of them, and how many more."""
    more = f" (and {len(workers) - 1} more)" if len(workers) > 1 else ""
    return f"the worker {workers[0]}{more}"


def unlike(answer: Any, ours: Mapping[str, str]) -> str:
    """In what a worker is not as we are, naming both."""
    if isinstance(answer, ImportError):
        return f"has no soccersim like this one ({answer})"
    if not isinstance(answer, Mapping):
        return f"cannot say which soccersim it has ({answer!r})"
    differ = [key for key in ours if answer.get(key) != ours[key]]
    named = [key for key in differ if key != LOADED] or differ
    theirs = ", ".join(f"{key} {answer.get(key, 'unknown')}" for key in named)
    return f"has {theirs}; here it is {', '.join(f'{key} {ours[key]}' for key in named)}"
