"""Plays a match in a process of its own and watches it: no team can end the one that asks.

Whatever ends that process, or breaks a limit, is not yet held against a team. The match is played
once more, alone, with each team in a process of its own: then it is certain whose doing it is.
"""

import json
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from mmap import mmap
from pathlib import Path
from subprocess import PIPE, STDOUT
from tempfile import TemporaryDirectory
from typing import Any

from soccersim.match.child import OUTCOME, REQUEST, TRACE, TURN
from soccersim.match.endings import how_ended
from soccersim.match.faults import CRASH, DEADLINE, MEMORY, TeamFault, forfeited
from soccersim.match.keep import Keep
from soccersim.match.prints import Prints
from soccersim.match.seating import Isolate, Origins
from soccersim.match.stopwatch import Stopwatch
from soccersim.match.traces import ask_trace, read_trace
from soccersim.match.turn import NOBODY, SIDES, SIZE, STAGES, State, Turn, read_turn
from soccersim.problems import InputError, MachineError, Problem, RunError
from soccersim.processes import Process, end, end_group, has_ended, start
from soccersim.spec.scenario import Scenario

LOOK = 0.02  # s from one look at the process to the next
APART: Isolate = "team" if os.name == "posix" else "match"  # how a doubtful match is played again
DOUBTFUL = (DEADLINE, MEMORY, CRASH)  # what a machine that is too full may bring about
CHILD = "soccersim.match.child"
Progress = Callable[[State], None]
Begin = Callable[..., Process]  # starts a process as processes.start does
Printed = Callable[[str], None]


@dataclass(frozen=True)
class Request:
    """A match to be played."""

    scenario: Scenario
    origins: Origins  # HOME's and AWAY's strategies
    isolate: Isolate = "match"
    recording: Path | None = None  # where it is written; None: nowhere
    keep: Keep = "all"  # which matches are worth it
    watched: int | None = None  # the slot whose losses are; None: whoever loses


@dataclass(frozen=True)
class Outcome:
    """How it came out."""

    score: tuple[int, int]  # home, away
    digest: str
    duration: float  # s played
    events: list[dict[str, Any]]
    faults: list[dict[str, Any]]
    realtime_factor: float  # once all is loaded; 0: it ended before
    again: str = ""  # why it was played twice; "": it was not


@dataclass(frozen=True)
class Attempt:
    """What one process came to: an outcome, or why there is none."""

    outcome: Outcome | None
    doubt: str = ""  # why it should be played again before a team is blamed
    trace: str = ""


def play(
    request: Request,
    progress: Progress | None = None,
    printed: Printed | None = None,
    child: str = CHILD,
) -> Outcome:
    """Play a match. progress: told now and then; printed: is given what the strategies print.

    InputError where a strategy is not there, MachineError where the machine fails, RunError where
    soccersim does. Ctrl-C leaves no process behind.
    """
    if request.isolate not in ("match", APART):
        raise InputError(Problem("--isolate team needs a POSIX system: leave it at match here"))
    first = attempt(request, progress, printed, child)
    if first.outcome and not first.doubt:
        return first.outcome
    if not first.outcome and request.isolate == "team":
        raise failed(first)
    second = attempt(replace(request, isolate=APART), progress, None, child)
    if not second.outcome:
        raise failed(second)
    return replace(second.outcome, again=first.doubt)


def failed(attempt: Attempt) -> RunError:
    """The error of an attempt without an outcome."""
    error = RunError(f"the match could not be played: {attempt.doubt}")
    error.add_note(attempt.trace)
    return error


def attempt(
    request: Request,
    progress: Progress | None = None,
    printed: Printed | None = None,
    child: str = CHILD,
    begin: Begin = start,
    within: Path | None = None,
) -> Attempt:
    """Play it once. A caller that plays several at a time repeats doubtful ones when alone.

    begin: starts the process; within: a folder for what passes between it and this one.
    """
    with TemporaryDirectory(prefix="soccersim-", dir=within, ignore_cleanup_errors=True) as name:
        folder = Path(name)
        path = request.recording and str(request.recording.absolute())
        told = {
            "scenario": request.scenario.model_dump_json(),
            "origins": [asdict(origin) for origin in request.origins],
            "isolate": request.isolate,
            "recording": path,
            "keep": request.keep,
            "watched": request.watched,
        }
        (folder / REQUEST).write_text(json.dumps(told), encoding="utf-8")
        (folder / TURN).write_bytes(bytes(Turn().buffer))
        with open(folder / TURN, "r+b") as file, mmap(file.fileno(), SIZE) as turn:
            process = begin(child, [name], stdout=PIPE, stderr=STDOUT)
            prints = Prints(process, printed)
            try:
                broken = watch(process, turn, prints, folder / TRACE, progress)
            finally:
                code = finish(process, turn)
                prints.finish()
            return judged(folder, broken or how_ended(code), read_turn(turn))


def watch(
    process: Process, turn: mmap, prints: Prints, trace: Path, progress: Progress | None
) -> tuple[str, str] | None:
    """Wait for the process to end; kind and words of the limit that it broke, None where none."""
    stopwatch = Stopwatch(process.pid, thread=True)
    while not has_ended(process):
        prints.wait(LOOK)
        state = read_turn(turn)
        if progress:
            progress(state)
        stage = None if state.slot == NOBODY else state.stage
        if broken := stopwatch.over((state.serial, state.slot, state.stage), stage):
            ask_trace(process.pid, trace)
            return DEADLINE, broken
    return None


def finish(process: Process, turn: mmap) -> int:
    """Leave no process of the match, nor of its teams; the exit code."""
    if not has_ended(process):
        end_group(process.pid)  # first, so that it starts no more
    for pid in read_turn(turn).processes:
        if pid:
            end_group(pid)
    return end(process)


def judged(folder: Path, ended: tuple[str, str], state: State) -> Attempt:
    """What the process left, or how it ended and in whose turn."""
    try:
        told = json.loads((folder / OUTCOME).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return died(ended, state, read_trace(folder / TRACE))
    if "problems" in told:
        raise InputError([Problem(message) for message in told["problems"]])
    if "machine" in told:
        raise MachineError(told["machine"])
    if "failed" in told:
        return Attempt(None, told["failed"], told["trace"])
    outcome = Outcome(**{**told, "score": tuple(told["score"])})
    doubts = [f for f in outcome.faults if f["kind"] in DOUBTFUL]
    return Attempt(outcome, f"{doubts[0]['side']}: {doubts[0]['kind']}" if doubts else "")


def died(ended: tuple[str, str], state: State, trace: str) -> Attempt:
    """The attempt of a process that left nothing."""
    kind, words = ended
    if state.slot == NOBODY:
        return Attempt(None, f"{words}, at tick {state.tick} in nobody's turn", trace)
    side = SIDES[state.slot]
    detail = "\n".join(filter(None, (trace, f"{words}, in {STAGES[state.stage]}")))
    fault = TeamFault(side, kind, state.tick, detail).document()
    score = forfeited(state.score, state.slot)
    return Attempt(Outcome(score, "", 0.0, [], [fault], 0.0), f"{side}: {words}", trace)
