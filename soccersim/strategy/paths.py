"""Ways round other robots, round the ball, and round the own penalty area."""

from collections.abc import Sequence
from math import asin, atan2, cos, hypot, pi, sin, sqrt

from soccersim.strategy.api import Player, View
from soccersim.strategy.motion import BRAKING, velocity

MARGIN = 0.12  # m of air between two robots
FORESIGHT = 0.5  # s at most that others are expected to go on as they go
TRIES = 4  # obstacles one behind the other
SWAY = 0.1  # rad per m/s: a robot under way to one side keeps to that side
DRIFT = 0.08  # m that a robot may be carried beyond a corner of its way
AHEAD = 0.3  # m, at least, to the next point of a way round something: nearer, robots hunt for it
OUTWARDS = 1.0  # rad off the edge of a disc, for a robot at its centre
VERGE = 0.3  # m outside the lines that a way may lead
BOARD = 0.3  # m that a robot's centre keeps from the boards

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
    """The disc that a straight way enters first; its radius no more than lets the end be."""
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
        free = min(
            radius, 0.98 * hypot(end[0] - x, end[1] - y)
        )  # to one within: as near as must be
        enters = along - sqrt(max(free * free - aside * aside, 0.0))
        if aside < free and enters < first:
            first, found = enters, (x, y, free)
    return found


def next_point(
    view: View, player: Player, x: float, y: float, discs: Sequence[Disc]
) -> tuple[float, float, float, float]:
    """Where a robot heads for on its way to (x, y) past the discs, how far it is from there on,
    and how fast it may be now: x, y, m, m/s.

    Discs that leave no gap between them are passed as one, on the side that is less of a detour.
    """
    start, target = (player.x, player.y), (x, y)
    disc = first_in_the_way(start, target, discs)
    if disc is None:
        return x, y, 0.0, player.body.speed
    vx, vy = velocity(player)
    dx, dy = x - player.x, y - player.y
    sway = SWAY * (dx * vy - dy * vx) / hypot(dx, dy)
    crowd, rest = [disc], [each for each in discs if each[:2] != disc[:2]]
    side = 0.0
    point = target
    for _ in range(TRIES):
        gather(crowd, rest, target)
        left, right = edges(start, target, crowd)
        if not side:
            side = 1.0 if left[0] - sway < sway - right[0] else -1.0
            if not may_pass(view, spot(start, target, left if side > 0 else right), target):
                side = -side
        point = spot(start, target, left if side > 0 else right)
        disc = first_in_the_way(start, point, rest)
        if disc is None:
            break
        crowd.append(disc)
        rest = [each for each in rest if each[:2] != disc[:2]]
    fast = corner_speed(player, point, target, crowd, rest)
    return point[0], point[1], hypot(x - point[0], y - point[1]), fast


def corner_speed(
    player: Player, point: Point, target: Point, crowd: Sequence[Disc], rest: Sequence[Disc]
) -> float:
    """How fast a robot may be now so that it can turn at the point to the way that follows, m/s.

    That way leads round the crowd still, or past the next of the rest.
    """
    start = player.x, player.y
    ahead = target
    disc = first_in_the_way(point, target, rest) or first_in_the_way(point, target, crowd)
    if disc:
        left, right = edges(point, target, [disc])
        ahead = spot(point, target, left if left[0] < -right[0] else right)
    dx, dy = point[0] - start[0], point[1] - start[1]
    ex, ey = ahead[0] - point[0], ahead[1] - point[1]
    turn = abs(atan2(dx * ey - dy * ex, dx * ex + dy * ey))
    a = BRAKING * player.body.acceleration
    # across the old way it needs v sin(turn), and drifts v2 sin2 / 2a until it has that
    slow2 = 2.0 * a * DRIFT / max(sin(min(turn, pi / 2.0)) ** 2, 1e-6)
    return sqrt(slow2 + 2.0 * a * hypot(dx, dy))


def gather(crowd: list[Disc], rest: list[Disc], target: Point) -> None:
    """Move to the crowd what overlaps one of it; a robot does not fit between."""
    for disc in crowd:  # it grows while it is read
        for other in list(rest):
            if hypot(disc[0] - other[0], disc[1] - other[1]) < disc[2] + other[2]:
                rest.remove(other)
                crowd.append(shrunk(other, target))


def shrunk(disc: Disc, target: Point) -> Disc:
    """A disc that the target is not in."""
    x, y, radius = disc
    return x, y, min(radius, 0.98 * hypot(target[0] - x, target[1] - y))


def edges(
    start: Point, target: Point, crowd: Sequence[Disc]
) -> tuple[tuple[float, float], tuple[float, float]]:
    """The outermost tangents of a crowd, left and right: angle off the straight way, length."""
    dx, dy = target[0] - start[0], target[1] - start[1]
    left, right = (-9.0, 0.0), (9.0, 0.0)
    for x, y, radius in crowd:
        ox, oy = x - start[0], y - start[1]
        far = hypot(ox, oy) + 1e-9
        off = atan2(dx * oy - dy * ox, dx * ox + dy * oy)
        # out of one that it is in already, a robot goes a little outwards
        half = asin(radius / far) if radius < far else pi / 2.0 + OUTWARDS * (1.0 - far / radius)
        length = max(sqrt(max(far * far - radius * radius, 0.0)), AHEAD)
        left = max(left, (off + half, length))
        right = min(right, (off - half, length))
    return left, right


def spot(start: Point, target: Point, edge: tuple[float, float]) -> Point:
    """The point where a tangent touches."""
    dx, dy = target[0] - start[0], target[1] - start[1]
    part = edge[1] / hypot(dx, dy)
    c, s = part * cos(edge[0]), part * sin(edge[0])
    return start[0] + c * dx - s * dy, start[1] + s * dx + c * dy


def may_pass(view: View, point: Point, target: Point) -> bool:
    """Whether a way may lead by a place: on the field, or to a target outside, on the floor."""
    verge = VERGE if on_field(view, target, VERGE / 2.0) else view.field.border - BOARD
    return on_field(view, point, verge)


def on_field(view: View, point: Point, verge: float) -> bool:
    """Whether a place is on the field, or so far outside."""
    field = view.field
    return abs(point[0]) < field.length / 2.0 + verge and abs(point[1]) < field.width / 2.0 + verge


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
