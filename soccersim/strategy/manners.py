"""Not running into others: a robot that pushes an opponent gives a free kick away."""

from dataclasses import replace
from math import cos, hypot, sin, sqrt

from soccersim.strategy.api import Command, Player, View
from soccersim.strategy.motion import BRAKING, LAG, velocity

AIR = 0.06  # m between two robots that stand beside each other
NEAR = 2.0  # m; others farther away do not matter
REACTION = LAG + 0.07  # s until it brakes when another does: the opponents' speeds are old news


def careful(view: View, player: Player, command: Command, air: float = AIR) -> Command:
    """The same command, no faster towards another robot than it can stop, should that one brake.

    That is v with v2 / 2a + v t = gap + w2 / 2a, w the speed at which the other moves off.
    """
    c, s = cos(player.heading), sin(player.heading)
    vx, vy = c * command.vx - s * command.vy, s * command.vx + c * command.vy
    clipped = False
    a = BRAKING * player.body.acceleration
    late = a * REACTION
    touch = player.body.radius + air
    bodies = [(o.x, o.y, o.vx, o.vy, touch + player.body.radius) for o in view.opponents]
    for x, y, wx, wy, room in bodies:
        dx, dy = x - player.x, y - player.y
        if abs(dx) > NEAR or abs(dy) > NEAR:
            continue
        far = hypot(dx, dy) or 1.0
        dx, dy = dx / far, dy / far
        closing = vx * dx + vy * dy
        if closing <= 0.0:
            continue
        gap, off = far - room, max(wx * dx + wy * dy, 0.0)
        most = sqrt(late * late + 2.0 * a * max(gap, 0.0) + off * off) - late
        if gap < 0.0:
            most = gap / 0.3
        if closing > most:
            vx, vy = vx + (most - closing) * dx, vy + (most - closing) * dy
            clipped = True
    return replace(command, vx=c * vx + s * vy, vy=c * vy - s * vx) if clipped else command
