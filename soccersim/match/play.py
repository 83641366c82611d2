"""One match from Python: who plays, where, how long."""

from collections.abc import Iterable
from os import PathLike, fspath
from pathlib import Path

from soccersim.match.request import match_request
from soccersim.match.seating import Isolate
from soccersim.match.supervise import Outcome, play

Named = str | PathLike[str]


def play_match(
    home: Named,
    away: Named,
    scenario: Named = "msl-match",
    *,
    seed: int | None = None,
    duration: float | None = None,
    settings: Iterable[str] = (),
    isolate: Isolate = "match",
    recording: Path | None = None,
) -> Outcome:
    """Play a match in a process of its own, as `soccersim match HOME AWAY` does.

    home, away: strategies, named as on the command line; a path may be a Path. duration: of the
    whole match, s. settings: `key.path=value`, as with --set. recording: the file to write it to.

    >>> play_match("roles", "chaser", seed=3, duration=60).score
    """
    asked = match_request(
        fspath(home),
        fspath(away),
        fspath(scenario),
        seed=seed,
        duration=duration,
        settings=settings,
        isolate=isolate,
        recording=recording,
    )
    return play(asked)
