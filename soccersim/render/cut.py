"""Which part of a recording a film shows, how fast and how large."""

import re
from dataclasses import dataclass
from math import inf, isfinite
from os import PathLike, fspath
from pathlib import PurePath

import numpy as np

from soccersim.problems import InputError, Problem, one_line
from soccersim.record.recording import Recording
from soccersim.render import look

SMALLEST, LARGEST = 128, 4096  # px of a side: less shows nothing, more no player does
SLOWEST, FASTEST = 0.01, 100.0
KINDS = (".mp4", ".gif", ".webp")
EARLY = 1e-6  # ticks; a frame that is due within this shows the record


@dataclass(frozen=True)
class Cut:
    """A part of a recording, in seconds since its beginning: all of it where nothing is said."""

    start: float | None = None
    end: float | None = None
    speed: float = 1.0
    size: tuple[int, int] = look.SIZE

    def check(self, duration: float) -> None:
        """InputError where nothing of a recording this long would be seen."""
        start, end = self.start or 0.0, inf if self.end is None else self.end
        if not (isfinite(start) and 0 <= start <= duration):
            raise InputError(Problem(f"--from {start:g}: from 0 to {duration:g} s are recorded"))
        if not end > start:
            raise InputError(Problem(f"--to {end:g} s must be later than --from {start:g} s"))
        if not SLOWEST <= self.speed <= FASTEST:
            wrong = f"--speed {self.speed:g}: it can be from {SLOWEST:g} to {FASTEST:g}"
            raise InputError(Problem(wrong))


def shown(recording: Recording, start: float | None, end: float | None) -> range:
    """The records between two times, both included; InputError where there is none."""
    Cut(start, end).check(recording.duration)
    hz = float(recording.meta["physics_hz"])
    first = 0 if start is None else np.searchsorted(recording.tick, start * hz - EARLY)
    last = len(recording.tick)
    if end is not None:
        last = int(np.searchsorted(recording.tick, end * hz + EARLY, side="right"))
    if first >= last and len(recording.tick):
        apart = 1 / recording.scenario.timing.record_hz
        wrong = f"no record lies between --from and --to: they are {apart:g} s apart"
        raise InputError(Problem(wrong))
    return range(int(first), last)


def film_kind(path: str | PathLike[str]) -> str:
    """`.mp4`, `.gif` or `.webp`, by the ending of a film's name; InputError for others."""
    kind = PurePath(path).suffix.lower()
    if kind not in KINDS:
        wrong = f"a film's name ends in {', '.join(KINDS[:-1])} or {KINDS[-1]}"
        raise InputError(Problem(wrong, one_line(fspath(path))))
    return kind


def film_size(text: str) -> tuple[int, int]:
    """Width and height from `1280x854`; InputError where no film can have them."""
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text.strip().lower())
    if found is None:
        raise InputError(Problem(f"--size {one_line(text)}: width and height, as in 1280x854"))
    width, height = int(found[1]), int(found[2])
    if width % 2 or height % 2:
        raise InputError(Problem(f"--size {width}x{height}: H.264 needs even numbers"))
    if not all(SMALLEST <= side <= LARGEST for side in (width, height)):
        wrong = f"--size {width}x{height}: a side has {SMALLEST} to {LARGEST} px"
        raise InputError(Problem(wrong))
    return width, height


def frame_indices(recording: Recording, cut: Cut | None = None) -> list[int]:
    """The record that each frame of a film shows: the last one before it is due."""
    cut = cut or Cut()
    if len(recording.tick) == 0:
        raise InputError(Problem("nothing to draw: a team forfeited before the match began"))
    cut.check(recording.duration)
    hz = float(recording.meta["physics_hz"])
    step = hz * cut.speed / recording.scenario.timing.frames_hz  # ticks from frame to frame
    first, last = int(recording.tick[0]), float(recording.tick[-1])
    begin = min(max(first, (cut.start or 0.0) * hz), last)
    end = last if cut.end is None else min(last, cut.end * hz)
    due = begin + np.arange(int((end - begin) / step + 1e-9) + 1) * step
    indices = np.searchsorted(recording.tick, due + EARLY, side="right") - 1
    return [int(index) for index in indices]
