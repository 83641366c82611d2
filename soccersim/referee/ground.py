"""Where things are on the field: areas, and the places where the ball is put. Field frame, m.

Everything here commutes with a half turn of the field: nearest places are chosen by distance, and
among equals by the side that a cross product tells, never by a list's order.
"""

from math import copysign, inf

from soccersim.referee.events import Place
from soccersim.referee.scene import Scene
from soccersim.spec.field import Area

SPOT_SHARE = 0.16  # of the length, where a field has no penalty mark: 3.6 m of 22


class Ground:
    """The field as the referee needs it."""

    def __init__(self, scene: Scene) -> None:
        field = scene.field
        self.field = field
        self.half_length, self.half_width = field.half_length, field.half_width
        self.ball_radius = scene.ball_radius
        mark = field.penalty_mark
        deep = mark if mark is not None else SPOT_SHARE * field.length
        if field.penalty_area:  # spots are outside it
            deep = max(deep, field.penalty_area.depth + scene.ball_radius)
        # Source: the six virtual spots of the 2016 book, placed as simatch's referee places them
        x, y = max(self.half_length - deep, 0.0), field.width / 4
        self.spots: list[Place] = [(x, y), (x, -y), (-x, y), (-x, -y)]
        self.drops: list[Place] = [*self.spots, (0.0, 0.0), (0.0, y), (0.0, -y)]
        self.mark = self.half_length - mark if mark is not None else None
        if self.mark is not None and self.penalty_end(self.mark, 0.0) == 0.0:
            self.drops += [(self.mark, 0.0), (-self.mark, 0.0)]

    def penalty_end(self, x: float, y: float) -> float:
        """+1.0 or -1.0 where the place is in the penalty area at that x, else 0.0."""
        return self._end(self.field.penalty_area, x, y)

    def goal_end(self, x: float, y: float) -> float:
        """The same of the goal areas."""
        return self._end(self.field.goal_area, x, y)

    def _end(self, area: Area | None, x: float, y: float) -> float:
        if area and self.half_length - abs(x) <= area.depth and abs(y) <= area.width / 2:
            return copysign(1.0, x)
        return 0.0

    def nearest(self, places: list[Place], x: float, y: float) -> Place:
        """The place nearest to x, y."""

        def key(place: Place) -> tuple[float, float]:
            dx, dy = place[0] - x, place[1] - y
            return dx * dx + dy * dy, y * place[0] - x * place[1]

        return min(places, key=key)

    def dropped(self, x: float, y: float) -> Place:
        """Where a ball is dropped that was stuck at x, y."""
        return self.nearest(self.drops, x, y)

    def free_kick(self, x: float, y: float) -> Place:
        """Where a free kick is taken for a foul at x, y: there, or outside the penalty area.

        Source: simatch's referee takes the nearest restart spot.
        """
        if self.penalty_end(x, y):
            return self.nearest(self.spots, x, y)
        return self.inside(x, y)

    def goal_kick(self, x: float, y: float) -> Place:
        """The restart spot nearest to where the ball went out."""
        end = copysign(1.0, x)
        return self.nearest([spot for spot in self.spots if spot[0] * end >= 0.0], x, y)

    def corner(self, x: float, y: float) -> Place:
        """The nearest corner of the field."""
        return copysign(self.half_length, x), copysign(self.half_width, y)

    def throw_in(self, x: float, y: float) -> Place:
        """On the touch line, where the ball crossed it."""
        return self.clipped(x, self.half_length), copysign(self.half_width, y)

    def inside(self, x: float, y: float) -> Place:
        """The place itself, or the nearest one inside the lines by a ball's radius."""
        radius = self.ball_radius
        return (
            self.clipped(x, self.half_length - radius),
            self.clipped(y, self.half_width - radius),
        )

    @staticmethod
    def clipped(value: float, most: float = inf) -> float:
        """The value, at most so far from 0."""
        return min(max(value, -most), most)
