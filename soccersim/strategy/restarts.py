"""Where robots stand while the ball is not in play, so that the referee is content."""

from math import atan2, cos, hypot, pi, sin

from soccersim.strategy.api import Command, Phase, Player, View
from soccersim.strategy.motion import GAIN, LAG, pace
from soccersim.strategy.moves import go_to

ROOM = 0.3  # m more than the rules ask: nobody knows exactly where he is
SLOW = 0.3  # m/s
CAUTIOUS = 0.6  # of its acceleration the taker plans to brake with before the ball
PAST = 0.1  # m of air to the ball, past which a robot comes out of a corner
READY = 0.3  # m of air between the ball and the robot that waits to take it
AROUND = tuple(side * step * pi / 8 for step in range(9) for side in (1, -1))  # rad

Point = tuple[float, float]


def may_play(view: View) -> bool:
    """Whether a robot of ours may go for the ball now: play is on, or the restart is ours."""
    if view.phase is Phase.PLAY:
        return True
    return view.started and view.phase not in (Phase.STOP, Phase.OVER) and view.ours is not False


def keep_distance(
    view: View, player: Player, x: float, y: float, far: float | None = None
) -> Command:
    """Go to a place, or as near to it as one may stand at this restart.

    That is away from the ball (far: m; None: what the rules ask, and some room), in the own half
    at a kick-off, out of the penalty areas at a penalty; the keeper may stay in its own.
    """
    x, y = allowed(view, player, x, y)
    ball = view.ball
    if ball is None:
        return go_to(view, player, x, y)
    far = asked(view) if far is None else far
    room = far - ROOM / 2
    off = hypot(player.x - ball.x, player.y - ball.y)
    if off < 0.9 * far:  # out of there first, straight away from the ball, or past it
        x, y = away(view, player, (player.x, player.y), far)
        room = player.body.radius + view.field.ball_radius + PAST
    elif hypot(x - ball.x, y - ball.y) < far:
        x, y = away(view, player, (x, y), far)
    return go_to(view, player, x, y, keep_off=((ball.x, ball.y, room),))


def stand_ready(view: View, player: Player, x: float, y: float) -> Command:
    """Stand behind the ball, looking at a place, ready to kick it there after START."""
    ball = view.ball
    if ball is None:
        return Command()
    dx, dy = x - ball.x, y - ball.y
    far = hypot(dx, dy) or 1.0
    air = player.body.radius + view.field.ball_radius
    back = (air + READY) / far
    runs = LAG * hypot(player.vx, player.vy)
    gap = max(hypot(player.x - ball.x, player.y - ball.y) - air - READY / 2 - runs, 0.0)
    return go_to(
        view,
        player,
        ball.x - back * dx,
        ball.y - back * dy,
        atan2(dy, dx),
        keep_off=((ball.x, ball.y, air + READY / 2),),
        # wherever it is sent next, it can stop before the ball
        speed=max(pace(gap, CAUTIOUS * player.body.acceleration, GAIN), SLOW),
    )


def asked(view: View) -> float:
    """How far from the ball one stands at this restart if one does not take it, m."""
    rules = view.field.rules
    if view.phase is Phase.DROPPED_BALL:
        return rules.dropped_ball + ROOM
    return (rules.mates if view.ours else rules.opponents) + ROOM


def allowed(view: View, player: Player, x: float, y: float) -> Point:
    """The place, or the nearest one that the phase allows, wherever the ball is."""
    field, room = view.field, player.body.radius + ROOM
    if view.phase is Phase.KICK_OFF:
        return min(x, -room), y
    area = field.penalty_area
    if view.phase is Phase.PENALTY and area:
        front = field.length / 2.0 - area.depth - room
        if abs(x) > front and not (player.role == "keeper" and x < 0):
            x = front if x > 0 else -front
    return x, y


def away(view: View, player: Player, start: Point, far: float) -> Point:
    """The place so far from the ball in the direction of start, or the next one that is allowed."""
    ball, field = view.ball, view.field
    if ball is None:
        return start
    way = atan2(start[1] - ball.y, start[0] - ball.x)
    x, y = start
    for turned in AROUND:
        x, y = ball.x + far * cos(way + turned), ball.y + far * sin(way + turned)
        inside = abs(x) < field.length / 2.0 and abs(y) < field.width / 2.0
        if inside and allowed(view, player, x, y) == (x, y):
            break
    return x, y
