"""Everybody after the ball, and with it at the goal: how children play.

Its strength: somebody is always at the ball. Its weakness: nobody keeps the goal, nobody waits for
a pass, and five robots at one ball stand in each other's way.
"""

from collections.abc import Sequence

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills

HOOF = 6.0  # m/s, of a ball kicked out of the own half, from where no goal counts
EDGE = 0.5  # m that robots wait before a penalty area, into which only one may follow the ball


class Chaser(Strategy):
    """One rule for all robots, the keeper too."""

    def decide(self, view: View) -> Sequence[Command]:
        """Chase while play is on; at a restart of ours the nearest robot takes it."""
        ball = view.ball
        if ball is None or view.phase in (Phase.STOP, Phase.OVER):
            return [Command() for _ in view.robots]
        first = skills.nearest(view.robots, ball.x, ball.y)
        return [
            chase(view, player, player is first)
            if view.phase is Phase.PLAY
            else take(view, player)
            if player is first and view.ours is not False
            else skills.keep_distance(view, player, *outside(view, player.x, player.y))
            for player in view.robots
        ]


def chase(view: View, player: Player, first: bool) -> Command:
    """Get the ball; with it, shoot, or out of the own half kick it ahead."""
    x, y = outside(view, view.ball.x, view.ball.y)
    if x != view.ball.x and not first:
        return skills.go_to(view, player, x, y)
    return kick(view, player)


def kick(view: View, player: Player) -> Command:
    """Shoot where goals count from, else kick ahead."""
    if view.phase is Phase.PLAY and (player.x > 0 or view.field.rules.own_half_goals):
        return skills.shoot(view, player)
    return skills.kick_at(view, player, view.field.length / 2.0, 0.0, HOOF, 0.3)


def take(view: View, player: Player) -> Command:
    """A restart of ours: wait behind the ball for START."""
    if not view.started:
        return skills.stand_ready(view, player, view.field.length / 2.0, 0.0)
    return kick(view, player)


def outside(view: View, x: float, y: float) -> tuple[float, float]:
    """The place, or one before the penalty area that it is in."""
    area = view.field.penalty_area
    if area is None or abs(y) > area.width / 2.0 + EDGE:
        return x, y
    most = view.field.length / 2.0 - area.depth - EDGE
    return min(max(x, -most), most), y
