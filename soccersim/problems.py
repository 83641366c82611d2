"""What goes wrong, told in one line: errors that a user reads instead of a traceback."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

LONGEST = 60  # characters of a user's text quoted in a message


def one_line(text: str, limit: int = LONGEST) -> str:
    """A user's text without line breaks or control characters, cut to about limit characters."""
    cut = text if len(text) <= limit else text[: limit - 3] + "..."
    if cut.isprintable():
        return cut
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in cut)


@dataclass(frozen=True)
class Problem:
    """One thing wrong with an input: where it stands, what is wrong, what would be right."""

    message: str
    file: str = ""
    line: int = 0  # from 1; 0 = not known
    column: int = 0  # from 1
    path: str = ""  # such as robots.0.model.mass

    def __str__(self) -> str:
        place = self.file
        if self.line:
            place += f":{self.line}:{self.column}"
        return ": ".join(part for part in (place, self.path, self.message) if part)


class InputError(Exception):
    """Bad input (exit code 2): all the problems of a file at once."""

    def __init__(self, problems: Problem | Iterable[Problem]) -> None:
        self.problems = (problems,) if isinstance(problems, Problem) else tuple(problems)
        super().__init__("\n".join(map(str, self.problems)))

    def __reduce__(self) -> tuple[Any, ...]:  # comes whole out of another process
        return type(self), (self.problems,)


class MachineError(Exception):
    """The machine failed us (exit code 3): a full disk, a folder that cannot be written."""


class RunError(Exception):
    """A run that is not valid (exit code 4): the state stopped being a number, say."""


class Stopped(Exception):
    """Ctrl-C (exit code 130): what was kept, and how to go on."""
