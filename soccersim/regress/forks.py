"""The server process: loads everything once, then forks a keeper for every process asked for.

It has one thread, so that what it forks is whole. It ends with the process that has started it, and
takes the run's folder away when all keepers have ended.
"""

import gc
import os
import shutil
import signal
import socket
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any

from soccersim.regress.keeper import keep
from soccersim.regress.warm import receive

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
SECONDS = 1.0  # of a match that are played to load what a match needs


def main(number: str, folder: str) -> None:
    """What the process does: answer the socket of this number."""
    with socket.socket(fileno=int(number)) as asked:
        for name in THREADS:
            os.environ.setdefault(name, "1")
        document, _ = receive(asked)
        import_module(document["module"])
        if document["scenario"]:
            load(document["scenario"], Path(folder))
        gc.collect()
        gc.freeze()  # or collecting would write to memory that all share
        signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # no keeper waits for its burial
        asked.send(b"+")
        with suppress(EOFError, ConnectionError):
            while True:
                serve(asked, *receive(asked))
    with suppress(ChildProcessError):
        os.waitpid(-1, 0)  # returns when the last keeper has ended
    shutil.rmtree(folder, ignore_errors=True)
    os._exit(0)


def serve(asked: socket.socket, document: dict[str, Any], files: list[int]) -> None:
    """Fork a keeper."""
    stdin, stdout, status = files
    try:
        if os.fork() == 0:
            asked.close()
            keep(stdin, stdout, status, document["module"], document["arguments"])
    except OSError:
        pass  # who asked hears of it, as nobody tells a number
    finally:
        for file in files:
            os.close(file)


def load(text: str, folder: Path) -> None:
    """Import all that a match needs, and the kernels: by playing a little of one."""
    import numpy as np

    from soccersim.match import child, process_seat, seating
    from soccersim.match.game import Game
    from soccersim.match.pitch import team_rows
    from soccersim.match.seats import TapeSeat
    from soccersim.spec.scenario import Scenario
    from soccersim.strategy import skills

    del child, process_seat, seating, skills
    scenario = Scenario.model_validate_json(text)
    teams = [len(team_rows(scenario, slot)) for slot in (0, 1)]
    seats = [TapeSeat(np.zeros((0, robots, 5), np.float32)) for robots in teams]
    played = Game(scenario).play(seats, until=round(SECONDS / scenario.dt))
    played.recording.save(folder / "loaded.npz")
    (folder / "loaded.npz").unlink()
