"""Where the opponents leave a gap: in the goal, on the way of a pass, round a player."""

from collections.abc import Iterable
from math import atan2, hypot, inf, tan

from soccersim.strategy.api import Player, View
from soccersim.strategy.motion import towards, velocity, wrap
from soccersim.strategy.rolling import kick_speed, kick_time, meeting

POST = 0.25  # m from a post that nobody aims at: nobody shoots so exactly
AWAY = 0.25  # m of open goal for each metre from where the robot looks
SIDEWAYS = 1.2  # rad; looking farther aside, a robot looks at no part of the goal
SIGHT = 0.05  # s that opponents' positions are carried on, at a shot
REACH = 1.0  # m/s, at which an opponent closes a pass's way, after it has seen it
REACTION = 0.2  # s
RECEIVE = 2.0  # m/s, of a ball that a robot can hold
SHORTEST, LONGEST = 1.2, 9.0  # m, of a pass
FORWARD = 0.2  # m of clear way that a metre forward is worth
TURN = 0.3  # m of clear way that a radian less to turn is worth: it also keeps one decided
SIGHTED = 4.0  # m of clear way that a radian of open goal is worth


def free_goal(view: View, x: float, y: float, heading: float | None = None) -> tuple[float, float]:
    """Where to aim from a point: y on the opponents' goal line, m, and the gap's half angle, rad.

    The widest part of the goal that no opponent covers; half angle 0 when there is none, and the
    y is then the middle of the goal. heading: of who shoots; of parts about as wide he takes the
    one that he looks at already, lest he turn to and fro.
    """
    field = view.field
    goal_x, half = field.length / 2.0, field.goal_width / 2.0 - POST
    far = goal_x - x
    if far <= 0:
        return 0.0, 0.0
    covered = []
    for other in view.opponents:
        ahead = other.x + SIGHT * other.vx - x
        if 0.1 < ahead < far + field.goal_depth:
            scale = far / ahead
            middle = y + (other.y + SIGHT * other.vy - y) * scale
            # a disc's shadow is widened where it falls on the line at an angle
            wide = (robot_radius(view) + field.ball_radius) * scale
            wide *= hypot(middle - y, far) / far
            covered.append((middle - wide, middle + wide))
    covered.sort()
    looks_at = None
    if heading is not None and abs(heading) < SIDEWAYS:
        looks_at = y + far * tan(heading)
    best, free_from, low, high = 0.0, -half, 0.0, 0.0
    for start, end in [*covered, (half, half)]:
        gap = min(start, half) - free_from
        worth = gap
        if looks_at is not None and gap > 0.0:
            worth = max(gap - AWAY * abs(free_from + gap / 2.0 - looks_at), 0.1 * gap)
        if worth > best:
            best, low, high = worth, free_from, free_from + gap
        free_from = max(free_from, end)
        if free_from >= half:
            break
    angle = atan2(high - y, far) - atan2(low - y, far)
    return (low + high) / 2.0, angle / 2.0


def robot_radius(view: View) -> float:
    """How large opponents are taken for: as large as ourselves."""
    return view.robots[0].body.radius if view.robots else 0.25


def clearance(view: View, x1: float, y1: float, x2: float, y2: float, speed: float) -> float:
    """How far at least a ball kicked from one point to the other stays clear of opponents, m.

    Each opponent runs for it from when it is kicked (speed, m/s): negative where one gets there.
    """
    field = view.field
    dx, dy = x2 - x1, y2 - y1
    far = hypot(dx, dy)
    least = 1e3
    room = robot_radius(view) + field.ball_radius
    for other in view.opponents:
        ox, oy = other.x - x1, other.y - y1
        along = (ox * dx + oy * dy) / far if far > 0 else 0.0
        if along < -room:
            continue
        along = min(max(along, 0.0), far)
        px, py = (dx / far * along, dy / far * along) if far > 0 else (0.0, 0.0)
        seconds = max(kick_time(field, along, speed) - REACTION, 0.0)
        runs = REACH * min(seconds, 3.0)
        least = min(least, hypot(ox - px, oy - py) - room - runs)
    return least


def lead(view: View, player: Player, mate: Player) -> tuple[float, float]:
    """Where a pass to a running mate goes, m."""
    vx, vy = velocity(mate)
    far = hypot(mate.x - player.x, mate.y - player.y)
    flight = kick_time(view.field, far, kick_speed(view.field, far, RECEIVE))
    run = 0.5 * min(flight, 2.0)  # it slows down to receive
    x, y = mate.x + run * vx, mate.y + run * vy
    half_length, half_width = view.field.length / 2 - 0.5, view.field.width / 2 - 0.5
    return min(max(x, -half_length), half_length), min(max(y, -half_width), half_width)


def best_pass(view: View, player: Player) -> tuple[Player | None, float]:
    """The mate that a pass helps most, and how clear its way is, m; None when it helps nobody.

    A clear way counts, up to a metre; so do ground that is gained, an open goal before him, and
    how far the robot has turned to him already.
    """
    best, found, open_by = 0.0, None, 0.0
    for mate in view.robots:
        if mate is player or not mate.in_play or mate.role == "keeper":
            continue
        far = hypot(mate.x - player.x, mate.y - player.y)
        if not SHORTEST < far < LONGEST:
            continue
        x, y = lead(view, player, mate)
        speed = kick_speed(view.field, hypot(x - player.x, y - player.y), RECEIVE)
        free = clearance(view, player.x, player.y, x, y, speed)
        if free <= 0.0:
            continue
        _, angle = free_goal(view, x, y) if x > 0 else (0.0, 0.0)
        turn = abs(wrap(towards(player, x, y) - player.heading))
        value = min(free, 1.0) + FORWARD * (x - player.x) + SIGHTED * angle - TURN * turn
        if value > best:
            best, found, open_by = value, mate, free
    return found, open_by


def nearest(players: Iterable[Player], x: float, y: float) -> Player | None:
    """The robot in play that is nearest to a point; None when none is in play."""
    playing = [player for player in players if player.in_play]
    return min(playing, key=lambda p: hypot(p.x - x, p.y - y), default=None)


def quickest(view: View, players: Iterable[Player]) -> Player | None:
    """The robot in play that can have the ball first, where it rolls too; None when none can."""
    ball = view.ball
    if ball is None:
        return None
    playing = [player for player in players if player.in_play]
    for player in playing:
        if player.has_ball:
            return player
    far = {player.number: hypot(player.x - ball.x, player.y - ball.y) for player in playing}
    rolls = hypot(ball.vx, ball.vy)
    first, found = inf, None
    for player in sorted(playing, key=lambda player: far[player.number]):
        reach = player.body.radius + view.field.ball_radius
        if far[player.number] - reach < first * (player.body.speed + rolls):  # else never sooner
            seconds = meeting(view.field, ball, player)[2]
            if seconds < first:
                first, found = seconds, player
    return found
