"""Skills: each looks at the view and gives one robot's Command. Built on the public API alone.

Places are in the team frame, m; headings in rad. `player` is one of view.robots. Skills that need
the ball stand still while nobody has seen it. Change what one gives with
dataclasses.replace(command, label="press").
"""

from math import asin, atan2, hypot

from soccersim.strategy.api import Command, Player, View
from soccersim.strategy.motion import (
    distance,
    drive_to,
    since_report,
    time_to,
    towards,
    turn_to,
    velocity,
    wrap,
)
from soccersim.strategy.moves import face, go_to
from soccersim.strategy.openings import (
    RECEIVE,
    best_pass,
    clearance,
    free_goal,
    lead,
    nearest,
    quickest,
)
from soccersim.strategy.restarts import keep_distance, may_play, stand_ready
from soccersim.strategy.rolling import ball_at, kick_speed, meeting
from soccersim.strategy.taking import take, travel

__all__ = [
    "ball_at",
    "best_pass",
    "block",
    "clearance",
    "distance",
    "dribble",
    "face",
    "free_goal",
    "go_to",
    "intercept",
    "keep_distance",
    "kick_at",
    "kick_speed",
    "lead",
    "may_play",
    "meeting",
    "nearest",
    "pass_to",
    "quickest",
    "shoot",
    "stand_ready",
    "stop_shot",
    "time_to",
    "towards",
    "velocity",
    "wrap",
]

Point = tuple[float, float]

CARRY_SPEED = 2.2  # m/s with the ball (CAMBADA's dribble_max_linear_vel)
CARRY_TURN = 3.5  # rad/s with the ball; turned faster, it leaves the mouth
AT_MOUTH = 0.6  # m of air to the ball, from which the dribbler runs
TRIGGER = 0.025  # s from a view to the kick that it leads to; the heading must be right then
SURE, FINE = 0.15, 0.02  # rad, the widest and the finest error of heading with which a robot kicks
HIT = 0.2  # m, by which a pass may miss its mate
JITTER = 0.03  # s, by which a kick may come sooner or later than thought
SHOT = 0.8  # m/s; a ball that comes faster towards the goal is stopped on its way


def intercept(
    view: View, player: Player, aim: Point | None = None, *, avoid: bool = True
) -> Command:
    """Get the ball into the mouth; with it, stand and hold it.

    A rolling ball is met where the robot can first be, mouth towards it. aim: a place that the
    robot shall look at when it takes a ball that lies: it goes round behind the ball.
    """
    ball = view.ball
    if ball is None or player.has_ball:
        return Command(dribble=player.has_ball)
    air = distance(player, ball.x, ball.y) - player.body.radius - view.field.ball_radius
    return Command(*take(view, player, ball, aim, avoid), dribble=air < AT_MOUTH)


def dribble(view: View, player: Player, x: float, y: float, *, avoid: bool = True) -> Command:
    """Carry the ball to a place, mouth ahead; without it, get it first."""
    if not player.has_ball:
        return intercept(view, player, (x, y), avoid=avoid)
    heading = towards(player, x, y) if distance(player, x, y) > 0.5 else player.heading
    twist = travel(view, player, (x, y), heading, avoid, speed=CARRY_SPEED, turn_rate=CARRY_TURN)
    return Command(*twist, dribble=True)


def kick_at(view: View, player: Player, x: float, y: float, speed: float, sure: float) -> Command:
    """Kick the ball to a place at a speed (m/s), once the heading is right within sure (rad).

    The ball keeps the velocity of the mouth, so the robot aims beside the place to make up for
    it. Without the ball: get it first, from behind.
    """
    if not player.has_ball:
        return intercept(view, player, (x, y))
    dx, dy = x - player.x, y - player.y
    far = hypot(dx, dy) or 1.0
    heading = atan2(dy, dx)
    asked = turn_to(player, heading, CARRY_TURN)
    looks, omega = since_report(player, asked)
    vx, vy = velocity(player)
    along, across = (dx * vx + dy * vy) / far, (dx * vy - dy * vx) / far
    across += omega * (player.body.radius + view.field.ball_radius)
    speed = min(max(speed - along, 0.5), player.body.kick_speed)
    beside = asin(min(max(across / speed, -0.5), 0.5))
    off = wrap(heading - beside - looks - omega * TRIGGER)
    ready = abs(off) + JITTER * abs(omega) < min(max(sure, FINE), SURE)
    return Command(omega=asked, kick=speed if ready else 0.0, dribble=True)


def shoot(view: View, player: Player, speed: float | None = None) -> Command:
    """Shoot at the widest free part of the goal; without the ball, get it first.

    speed: m/s, None: as hard as it can. Most rules count no goal from the own half.
    """
    ball = view.ball
    if ball is None:
        return Command()
    x, y = (player.x, player.y) if player.has_ball else (ball.x, ball.y)
    aim, sure = free_goal(view, x, y, player.heading)
    hard = player.body.kick_speed if speed is None else speed
    return kick_at(view, player, view.field.length / 2.0, aim, hard, 0.6 * sure)


def pass_to(view: View, player: Player, mate: Player, arrive: float = RECEIVE) -> Command:
    """Pass to a mate, where it will be, so that the ball arrives at a speed (m/s)."""
    x, y = lead(view, player, mate)
    far = distance(player, x, y)
    return kick_at(view, player, x, y, kick_speed(view.field, far, arrive), HIT / max(far, HIT))


def block(view: View, player: Player, out: float = 1.0, threat: Point | None = None) -> Command:
    """Stand between the ball and the own goal, `out` metres before the middle of the goal line.

    A ball that rolls at the goal is stopped on its way. threat: a place to stand against instead
    of the ball, as where an opponent waits.
    """
    ball, field = view.ball, view.field
    goal = -field.length / 2.0
    if ball is None and threat is None:
        return go_to(view, player, goal + out, 0.0, 0.0)
    if threat is None and ball is not None:
        threat = ball.x, ball.y
        stop = stop_shot(view, player)
        if stop:
            return stop
    x, y = threat or (0.0, 0.0)
    far = hypot(x - goal, y) or 1.0
    out = min(out, max(far - player.body.radius - field.ball_radius, 0.0))
    at = max(goal + out * (x - goal) / far, goal + player.body.radius)
    return Command(*drive_to(player, at, out * y / far, towards(player, x, y)))


def stop_shot(view: View, player: Player) -> Command | None:
    """Get in the way of a ball that rolls into the own goal; None if none does."""
    ball, field = view.ball, view.field
    if ball is None or ball.vx > -SHOT / 2.0:
        return None
    goal = -field.length / 2.0
    speed = hypot(ball.vx, ball.vy)
    seconds = (goal - ball.x) / ball.vx
    crosses = ball.y + ball.vy * seconds
    stops = speed * speed < 2.0 * field.ball_rolling * (speed * seconds)
    if seconds < 0 or stops or speed < SHOT or abs(crosses) > field.goal_width / 2.0 + 0.3:
        return None
    ux, uy = ball.vx / speed, ball.vy / speed
    line = player.body.radius + goal  # no nearer to the goal than that
    along = (player.x - ball.x) * ux + (player.y - ball.y) * uy
    along = min(max(along, 0.0), (line - ball.x) / ux)
    x, y = ball.x + along * ux, ball.y + along * uy
    late = time_to(player, x, y) > along / speed
    twist = drive_to(player, x, y, atan2(-uy, -ux), beyond=1.0 if late else 0.0)
    return Command(*twist, dribble=True)
