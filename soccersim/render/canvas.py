"""Shapes in metres, drawn at several times their size and shrunk: the edges come out smooth."""

from collections.abc import Iterable
from itertools import accumulate
from math import ceil, cos, hypot, sin

import numpy as np
import pygame

FINE = 4  # times as large while drawn; beyond it nobody sees a difference
Shade = tuple[int, int, int] | tuple[int, int, int, int]
Place = tuple[float, float]


class Shapes:
    """Polygons in their shades that are drawn again and again, at other headings."""

    def __init__(self, polygons: list[tuple[list[Place], Shade]]) -> None:
        self.points = np.array([place for places, _ in polygons for place in places])
        ends = list(accumulate(len(places) for places, _ in polygons))
        parts = map(slice, [0, *ends], ends)
        self.parts = list(zip(parts, (shade for _, shade in polygons), strict=True))


class Canvas:
    """A picture whose middle is (0, 0); x to the right, y up, in metres.

    It is transparent, unless it gets a ground.
    """

    def __init__(
        self,
        size: tuple[int, int],
        px_per_m: float,
        fine: int = FINE,
        ground: Shade | None = None,
    ) -> None:
        self.size = size
        self.px_per_m = px_per_m * fine
        self.transparent = ground is None
        flags = pygame.SRCALPHA if self.transparent else 0
        self.surface = pygame.Surface((size[0] * fine, size[1] * fine), flags, 32)
        self.surface.fill(ground or (0, 0, 0, 0))
        self.middle = (size[0] * fine / 2, size[1] * fine / 2)

    @classmethod
    def around(cls, reach: float, px_per_m: float) -> "Canvas":
        """A square one that shows as many metres each way."""
        side = 2 * ceil(reach * px_per_m + 1)
        return cls((side, side), px_per_m)

    def pixel(self, x: float, y: float) -> tuple[int, int]:
        """Where a place lies on the large surface."""
        return (
            round(self.middle[0] + x * self.px_per_m),
            round(self.middle[1] - y * self.px_per_m),
        )

    def length(self, metres: float) -> int:
        """A length on the large surface: never nothing."""
        return max(1, round(metres * self.px_per_m))

    def box(self, corner: Place, other: Place, shade: Shade) -> None:
        """A filled rectangle between two corners."""
        x1, y1 = self.pixel(min(corner[0], other[0]), max(corner[1], other[1]))
        x2, y2 = self.pixel(max(corner[0], other[0]), min(corner[1], other[1]))
        self.surface.fill(shade, (x1, y1, max(1, x2 - x1), max(1, y2 - y1)))

    def frame(self, corner: Place, other: Place, width: float, shade: Shade) -> None:
        """The outline of a rectangle, drawn inside it."""
        x1, x2 = sorted((corner[0], other[0]))
        y1, y2 = sorted((corner[1], other[1]))
        self.box((x1, y1), (x2, y1 + width), shade)
        self.box((x1, y2 - width), (x2, y2), shade)
        self.box((x1, y1), (x1 + width, y2), shade)
        self.box((x2 - width, y1), (x2, y2), shade)

    def disc(self, place: Place, radius: float, shade: Shade) -> None:
        """A filled circle."""
        pygame.draw.circle(self.surface, shade, self.pixel(*place), self.length(radius))

    def ring(
        self, place: Place, radius: float, width: float, shade: Shade, quarter: Place | None = None
    ) -> None:
        """A circle's outline, drawn inside it; or its quarter on the side of these signs."""
        parts = {}
        if quarter:
            side = "right" if quarter[0] > 0 else "left"
            parts = {f"draw_{'top' if quarter[1] > 0 else 'bottom'}_{side}": True}
        pygame.draw.circle(
            self.surface,
            shade,
            self.pixel(*place),
            self.length(radius),
            self.length(width),
            **parts,
        )

    def polygon(self, points: Iterable[Place], shade: Shade) -> None:
        """A filled polygon."""
        pygame.draw.polygon(self.surface, shade, [self.pixel(x, y) for x, y in points])

    def line(self, start: Place, end: Place, width: float, shade: Shade) -> None:
        """A straight line with square ends."""
        self.polygon(bar(start, end, width), shade)

    def turned(self, shapes: Shapes, heading: float) -> None:
        """Polygons turned counter-clockwise about the middle, all at once."""
        c, s = cos(heading) * self.px_per_m, sin(heading) * self.px_per_m
        places = shapes.points @ np.array(((c, -s), (-s, -c))) + self.middle
        pixels = np.rint(places).astype(int).tolist()
        for part, shade in shapes.parts:
            pygame.draw.polygon(self.surface, shade, pixels[part])

    def shrunk(self) -> pygame.Surface:
        """The picture at its size; without a ground to be blitted with BLEND_PREMULTIPLIED."""
        surface = self.surface.premul_alpha() if self.transparent else self.surface
        return pygame.transform.smoothscale(surface, self.size)


def bar(start: Place, end: Place, width: float) -> list[Place]:
    """The corners of a straight line with square ends."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    half = width / 2 / (hypot(dx, dy) or 1.0)
    nx, ny = -dy * half, dx * half
    return [
        (start[0] + nx, start[1] + ny),
        (end[0] + nx, end[1] + ny),
        (end[0] - nx, end[1] - ny),
        (start[0] - nx, start[1] - ny),
    ]


def turned(points: Iterable[Place], angle: float, place: Place = (0.0, 0.0)) -> list[Place]:
    """Points turned counter-clockwise about (0, 0), then moved to a place."""
    c, s = cos(angle), sin(angle)
    return [(place[0] + c * x - s * y, place[1] + s * x + c * y) for x, y in points]


def sector(radius: float, start: float, end: float, inner: float = 0.0) -> list[Place]:
    """The outline of a piece of cake between two angles, its tip cut off at the inner radius."""
    steps = 16
    angles = [start + (end - start) * i / steps for i in range(steps + 1)]
    rim = [(radius * cos(a), radius * sin(a)) for a in angles]
    return rim + [(inner * cos(a), inner * sin(a)) for a in reversed(angles)]
