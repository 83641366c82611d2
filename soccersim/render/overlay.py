"""A picture over a ground that stays: what was drawn is taken off again, and nothing else touched.

A frame of 1280 x 854 has four megabytes, of which its robots, words and trails cover a twentieth.
"""

from collections.abc import Iterable

import pygame

from soccersim.render.lettering import Blit
from soccersim.render.look import Colour

SMALL = 2000  # px, a rectangle that is worked on as one
PIECE = 24  # px, of a line: the rectangle round all of it would be mostly empty
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
        for sprite, place in blits:
            self.mark(sprite.get_rect(topleft=place))

    def mark(self, rect: pygame.Rect) -> None:
        """Something was drawn within, as pygame's own functions return it."""
        self.drawn.append(rect.clip(self.surface.get_clip()))

    def line(self, colour: Colour, start: Place, end: Place, width: int = 1) -> None:
        """A straight line with smooth edges."""
        around = pygame.draw.aaline(self.surface, colour, start, end, width)
        edge = width // 2 + 4  # smooth edges, and ends cut to whole pixels
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

    def clear(self, also: Iterable[pygame.Rect] = ()) -> list[pygame.Rect]:
        """Take off all that was drawn; where that was, and where else the ground has changed."""
        cleared = [*self.drawn, *also]
        self.surface.blits([(self.ground, rect, rect) for rect in cleared], doreturn=False)
        self.drawn = []
        return cleared
