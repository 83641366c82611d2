"""Where robots without the ball stand, and who goes where. All places in the team frame, m."""

from collections.abc import Iterable, Sequence
from math import hypot

from soccersim.strategy.api import Player, View
from soccersim.strategy.openings import clearance

INSIDE = 0.5  # m from the lines, and from the penalty areas, that a place is
ROOM = 1.1  # m from an opponent; nearer, two robots get into each other's way
BEYOND = 0.7  # m more than a mate's distance at a restart, to where it receives the ball
SOFT = 3.0  # m/s, of that pass

Point = tuple[float, float]
Spot = tuple[float, float, str]  # x, y and what the robot there is called


def homeward(view: View, x: float, y: float, step: float) -> Point:
    """A place so far from (x, y) towards the own goal."""
    home = -view.field.length / 2.0
    far = hypot(x - home, y) or 1.0
    return x + step / far * (home - x), y - step / far * y


def room_for(view: View, x: float, y: float) -> Point:
    """The nearest place within the lines and before the penalty areas, beside opponents."""
    field, area = view.field, view.field.penalty_area
    most_x = field.length / 2.0 - INSIDE - (area.depth if area else 0.0)
    most_y = field.width / 2.0 - INSIDE
    x, y = min(max(x, -most_x), most_x), min(max(y, -most_y), most_y)
    for other in view.opponents:
        far = hypot(x - other.x, y - other.y)
        if 0.0 < far < ROOM:
            return other.x + ROOM / far * (x - other.x), other.y + ROOM / far * (y - other.y)
    return x, y


def share(view: View, players: Iterable[Player], spots: Sequence[Spot]) -> dict[int, Spot]:
    """Who goes where, by number: each spot, the most important first, to the nearest robot."""
    free, given = list(players), {}
    for x, y, name in spots[: len(free)]:
        x, y = room_for(view, x, y)
        player = min(free, key=lambda p: hypot(p.x - x, p.y - y))
        free.remove(player)
        given[player.number] = x, y, name
    return given


def receiving(view: View) -> Point:
    """Where a mate receives a restart of ours: back and to the side that is clearer."""
    x, y = (view.ball.x, view.ball.y) if view.ball else (0.0, 0.0)
    far = view.field.rules.mates + BEYOND
    best, place = -1e3, (x - far, 0.0)
    for side in (1.0, -1.0) if y < 0.0 else (-1.0, 1.0):  # the middle first
        at = x - 0.6 * far, y + 0.8 * side * far
        clear = min(clearance(view, x, y, *at, SOFT), 0.5)
        if clear > best and abs(at[1]) < view.field.width / 2.0 - 0.5:
            best, place = clear, at
    return place


def in_own_area(view: View) -> bool:
    """Whether the ball is in the own penalty area, or where there would be one."""
    field, area = view.field, view.field.penalty_area
    deep, wide = (area.depth, area.width) if area else (0.1 * field.length, 0.5 * field.width)
    ball = view.ball
    return ball is not None and ball.x < deep - field.length / 2.0 and abs(ball.y) < wide / 2.0
