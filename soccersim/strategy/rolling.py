"""Where a ball will be, how hard to kick it, and where a robot meets it."""

from collections.abc import Callable
from math import hypot, sqrt

from soccersim.strategy.api import Ball, Pitch, Player
from soccersim.strategy.motion import LAG, time_from, velocity

SHELL = 2.0 / 3.0  # moment of inertia of a hollow ball over m r2
SOON = 0.04  # s, one decision: so exact is the moment of a meeting
LYING = 0.05  # m/s, of a ball that will be where it is
STEPS = 14  # at most, towards that moment
BOLDEST = 0.4  # of the surest rate: bolder steps pass over a moment at which a fast ball is met


def ball_at(field: Pitch, ball: Ball, seconds: float) -> tuple[float, float]:
    """Where a rolling ball will be if nobody touches it, m."""
    speed = hypot(ball.vx, ball.vy)
    if speed == 0.0:
        return ball.x, ball.y
    slowing = field.ball_rolling
    t = min(seconds, speed / slowing) if slowing > 0 else seconds
    part = t * (1.0 - slowing * t / (2.0 * speed))
    return ball.x + ball.vx * part, ball.y + ball.vy * part


def kick_speed(field: Pitch, far: float, arrive: float = 2.0) -> float:
    """How fast a ball must leave to come so far and arrive with a speed, m/s.

    It slides until it rolls at v0 / (1 + k) = 0.6 v0, after k (k + 2) v0^2 / (2 mu g (1 + k)^2).
    """
    slide, roll = field.ball_sliding, field.ball_rolling
    if slide <= 0:
        return sqrt(arrive * arrive + 2.0 * roll * far)
    keep = 1.0 / (1.0 + SHELL)
    path = SHELL * (SHELL + 2.0) * keep * keep / (2.0 * slide)  # m of sliding a (m/s)^2
    v0 = sqrt((arrive * arrive + 2.0 * roll * far) / (keep * keep + 2.0 * roll * path))
    return v0 if path * v0 * v0 <= far else sqrt(arrive * arrive + 2.0 * slide * far)


def kick_time(field: Pitch, far: float, speed: float) -> float:
    """Seconds until a ball kicked with a speed has come so far; inf if it stops before."""
    slide, roll = field.ball_sliding, field.ball_rolling
    spent = 0.0
    if slide > 0:
        sliding = SHELL * speed / ((1.0 + SHELL) * slide)
        path = sliding * (speed - slide * sliding / 2.0)
        if path >= far:
            return (speed - sqrt(max(speed * speed - 2.0 * slide * far, 0.0))) / slide
        spent, far, speed = sliding, far - path, speed / (1.0 + SHELL)
    if speed * speed < 2.0 * roll * far:
        return float("inf")
    return spent + 2.0 * far / (speed + sqrt(speed * speed - 2.0 * roll * far))


def meeting(field: Pitch, ball: Ball, player: Player) -> tuple[float, float, float]:
    """Where and when a robot can first reach the ball with its mouth: x, y in m, s from now.

    Where the ball runs out of the field before, the place where it does.
    """
    needed = reaching(player, player.body.radius + field.ball_radius)
    speed = hypot(ball.vx, ball.vy)
    fastest = rate = 1.0 + speed / player.body.speed  # at which the two can close up
    early, t, x, y = 0.0, 0.0, ball.x, ball.y
    late = needed(x, y)
    if speed < LYING:
        return x, y, late
    met = passing(field, ball, *resting(player))  # at the latest, if it is in time for that
    if met and needed(met[0], met[1]) > met[2]:
        met = None
    most_x, most_y = field.length / 2.0, field.width / 2.0
    for _ in range(STEPS):
        before, was = t, late
        if late <= SOON:
            met = x, y, t
            if late > -SOON or t - early < SOON:
                break
            t = (early + t) / 2.0  # it could be sooner: the ball may have rolled through it
        else:
            early = t
            t += max(late / rate, SOON)
            if met and t >= met[2]:
                t = (early + met[2]) / 2.0
        x, y = ball_at(field, ball, t)
        if not (-most_x <= x <= most_x and -most_y <= y <= most_y) and field.rules.lines:
            x, y = last_inside(field, ball, x, y)
            return x, y, max(t, needed(x, y))
        late = needed(x, y) - t
        if t > before:  # the next step goes on as this one went (secant)
            rate = min(max((was - late) / (t - before), BOLDEST * fastest), fastest)
    return met or (x, y, t)


def reaching(player: Player, reach: float) -> Callable[[float, float], float]:
    """Tells of a point how many seconds it takes until a robot's mouth can be there, at rest.

    None, if the robot comes to rest there anyway.
    """
    px, py = player.x, player.y
    a, top = player.body.acceleration, player.body.speed
    vx, vy = velocity(player)
    rest_x, rest_y = resting(player)

    def needed(x: float, y: float) -> float:
        if hypot(x - rest_x, y - rest_y) <= reach:
            return 0.0
        dx, dy = x - px, y - py
        far = hypot(dx, dy)
        if far <= reach:
            return LAG
        return LAG + time_from(far - reach, (vx * dx + vy * dy) / far, a, top)

    return needed


def field_has(field: Pitch, x: float, y: float) -> bool:
    """Whether a place lies within the lines."""
    return abs(x) <= field.length / 2.0 and abs(y) <= field.width / 2.0


def resting(player: Player) -> tuple[float, float]:
    """Where a robot comes to rest that brakes now."""
    vx, vy = velocity(player)
    stops = hypot(vx, vy) / (2.0 * player.body.acceleration) + LAG
    return player.x + stops * vx, player.y + stops * vy


def passing(field: Pitch, ball: Ball, x: float, y: float) -> tuple[float, float, float] | None:
    """Where and when a rolling ball passes a place: x, y, s; None: it never does."""
    speed = hypot(ball.vx, ball.vy)
    ux, uy = ball.vx / speed, ball.vy / speed
    far = (x - ball.x) * ux + (y - ball.y) * uy
    left = speed * speed - 2.0 * field.ball_rolling * far
    if far <= 0.0 or left < 0.0:
        return None
    return ball.x + far * ux, ball.y + far * uy, 2.0 * far / (speed + sqrt(left))


def last_inside(field: Pitch, ball: Ball, x: float, y: float) -> tuple[float, float]:
    """Where the way from the ball to a place outside crosses the line; the ball, if it is out."""
    if not field_has(field, ball.x, ball.y):
        return ball.x, ball.y
    dx, dy = x - ball.x, y - ball.y
    most_x, most_y = field.length / 2.0, field.width / 2.0
    part = 1.0
    if abs(x) > most_x:
        part = (most_x - abs(ball.x) * (1 if ball.x * x > 0 else -1)) / abs(dx)
    if abs(y) > most_y:
        part = min(part, (most_y - abs(ball.y) * (1 if ball.y * y > 0 else -1)) / abs(dy))
    return ball.x + part * dx, ball.y + part * dy
