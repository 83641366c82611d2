"""The last seconds of every robot's way: where it was (solid), where it believed it was (dashed).

In a match they are few, without the belief, and the ball has one as well.

A trail is cut into pieces of half a second. Complete pieces are laid onto the field and stay there
until the next one is complete: drawing every line in every frame would cost more than all else.
"""

from bisect import bisect_right
from functools import lru_cache
from math import ceil, floor

import numpy as np
import pygame
from numpy.typing import NDArray

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.lettering import Blit
from soccersim.render.overlay import Overlay
from soccersim.render.pitch import View

SAMPLES_HZ = 10  # points of a way a second; always the same records, or the trail would shimmer
PIECE = 5  # samples
BUDGET = 60.0  # seconds of trail over all robots: one shows its whole way, many do not tangle
SHORTEST, LONGEST = 4.0, 30.0  # s
OF_A_MATCH = 2.5  # s: ten robots that go to and fro would fill the field
KEPT = 4000  # pieces kept for the next frame, some kilobytes each
LEVELS = 8  # steps in which a trail fades
FAINTEST = 0.08  # strength of the oldest pieces; the newest have 1
DASH = 5.0  # px, and as much between two
JUMP = 60.0  # px between two samples: the robot was put there, it did not drive
BALL_JUMP = 20.0  # m/s: the same of the ball
STILL = 0.05  # px between two samples: it stands
FINE = 3  # times as large while drawn
TRUE_WIDTH, BELIEVED_WIDTH = 2.2, 1.3  # px

Array = NDArray[np.float64]
Point = tuple[float, float]


class Way:
    """Where one robot went, as straight strokes, and at which sample each was complete."""

    def __init__(
        self,
        strokes: Array,
        ends: Array,
        colour: look.Colour,
        width: float,
        jump: float = JUMP,
    ) -> None:
        length = np.linalg.norm(strokes[:, 1] - strokes[:, 0], axis=1)
        kept = (length > STILL) & (length < jump)
        self.strokes: list[tuple[Point, Point]] = [
            ((x1, y1), (x2, y2)) for (x1, y1), (x2, y2) in strokes[kept].tolist()
        ]
        self.ends: list[float] = ends[kept].tolist()
        self.colour = colour
        self.width = width

    def between(self, start: float, end: float) -> list[tuple[Point, Point]]:
        """The strokes that were complete after one sample and by another."""
        return self.strokes[bisect_right(self.ends, start) : bisect_right(self.ends, end)]

    def piece(self, number: int) -> Blit | None:
        """The strokes of a piece as a sprite; None where the robot stood still."""
        strokes = self.between(number * PIECE, (number + 1) * PIECE)
        if not strokes:
            return None
        x, y = zip(*(point for stroke in strokes for point in stroke), strict=True)
        left, top = floor(min(x) - self.width), floor(min(y) - self.width)
        size = (ceil(max(x) + self.width) - left, ceil(max(y) + self.width) - top)
        large = pygame.Surface((size[0] * FINE, size[1] * FINE), pygame.SRCALPHA, 32)
        for stroke in strokes:
            start, end = (((x - left) * FINE, (y - top) * FINE) for x, y in stroke)
            pygame.draw.line(large, self.colour, start, end, round(self.width * FINE))
        return pygame.transform.smoothscale(large.premul_alpha(), size), (left, top)


class Trails:
    """All ways of a recording in pixels, prepared once."""

    def __init__(self, recording: Recording, view: View) -> None:
        players = recording.scenario.robots
        record_hz = recording.scenario.timing.record_hz
        self.stride = max(1, record_hz // SAMPLES_HZ)
        seconds = min(max(BUDGET / max(1, len(players)), SHORTEST), LONGEST)
        if recording.match:
            seconds = OF_A_MATCH
        self.pieces = round(seconds * record_hz / self.stride / PIECE)
        self.ways: list[Way] = []
        for robot, player in enumerate(players):
            true = view.pixels(recording.body[:: self.stride, robot, :2])
            self.ways.append(Way(*_solid(true), look.tint(player.team), TRUE_WIDTH))
            if recording.match is None:
                believed = view.pixels(recording.estimate[:: self.stride, robot, :2])
                self.ways.append(Way(*_dashed(believed), look.BELIEVED, BELIEVED_WIDTH))
        if recording.match and recording.ball is not None:  # faster: every record is a sample
            strokes, ends = _solid(view.pixels(recording.ball[:, :2]))
            jump = BALL_JUMP / record_hz * view.px_per_m
            self.ways.append(Way(strokes, ends / self.stride, look.BALL_TRAIL, TRUE_WIDTH, jump))
        self.fresh = lru_cache(KEPT)(lambda way, piece: self.ways[way].piece(piece))
        self.faded = lru_cache(KEPT)(self._faded)

    def finished(self, index: int) -> int:
        """How many pieces are complete at this record: lay() changes only with this number."""
        return index // self.stride // PIECE

    def lay(self, ground: Overlay, finished: int) -> None:
        """All complete pieces that are not too old."""
        oldest = finished - self.pieces
        shown = range(max(0, oldest), finished)
        levels = [(piece, (piece - oldest) * LEVELS // self.pieces) for piece in shown]
        blits = [self.faded(way, *piece) for way in range(len(self.ways)) for piece in levels]
        ground.lay([blit for blit in blits if blit])

    def draw(self, overlay: Overlay, index: int) -> None:
        """What came after the complete pieces, up to this record."""
        start = self.finished(index) * PIECE
        for way in self.ways:
            for stroke in way.between(start, index / self.stride):
                overlay.line(way.colour, *stroke, round(way.width))

    def _faded(self, way: int, piece: int, level: int) -> Blit | None:
        """A piece at one of the LEVELS of strength, from 0."""
        fresh = self.fresh(way, piece)
        if fresh is None:
            return None
        faded = fresh[0].copy()
        strength = round(255 * (FAINTEST + (1 - FAINTEST) * level / (LEVELS - 1)))
        faded.fill((strength,) * 4, special_flags=pygame.BLEND_RGBA_MULT)
        return faded, fresh[1]


def _solid(way: Array) -> tuple[Array, Array]:
    """Strokes (N, 2, 2) from each sample (S, 2) to the next, and when each is complete."""
    return np.stack((way[:-1], way[1:]), axis=1), np.arange(1.0, len(way))


def _dashed(way: Array) -> tuple[Array, Array]:
    """The same as dashes of equal length, and when each is complete."""
    steps = np.linalg.norm(np.diff(way, axis=0), axis=1)
    travelled = np.concatenate(([0.0], np.cumsum(steps)))
    marks = DASH * np.arange(2 * (int(travelled[-1] / DASH + 1) // 2))
    places = [np.interp(marks, travelled, way[:, axis]) for axis in (0, 1)]
    strokes = np.stack(places, axis=1).reshape(-1, 2, 2)
    return strokes, np.interp(marks[1::2], travelled, np.arange(len(way)))
