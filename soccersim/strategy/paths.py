"""Ways round other robots, round the ball, and round the own penalty area."""

from collections.abc import Sequence
from math import hypot, sqrt

from soccersim.strategy.api import Player, View
from soccersim.strategy.motion import velocity

MARGIN = 0.12  # m of air between two robots
FORESIGHT = 1.0  # s at most that others are expected to go on as they go
TRIES = 4  # obstacles one behind the other
SWAY = 0.15  # s: a robot under way to one side keeps to that side
INSIDE = 0.3  # m from the board that a way may come

Disc = tuple[float, float, float]  # x, y, radius to keep the robot's centre away by; m
Point = tuple[float, float]


def others(view: View, player: Player) -> list[Disc]:
    """All other robots, where they will be when this one comes by."""
    discs = []
    own = player.body.radius + MARGIN
    vx, vy = velocity(player)
    going = max(hypot(vx, vy), 1.0)
    for mate in view.robots:
        if mate is not player and mate.in_play:
            wx, wy = velocity(mate)
            ahead = min(hypot(mate.x - player.x, mate.y - player.y) / going, FORESIGHT)
            discs.append((mate.x + ahead * wx, mate.y + ahead * wy, own + mate.body.radius))
    for other in view.opponents:
        ahead = min(hypot(other.x - player.x, other.y - player.y) / going, FORESIGHT)
        x, y = other.x + ahead * other.vx, other.y + ahead * other.vy
        discs.append((x, y, own + player.body.radius))  # as large as ourselves, as far as we know
    return discs


def first_in_the_way(start: Point, end: Point, discs: Sequence[Disc]) -> Disc | None:
    """The disc that a straight way enters first; its radius no more than lets start and end be."""
    sx, sy = start
    dx, dy = end[0] - sx, end[1] - sy
    far = hypot(dx, dy)
    if far < 1e-6:
        return None
    dx, dy = dx / far, dy / far
    first, found = far, None
    for x, y, radius in discs:
        ox, oy = x - sx, y - sy
        along = ox * dx + oy * dy
        if along <= 0.0 or along - radius >= first:
            continue
        aside = abs(ox * dy - oy * dx)
        if aside >= radius:
            continue
        # from within, or to a place within, the robot goes as near as it must
        free = min(radius, 0.98 * hypot(ox, oy), 0.98 * hypot(end[0] - x, end[1] - y))
        enters = along - sqrt(max(free * free - aside * aside, 0.0))
        if aside < free and enters < first:
            first, found = enters, (x, y, free)
    return found


def beside(start: Point, disc: Disc, side: float) -> Point:
    """Where the tangent from start touches the disc; side: 1 leaves it to the right, -1 left."""
    ox, oy = disc[0] - start[0], disc[1] - start[1]
    far2 = ox * ox + oy * oy
    radius = 1.02 * disc[2]
    reach2 = max(far2 - radius * radius, 1e-4 * far2)
    # turn the way to the centre by asin(radius / far), and shorten it to the point of touch
    c, s = reach2 / far2, side * radius * sqrt(reach2) / far2
    return start[0] + c * ox - s * oy, start[1] + s * ox + c * oy


def next_point(
    view: View, player: Player, x: float, y: float, discs: Sequence[Disc]
) -> tuple[float, float, float]:
    """Where a robot heads for on its way to (x, y) past the discs, and metres from there on."""
    start, target = (player.x, player.y), (x, y)
    disc = first_in_the_way(start, target, discs)
    if disc is None:
        return x, y, 0.0
    vx, vy = velocity(player)
    dx, dy = x - player.x, y - player.y
    far = hypot(dx, dy)
    aside = (dx * (disc[1] - player.y) - dy * (disc[0] - player.x)) / far
    sway = SWAY * (dx * vy - dy * vx) / far
    side = -1.0 if aside > sway else 1.0
    point = beside(start, disc, side)
    field = view.field
    most_x = field.length / 2.0 + field.border - INSIDE
    most_y = field.width / 2.0 + field.border - INSIDE
    if abs(point[0]) > most_x or abs(point[1]) > most_y:
        side = -side
        point = beside(start, disc, side)
    for _ in range(TRIES):
        disc = first_in_the_way(start, point, discs)
        if disc is None:
            break
        point = beside(start, disc, side)
    return point[0], point[1], hypot(x - point[0], y - point[1])


def round_area(view: View, player: Player, x: float, y: float) -> tuple[float, float, float]:
    """The same round the own penalty area: a corner of it, or the place itself."""
    area = view.field.penalty_area
    if area is None:
        return x, y, 0.0
    room = player.body.radius + MARGIN
    front = area.depth - view.field.length / 2.0 + room
    side = area.width / 2.0 + room
    start, end = (player.x, player.y), (x, y)
    within = player.x < front and abs(player.y) < side
    if within or not enters_area(start, end, front, side):
        return x, y, 0.0
    near, far = (front, side), (front, -side)
    if abs(player.y + side) < abs(player.y - side):
        near, far = far, near
    sees_far = not enters_area(start, far, front, side)
    corner = far if sees_far and enters_area(near, end, front, side) else near
    return corner[0], corner[1], hypot(x - corner[0], y - corner[1])


def enters_area(start: Point, end: Point, front: float, side: float) -> bool:
    """Whether a straight way enters the area behind x = front, within |y| < side."""
    low, high = 0.0, 1.0
    small = 1e-3  # its edge is not in it
    for a, b in (
        (start[0] - front + small, end[0] - front + small),
        (start[1] - side + small, end[1] - side + small),
        (-start[1] - side + small, -end[1] - side + small),
    ):
        if a >= 0.0 and b >= 0.0:
            return False
        if a >= 0.0:
            low = max(low, a / (a - b))
        elif b >= 0.0:
            high = min(high, a / (a - b))
    return low < high


def out_of_area(view: View, player: Player, x: float, y: float) -> Point:
    """The place itself, or the nearest one outside the own penalty area."""
    area = view.field.penalty_area
    if area is None:
        return x, y
    room = player.body.radius + MARGIN
    front = area.depth - view.field.length / 2.0 + room
    side = area.width / 2.0 + room
    if x >= front or abs(y) >= side:
        return x, y
    if front - x <= side - abs(y):
        return front, y
    return x, side if y > 0 else -side
