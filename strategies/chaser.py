"""Everybody after the ball, and with it at the goal: how children play.

Its strength: somebody is always at the ball. Its weakness: nobody keeps the goal, nobody waits for
a pass, and five robots at one ball stand in each other's way.
"""

from collections.abc import Sequence

from soccersim.strategy import Ball, Command, Phase, Player, Strategy, View, skills
from soccersim.strategy.manners import careful

HOOF = 6.0  # m/s, of a ball kicked out of the own half, from where no goal counts
EDGE = 0.5  # m before a penalty area, where all but the first wait
FAIR = 0.0  # m of air to an opponent: touch, but do not push


class Chaser(Strategy):
    """One rule for all robots, the keeper too."""

    def decide(self, view: View) -> Sequence[Command]:
        """Chase while the ball is anybody's; at a restart of ours the nearest robot takes it."""
        ball = view.ball
        if ball is None or view.phase in (Phase.STOP, Phase.OVER):
            return [Command() for _ in view.robots]
        first = skills.nearest(view.robots, ball.x, ball.y)
        if view.ours is None and skills.may_play(view):
            return [chase(view, player, ball, player is first) for player in view.robots]
        return [
            take(view, player) if view.ours and player is first else wait(view, player)
            for player in view.robots
        ]


def chase(view: View, player: Player, ball: Ball, first: bool) -> Command:
    """Get the ball; with it, shoot, or out of the own half kick it ahead."""
    if player.has_ball:
        return kick(view, player)
    x, y = outside(view, ball.x, ball.y)
    enters = first or x == ball.x  # only one may follow the ball into a penalty area
    command = kick(view, player) if enters else skills.go_to(view, player, x, y)
    return careful(view, player, command, FAIR)


def kick(view: View, player: Player) -> Command:
    """Shoot where goals count from, else kick ahead; both get the ball first."""
    if view.ours is None and (player.x > 0 or view.field.rules.own_half_goals):
        return skills.shoot(view, player)
    return skills.kick_at(view, player, view.field.length / 2.0, 0.0, HOOF, 0.3)


def take(view: View, player: Player) -> Command:
    """A restart of ours: wait behind the ball for START."""
    if view.started:
        return kick(view, player)
    return skills.stand_ready(view, player, view.field.length / 2.0, 0.0)


def wait(view: View, player: Player) -> Command:
    """Stay away from the ball, as far as the rules ask, and out of the penalty areas."""
    return skills.keep_distance(view, player, *outside(view, player.x, player.y))


def outside(view: View, x: float, y: float) -> tuple[float, float]:
    """The place, or one before the penalty area that it is in."""
    area = view.field.penalty_area
    if area is None or abs(y) > area.width / 2.0 + EDGE:
        return x, y
    most = view.field.length / 2.0 - area.depth - EDGE
    return min(max(x, -most), most), y
