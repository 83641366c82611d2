"""Where matches are played on this machine: processes for them, and a folder for their files."""

import atexit
import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from tempfile import mkdtemp
from threading import Event, Lock

from soccersim.match.supervise import CHILD
from soccersim.processes import Process
from soccersim.regress.reused import Reused
from soccersim.regress.warm import CAN_FORK, Warm

PREFIX = "soccersim-run-"  # then the id of the process that has the folder

_own: list["Ground"] = []
_lock = Lock()


class Ground:
    """Shared by the threads that watch the matches."""

    def __init__(self, scenario: str = "", child: str = CHILD, fork: bool = CAN_FORK) -> None:
        """scenario: a match, as JSON, to load all for; child: the module that a process runs."""
        tidy()
        self.folder = Path(mkdtemp(prefix=f"{PREFIX}{os.getpid()}-")).absolute()
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


def tidy() -> None:
    """Take away the folders of runs that were killed together with all their processes."""
    if os.name != "posix":
        return
    for folder in Path(tempfile.gettempdir()).glob(f"{PREFIX}*"):
        pid = folder.name.removeprefix(PREFIX).partition("-")[0]
        try:
            if pid.isdecimal():
                os.kill(int(pid), 0)
        except ProcessLookupError:
            shutil.rmtree(folder, ignore_errors=True)
        except (OSError, OverflowError):
            continue
