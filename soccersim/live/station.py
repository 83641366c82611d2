"""The base station: a session and its server, until somebody ends it."""

import asyncio
import contextlib
import errno
import signal
import socket
from collections.abc import AsyncIterator, Callable

from soccersim.live.catalogue import Catalogue
from soccersim.live.gate import Gate, is_loopback, new_token
from soccersim.live.hub import Hub
from soccersim.live.play import Play
from soccersim.live.server import LiveServer
from soccersim.live.session import Session
from soccersim.problems import InputError, Problem

PORT = 8765


def bound(host: str, port: int) -> socket.socket:
    """A socket that listens there; InputError where it cannot."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # named TCP, or asyncio would leave small messages waiting for others: 40 ms
    listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    try:
        if hasattr(socket, "SO_EXCLUSIVEADDRUSE"):  # on Windows two programs could share a port
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        else:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((host, port))
        listener.listen(64)
        listener.setblocking(False)
    except OSError as error:
        listener.close()
        raise InputError(Problem(refused(host, port, error))) from None
    return listener


def refused(host: str, port: int, error: OSError) -> str:
    """Why we cannot listen there, and what would be right."""
    if error.errno == errno.EADDRINUSE:
        return f"port {port} is in use: end what listens there, or take --port 0 for a free one"
    if error.errno == errno.EACCES:
        return f"port {port} is not ours to take: use one above 1023, or --port 0"
    if isinstance(error, socket.gaierror) or error.errno == errno.EADDRNOTAVAIL:
        return f"--host {host} is no address of this computer: 0.0.0.0 takes all it has"
    return f"cannot listen at {host}, port {port}: {error.strerror or error}"


@contextlib.asynccontextmanager
async def open_station(
    catalogue: Catalogue, play: Play, listener: socket.socket, host: str
) -> AsyncIterator[tuple[Gate, Session]]:
    """Serves and simulates as long as it is open."""
    gate = Gate(host, listener.getsockname()[1], "" if is_loopback(host) else new_token())
    hub = Hub(asyncio.get_running_loop())
    session = Session(catalogue, play, hub.listen)
    try:
        async with LiveServer(session, hub, gate).open(listener):
            session.start()
            yield gate, session
    finally:
        await asyncio.to_thread(session.end)


def serve_station(
    catalogue: Catalogue,
    play: Play,
    listener: socket.socket,
    host: str,
    tell: Callable[[str], None],
) -> None:
    """Serve until Ctrl-C; tell is told the address once it can be opened."""

    async def serve() -> None:
        loop, ended = asyncio.get_running_loop(), asyncio.Event()
        with contextlib.suppress(NotImplementedError):  # Windows: Ctrl-C cancels this task instead
            for number in (signal.SIGINT, signal.SIGTERM):
                loop.add_signal_handler(number, ended.set)
        async with open_station(catalogue, play, listener, host) as (gate, _):
            tell(gate.url)
            with contextlib.suppress(asyncio.CancelledError):
                await ended.wait()

    asyncio.run(serve())
