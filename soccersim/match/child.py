"""The process of one match: it plays what request.json says, and leaves outcome.json."""

import json
import os
import shutil
import threading
from collections.abc import Callable
from contextlib import suppress
from mmap import mmap
from pathlib import Path
from typing import Any

from soccersim.match.memory import MEBIBYTE, TEAM, limit_memory
from soccersim.match.pace import Pace
from soccersim.match.traces import keep_traces
from soccersim.match.turn import Turn
from soccersim.problems import InputError, MachineError
from soccersim.processes import end_group, take_pipes

OWN = 512 * MEBIBYTE  # for what is recorded and compiled while both teams play
Document = dict[str, Any]
REQUEST, OUTCOME, TRACE, TURN = "request.json", "outcome.json", "trace", "turn"


def main(folder: str) -> None:
    """What the process does."""
    serve(Path(folder), play)


def serve(folder: Path, work: Callable[[Document, Turn, Path], Document]) -> None:
    """Do the work that request.json asks for; end with all threads that teams have left."""
    with open(folder / TURN, "r+b") as file:
        turn = Turn(mmap(file.fileno(), 0))
    parent, out = take_pipes()
    os.close(out)
    threading.Thread(target=follow_parent, args=(parent, turn, folder), daemon=True).start()
    keep_traces(folder / TRACE)
    answer(folder, turn, work)
    os._exit(0)


def answer(folder: Path, turn: Turn, work: Callable[[Document, Turn, Path], Document]) -> Document:
    """Do the work that request.json asks for; leaves outcome.json, and returns it."""
    outcome = told(lambda: work(json.loads((folder / REQUEST).read_text("utf-8")), turn, folder))
    part = folder / (OUTCOME + ".part")
    part.write_text(json.dumps(outcome), encoding="utf-8")
    part.replace(folder / OUTCOME)
    return outcome


def told(work: Callable[[], Document]) -> Document:
    """What the work leads to; where it fails, how."""
    try:
        return work()
    except InputError as error:
        return {"problems": [str(problem) for problem in error.problems]}
    except MachineError as error:
        return {"machine": str(error)}
    except BaseException as error:
        import traceback

        return {"failed": str(error) or type(error).__name__, "trace": traceback.format_exc()}


def play(request: Document, turn: Turn, folder: Path) -> Document:
    """The match itself."""
    from soccersim.match.game import Game
    from soccersim.match.keep import is_kept
    from soccersim.match.seating import take_seats
    from soccersim.spec.scenario import Scenario
    from soccersim.strategy.load import Origin

    scenario = Scenario.model_validate_json(request["scenario"])
    home, away = (Origin(**origin) for origin in request["origins"])
    game = Game(scenario, turn)
    if request["isolate"] == "match":
        limit_memory(2 * TEAM + OWN)
    seats = take_seats(scenario, (home, away), request["isolate"], turn, folder)
    pace = Pace(scenario.duration)
    result = game.play(seats, pace)
    factor = pace.factor(result.recording.duration)
    for seat in seats:
        seat.close()
    recording = result.recording
    kept = is_kept(request["keep"], request["watched"], result.score, result.faults)
    if request["recording"] and kept:
        keep_standard_files()
        recording.save(request["recording"])
    match = recording.match or {}
    return {
        "score": list(result.score),
        "digest": recording.digest,
        "duration": recording.duration,
        "events": match["events"],
        "faults": match["faults"],
        "realtime_factor": factor,
    }


def keep_standard_files() -> None:
    """Where a team has closed them, no file of ours may get their numbers: prints would go in."""
    for number in (0, 1, 2):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)


def follow_parent(parent: int, turn: Turn, folder: Path) -> None:
    """End with the process that asked for this match, however that ends: it holds a pipe open."""
    with suppress(OSError):
        while os.read(parent, 64):
            pass
        for pid in turn.processes:
            if pid:
                end_group(pid)
        shutil.rmtree(folder, ignore_errors=True)
        end_group(os.getpid())
