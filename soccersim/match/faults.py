"""What a team may do wrong, so that the match is over and it has lost."""

import importlib
import re
import traceback
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

from soccersim.problems import one_line

# kinds: the team's code raised, answered nonsense, took too long or too much, left or died
IMPORT, INIT, EXCEPTION = "import", "init", "exception"
BAD_COMMAND, DEADLINE, MEMORY, EXIT, CRASH = "bad_command", "deadline", "memory", "exit", "crash"
KINDS = (IMPORT, INIT, EXCEPTION, BAD_COMMAND, DEADLINE, MEMORY, EXIT, CRASH)
SPACE = re.compile(r"(?m)^([ |]*)team_\d+\.")  # before the names of a team's own exceptions
LAST_LINES = 12  # of a traceback that are kept
LONGEST_LINE = 300  # characters
LOST_BY = 3  # goals: a forfeit counts 0:3, or worse
OURS = str(Path(__file__).parents[1])  # code that a team's traceback begins in ...
IMPORTING = (importlib.__file__ or OURS, "<frozen importlib")
LOADING = (str(Path(OURS, "strategy")), *IMPORTING)
BUNDLED = str(Path(OURS, "bundled"))  # ... but for the strategies that come with it


@dataclass(frozen=True)
class TeamFault:
    """Who did what, and when."""

    side: str  # home or away
    kind: str  # one of KINDS
    tick: int
    detail: str  # the last lines of its traceback, or what was wrong

    def document(self) -> dict[str, Any]:
        """For JSON."""
        return {"side": self.side, "kind": self.kind, "tick": self.tick, "detail": self.detail}


class Forfeit(Exception):
    """Raised by a seat whose team did wrong."""

    def __init__(self, kind: str, detail: str) -> None:
        super().__init__(kind, detail)
        self.kind = kind
        self.detail = detail


def blamed(error: BaseException, kind: str) -> Forfeit:
    """What a team's exception is called, with the last lines of its traceback.

    MemoryError and SystemExit have kinds of their own wherever they come from.
    """
    if isinstance(error, MemoryError):
        kind = MEMORY
    elif isinstance(error, SystemExit | KeyboardInterrupt | GeneratorExit):
        kind = EXIT
    try:
        told = "".join(traceback.format_exception(error.with_traceback(own_part(error))))
    except BaseException:  # an exception whose own __str__ raises
        told = type(error).__name__
    return Forfeit(kind, last_lines(SPACE.sub(r"\1", told)))


def own_part(error: BaseException) -> TracebackType | None:
    """The traceback from where the team's own code begins.

    None where its loading failed before that; all of it where it never gets there.
    """
    trace, file = error.__traceback__, ""
    while trace and is_ours(file := trace.tb_frame.f_code.co_filename):
        trace = trace.tb_next
    return trace or (None if file.startswith(LOADING) else error.__traceback__)


def is_ours(file: str) -> bool:
    """Whether this code is the simulator's, or what it loads a team with."""
    return file.startswith((OURS, *IMPORTING)) and not file.startswith(BUNDLED)


def last_lines(text: str) -> str:
    """The end of a text, where a traceback says what happened."""
    lines = [one_line(line, LONGEST_LINE) for line in text.rstrip().splitlines()[-LAST_LINES:]]
    return "\n".join(lines)


def forfeited(score: tuple[int, int], slot: int) -> tuple[int, int]:
    """The score when this side forfeits: 0:3, or as it stands where that is worse for it."""
    own, other = score[slot], score[1 - slot]
    if other - own < LOST_BY:
        own, other = 0, LOST_BY
    return (own, other) if slot == 0 else (other, own)
