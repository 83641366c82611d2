"""A robot as it is drawn: its body in its team's colour, a white nose, a hub, its wheels as built.

A match shows it at hundreds of headings, so its outlines are worked out once and turned as a whole.
"""

from math import cos, hypot, radians, sin
from typing import NamedTuple

from soccersim.render import look
from soccersim.render.canvas import Canvas, Place, Shade, Shapes, bar, sector, turned
from soccersim.spec.base import per_item
from soccersim.spec.robot import Robot, Wheels

NOSE = radians(34)  # half the angle of the white sector at a robot's front
HUB = 0.46  # of the radius: the disc that carries the number
TREAD = {"drive": 0.8, "dead": 0.6}  # thickness of a wheel beside its radius
GAPS = (-0.45, 0.0, 0.45)  # of a wheel's length: where its rollers meet


class WheelMark(NamedTuple):
    """A wheel as drawn: body frame, metres and radians."""

    x: float
    y: float
    direction: float  # where it rolls to
    length: float
    thickness: float
    roller: float  # the angle of its rollers
    dead: bool


def wheel_marks(model: Robot) -> list[WheelMark]:
    """All the wheels of a robot: the driven ones, then the dead ones."""
    marks = _marks(model.drive, dead=False)
    return marks + _marks(model.dead, dead=True) if model.dead else marks


def _marks(wheels: Wheels, dead: bool) -> list[WheelMark]:
    count = len(wheels.azimuth_deg)
    directions = wheels.direction_deg or tuple(a + 90 for a in wheels.azimuth_deg)
    rollers = per_item(wheels.roller_deg, count)
    thickness = wheels.radius * TREAD["dead" if dead else "drive"]
    return [
        WheelMark(
            distance * cos(radians(azimuth)),
            distance * sin(radians(azimuth)),
            radians(direction),
            2 * wheels.radius,
            thickness,
            radians(roller),
            dead,
        )
        for azimuth, distance, direction, roller in zip(
            wheels.azimuth_deg, per_item(wheels.distance, count), directions, rollers, strict=True
        )
    ]


def _wheel(mark: WheelMark) -> list[tuple[list[Place], Shade]]:
    """A tyre with bevelled corners, and gaps between its rollers; body frame, m."""
    long, wide = mark.length / 2, mark.thickness / 2
    bevel = 0.35 * wide
    quarter = [(long, wide - bevel), (long - bevel, wide)]
    half = [*quarter, *((-x, y) for x, y in reversed(quarter))]
    tyre = [*half, *((-x, -y) for x, y in half)]
    polygons: list[tuple[list[Place], Shade]] = [(tyre, look.DEAD_TYRE if mark.dead else look.TYRE)]
    lean = 0.7 * wide * sin(mark.roller)
    for share in GAPS:
        x = share * mark.length
        gap = bar((x + lean, -0.7 * wide), (x - lean, 0.7 * wide), 0.08 * mark.length)
        polygons.append((gap, look.DEAD_ROLLER if mark.dead else look.ROLLER))
    return [(turned(points, mark.direction, (mark.x, mark.y)), shade) for points, shade in polygons]


class Likeness:
    """What one model of robot looks like."""

    def __init__(self, model: Robot) -> None:
        self.radius = model.radius
        marks = wheel_marks(model)
        self.reach = max(
            self.radius, *(hypot(m.x, m.y) + hypot(m.length, m.thickness) / 2 for m in marks)
        )
        self.wheels = Shapes([polygon for mark in marks for polygon in _wheel(mark)])

    def paint(self, colour: look.Colour, px_per_m: float, heading: float) -> Canvas:
        """The robot with its shadow, turned to a heading in rad."""
        radius, canvas = self.radius, Canvas.around(1.12 * self.reach, px_per_m)
        rim = max(0.05 * radius, 1.0 / px_per_m)
        canvas.disc((0.06 * radius, -0.09 * radius), radius, look.SHADOW)
        canvas.disc((0, 0), radius, look.OUTLINE)
        canvas.disc((0, 0), radius - rim, look.mix(colour, look.OUTLINE, 0.22))
        canvas.disc((0, 0), 0.9 * (radius - rim), colour)
        nose = sector(radius - rim, -NOSE, NOSE, HUB * radius)
        canvas.polygon(turned(nose, heading), look.NOSE)
        canvas.disc((0, 0), HUB * radius, look.HUB)
        canvas.turned(self.wheels, heading)
        return canvas
