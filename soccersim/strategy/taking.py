"""How a robot comes to the ball so that it ends in its mouth: twists in the body frame."""

from math import atan2, hypot

from soccersim.strategy import paths
from soccersim.strategy.api import Ball, Pitch, Player, View
from soccersim.strategy.motion import GAIN, drive_to
from soccersim.strategy.rolling import meeting

EDGE = 0.5  # m from a line, within which a ball is taken so that it does not roll over it
INWARDS = 0.3  # of the direction in which it is taken there

Twist = tuple[float, float, float]  # m/s, m/s, rad/s; body frame
Point = tuple[float, float]

LYING = 0.5  # m/s; a slower ball is taken where it lies: nobody knows its speed so well
TOUCH = 0.6  # m/s over the ball's speed, with which a robot comes to it: it hardly bounces off
DEEPER = TOUCH / GAIN  # m beyond the ball's edge that the robot steers for, to be so fast
AT_HAND = 0.7  # s to the ball: nearer, it is run down instead of waited for
FRONTAL = 0.7  # cosine: a ball that comes at the robot so straight is waited for
IN_LINE = 0.06  # m aside of it at which the mouth still takes the ball
BEHIND = 0.6  # m aside of the line through the ball, per metre behind it: more, go round it
STAND_OFF = 0.1  # m of air between robot and ball on the way round it
SLOPE = 2.0  # m farther behind the ball for each metre aside of the line


def take(view: View, player: Player, ball: Ball, aim: Point | None, avoid: bool) -> Twist:
    """Come to the ball, wherever it lies or rolls."""
    speed = hypot(ball.vx, ball.vy)
    if speed < LYING:
        return fetch(view, player, ball, aim, avoid)
    x, y, seconds = meeting(view.field, ball, player)
    off = hypot(ball.x - player.x, ball.y - player.y)
    comes = (player.x - ball.x) * ball.vx + (player.y - ball.y) * ball.vy
    if comes > FRONTAL * speed * off:
        return stop_in_its_way(view, player, ball, (x, y), avoid)
    if seconds < AT_HAND:
        return run_down(view, player, ball)
    heading = atan2(ball.y - player.y, ball.x - player.x)
    return travel(view, player, (x, y), heading, avoid)


def fetch(view: View, player: Player, ball: Ball, aim: Point | None, avoid: bool) -> Twist:
    """Take a ball that lies: from behind it, as seen towards the aim, or straight."""
    reach = player.body.radius + view.field.ball_radius
    ahead_x, ahead_y = ball.x - player.x, ball.y - player.y
    if aim:
        to_x, to_y = aim[0] - ball.x, aim[1] - ball.y
    else:
        to_x, to_y = ahead_x, ahead_y
    to_x, to_y = off_the_line(view.field, ball, to_x, to_y)
    heading = atan2(to_y, to_x)
    back = ahead_x * to_x + ahead_y * to_y  # how far the robot is behind the ball
    aside = abs(ahead_x * to_y - ahead_y * to_x)
    if aside > max(BEHIND * back, 0.05):
        behind = reach + STAND_OFF + 0.05
        target = ball.x - behind * to_x, ball.y - behind * to_y
        round_it = (ball.x, ball.y, reach + STAND_OFF)
        return travel(view, player, target, heading, avoid, (round_it,))
    behind = reach - DEEPER + min(SLOPE * max(aside - IN_LINE, 0.0), STAND_OFF + DEEPER)
    target = ball.x - behind * to_x, ball.y - behind * to_y
    return travel(view, player, target, heading, avoid)


def off_the_line(field: Pitch, ball: Ball, x: float, y: float) -> Point:
    """The direction (x, y) as a unit vector, turned so that a push does not roll the ball out."""
    far = hypot(x, y)
    x, y = (x / far, y / far) if far > 0 else (1.0, 0.0)
    if not field.rules.lines:
        return x, y
    if abs(ball.y) > field.width / 2.0 - EDGE and y * ball.y > 0:
        y = -INWARDS if ball.y > 0 else INWARDS
    behind = abs(ball.x) > field.length / 2.0 - EDGE and x * ball.x > 0
    if behind and not (ball.x > 0 and abs(ball.y) < field.goal_width / 2.0):
        x = -INWARDS if ball.x > 0 else INWARDS
    far = hypot(x, y)
    return x / far, y / far


def stop_in_its_way(view: View, player: Player, ball: Ball, meet: Point, avoid: bool) -> Twist:
    """Stand in the way of a ball that comes, mouth towards it."""
    reach = player.body.radius + view.field.ball_radius
    speed = hypot(ball.vx, ball.vy)
    ux, uy = ball.vx / speed, ball.vy / speed
    target = meet[0] + reach * ux, meet[1] + reach * uy
    return travel(view, player, target, atan2(-uy, -ux), avoid)


def run_down(view: View, player: Player, ball: Ball) -> Twist:
    """Run up to a ball that rolls by or away, and at last with it."""
    reach = player.body.radius + view.field.ball_radius
    dx, dy = ball.x - player.x, ball.y - player.y
    far = hypot(dx, dy) or 1.0
    part = (reach - DEEPER) / far
    run = ball.vx, ball.vy
    return drive_to(player, ball.x - part * dx, ball.y - part * dy, atan2(dy, dx), run=run)


def travel(
    view: View,
    player: Player,
    target: Point,
    heading: float,
    avoid: bool,
    keep_off: tuple[paths.Disc, ...] = (),
    *,
    speed: float | None = None,
    turn_rate: float | None = None,
) -> Twist:
    """Go to a place with a heading, round what is in the way."""
    x, y = target
    beyond = 0.0
    discs = [*keep_off, *paths.others(view, player)] if avoid else keep_off
    if discs:
        x, y, beyond, fast = paths.next_point(view, player, x, y, discs)
        speed = fast if speed is None else min(speed, fast)
    return drive_to(player, x, y, heading, speed=speed, turn_rate=turn_rate, beyond=beyond)
