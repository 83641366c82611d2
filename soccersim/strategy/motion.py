"""How a robot gets from here to there: as fast as it can and still stop, in spite of the delays."""

from math import atan2, cos, floor, hypot, pi, sin, sqrt

from soccersim.strategy.api import Player

LAG = 0.08  # s from a command to the motion it asks for: radio, half a decision, wheels (estimate)
BRAKING = 0.8  # of its acceleration a robot plans to brake with: the rest corrects its course
TURNING = 0.8  # the same of its turning
GAIN = 3.5  # 1/s, near the goal; the delays allow no more
TURN_GAIN = 5.0  # 1/s; from 6.5 on robots swing to and fro for ever, as their reports are 80 ms old


def wrap(angle: float) -> float:
    """The same direction in [-pi, pi)."""
    return angle - 2.0 * pi * floor((angle + pi) / (2.0 * pi))


def velocity(player: Player) -> tuple[float, float]:
    """A robot's velocity in the team frame, m/s."""
    c, s = cos(player.heading), sin(player.heading)
    return c * player.vx - s * player.vy, s * player.vx + c * player.vy


def towards(player: Player, x: float, y: float) -> float:
    """The heading from a robot's centre to a point, rad."""
    return atan2(y - player.y, x - player.x)


def distance(player: Player, x: float, y: float) -> float:
    """From a robot's centre to a point, m."""
    return hypot(x - player.x, y - player.y)


def pace(far: float, braking: float, gain: float) -> float:
    """The speed from which one can still stop within far: sqrt(2 a d), and gain * d near the end.

    Both meet with one slope at a / gain2 (as the square-root controller of ArduPilot).
    """
    near = braking / (gain * gain)
    return gain * far if far < near else sqrt(2.0 * braking * (far - near / 2.0))


def turn_to(player: Player, heading: float, fastest: float | None = None) -> float:
    """The rate of turning that brings a robot to a heading, rad/s."""
    body = player.body
    most = body.turn_rate if fastest is None else min(fastest, body.turn_rate)
    left = wrap(heading - player.heading - player.omega * LAG)
    rate = min(pace(abs(left), TURNING * body.turn_acceleration, TURN_GAIN), most)
    return rate if left > 0 else -rate


def since_report(player: Player, asked: float) -> tuple[float, float]:
    """Where a robot looks and how fast it turns now, rad and rad/s.

    Its report is old, and carried on as if it had gone on turning as it did; but it follows what
    it is asked for, a rate of turning that hardly changes from one decision to the next.
    """
    most = player.body.turn_acceleration * player.age
    more = min(max(asked - player.omega, -most), most)
    return player.heading + more * player.age / 2.0, player.omega + more


def drive_to(
    player: Player,
    x: float,
    y: float,
    heading: float,
    *,
    speed: float | None = None,
    turn_rate: float | None = None,
    beyond: float = 0.0,
    run: tuple[float, float] = (0.0, 0.0),
) -> tuple[float, float, float]:
    """The twist (body frame) that brings a robot to a point with a heading.

    speed and turn_rate: at most so fast. beyond: metres still to go after the point, so it need
    not stop there. run: the point's own velocity (team frame, m/s), with which it arrives.
    """
    body = player.body
    most = body.speed if speed is None else min(speed, body.speed)
    vx, vy = velocity(player)
    dx = x - player.x - LAG * (vx - run[0])
    dy = y - player.y - LAG * (vy - run[1])
    far = hypot(dx, dy)
    fast = pace(far + beyond, BRAKING * body.acceleration, GAIN) / far if far > 0 else 0.0
    wx, wy = run[0] + fast * dx, run[1] + fast * dy
    wanted = hypot(wx, wy)
    if wanted > most:
        wx, wy = wx * most / wanted, wy * most / wanted
    omega = turn_to(player, heading, turn_rate)
    at = player.heading + player.omega * LAG  # as it will stand when it moves like this
    c, s = cos(at), sin(at)
    return c * wx + s * wy, c * wy - s * wx, omega


def time_to(player: Player, x: float, y: float, *, stop: bool = True) -> float:
    """Seconds a robot needs to a point in a straight line, from the speed it has; s.

    stop: to stand there; else to pass it.
    """
    dx, dy = x - player.x, y - player.y
    far = hypot(dx, dy)
    vx, vy = velocity(player)
    towards_it = (vx * dx + vy * dy) / far if far > 0 else 0.0
    return time_from(far, towards_it, player.body.acceleration, player.body.speed, stop)


def time_from(far: float, u: float, a: float, top: float, stop: bool = True) -> float:
    """Seconds for a way of far metres, begun at the speed u towards its end; a: m/s2."""
    spent = 0.0
    if u < 0:  # it must turn back first
        spent, far, u = -u / a, far + u * u / (2.0 * a), 0.0
    elif u > top:
        u = top
    if not stop:
        gained = min(sqrt(u * u + 2.0 * a * far), top)
        return spent + (gained - u) / a + (far - (gained * gained - u * u) / (2.0 * a)) / top
    if u * u >= 2.0 * a * far:  # it passes the point and comes back
        over = u * u / (2.0 * a) - far
        return spent + u / a + 2.0 * sqrt(over / a)
    peak = min(sqrt(a * far + u * u / 2.0), top)
    cruise = far - (2.0 * peak * peak - u * u) / (2.0 * a)
    return spent + (2.0 * peak - u) / a + (cruise / top if cruise > 0 else 0.0)
