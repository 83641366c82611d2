"""The field as seen from above: where it lies in the picture, and its lines, goals and board."""

from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from soccersim.render import look
from soccersim.render.canvas import Canvas
from soccersim.spec.field import Area, Field

FINE = 3  # lines are upright or level: less is enough than for sprites, and saves memory
BOARD = 0.1  # m, thickness as drawn
STRIPES = 12  # mowing stripes over the length
MARGIN = 4  # px between the board and the head-up display
MESH = 0.12  # m between the cords of a net


class View(NamedTuple):
    """How the field lies in the picture: metres to pixels."""

    centre: tuple[float, float]  # px, of the centre spot
    px_per_m: float
    frame: pygame.Rect  # px, the field with its board; nobody draws play outside

    @classmethod
    def fit(cls, field: Field, size: tuple[int, int], band: int) -> "View":
        """The whole field between two bands of this height, in the middle of the picture."""
        length, width = floor(field)
        room = (size[0] - 2 * MARGIN, size[1] - 2 * (band + MARGIN))
        px_per_m = min(room[0] / (length + 2 * BOARD), room[1] / (width + 2 * BOARD))
        box = [2 * int(px_per_m * (side / 2 + BOARD)) for side in (length, width)]
        frame = pygame.Rect((size[0] - box[0]) // 2, (size[1] - box[1]) // 2, *box)
        return cls((size[0] / 2, size[1] / 2), px_per_m, frame)

    def pixel(self, x: float, y: float) -> tuple[float, float]:
        """A place on the field in the picture: x to the right, y down."""
        return self.centre[0] + x * self.px_per_m, self.centre[1] - y * self.px_per_m

    def pixels(self, places: NDArray[Any]) -> NDArray[np.float64]:
        """Places (..., 2) on the field, each as pixel() gives it."""
        scale = np.array([self.px_per_m, -self.px_per_m])
        return np.asarray(places * scale + np.array(self.centre))


def floor(field: Field) -> tuple[float, float]:
    """Length and width within the board, m."""
    return field.length + 2 * field.border, field.width + 2 * field.border


def paint_pitch(field: Field, view: View, home: int = -1) -> pygame.Surface:
    """The empty field, as large as the view's frame; home keeps the goal at x of this sign."""
    canvas = Canvas(view.frame.size, view.px_per_m, FINE, look.BOARD)
    _paint_floor(canvas, field)
    _paint_lines(canvas, field)
    for side, team in ((home, "home"), (-home, "away")):
        for area in (field.penalty_area, field.goal_area):
            if area:
                _paint_area(canvas, field, area, side)
        if field.penalty_mark:
            x = side * (field.half_length - field.penalty_mark)
            canvas.disc((x, 0), field.line_width, look.LINE)
        _paint_goal(canvas, field, side, look.TEAMS[team])
    return canvas.shrunk()


def _paint_floor(canvas: Canvas, field: Field) -> None:
    x, y = (side / 2 for side in floor(field))
    edge = BOARD / 4
    canvas.box((-x - edge, -y - edge), (x + edge, y + edge), look.BOARD_EDGE)
    canvas.box((-x, -y), (x, y), look.VERGE)
    stripe = field.length / STRIPES
    for i in range(STRIPES):
        left = -field.half_length + i * stripe
        corner = (left, -field.half_width)
        canvas.box(corner, (left + stripe, field.half_width), look.GRASS[i % 2])


def _paint_lines(canvas: Canvas, field: Field) -> None:
    """All that both halves share; a line belongs to what it bounds."""
    x, y, width = field.half_length, field.half_width, field.line_width
    canvas.frame((-x, -y), (x, y), width, look.LINE)
    canvas.box((-width / 2, -y), (width / 2, y), look.LINE)
    canvas.disc((0, 0), width, look.LINE)
    if field.centre_circle:
        canvas.ring((0, 0), field.centre_circle, width, look.LINE)
    if field.corner_arc:
        for sx in (-1, 1):
            for sy in (-1, 1):
                inward = (-sx, -sy)
                canvas.ring((sx * x, sy * y), field.corner_arc, width, look.LINE, inward)


def _paint_area(canvas: Canvas, field: Field, area: Area, side: int) -> None:
    x = side * field.half_length
    corner, other = (x, -area.width / 2), (x - side * area.depth, area.width / 2)
    canvas.frame(corner, other, field.line_width, look.LINE)


def _paint_goal(canvas: Canvas, field: Field, side: int, colour: look.Colour) -> None:
    """A net in the colour of the team that keeps it, its frame, and two posts."""
    goal = field.goal
    x, back, y = field.half_length, field.half_length + goal.depth, goal.width / 2
    canvas.box((side * x, -y), (side * back, y), look.mix(look.VERGE, colour, 0.35))
    cord = look.mix(look.VERGE, colour, 0.75)
    for i in range(1, round(goal.width / MESH)):
        place = -y + i * goal.width / round(goal.width / MESH)
        canvas.line((side * x, place), (side * back, place), 0.012, cord)
    for i in range(1, round(goal.depth / MESH)):
        place = side * (x + i * goal.depth / round(goal.depth / MESH))
        canvas.line((place, -y), (place, y), 0.012, cord)
    bar = goal.post_radius
    for sy in (-1, 1):
        canvas.line((side * x, sy * y), (side * back, sy * y), bar, colour)
    canvas.line((side * back, -y - bar / 2), (side * back, y + bar / 2), bar, colour)
    for sy in (-1, 1):
        canvas.disc((side * x, sy * y), goal.post_radius * 1.25, look.OUTLINE)
        canvas.disc((side * x, sy * y), goal.post_radius, look.POST)
