"""Processes in groups of their own, so that nothing they start outlives them."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import IO, Any, Protocol

from soccersim.match.faults import CRASH, EXIT, MEMORY

# as `python -m MODULE`, with our own sys.path; -P: no module of the working folder slips in
BOOT = """\
import sys, json, importlib
sys.path[:] = json.loads(sys.argv[1])
importlib.import_module(sys.argv[2]).main(*sys.argv[3:])
"""
BURIAL = 1.0  # s that a process may take to end once its pipe is closed
FULL = 77  # exit code of a team's process whose memory is full


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


def start(module: str, arguments: Sequence[str], **pipes: Any) -> Process:
    """A Python process that runs MODULE.main(*arguments); it hears no Ctrl-C of the terminal."""
    path = json.dumps([entry for entry in sys.path if isinstance(entry, str)])
    words = [sys.executable, "-u", "-P", "-c", BOOT, path, module, *arguments]
    # texts in sets in the same order each time, also for strategies that iterate over them
    environment = {"PYTHONHASHSEED": "0", **os.environ}
    return subprocess.Popen(
        words, bufsize=0, env=environment, stdin=subprocess.PIPE, start_new_session=True, **pipes
    )


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


def how_ended(code: int) -> tuple[str, str]:
    """The kind of fault that an end with this exit code is, and its words."""
    if code == FULL:
        return MEMORY, "its memory is full"
    if code >= 0:
        return EXIT, f"its process ended with exit code {code}"
    try:
        name = signal.Signals(-code).name
    except ValueError:
        name = f"signal {-code}"
    full = ", as a system does whose memory is full" if name == "SIGKILL" else ""
    return CRASH, f"its process was killed by {name}{full}"
