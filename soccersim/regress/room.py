"""A match that has its machine to itself: what else the clusters' runs play there waits for it.

A machine of a cluster has several workers, processes that know nothing of each other: so this is
kept by two locked files, and ends with the process that holds them. On Windows nobody waits.
"""

import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO

LOOK = 0.05  # s from one look at a lock to the next
DOOR, ROOM = "door", "room"  # all go through the door, one at a time; then they are in the room


@contextmanager
def room(alone: bool, wanted: Callable[[], bool]) -> Iterator[bool]:
    """As long as this lasts, a match is played here; whether it is still wanted when that begins.

    Who is to be alone shuts the door, so that no more come in, and waits until all have gone.
    """
    if sys.platform == "win32":
        yield wanted()
        return
    import fcntl

    with opened(DOOR) as door, opened(ROOM) as inside:
        how = fcntl.LOCK_EX if alone else fcntl.LOCK_SH
        if taken(door, fcntl.LOCK_EX, wanted) and taken(inside, how, wanted):
            if not alone:
                fcntl.flock(door, fcntl.LOCK_UN)
            yield True
        else:
            yield False


def taken(file: IO[bytes], how: int, wanted: Callable[[], bool]) -> bool:
    """Wait for a lock; False once that is not wanted any more."""
    import fcntl

    while wanted():
        try:
            fcntl.flock(file, how | fcntl.LOCK_NB)
            return True
        except BlockingIOError:
            time.sleep(LOOK)
    return False


def opened(name: str) -> IO[bytes]:
    """A file that all of this user's processes on this machine know."""
    user = os.getuid() if sys.platform != "win32" else 0
    return open(Path(tempfile.gettempdir()) / f"soccersim-{user}-{name}.lock", "ab")
