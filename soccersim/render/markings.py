"""The markings of a field as polylines, for plots to scale. All in the field frame."""

import numpy as np

from soccersim.render.tracks import Array
from soccersim.spec.field import Field

ARC_STEPS = 72  # pieces of a full circle


def floor(field: Field) -> Array:
    """The corners of the floor inside the boards."""
    return _box(field.half_length + field.border, field.half_width + field.border)


def lines(field: Field) -> list[Array]:
    """The middle of every painted line: lines belong to the area they bound."""
    half = field.line_width / 2
    x, y = field.half_length - half, field.half_width - half
    drawn = [_box(x, y), np.array([(0.0, -y), (0.0, y)])]
    if field.centre_circle:
        drawn.append(_arc(field.centre_circle - half, 0.0, 2 * np.pi))
    for area in (field.penalty_area, field.goal_area):
        if area:
            drawn += _before_goals(x, field.half_length - area.depth + half, area.width / 2 - half)
    if field.corner_arc:
        arc = _arc(field.corner_arc - half, np.pi, 1.5 * np.pi) + np.array((x, y))
        drawn += [arc * (sx, sy) for sx in (-1, 1) for sy in (-1, 1)]
    return drawn


def goals(field: Field) -> list[Array]:
    """Both goals seen from above: post, net, post."""
    back = field.half_length + field.goal.depth
    return _before_goals(field.half_length, back, field.goal.width / 2)


def spots(field: Field) -> Array:
    """Centre spot and penalty marks."""
    drawn = [(0.0, 0.0)]
    if field.penalty_mark:
        x = field.half_length - field.penalty_mark
        drawn += [(-x, 0.0), (x, 0.0)]
    return np.array(drawn)


def _before_goals(goal_line: float, x: float, y: float) -> list[Array]:
    """Three sides of a box at either end."""
    box = np.array([(goal_line, y), (x, y), (x, -y), (goal_line, -y)])
    return [box, -box]


def _box(x: float, y: float) -> Array:
    return np.array([(-x, -y), (x, -y), (x, y), (-x, y), (-x, -y)])


def _arc(radius: float, begin: float, end: float) -> Array:
    angle = np.linspace(begin, end, round(ARC_STEPS * (end - begin) / (2 * np.pi)) + 1)
    return radius * np.column_stack((np.cos(angle), np.sin(angle)))
