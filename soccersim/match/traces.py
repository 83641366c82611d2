"""What a process was doing when it crashed, or hangs: told by Python's faulthandler into a file."""

import faulthandler
import os
import re
import signal
import time
from pathlib import Path

from soccersim.match.faults import is_ours, last_lines

ASK = getattr(signal, "SIGUSR1", None)  # asks a process for its traceback, where there is such
TELLING = 0.5  # s that it may take to tell
PLACE = re.compile(r'  File "(.*)", line \d+ in .*')
MOST = 64 * 1024  # bytes of a file that are read

_file: int | None = None  # the handler writes there as long as the process lives


def keep_traces(path: Path) -> None:
    """In this process: write into the file on a crash, or when asked."""
    global _file
    before, _file = _file, os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    faulthandler.enable(_file, all_threads=False)
    if ASK is not None:
        faulthandler.register(ASK, _file, all_threads=False)
    if before is not None:
        os.close(before)


def ask_trace(pid: int, path: Path) -> None:
    """Have another process write its traceback now, if it can; it may die of it if it cannot."""
    if ASK is None:
        return
    try:
        os.kill(pid, ASK)
    except OSError:
        return
    end = time.monotonic() + TELLING
    seen = 0
    while time.monotonic() < end:
        time.sleep(0.02)
        size = _size(path)
        if size and size == seen:
            return
        seen = size


def read_trace(path: Path) -> str:
    """The last lines of what the process wrote, the team's own part, as Python orders it."""
    try:
        with open(path, "rb") as file:
            text = file.read(MOST).decode("utf-8", "replace")
    except OSError:
        return ""
    places: list[str] = []
    fatal: list[str] = []
    for line in text.splitlines():
        if line.startswith("Fatal Python error"):
            fatal = [line]
        elif found := PLACE.fullmatch(line):
            if is_ours(found[1]) and places:
                break  # from here on it is the simulator that called
            if not is_ours(found[1]):
                places.append(line)
    head = ["Traceback (most recent call last):"] if places else []
    return last_lines("\n".join([*head, *places[::-1], *fatal]))


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError:
        return 0
