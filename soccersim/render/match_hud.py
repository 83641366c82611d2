"""The head-up display of a match: clock, teams and score, phase, and what the referee decided."""

from functools import cache
from math import ceil

import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.canvas import Canvas
from soccersim.render.lettering import Blit, Lettering
from soccersim.render.match_band import MatchBand
from soccersim.render.story import LEVELS, Story

TEAMS = tuple(look.TEAMS)  # by slot
EDGE = 20  # px at the left and right
SIDE = 190  # px of the columns at the left and right: clock and phase
SCORE = (130, 40)  # px of the score's card
BADGE = 8  # px, width of a team's colour beside the score
ARROW = 22  # px, side of the arrow that says where a team plays to
FIRST, SECOND = 27, 60  # px, middles of the two rows


class MatchHud:
    """Two bands: the upper here, the one below the field in match_band."""

    def __init__(self, recording: Recording, size: tuple[int, int], story: Story) -> None:
        self.story = story
        self.size = size
        self.scale = scale = look.scale(size)
        self.band = MatchBand(recording, size, story)
        self.clock = Lettering(30 * scale, look.INK, look.PAGE, bold=True)
        self.small = Lettering(13 * scale, look.FAINT, look.PAGE)
        self.name = Lettering(22 * scale, look.INK, look.PAGE, bold=True)
        self.phases = [
            Lettering(20 * scale, ink, look.PAGE, bold=True)
            for ink in (*map(look.tint, TEAMS), look.INK)  # home's, away's, nobody's
        ]
        self.words = cache(self._words)
        self.scores = cache(self._score)
        self.arrows = cache(self._arrow)
        self.card = pygame.Rect((0, 0), tuple(round(side * scale) for side in SCORE))
        self.card.center = (size[0] // 2, round(FIRST * scale))
        self.fitted = cache(self.small.fitted)

    def paint(self, picture: pygame.Surface) -> None:
        """What never changes, once, onto the background."""
        for slot, way in enumerate((-1, 1)):
            edge = self.card.left if slot == 0 else self.card.right
            width = max(2, round(BADGE * self.scale))
            left = edge - width if slot == 0 else edge
            picture.fill(look.TEAMS[TEAMS[slot]], (left, self.card.top, width, self.card.height))
            inner = edge + way * (BADGE + ARROW + 22) * self.scale
            outer = (EDGE + SIDE) * self.scale if slot == 0 else self._right() - SIDE * self.scale
            name = self.name.fitted(self.story.names[slot], abs(outer - inner))
            x = inner - self.name.width(name) if slot == 0 else inner
            self.name.write(picture, name, x, FIRST * self.scale)
        self.band.paint(picture)

    def blits(self, index: int) -> list[Blit]:
        """What one record shows, to be blitted onto the background."""
        story, scale = self.story, self.scale
        home, away = story.score(index)
        blits = [
            (self.scores(home, away, story.cheering(index)), self.card.topleft),
            *self._clock(index),
            *self._state(index),
        ]
        direction = story.direction[story.decision[index]]
        aside = round((BADGE + 10 + ARROW / 2) * scale)
        for x, ahead, slot in (
            (self.card.left - aside, direction, 0),
            (self.card.right + aside, -direction, 1),
        ):
            arrow = self.arrows(slot, ahead)
            place = (x - arrow.width // 2, self.card.centery - arrow.height // 2)
            blits.append((arrow, place))
        if said := story.said(index):
            word = self.words(said.text, said.side, said.level)
            place = ((self.size[0] - word.width) // 2, round(SECOND * scale - word.height / 2))
            blits.append((word, place))
        return blits + self.band.blits(index)

    def _right(self) -> float:
        return self.size[0] - EDGE * self.scale

    def _clock(self, index: int) -> list[Blit]:
        """The time played, the half, and how long it lasts yet."""
        story, scale = self.story, self.scale
        half, whole = story.half(index), story.duration
        played = story.seconds(index)
        left = max(0, ceil(whole * half / 2 - played - 1e-6))
        about = f"{'1st' if half == 1 else '2nd'} half, {minutes(left)} left"
        return [
            _from(self.clock.word(minutes(int(played + 1e-6))), EDGE * scale, FIRST * scale),
            _from(self.small.word(about), EDGE * scale, SECOND * scale),
        ]

    def _state(self, index: int) -> list[Blit]:
        """The phase in the colour of whose restart it is, or of who has the ball."""
        word, slot, about = self.story.state(index)
        letters = self.phases[2 if slot is None else slot]
        blits = [letters.ending_at(self._right(), FIRST * self.scale, word)]
        if about:
            text = self.fitted(about, round(SIDE * self.scale))
            blits.append(self.small.ending_at(self._right(), SECOND * self.scale, text))
        return blits

    def _words(self, text: str, side: int | None, level: int) -> pygame.Surface:
        """A decision at one of its steps from PAGE to its colour."""
        ink = look.INK if side is None else look.tint(TEAMS[side])
        shade = look.mix(look.PAGE, ink, level / LEVELS)
        room = self.size[0] - 2 * (EDGE + SIDE + 10) * self.scale
        for size in (15, 13):  # the first in which it fits
            letters = Lettering(size * self.scale, shade, look.PAGE, bold=side is not None)
            if letters.width(text) <= room:
                break
        return letters.word(letters.fitted(text, room))

    def _score(self, home: int, away: int, cheering: int | None) -> pygame.Surface:
        """The score on its card, in a team's colour when it has just scored."""
        ground = look.CARD if cheering is None else look.TEAMS[TEAMS[cheering]]
        card = pygame.Surface(self.card.size, 0, 32)
        card.fill(ground)
        letters = Lettering(30 * self.scale, look.INK, ground, bold=True)
        middle, colon = card.width / 2, letters.width(":")
        gap = 7 * self.scale
        letters.write(card, ":", middle - colon / 2, card.height / 2 - 2 * self.scale)
        letters.write(
            card, str(home), middle - colon / 2 - gap - letters.width(str(home)), card.height / 2
        )
        letters.write(card, str(away), middle + colon / 2 + gap, card.height / 2)
        return card

    def _arrow(self, slot: int, ahead: int) -> pygame.Surface:
        """Where a team plays to, in its colour."""
        side = 2 * round(ARROW * self.scale / 2)
        canvas = Canvas((side, side), side / 2, ground=look.PAGE)
        shape = [(0.9, 0.0), (0.0, 0.75), (0.0, 0.28), (-0.9, 0.28)]
        outline = [*shape, *((x, -y) for x, y in reversed(shape[1:]))]
        canvas.polygon([(ahead * x, y) for x, y in outline], look.TEAMS[TEAMS[slot]])
        return canvas.shrunk()


def minutes(seconds: int) -> str:
    """Whole seconds as minutes and seconds."""
    return f"{seconds // 60:02d}:{seconds % 60:02d}"


def _from(word: pygame.Surface, left: float, middle: float) -> Blit:
    return word, (round(left), round(middle - word.height / 2))
