"""Where matches are played on this machine: processes for them, and a folder for their files."""

import atexit
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from tempfile import mkdtemp
from threading import Event, Lock
from typing import IO

from soccersim.match.supervise import CHILD
from soccersim.processes import Process
from soccersim.regress.reused import Reused
from soccersim.regress.warm import CAN_FORK, Warm

NEW, PREFIX, LOCK = "soccersim-new-", "soccersim-run-", "lock"

_own: list["Ground"] = []
_lock = Lock()


class Ground:
    """Shared by the threads that watch the matches."""

    def __init__(self, scenario: str = "", child: str = CHILD, fork: bool = CAN_FORK) -> None:
        """scenario: a match, as JSON, to load all for; child: the module that a process runs."""
        tidy()
        new = Path(mkdtemp(prefix=NEW)).absolute()
        self.folder = new.with_name(new.name.replace(NEW, PREFIX))
        self._lock = locked(new / LOCK)  # before its name tells that it is one of these
        new.rename(self.folder)
        self.child = child
        self.stopping = Event()  # set: no match is wanted any more
        self._source = Warm(self.folder, child, scenario) if fork else Reused()

    @property
    def begin(self) -> Callable[..., Process]:
        """Starts a process, as processes.py does."""
        return self._source.begin

    def start(self) -> None:
        """Load all that matches need, which takes seconds; without it, the first match waits."""
        self._source.start()

    def close(self) -> None:
        """End what is still played, and leave nothing."""
        self.stopping.set()
        self._source.close()
        if self._lock:
            self._lock.close()
        shutil.rmtree(self.folder, ignore_errors=True)


def own_ground(scenario: str) -> Ground:
    """The ground of this process: on a machine of a cluster, say. It lasts as long.

    scenario: what it is loaded for, if it is not there yet.
    """
    with _lock:
        if not _own:
            _own.append(Ground(scenario))
            atexit.register(_own[0].close)
    return _own[0]


def locked(path: Path) -> IO[bytes] | None:
    """The file, as long as it is open this process's alone; None where another one has it.

    None on Windows too, where a folder with an open file could not be renamed.
    """
    if sys.platform == "win32":
        return None
    import fcntl

    file = open(path, "wb")  # noqa: SIM115
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        file.close()
        return None
    return file


def tidy() -> None:
    """Take away the folders of runs that were killed together with all their processes."""
    for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*"):
        try:
            if file := locked(folder / LOCK):
                shutil.rmtree(folder, ignore_errors=True)
                file.close()
        except OSError:  # another one's, or gone
            continue
