"""The head-up display: above the field what is shown, below it how far each robot is off."""

from collections.abc import Callable
from functools import partial

import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.canvas import Canvas
from soccersim.render.cells import Cells
from soccersim.render.lettering import Blit, Lettering
from soccersim.render.sprites import draw_target
from soccersim.spec.scenario import Scenario

EDGE = 20  # px at the left and right of the head-up display
ICON = 20  # px, side of a legend's sign
ITEM_GAP = 18  # px between two items of the legend

Item = tuple[str, Callable[[Canvas], None]]


class Hud:
    """Two bands: what never changes is painted once, the figures anew in every frame."""

    def __init__(self, recording: Recording, size: tuple[int, int]) -> None:
        self.scenario = recording.scenario
        self.seed = int(recording.meta["seed"])
        self.scale = look.scale(size)
        self.size = size
        self.tenths = (recording.time * 10 + 1e-6).astype(int)
        self.clock = Lettering(34 * self.scale, look.INK, look.PAGE, bold=True)
        self.cells = Cells(recording, size)

    def paint(self, picture: pygame.Surface) -> None:
        """What never changes, once, onto the background."""
        self._paint_title(picture, self.scenario)
        self._paint_legend(picture)
        self.cells.paint(picture)

    def blits(self, index: int) -> list[Blit]:
        """The figures of one record, to be blitted onto the background."""
        text = clock(int(self.tenths[index]))
        right = (self.size[0] + self.clock.width(text)) // 2
        middle = round(look.BAND * self.scale / 2)
        return [self.clock.ending_at(right, middle, text), *self.cells.blits(index)]

    def _paint_title(self, picture: pygame.Surface, scenario: Scenario) -> None:
        title = Lettering(22 * self.scale, look.INK, look.PAGE, bold=True)
        about = Lettering(13 * self.scale, look.FAINT, look.PAGE)
        room = self.size[0] / 2 - (EDGE + 110) * self.scale
        x, field = EDGE * self.scale, scenario.field
        title.write(picture, title.fitted(scenario.name, room), x, 29 * self.scale)
        facts = f"field {field.length:g} \u00d7 {field.width:g} m   ·   seed {self.seed}"
        about.write(picture, about.fitted(facts, room), x, 54 * self.scale)

    def _paint_legend(self, picture: pygame.Surface) -> None:
        """Two rows at the right: the teams that play, and the marks."""
        teams = [t for t in look.TEAMS if any(r.team == t for r in self.scenario.robots)]
        rows: list[list[Item]] = [
            [(team, partial(_team_sign, look.TEAMS[team])) for team in teams],
            [("true", _true_sign), ("believed", _believed_sign), ("target", _target_sign)],
        ]
        for row, height in zip(rows, (29, 54), strict=True):
            self._paint_items(picture, row, height * self.scale)

    def _paint_items(self, picture: pygame.Surface, items: list[Item], middle: float) -> None:
        text = Lettering(13 * self.scale, look.INK, look.PAGE)
        side = 2 * round(ICON * self.scale / 2)
        x = self.size[0] - EDGE * self.scale
        for label, paint in reversed(items):
            x -= text.width(label)
            text.write(picture, label, x, middle)
            x -= 6 * self.scale + 2 * side
            canvas = Canvas((2 * side, side), side / 2)  # its metre is half a sign
            paint(canvas)
            place = (round(x), round(middle - side / 2))
            picture.blit(canvas.shrunk(), place, special_flags=pygame.BLEND_PREMULTIPLIED)
            x -= ITEM_GAP * self.scale


def clock(tenths: int) -> str:
    """Tenths of a second as minutes, seconds and tenths."""
    return f"{tenths // 600:02d}:{tenths // 10 % 60:02d}.{tenths % 10}"


def _team_sign(colour: look.Colour, canvas: Canvas) -> None:
    canvas.disc((1.1, 0), 0.75, colour)


def _true_sign(canvas: Canvas) -> None:
    canvas.line((-1.9, 0), (1.0, 0), 0.2, look.INK)
    canvas.disc((1.0, 0), 0.7, look.INK)


def _believed_sign(canvas: Canvas) -> None:
    for start in (-1.9, -1.1, -0.3):
        canvas.line((start, 0), (start + 0.45, 0), 0.2, look.BELIEVED)
    canvas.ring((1.0, 0), 0.75, 0.2, look.BELIEVED)


def _target_sign(canvas: Canvas) -> None:
    draw_target(canvas, 0.7, 0.22, 0.0)
