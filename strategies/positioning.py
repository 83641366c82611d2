"""Keeper, defender, midfielders, striker: everyone has a way on the field, and stays on it.

The ways are those that Utama et al. drive in their figure 8, as our scenarios `defender`,
`midfielder` and `striker` lay them on the field, stretched to the field that is played on. A robot
stands where its way comes nearest to the ball. It leaves it for a ball on its own beat only, which
it passes forward, in the end to the striker, who shoots.

Its strength: somebody is everywhere, and few meet at the ball. Its weakness: roles never change. A
beat whose robot is beaten, or off the field, stays open, and everybody knows where the pass goes.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import hypot
from typing import NamedTuple

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills

CLEAR = 6.0  # m/s, of a ball kicked ahead to nobody
NARROW = 0.05  # rad, half of the gap in the goal that the striker thinks worth a shot

Point = tuple[float, float]


class Role(NamedTuple):
    """A way and a beat; 1.0 is half the field's length or width."""

    name: str
    start: Point
    end: Point
    beat: Point  # from which x to which x the ball is this robot's


DEFENDER = Role("defender", (-0.56, -0.17), (-0.33, 0.67), (-1.0, -0.1))
MIDFIELDER = Role("midfielder", (-0.33, -0.5), (0.22, 0.33), (-0.5, 0.4))
STRIKER = Role("striker", (0.0, -0.27), (0.78, -0.27), (0.0, 1.0))
OTHER_MIDFIELDER = MIDFIELDER._replace(start=(-0.33, 0.5), end=(0.22, -0.33))
ROLES = (DEFENDER, MIDFIELDER, STRIKER, OTHER_MIDFIELDER)


class Positioning(Strategy):
    """Field players take the roles in the order in which they are listed."""

    def decide(self, view: View) -> Sequence[Command]:
        """One plays the ball, the keeper keeps, the others stand on their ways."""
        team = [player for player in view.robots if player.role == "field"]
        roles = {player.number: ROLES[row % len(ROLES)] for row, player in enumerate(team)}
        on_ball = chosen(view, team, roles)
        commands = []
        for player in view.robots:
            role = roles.get(player.number)
            if role is None:
                command = skills.block(view, player)
            elif player is on_ball:
                command = replace(play(view, player, role), label=role.name + " plays")
            else:
                command = replace(stand(view, player, role), label=role.name)
            commands.append(command)
        return commands


def chosen(view: View, team: list[Player], roles: dict[int, Role]) -> Player | None:
    """Who plays the ball: of those on whose beat it is, the nearest."""
    ball = view.ball
    if ball is None or view.phase is Phase.STOP or view.ours is False:
        return None
    x = 2.0 * ball.x / view.field.length
    beats = {number: role.beat for number, role in roles.items()}
    near = [p for p in team if p.in_play and beats[p.number][0] <= x <= beats[p.number][1]]
    restart = view.phase is not Phase.PLAY
    return skills.nearest(tuple(team if restart or not near else near), ball.x, ball.y)


def play(view: View, player: Player, role: Role) -> Command:
    """Pass forward; the striker shoots, and whoever has nobody before him kicks ahead."""
    goal = view.field.length / 2.0
    mate = forward(view, player)
    x, y = (mate.x, mate.y) if mate else (goal, 0.0)
    if not skills.may_play(view):
        return skills.stand_ready(view, player, x, y)
    if view.phase is Phase.PLAY and player.x > 0:
        _, gap = skills.free_goal(view, player.x, player.y)
        if role is STRIKER or gap > 2 * NARROW:
            return skills.shoot(view, player)
    if mate:
        return skills.pass_to(view, player, mate)
    return skills.kick_at(view, player, x, y, CLEAR, 0.2)


def forward(view: View, player: Player) -> Player | None:
    """The mate nearest to the opponents' goal whom a pass reaches."""
    mates = [p for p in view.robots if p is not player and p.in_play and p.x > player.x + 1.0]
    return max(mates, key=lambda mate: mate.x, default=None)


def stand(view: View, player: Player, role: Role) -> Command:
    """Go to where the own way comes nearest to the ball."""
    half_length, half_width = view.field.length / 2.0, view.field.width / 2.0
    x, y = half_length * role.start[0], half_width * role.start[1]
    if view.ball:
        dx, dy = half_length * role.end[0] - x, half_width * role.end[1] - y
        along = ((view.ball.x - x) * dx + (view.ball.y - y) * dy) / hypot(dx, dy) ** 2
        part = min(max(along, 0.0), 1.0)
        x, y = x + part * dx, y + part * dy
    if view.phase is Phase.PLAY:
        return skills.go_to(view, player, x, y, area=False)
    return skills.keep_distance(view, player, x, y)
