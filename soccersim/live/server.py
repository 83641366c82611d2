"""The server: the page by HTTP, and one WebSocket a browser, all in one thread."""

import asyncio
import contextlib
import socket
import time
from http import HTTPStatus
from typing import Any

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from soccersim.live import messages as say
from soccersim.live.gate import Gate
from soccersim.live.hub import CROWD, Hub, Viewer, text_of
from soccersim.live.messages import Wrong
from soccersim.live.page import page, policy
from soccersim.live.session import Session

RATE = 400  # messages a second of one browser; one that says more is read more slowly
BURST = 400
LARGEST = 64 * 1024  # bytes; what is larger is not even read
PATIENCE = 20.0  # s for an answer of the session: opening a match starts processes


class LiveServer:
    """Serves one session."""

    def __init__(self, session: Session, hub: Hub, gate: Gate) -> None:
        self.session, self.hub, self.gate = session, hub, gate
        self._page = page().encode()
        self._policy = policy()

    @contextlib.asynccontextmanager
    async def open(self, listener: socket.socket) -> Any:
        """Serve on this socket."""
        server: Server
        async with serve(
            self._watch,
            sock=listener,
            process_request=self._request,
            compression=None,  # 200 kB/s through this computer cost less than packing them
            max_size=LARGEST,
            max_queue=8,
            write_limit=64 * 1024,
            ping_interval=20,
            ping_timeout=20,
            close_timeout=1,
            server_header=None,
        ) as server:
            yield server

    def _request(self, connection: ServerConnection, request: Request) -> Response | None:
        """The page, or the way to the WebSocket, or why not."""
        path = request.path.partition("?")[0]
        try:
            # of two headers of a name, neither is to be believed
            origin = request.headers.get("Origin")
            refusal = self.gate.refusal(request.path, request.headers, origin)
        except Exception:
            return self._answer(HTTPStatus.BAD_REQUEST, "a request with odd headers")
        if refusal:
            return self._answer(HTTPStatus.FORBIDDEN, refusal)
        if path == "/live":
            if len(self.hub.viewers) >= CROWD:
                return self._answer(HTTPStatus.SERVICE_UNAVAILABLE, f"{CROWD} watch already")
            return None
        if path == "/":
            return self._answer(HTTPStatus.OK, self._page, "text/html")
        return self._answer(HTTPStatus.NOT_FOUND, "there is nothing here but /")

    def _answer(self, status: HTTPStatus, body: str | bytes, kind: str = "text/plain") -> Response:
        data = body if isinstance(body, bytes) else f"soccersim live: {body}\n".encode()
        headers = Headers(
            {
                "Content-Type": f"{kind}; charset=utf-8",
                "Content-Length": str(len(data)),
                "Content-Security-Policy": self._policy,
                "X-Content-Type-Options": "nosniff",
                "X-Frame-Options": "DENY",
                "Referrer-Policy": "no-referrer",  # the address may hold the token
                "Cross-Origin-Resource-Policy": "same-origin",
                "Cache-Control": "no-store",
                "Connection": "close",
            }
        )
        return Response(status.value, status.phrase, headers, data)

    async def _watch(self, connection: ServerConnection) -> None:
        """One browser, from its greeting to its end."""
        viewer = Viewer(connection)
        viewer.tell(text_of(self.session.greeting()))
        self.hub.join(viewer)
        self.session.viewers = len(self.hub.viewers)
        writing = asyncio.create_task(self._write(viewer))
        try:
            with contextlib.suppress(ConnectionClosed):
                await self._read(connection, viewer)
        finally:
            self.hub.viewers.discard(viewer)
            self.session.viewers = len(self.hub.viewers)
            writing.cancel()

    async def _write(self, viewer: Viewer) -> None:
        with contextlib.suppress(ConnectionClosed):
            await viewer.write()

    async def _read(self, connection: ServerConnection, viewer: Viewer) -> None:
        """Every message is answered; the next is read when there is time for it."""
        allowed, last = float(BURST), time.monotonic()
        async for text in connection:
            now = time.monotonic()
            if viewer.lost:
                break
            allowed, last = min(BURST, allowed + RATE * (now - last)) - 1.0, now
            viewer.tell(text_of(await self._answered(text)))
            if allowed < 0.0 or len(viewer.texts) > 100:
                await asyncio.sleep(max(-allowed / RATE, 0.01))

    async def _answered(self, text: str | bytes) -> dict[str, Any]:
        """The answer to one message."""
        try:
            message = say.read(text)
            if isinstance(message, say.Ping):
                return {"type": "pong", "id": message.id}
            asked = asyncio.wrap_future(self.session.ask(message))
            return await asyncio.wait_for(asked, PATIENCE)
        except Wrong as wrong:
            return {"type": "wrong", "id": wrong.id, "what": str(wrong)}
        except TimeoutError:
            return {"type": "wrong", "id": message.id, "what": "no answer yet: it is busy"}
