"""Which processes live, whether they have ended soon, and killing some of them."""

import os
import signal
import time
from pathlib import Path


def parents():
    """The parent of each process that lives, by their ids."""
    found = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, parent = path.read_text().rpartition(")")[2].split()[:2]
        except OSError:
            continue
        if state != "Z":
            found[int(path.parent.name)] = int(parent)
    return found


def descendants(pid):
    """All that a process has started, directly or not, and that lives."""
    known, found = parents(), []
    level = [pid]
    while level:
        level = [child for child, parent in known.items() if parent in level]
        found += level
    return found


def lives(pid):
    """Whether it does, and is not just waiting to be buried."""
    return pid in parents()


def has_ended_soon(*pids, seconds=20):
    """Whether all of them have ended; waits for that."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if not set(pids) & parents().keys():
            return True
        time.sleep(0.01)
    return False


def marked(mark):
    """The processes that live with this text in their environment, whoever is their parent."""
    found = []
    for pid in parents():
        try:
            if mark.encode() in Path(f"/proc/{pid}/environ").read_bytes():
                found.append(pid)
        except OSError:
            continue
    return [pid for pid in found if pid != os.getpid()]


def killed(chance, coordinator, mark):
    """Kill the coordinator, one process of the others, or all of them; whether it was the first."""
    workers = [pid for pid in marked(mark) if pid != coordinator.pid]
    part = chance.choice(["coordinator", "one", "one", "all"])
    if part == "coordinator":
        coordinator.kill()
        return True
    for pid in workers if part == "all" else chance.sample(workers, min(1, len(workers))):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            continue
    return False
