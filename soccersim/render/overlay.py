"""A picture over a ground that stays: what was drawn is taken off again, and nothing else touched.

A frame of 1280 x 854 has four megabytes, of which its robots, words and trails cover a twentieth.
"""

from collections.abc import Iterable

import pygame

from soccersim.render.lettering import Blit
from soccersim.render.look import Colour

SMALL = 2000  # px, a rectangle that is worked on as one
PIECE = 24  # px, of a line: the rectangle round all of it would be mostly empty
AT_ONCE = 4  # sides of a loop in one rectangle
EDGE = 4  # px round a thin line: smooth edges, and ends cut to whole pixels
Place = tuple[float, float]


class Overlay:
    """A surface that begins as a copy of its ground; `drawn` tells where it shows something else.

    Two overlays can share a surface, where they draw on different parts of it.
    """

    def __init__(self, ground: pygame.Surface, surface: pygame.Surface | None = None) -> None:
        self.ground = ground
        self.surface = surface or ground.copy()
        self.drawn: list[pygame.Rect] = []

    def lay(self, blits: list[Blit], flags: int = pygame.BLEND_PREMULTIPLIED) -> None:
        """Sprites at their places."""
        self.surface.fblits(blits, flags)
        clip = self.surface.get_clip()
        self.drawn += [sprite.get_rect(topleft=place).clip(clip) for sprite, place in blits]

    def mark(self, rect: pygame.Rect) -> None:
        """Something was drawn within, as pygame's own functions return it."""
        self.drawn.append(rect.clip(self.surface.get_clip()))

    def line(self, colour: Colour, start: Place, end: Place, width: int = 1) -> None:
        """A straight line with smooth edges."""
        around = pygame.draw.aaline(self.surface, colour, start, end, width)
        edge = width // 2 + EDGE
        seen = self.surface.get_clip().inflate(2 * edge, 2 * edge).clipline(start, end)
        if not seen or around.width * around.height < SMALL:
            self.mark(around)
            return
        (x, y), (u, v) = seen
        pieces = max(around.width, around.height) // PIECE + 1
        wide, high = (u - x) / pieces, (v - y) / pieces
        size = abs(wide) + 2 * edge + 1, abs(high) + 2 * edge + 1
        left, top = x + min(wide, 0) - edge, y + min(high, 0) - edge
        for piece in range(pieces):
            self.mark(pygame.Rect(left + piece * wide, top + piece * high, *size))

    def loop(self, colour: Colour, corners: list[Place]) -> None:
        """A closed line through many corners, with smooth edges."""
        around = pygame.draw.aalines(self.surface, colour, True, corners)
        if around.width * around.height < SMALL:
            self.mark(around)
            return
        closed = [*corners, corners[0]]
        for start in range(0, len(corners), AT_ONCE):
            x, y = zip(*closed[start : start + AT_ONCE + 1], strict=True)
            left, top = min(x) - EDGE, min(y) - EDGE
            self.mark(pygame.Rect(left, top, max(x) + EDGE + 1 - left, max(y) + EDGE + 1 - top))

    def clear(self, also: Iterable[pygame.Rect] = ()) -> list[pygame.Rect]:
        """Take off all that was drawn; where that was, and where else the ground has changed."""
        cleared = [*self.drawn, *also]
        self.surface.blits([(self.ground, rect, rect) for rect in cleared], doreturn=False)
        self.drawn = []
        return cleared
