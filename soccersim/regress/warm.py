"""Processes that begin with everything loaded: forked by a server process that has done so once.

The server (forks.py) is one small process of one thread. For each match it forks a keeper, and the
keeper forks the match's process: what they have in common is in memory once.
"""

import json
import os
import select
import signal
import socket
import struct
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from subprocess import DEVNULL
from threading import Lock
from typing import IO, Any

from soccersim.match.stopwatch import STALL
from soccersim.problems import MachineError, one_line
from soccersim.processes import Process, end, start

CAN_FORK = hasattr(os, "fork") and hasattr(os, "waitid") and sys.platform != "darwin"
NUMBER = struct.Struct("<i")  # what a keeper tells: first the process's id, then its exit code
LENGTH = struct.Struct("<I")
SERVER = "soccersim.regress.forks"
WORDS = "server.txt"  # what the server says when it fails
TRIES = 3  # servers that may be lost one after the other
PATIENCE = 60.0  # s that a fork may take
BURIAL = 10.0  # s that a keeper may take to end what a match has left behind


class Forked:
    """A process of a match, as subprocess.Popen would show it; its keeper tells how it ends."""

    def __init__(self, pid: int, stdin: IO[bytes], stdout: IO[bytes], status: int) -> None:
        self.pid, self.stdin, self.stdout = pid, stdin, stdout
        self.returncode: int | None = None
        self._status = status
        self._code: int | None = None

    def poll(self) -> int | None:
        """Its exit code; None while it runs. Its group keeps its number until wait()."""
        if self._code is None:
            self._code = told(self._status, 0.0)
        return self._code

    def wait(self) -> int:
        """Its exit code; returns when it has ended and all that it has left behind."""
        if self.returncode is None:
            while self._code is None:
                self._code = told(self._status, BURIAL)
            self.stdin.close()  # the keeper waits for that
            is_there(self._status, BURIAL)  # the end of what it tells, since it has ended
            os.close(self._status)
            self.returncode = self._code
        return self.returncode


class Warm:
    """Starts processes as processes.py does, but warm ones. Threads may share it."""

    def __init__(self, folder: Path, module: str, scenario: str) -> None:
        """folder: of this run alone, removed when it ends.

        The module is imported ahead, and all loaded for a match of this scenario (JSON) if it is
        not "".
        """
        self.folder, self.module, self.scenario = folder, module, scenario
        self._lock = Lock()
        self._server: Process | None = None
        self._socket: socket.socket | None = None

    def start(self) -> None:
        """Start the server; returns when it has loaded all. MachineError where it cannot."""
        with self._lock:
            self._connect()

    def begin(self, module: str, arguments: Sequence[str], **_: Any) -> Process:
        """A process that runs MODULE.main(*arguments), its prints in a pipe."""
        with self._lock:
            for _try in range(TRIES):
                try:
                    return self._fork(module, arguments)
                except OSError:  # the server has ended, whoever did that
                    self._drop()
        raise MachineError(f"no process can be started{self._words()}")

    def close(self) -> None:
        """End the server, and with it all that it has started."""
        with self._lock:
            self._drop()

    def _connect(self) -> socket.socket:
        for _try in range(TRIES - 1):
            with suppress(MachineError):  # it may have been killed while it loaded
                return self._connected()
        return self._connected()

    def _connected(self) -> socket.socket:
        if self._socket:
            return self._socket
        ours, its = socket.socketpair()
        with its, open(self.folder / WORDS, "wb") as words:
            arguments = [str(its.fileno()), str(self.folder)]
            self._server = start(
                SERVER, arguments, pass_fds=[its.fileno()], stdout=DEVNULL, stderr=words
            )
        self._socket = ours
        try:
            send(ours, {"module": self.module, "scenario": self.scenario})
            ours.settimeout(STALL)
            if not ours.recv(1):
                raise ConnectionError
        except OSError as error:
            self._drop()
            raise MachineError(f"no process can be started{self._words()}") from error
        ours.settimeout(PATIENCE)
        return ours

    def _fork(self, module: str, arguments: Sequence[str]) -> Process:
        server = self._connect()
        (stdin, sink), (source, stdout), (status, tell) = (os.pipe() for _ in range(3))
        sink_file, source_file = os.fdopen(sink, "wb", 0), os.fdopen(source, "rb", 0)
        try:
            try:
                document = {"module": module, "arguments": list(arguments)}
                send(server, document, [stdin, stdout, tell])
            finally:
                for number in (stdin, stdout, tell):
                    os.close(number)
            pid = told(status, PATIENCE)
            if pid is None or pid <= 0:
                raise ConnectionError("no process")
        except BaseException:
            sink_file.close()
            source_file.close()
            os.close(status)
            raise
        return Forked(pid, sink_file, source_file, status)

    def _drop(self) -> None:
        if self._server:
            end(self._server)  # first: left alone, it would take the folder away
        if self._socket:
            self._socket.close()
        self._socket = self._server = None

    def _words(self) -> str:
        try:
            text = (self.folder / WORDS).read_text("utf-8", "replace")
        except OSError:
            return ""
        last = text.strip().rpartition("\n")[2]
        return last and f": {one_line(last, 200)}"


def told(status: int, seconds: float) -> int | None:
    """The next number that a keeper tells; None where none comes in time.

    A keeper that is gone counts as its process killed: it kills that as it ends.
    """
    if not is_there(status, seconds):
        return None
    data = os.read(status, NUMBER.size)
    return int(NUMBER.unpack(data)[0]) if len(data) == NUMBER.size else -signal.SIGKILL


def is_there(pipe: int, seconds: float) -> bool:
    """Whether there is something to read from a pipe, or its end, so many seconds from now."""
    poll = select.poll()  # not select(), which knows the first 1024 files alone
    poll.register(pipe, select.POLLIN)
    return bool(poll.poll(1000 * seconds))


def send(to: socket.socket, document: dict[str, Any], files: Sequence[int] = ()) -> None:
    """A document, and open files with it."""
    data = json.dumps(document).encode()
    socket.send_fds(to, [LENGTH.pack(len(data))], files)
    to.sendall(data)


def receive(source: socket.socket) -> tuple[dict[str, Any], list[int]]:
    """What send has sent; EOFError where nobody sends any more."""
    data, files, _, _ = socket.recv_fds(source, LENGTH.size, 3)
    if len(data) < LENGTH.size:
        raise EOFError
    length, data = LENGTH.unpack(data)[0], b""
    while len(data) < length:
        more = source.recv(length - len(data))
        if not more:
            raise EOFError
        data += more
    return dict(json.loads(data)), files
