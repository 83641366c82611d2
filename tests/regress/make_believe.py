"""Matches that nobody plays: who wins is drawn from seed and code, in no time.

A team whose code says GOOD scores more; FAULTY is at fault in every match, MOODY never plays the
same match twice, SHY not when it is filmed. They end in another order than they began in.
"""

import hashlib
import time
from concurrent.futures import ThreadPoolExecutor
from random import Random

from soccersim.regress.bundle import content
from soccersim.regress.job import Played
from soccersim.regress.row import Row

FAULT = {"kind": "exception", "tick": 40, "detail": "Traceback ...\n  in decide\nValueError: no"}


class Ground:
    """Stands for the processes of this machine."""

    def __init__(self, scenario):
        del scenario


class Pool:
    """Plays them in threads."""

    quiet = True
    opened = 0
    begun: list = []  # noqa: RUF012 - (pair, leg) of all pools

    def __init__(self, jobs, ground):
        del ground
        self.width = jobs
        self._threads = ThreadPoolExecutor(jobs)

    def __enter__(self):
        Pool.opened += 1
        return self

    def __exit__(self, *_):
        self._threads.shutdown(cancel_futures=True)

    def submit(self, leg, alone):
        del alone
        Pool.begun.append((leg.pair, leg.leg))
        return self._threads.submit(play, leg)


def play(leg):
    """The leg's row, after a while."""
    teams = [repr(content(team)) for team in (leg.home, leg.away)]
    told = [leg.seed, *teams]
    digest = hashlib.sha256(repr(told).encode()).hexdigest()
    chance = Random(digest)
    time.sleep(0.002 * chance.random())
    score = [sum(chance.random() < 0.2 + 0.2 * ("GOOD" in code) for _ in "12345") for code in teams]
    if teams[0] == teams[1]:
        score = [1, 1]
    faults = ()
    for slot, side in enumerate(("home", "away")):
        if "FAULTY" in teams[slot] and not faults:
            faults = ({"side": side, **FAULT},)
            score = [0, 3] if slot == 0 else [3, 0]
    if any("MOODY" in code for code in teams):
        digest = hashlib.sha256(repr((digest, time.perf_counter())).encode()).hexdigest()
    if leg.keep == "all" and any("SHY" in code for code in teams):
        digest += " filmed"
    where = leg.key, leg.pair, leg.leg, leg.seed, leg.home.sha, leg.away.sha
    return Played(
        Row(*where, tuple(score), digest, 60.0, faults, (), 0.5, 0.1),
        "",
        b"film" * (leg.keep == "all"),
    )
