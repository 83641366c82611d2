"""Text on pictures. Rendering it is slow, so words once written are kept."""

from functools import cache, lru_cache
from importlib.util import find_spec
from pathlib import Path

import pygame
import pygame.font

from soccersim.render.look import Colour

Blit = tuple[pygame.Surface, tuple[int, int]]
FONT = "mpl-data/fonts/ttf/DejaVuSans{}.ttf"  # comes with matplotlib, has every sign we need
WORDS = 4096  # kept, some kilobytes each: the distances and angles of a run come again and again


@cache
def _font_file(bold: bool) -> str | None:
    """DejaVu Sans; without it pygame's own font (None)."""
    spec = find_spec("matplotlib")  # finds without importing, which would take half a second
    for folder in (spec and spec.submodule_search_locations) or ():
        file = Path(folder) / FONT.format("-Bold" if bold else "")
        if file.is_file():
            return str(file)
    return None


class Lettering:
    """Letters of one size and colour: on a ground of one colour, or see-through without."""

    def __init__(self, size: float, ink: Colour, ground: Colour | None, bold: bool = False) -> None:
        pygame.font.init()
        self.font = pygame.font.Font(_font_file(bold), max(8, round(size)))
        self.ink = ink
        self.ground = ground
        self.word = lru_cache(WORDS)(self._render)

    def _render(self, text: str) -> pygame.Surface:
        if self.ground is None:
            return self.font.render(text, True, self.ink).premul_alpha()
        text_surface = self.font.render(text, True, self.ink, self.ground)
        return text_surface.convert(pygame.Surface((1, 1), 0, 32))

    def width(self, text: str) -> int:
        """Pixels this text takes."""
        return self.font.size(text)[0]

    def fitted(self, text: str, room: float) -> str:
        """The text, its end left out where it takes more than this many pixels."""
        if self.width(text) <= room:
            return text
        while text and self.width(text + "…") > room:
            text = text[:-1]
        return text.rstrip() + "…"

    def write(self, surface: pygame.Surface, text: str, x: float, middle: float) -> int:
        """Write from x on, around this height; the x where it ends."""
        word = self.word(text)
        flags = 0 if self.ground else pygame.BLEND_PREMULTIPLIED
        place = (round(x), round(middle - word.height / 2))
        surface.blit(word, place, special_flags=flags)
        return place[0] + word.width

    def ending_at(self, right: float, middle: float, text: str) -> Blit:
        """A text as a blit: where it ends, and around which height."""
        word = self.word(text)
        return word, (round(right - word.width), round(middle - word.height / 2))
