"""A process that plays match after match: it reads folders, and answers when it is ready again."""

import json
import os
import threading
from collections.abc import Iterator
from importlib import import_module
from mmap import mmap
from pathlib import Path
from queue import SimpleQueue

from soccersim.match.child import TRACE, TURN, Document, answer
from soccersim.match.traces import keep_traces
from soccersim.match.turn import Turn, read_turn
from soccersim.processes import end_group, take_pipes


def main() -> None:
    """What the process does."""
    source, sink = take_pipes()
    asked: SimpleQueue[str] = SimpleQueue()
    state: list[mmap] = []
    threading.Thread(target=listen, args=(source, asked, state), daemon=True).start()
    threads = threading.active_count()
    while True:
        module, name = json.loads(asked.get())
        folder = Path(name)
        with open(folder / TURN, "r+b") as file:
            state[:] = [mmap(file.fileno(), 0)]
        keep_traces(folder / TRACE)
        match = import_module(module)
        outcome = answer(folder, Turn(state[0]), match.play)
        if not is_clean(outcome) or threading.active_count() != threads:
            os._exit(0)
        os.write(sink, b"+")


def is_clean(outcome: Document) -> bool:
    """Whether a match ended so that nothing of it can hurt the next one."""
    return outcome.get("faults") == []


def listen(source: int, asked: "SimpleQueue[str]", state: list[mmap]) -> None:
    """Take what is asked; end, with the teams' processes, when nobody can ask any more."""
    for line in lines(source):
        asked.put(line)
    for turn in state:
        for pid in read_turn(turn).processes:
            if pid:
                end_group(pid)
    end_group(os.getpid())


def lines(source: int) -> Iterator[str]:
    """What comes, line by line."""
    with open(source, encoding="utf-8") as file:
        yield from file
