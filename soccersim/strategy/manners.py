"""Not running into opponents: who pushes one gives a free kick away."""

from dataclasses import replace
from math import cos, hypot, sin, sqrt

from soccersim.strategy.api import Command, Player, View
from soccersim.strategy.motion import BRAKING, LAG

AIR = 0.06  # m left between two robots
NEAR = 2.0  # m; opponents farther away do not matter
REACTION = LAG + 0.07  # s until a robot brakes when another does, whose speed is old news
BACK_OFF = 3.0  # 1/s, with which too little air is made more


def careful(view: View, player: Player, command: Command, air: float = AIR) -> Command:
    """The same command, but no faster towards an opponent than the robot can stop, if that brakes.

    That is v with v t + v2 / 2a = gap + w2 / 2a, w how fast the opponent moves off. air: m that is
    left between the two; below 0, they may touch.
    """
    c, s = cos(player.heading), sin(player.heading)
    vx, vy = c * command.vx - s * command.vy, s * command.vx + c * command.vy
    a = BRAKING * player.body.acceleration
    late, touch = a * REACTION, 2.0 * player.body.radius + air
    changed = False
    for other in view.opponents:
        dx, dy = other.x - player.x, other.y - player.y
        if abs(dx) > NEAR or abs(dy) > NEAR:
            continue
        far = hypot(dx, dy) or 1.0
        dx, dy = dx / far, dy / far
        closing, gap = vx * dx + vy * dy, far - touch
        if closing <= 0.0:
            continue
        off = max(other.vx * dx + other.vy * dy, 0.0)
        most = sqrt(late * late + 2.0 * a * max(gap, 0.0) + off * off) - late
        most = most if gap > 0.0 else BACK_OFF * gap
        if closing > most:
            vx, vy = vx + (most - closing) * dx, vy + (most - closing) * dy
            changed = True
    return replace(command, vx=c * vx + s * vy, vy=c * vy - s * vx) if changed else command
