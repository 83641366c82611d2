"""Python processes in groups of their own: they hear no Ctrl-C, and leave nobody behind."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

# as `python -m MODULE`, with our own sys.path; -P: no module of the working folder slips in
BOOT = """\
import sys, json, importlib
sys.path[:] = json.loads(sys.argv[1])
importlib.import_module(sys.argv[2]).main(*sys.argv[3:])
"""
Process = subprocess.Popen[bytes]


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
    if not hasattr(os, "waitid"):
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
