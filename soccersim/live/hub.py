"""The browsers that watch. Each gets the newest picture when it is ready for one, and all texts.

A browser that does not keep up misses pictures; one that does not even take texts is closed.
"""

import asyncio
import contextlib
import json
from collections import deque
from typing import Any, Protocol

MOST_TEXTS = 400  # that wait for one browser
CROWD = 16  # browsers at once


class Line(Protocol):
    """What a browser is told through."""

    async def send(self, message: str | bytes) -> None:
        """Tell it; returns when there is room for more."""

    async def close(self, code: int = 1000, reason: str = "") -> None:
        """Say goodbye."""


class Viewer:
    """One browser."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.texts: deque[str] = deque()
        self.picture: bytes | None = None
        self.news = asyncio.Event()
        self.lost = False  # it takes nothing any more

    def tell(self, text: str) -> None:
        """A text, after those before."""
        if len(self.texts) >= MOST_TEXTS:
            self.lost = True
        else:
            self.texts.append(text)
        self.news.set()

    def show(self, picture: bytes) -> None:
        """A picture, instead of one that it has not taken yet."""
        self.picture = picture
        self.news.set()

    async def write(self) -> None:
        """Hand over what there is, for ever; ends with the line."""
        while not self.lost:
            await self.news.wait()
            self.news.clear()
            while self.texts and not self.lost:
                await self.line.send(self.texts.popleft())
            picture, self.picture = self.picture, None
            if picture is not None and not self.lost:
                await self.line.send(picture)
        await self.line.close(1013, "you do not keep up")


class Hub:
    """All browsers. Only `listen` may be called from another thread."""

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self.loop = loop
        self.viewers: set[Viewer] = set()
        self.picture: bytes | None = None  # the newest

    def join(self, viewer: Viewer) -> None:
        """One more; it sees at once what there is to see."""
        self.viewers.add(viewer)
        if self.picture is not None:
            viewer.show(self.picture)

    def listen(self, told: bytes | dict[str, Any]) -> None:
        """What the session tells."""
        with contextlib.suppress(RuntimeError):  # the loop has ended; the session will, too
            self.loop.call_soon_threadsafe(self._spread, told)

    def _spread(self, told: bytes | dict[str, Any]) -> None:
        if isinstance(told, bytes):
            self.picture = told
            for viewer in self.viewers:
                viewer.show(told)
        else:
            text = text_of(told)
            if told["type"] == "hello":
                self.picture = None  # of what was open before: nobody could read it now
            for viewer in self.viewers:
                if told["type"] == "hello":
                    viewer.picture = None
                viewer.tell(text)


def text_of(told: dict[str, Any]) -> str:
    """As JSON."""
    return json.dumps(told, separators=(",", ":"))
