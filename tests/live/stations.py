"""A base station in a thread of this process, and somebody who speaks to it as a browser does."""

import asyncio
import json
import threading
import time
from contextlib import contextmanager

import numpy as np
from websockets.sync.client import connect

from soccersim.live.catalogue import Catalogue
from soccersim.live.station import bound, open_station


@contextmanager
def station(scenario="training", host="127.0.0.1", moves=True, **more):
    """Gate and session of a station, once it moves; `cpu` is what its serving thread works."""
    catalogue, ready, told = Catalogue(scenario, **more), threading.Event(), {}
    listener = bound(host, 0)

    async def serve():
        ended = told["ended"] = asyncio.Event()
        told["loop"] = asyncio.get_running_loop()
        async with open_station(catalogue, catalogue.first(), listener, host) as opened:
            told["opened"] = opened
            ready.set()
            await ended.wait()

    def run():
        try:
            asyncio.run(serve())
        finally:
            ready.set()

    thread = threading.Thread(target=run)
    thread.start()
    assert ready.wait(60)
    gate, session = told["opened"]
    session.loop = told["loop"]
    end = time.monotonic() + 90.0
    while moves and session.play.tick == 0 and time.monotonic() < end:
        time.sleep(0.01)  # compiling takes longer than a browser waits
    try:
        yield gate, session
    finally:
        told["loop"].call_soon_threadsafe(told["ended"].set)
        thread.join(20)
        listener.close()
        assert not thread.is_alive()
        assert not session._thread.is_alive()


def cpu(session):
    """Seconds that the serving thread has worked."""

    async def measured():
        return time.thread_time()

    return asyncio.run_coroutine_threadsafe(measured(), session.loop).result(5)


class Talk:
    """One browser."""

    def __init__(self, gate, query="", **more):
        origin = f"http://127.0.0.1:{gate.port}"
        address = f"ws://127.0.0.1:{gate.port}/live{query}"
        self.opened = connect(
            address, **{"origin": origin, "compression": None, "close_timeout": 0.1, **more}
        )
        self.line = self.opened.__enter__()
        self.frames, self.texts, self.number = [], [], 0
        self.hello = self.until("hello")
        layout = self.hello["layout"]
        self.head = {name: i for i, name in enumerate(layout["head"])}
        self.of = {name: i for i, name in enumerate(layout["robot"])}
        self.first = len(layout["head"]) + len(layout["ball"])
        self.size = len(layout["robot"]) + layout["wheels"] * len(layout["wheel"])

    def hear(self, timeout=10):
        """The next message: a text as what it says, a picture as numbers."""
        told = self.line.recv(timeout)
        return json.loads(told) if isinstance(told, str) else np.frombuffer(told, "<f8")

    def until(self, kind):
        """The next text of this kind; what comes before is kept."""
        while True:
            told = self.hear()
            if isinstance(told, dict):
                if told["type"] == kind:
                    return told
                self.texts.append(told)
            else:
                self.frames.append(told)

    def say(self, **message):
        """What it answers."""
        self.number += 1
        self.line.send(json.dumps({**message, "id": self.number}))
        return self.answer(self.number)

    def raw(self, data):
        """What it answers to this, as it is."""
        self.line.send(data)
        return self.answer()

    def answer(self, number=None):
        """The next answer."""
        while True:
            told = self.hear()
            if isinstance(told, dict) and told["type"] in ("done", "wrong", "pong"):
                if number is None or told["id"] == number:
                    return told
            elif isinstance(told, dict):
                self.texts.append(told)
            else:
                self.frames.append(told)

    def picture(self):
        """The next picture."""
        while True:
            told = self.hear()
            if not isinstance(told, dict):
                return told
            self.texts.append(told)

    def pose(self, frame, robot=0):
        """x, y, heading."""
        start = self.first + robot * self.size
        return frame[start : start + 3]

    def close(self):
        self.opened.__exit__(None, None, None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
