"""The thread that simulates: at the pace of the clock, obeying what browsers say in between.

It never waits for a browser. What it tells goes to `listen`, which must return at once.
"""

import threading
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from queue import Empty, Full, Queue
from typing import Any

from soccersim.kernel import will_compile
from soccersim.live import messages as say
from soccersim.live.catalogue import Catalogue
from soccersim.live.frame import Framer
from soccersim.live.messages import Wrong
from soccersim.live.play import Play
from soccersim.live.told import hello
from soccersim.problems import InputError, MachineError, RunError, one_line

PERIOD = 0.02  # s from picture to picture
IDLE = 0.2  # s from picture to picture while nothing moves
BEHIND = 0.25  # s that may be caught up with; what is later is left
WAITING = 500  # messages that may wait
EVENTS = 200  # that are kept for browsers that come later
MEASURED = 1.0  # s over which the pace is measured
COMPILING = "compiling the physics, once; about half a minute"

Telling = Callable[[bytes | dict[str, Any]], None]
Answer = dict[str, Any]


class Session:
    """One simulation, for any number of browsers."""

    def __init__(self, catalogue: Catalogue, play: Play, listen: Telling) -> None:
        self.catalogue, self.listen = catalogue, listen
        self.speed, self.paused, self.viewers = 1.0, False, 0
        self._asked: Queue[tuple[say.Message, Future[Answer]]] = Queue(WAITING)
        self._ending = threading.Event()
        self._events: deque[dict[str, Any]] = deque(maxlen=EVENTS)
        self._paces: deque[tuple[float, int]] = deque()
        self._owed = 0.0  # s of simulation that are due
        self._late = 0.0  # s that the last picture came after its time
        self._compiles = time.monotonic() if will_compile() else None  # since when
        self._take(play)
        self._thread = threading.Thread(target=self._run, name="simulation", daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def end(self) -> None:
        """Stop, and end what belongs to it."""
        self._ending.set()
        if self._thread.is_alive():
            self._thread.join(0.1 if self._compiles else 10)  # compiling cannot be interrupted
        self.play.close()

    def ask(self, message: say.Message) -> "Future[Answer]":
        """The answer, once it is done; Wrong where too many wait or it cannot be done."""
        future: Future[Answer] = Future()
        try:
            if self._compiles is not None:
                raise Wrong(f"not yet: {COMPILING}", message.id)
            self._asked.put_nowait((message, future))
        except Full:
            future.set_exception(Wrong("too much at once: ask again", message.id))
        except Wrong as wrong:
            future.set_exception(wrong)
        return future

    def greeting(self) -> dict[str, Any]:
        """What a browser is told first: read by its thread, written as a whole by ours."""
        return self._hello | {
            "events": list(self._events),
            "gains": self._gains,
            "labels": self._labels,
            "notes": self._notes,
            "waits": self.waits(),
        }

    def waits(self) -> tuple[str, float] | None:
        """What must be done before anything moves, and for how long it has been under way, s."""
        since = self._compiles
        return None if since is None else (COMPILING, time.monotonic() - since)

    def _take(self, play: Play) -> None:
        """Go on with this play, from its start."""
        self.play, self._framer = play, Framer(play)
        self._events.clear()
        self._paces.clear()
        self._owed = 0.0
        self._labels, self._notes = play.labels(), play.notes()
        self._gains = play.told_gains()
        self._hello = hello(play, self._framer.layout(), self.catalogue)

    def _run(self) -> None:
        """Until the end: obey, advance, tell, wait."""
        last = due = shown = time.monotonic()
        changed = True
        self._show(last)  # before the first step, which may have to be compiled
        while not self._ending.is_set():
            now = time.monotonic()
            if not self.paused and not self.play.over:
                self._owed = min(self._owed + (now - last) * self.speed, BEHIND * self.speed)
                changed |= self._advance(int(self._owed * self.play.hz))
            last = now
            if changed or now - shown >= IDLE:
                self._late = max(0.0, now - due)
                self._show(now)
                shown, changed = now, False
            due = max(due + PERIOD, now)
            changed |= self._listen(due)

    def _advance(self, ticks: int) -> bool:
        """Whether anything moved; a run that fails is told, and stands."""
        before, play = self.play.tick, self.play
        try:
            play.advance(ticks)
        except Exception as error:  # whatever it is, those who watch shall be told
            play.over = True
            play.tell(f"the simulation has stopped: {told(error)}", "fault")
        self._owed -= (play.tick - before) / play.hz
        moved = play.tick != before or play.over
        if moved:
            self._compiles = None  # what the first step needs serves all others
        return moved

    def _listen(self, until: float) -> bool:
        """Obey what comes in until then; whether there was anything."""
        found = False
        while not self._ending.is_set():
            try:
                wait = until - time.monotonic()
                message, future = self._asked.get(timeout=wait) if wait > 0 else self._at_once()
            except Empty:
                return found
            found = True
            if not future.set_running_or_notify_cancel():
                continue
            try:
                future.set_result(self._obey(message))
            except Wrong as wrong:
                future.set_exception(Wrong(str(wrong), message.id))
            except Exception as error:  # no message ends the thread that simulates
                future.set_exception(Wrong(told(error), message.id))
        return found

    def _at_once(self) -> tuple[say.Message, "Future[Answer]"]:
        return self._asked.get_nowait()

    def _obey(self, message: say.Message) -> Answer:
        """Do it, and say when it was done."""
        match message:
            case say.Pause():
                self.paused = True
            case say.Resume():
                self.paused = False
            case say.Speed():
                self.speed = message.factor
            case say.Step():
                self.paused, self._owed = True, 0.0
                self._advance(message.ticks)
                self._owed = 0.0
            case say.Open():
                play = self.catalogue.open(message)
                old = self.play
                self._take(play)
                old.close()
                self.listen(self.greeting())
                self._show(time.monotonic())  # its first step may take long
            case _:
                if self.play.over:
                    raise Wrong("it is over: start it again, or open something else")
                self.play.obey(message)
                if isinstance(message, say.Gains):
                    self._gains = self.play.told_gains()
                    self.listen({"type": "gains", "gains": self._gains})
        return {"type": "done", "id": message.id, "tick": self.play.tick}

    def _show(self, now: float) -> None:
        """A picture, and what is new."""
        self._paces.append((now, self.play.tick))
        while now - self._paces[0][0] > MEASURED:
            self._paces.popleft()
        (then, tick), seconds = self._paces[0], now - self._paces[0][0]
        pace = (self.play.tick - tick) / self.play.hz / seconds if then < now else 0.0
        news, self.play.news = self.play.news, []
        if news:
            self._events.extend(news)
            self.listen({"type": "news", "events": news})
        self._tell_words()
        head = {
            "age": self._late,
            "factor": pace,
            "speed": self.speed,
            "viewers": self.viewers,
            "paused": float(self.paused),
            "over": float(self.play.over),
        }
        self.listen(self._framer.packed(head))

    def _tell_words(self) -> None:
        """Labels and notes of teams, where they have changed."""
        labels, notes = self.play.labels(), self.play.notes()
        if labels != self._labels or notes != self._notes:
            self._labels, self._notes = labels, notes
            self.listen({"type": "words", "labels": labels, "notes": notes})


def told(error: Exception) -> str:
    """What went wrong, in a line; of what nobody foresaw also its kind."""
    if isinstance(error, InputError | MachineError | RunError | OSError):
        return one_line(str(error), 300)
    return one_line(f"{type(error).__name__}: {error}; a fault of soccersim itself", 300)
