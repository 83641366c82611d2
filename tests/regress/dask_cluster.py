"""A Dask cluster on this machine: a scheduler and workers, each with its nanny, as programs."""

import json
import os
import signal
import subprocess
import sys
import time

from living import descendants, has_ended_soon

from soccersim import load_scenario
from soccersim.regress.bundle import bundle
from soccersim.regress.ground import Ground
from soccersim.regress.leg import pair_of
from soccersim.regress.pool import LocalPool
from soccersim.regress.runner import run
from soccersim.regress.store import Store

QUIET = {"DASK_LOGGING__DISTRIBUTED": "error", "DASK_DISTRIBUTED__ADMIN__LOW_LEVEL_LOG_LENGTH": "0"}


class Programs:
    """They end with it."""

    def __init__(self, folder):
        self.folder, self.file = folder, folder / "scheduler.json"
        self.temporary = folder / "tmp"
        self.temporary.mkdir(parents=True)
        self.begun = []
        self.scheduler = self.start("scheduler", "--scheduler-file", str(self.file), "--port", "0")
        self.address = json.loads(self.waited(self.file).read_text())["address"]

    def waited(self, path):
        """A file that comes, whole."""
        end = time.monotonic() + 30
        while not path.exists() or not path.read_text():
            assert time.monotonic() < end, self.told()
            time.sleep(0.05)
        return path

    def worker(self, *more, **environment):
        """A worker's program: the nanny, or with "--no-nanny" the worker itself."""
        asked = ["--local-directory", str(self.folder / "local"), "--nthreads", "1"]
        return self.start("worker", self.address, *asked, *more, **environment)

    def start(self, what, *arguments, **environment):
        words = [sys.executable, "-m", "dask", what, "--host", "127.0.0.1", "--no-dashboard"]
        told = {**os.environ, **QUIET, "TMPDIR": str(self.temporary), **environment}
        with open(self.folder / f"{what}-{len(self.begun)}.log", "wb") as log:
            self.begun.append(
                subprocess.Popen(
                    [*words, *arguments],
                    stdout=log,
                    stderr=log,
                    stdin=subprocess.DEVNULL,
                    env={name: value for name, value in told.items() if value is not None},
                    start_new_session=True,
                    cwd=self.folder,  # python -m looks for packages there first
                )
            )
        return self.begun[-1]

    def told(self):
        """What all of them have printed."""
        return "\n".join(path.read_text("utf-8", "replace") for path in self.folder.glob("*.log"))

    def close(self, how=signal.SIGKILL):
        """Ends all of them, and sees that nothing of theirs is left."""
        mine = [pid for program in self.begun for pid in descendants(program.pid)]
        for program in self.begun:
            program.send_signal(how)
        for program in self.begun:
            program.wait(30)
        assert has_ended_soon(*mine), self.told()
        assert not list(self.temporary.glob("soccersim-run-*"))


def worker_of(nanny):
    """The process of a nanny's worker."""
    end = time.monotonic() + 30
    while time.monotonic() < end:
        for pid in descendants(nanny.pid):
            with open(f"/proc/{pid}/cmdline", "rb") as file:
                if b"spawn_main" in file.read():
                    return pid
        time.sleep(0.05)
    raise AssertionError("no worker")


def matches_of(pid):
    """The processes of matches that a worker plays just now: they lead groups of their own."""
    found = []
    for child in descendants(pid):
        try:
            with open(f"/proc/{child}/cmdline", "rb") as file:
                if b"soccersim.regress.forks" in file.read():
                    found.append(child)
        except OSError:
            continue
    return found[1:]  # the first is the server


def until(what, seconds=30):
    """Whether it becomes true; waits for that."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if what():
            return True
        time.sleep(0.02)
    return False


def asked(pairs, seconds=5, first="roles", second="chaser", **more):
    spec = load_scenario("friendly-match", settings=[f"duration={seconds}"])
    teams = bundle(first), bundle(second)
    return [leg for n in range(pairs) for leg in pair_of(spec, teams, n, n + 1, **more)]


def table(store):
    return [row.result for row in store.rows()]


def locally(path, legs):
    """The table of these legs as this machine plays them."""
    with Store(path) as store, LocalPool(1, Ground(legs[0].scenario)) as pool:
        list(run(legs, store, pool))
        return table(store)
