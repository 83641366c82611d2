"""Where a ball will be, how hard to kick it, and where a robot meets it."""

from collections.abc import Iterator
from math import hypot, sqrt

from soccersim.strategy.api import Ball, Pitch, Player
from soccersim.strategy.motion import LAG, time_to

SHELL = 2.0 / 3.0  # moment of inertia of a hollow ball over m r2
SOON = 0.04  # s, one decision
GROWTH = 1.2  # each moment looked at is later by this factor
LATEST = 8.0  # s
HALVINGS = 4


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


def moments() -> Iterator[float]:
    """Seconds from now at which a meeting is tried, ever farther apart."""
    t = SOON
    while t < LATEST:
        yield t
        t = t * GROWTH + SOON


def meeting(field: Pitch, ball: Ball, player: Player) -> tuple[float, float, float]:
    """Where and when a robot can first reach the ball: x, y in m, s from now.

    Where a ball runs out of the field before, the last place inside; where it is too fast or
    comes to rest, where it will lie.
    """
    if hypot(ball.vx, ball.vy) < 0.05:
        return ball.x, ball.y, time_to(player, ball.x, ball.y)
    half_length, half_width = field.length / 2.0, field.width / 2.0
    reach = player.body.radius + field.ball_radius
    before = 0.0
    for t in moments():
        x, y = ball_at(field, ball, t)
        out = field.rules.lines and not (abs(x) < half_length and abs(y) < half_width)
        if out or arrives(player, x, y, reach, t):
            break
        before = t
    else:
        return x, y, t
    for _ in range(HALVINGS):
        middle = (before + t) / 2.0
        x, y = ball_at(field, ball, middle)
        gone = out and not (abs(x) < half_length and abs(y) < half_width)
        if gone or (not out and arrives(player, x, y, reach, middle)):
            t = middle
        else:
            before = middle
    x, y = ball_at(field, ball, before if out else t)
    return x, y, t


def arrives(player: Player, x: float, y: float, reach: float, seconds: float) -> bool:
    """Whether a robot's mouth can be at a point in that time."""
    far = hypot(x - player.x, y - player.y)
    if far <= reach:
        return True
    keep = (far - reach) / far
    near_x, near_y = player.x + keep * (x - player.x), player.y + keep * (y - player.y)
    return time_to(player, near_x, near_y) + LAG <= seconds
