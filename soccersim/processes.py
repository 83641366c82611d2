"""Python processes in groups of their own: they hear no Ctrl-C, and leave nobody behind."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import IO, Any, Protocol

# as `python -m MODULE`, with our own sys.path; -P: no module of the working folder slips in
BOOT = """\
import sys, json, importlib
sys.path[:] = json.loads(sys.argv[1])
importlib.import_module(sys.argv[2]).main(*sys.argv[3:])
"""


class Process(Protocol):
    """What is known of a process that was started: a subprocess.Popen, or what does as it does."""

    pid: int  # it leads a group of this number

    @property
    def stdin(self) -> IO[bytes] | None:
        """The end that is closed when nobody wants the process any more."""

    @property
    def stdout(self) -> IO[bytes] | None:
        """What it prints."""

    @property
    def returncode(self) -> int | None:
        """Its exit code; None until it is buried."""

    def poll(self) -> int | None:
        """Its exit code; None while it runs."""

    def wait(self) -> int:
        """Bury it as soon as it ends; its exit code."""


def start(module: str, arguments: Sequence[str] = (), **pipes: Any) -> Process:
    """A process that runs MODULE.main(*arguments); its standard input is a pipe."""
    path = json.dumps([entry for entry in sys.path if isinstance(entry, str)])
    words = [sys.executable, "-u", "-P", "-c", BOOT, path, module, *arguments]
    # texts in sets in the same order each time, also for strategies that iterate over them
    environment = {"PYTHONHASHSEED": "0", **os.environ}
    return subprocess.Popen(
        words, bufsize=0, env=environment, stdin=subprocess.PIPE, start_new_session=True, **pipes
    )


def take_pipes() -> tuple[int, int]:
    """In such a process: its input and output, where no print gets into them.

    What is read from standard input from now on is empty, what is printed goes to standard error.
    """
    source, sink = os.dup(0), os.dup(1)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    return source, sink


def has_ended(process: Process) -> bool:
    """Whether it has; it stays unburied where that can be, so that its group keeps its number."""
    if process.returncode is not None:
        return True
    if not hasattr(os, "waitid") or not isinstance(process, subprocess.Popen):
        return process.poll() is not None
    try:
        flags = os.WEXITED | os.WNOHANG | os.WNOWAIT
        return os.waitid(os.P_PID, process.pid, flags) is not None
    except ChildProcessError:
        return process.poll() is not None


def end_group(pid: int) -> None:
    """Kill a process and all of its group."""
    with suppress(ProcessLookupError, PermissionError):
        if hasattr(os, "killpg"):
            os.killpg(pid, signal.SIGKILL)
        else:
            os.kill(pid, signal.SIGTERM)  # Windows: ends it at once


def end(process: Process) -> int:
    """Kill it and its group, and bury it; its exit code, which it may have had before."""
    if process.returncode is None:
        end_group(process.pid)
    code = process.wait()
    if process.stdin:
        with suppress(OSError):
            process.stdin.close()
    return code
