"""A keeper: the parent of one match's process. It tells how that ends, and leaves nothing of it.

On Linux it also inherits what the match has started and cut loose, and its own end is the end of
the match's process.
"""

import ctypes
import os
import select
import signal
import sys
import time
import traceback
from collections.abc import Iterator
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import NoReturn

from soccersim.processes import end_group
from soccersim.regress.warm import NUMBER

DEATH_SIGNAL, SUBREAPER = 1, 36  # of prctl
MOST_FILES = 65536
GENERATIONS = 200  # of processes that start others as fast as they are killed


def keep(stdin: int, stdout: int, status: int, module: str, arguments: list[str]) -> NoReturn:
    """Be the keeper of a process that runs MODULE.main(*arguments).

    stdin: its other end is closed when nobody wants the process any more.
    """
    try:
        os.setsid()
        control(SUBREAPER, 1)
        woken, wake = os.pipe()
        os.set_blocking(wake, False)
        signal.set_wakeup_fd(wake, warn_on_full_buffer=False)
        signal.signal(signal.SIGCHLD, lambda *_: None)
        keeper, (apart, begun) = os.getpid(), os.pipe()
        child = os.fork()
        if child == 0:
            become(keeper, stdin, stdout, module, arguments)
        os.close(stdout)
        os.close(begun)
        os.read(apart, 1)  # it leads a group now: whoever knows its id may end that
        with suppress(BrokenPipeError):
            os.write(status, NUMBER.pack(child))
            code = awaited(child, stdin, woken)
            if code is not None:
                os.write(status, NUMBER.pack(code))
                until_closed(stdin)
        end_group(child)
        os.waitpid(child, 0)
        end_strays()
    finally:
        os._exit(0)


def awaited(child: int, stdin: int, woken: int) -> int | None:
    """The exit code of the process once it has ended; None where nobody wants it any more."""
    poll = select.poll()
    poll.register(stdin, 0)  # tells of its end alone
    poll.register(woken, select.POLLIN)
    while True:
        ended = os.waitid(os.P_PID, child, os.WEXITED | os.WNOHANG | os.WNOWAIT)
        if ended:
            return ended.si_status if ended.si_code == os.CLD_EXITED else -ended.si_status
        for number, _ in poll.poll():
            if number == stdin:
                return None
            os.read(woken, 1024)


def until_closed(stdin: int) -> None:
    """Wait until nobody wants the process any more."""
    poll = select.poll()
    poll.register(stdin, 0)
    poll.poll()


def become(keeper: int, stdin: int, stdout: int, module: str, arguments: list[str]) -> NoReturn:
    """Be the process itself."""
    try:
        os.setsid()
        control(DEATH_SIGNAL, signal.SIGKILL)
        if os.getppid() != keeper:
            os._exit(1)
        signal.set_wakeup_fd(-1)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        for number, file in ((0, stdin), (1, stdout), (2, stdout)):
            os.dup2(file, number)
        os.closerange(3, MOST_FILES)  # the keeper waits for that
        if numpy := sys.modules.get("numpy"):  # Python's own generator sees to that itself
            numpy.random.seed()
        process = import_module(module)
        process.main(*arguments)
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    finally:
        os._exit(0)


def end_strays() -> None:
    """End all that has come to this process as its parents ended."""
    for _ in range(GENERATIONS):
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return
        for pid in children():
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(0.002)


def children() -> Iterator[int]:
    """The processes whose parent this one is; none where the system does not tell."""
    own = os.getpid()
    for path in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            if int(path.read_text().rpartition(")")[2].split()[1]) == own:
                yield int(path.parent.name)


def control(what: int, value: int) -> None:
    """prctl, where there is one."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(what, value, 0, 0, 0)
