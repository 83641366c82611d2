"""What strategies print: taken as fast as they print, and cut."""

import codecs
import os
import threading
from collections.abc import Callable
from queue import Empty, SimpleQueue

from soccersim.processes import Process

MOST = 64 * 1024  # bytes of a match that are shown
CUT = "\n... the strategies print more than is shown\n"


class Prints:
    """Drains the output of a process, whatever the rest of this one does."""

    def __init__(self, process: Process, show: Callable[[str], None] | None) -> None:
        """show: is given the texts, by wait() and finish()."""
        self.show = show
        self.texts: SimpleQueue[str] = SimpleQueue()
        self.over = threading.Event()
        self.thread = threading.Thread(target=self._drain, args=(process,), daemon=True)
        self.thread.start()

    def wait(self, seconds: float) -> None:
        """Show what has come; returns when the output is over, or so many seconds have passed."""
        if self.over.is_set():
            threading.Event().wait(seconds)
        else:
            self.over.wait(seconds)
        self._show()

    def finish(self) -> None:
        """Show the rest. Everybody who could print has ended, but for who has left its group."""
        self.thread.join(0.2)
        self._show()

    def _show(self) -> None:
        while True:
            try:
                text = self.texts.get_nowait()
            except Empty:
                return
            if self.show:
                self.show(text)

    def _drain(self, process: Process) -> None:
        decoder = codecs.getincrementaldecoder("utf-8")("replace")
        room, cut = MOST, False
        with process.stdout or open(os.devnull, "rb") as pipe:
            while data := os.read(pipe.fileno(), MOST):
                self.texts.put(decoder.decode(data[:room]))
                if len(data) > room and not cut:
                    self.texts.put(CUT)
                    cut = True
                room -= min(room, len(data))
        self.over.set()
