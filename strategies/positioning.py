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
from soccersim.strategy.manners import careful
from soccersim.strategy.places import receiving

CLEAR = 6.0  # m/s, of a ball kicked ahead to nobody
OPEN = 0.1  # rad, half of the gap in the goal at which others than the striker shoot
OUT = 0.9  # m before its line that the keeper stands
FAIR = 0.0  # m of air to an opponent, on the way to the ball

Point = tuple[float, float]


class Role(NamedTuple):
    """A way and a beat; 1.0 is half the field's length or width."""

    name: str
    start: Point
    end: Point
    beat: Point  # from which x to which x the ball is this robot's

    def nearest(self, view: View) -> Point:
        """Where on the way the ball is nearest, m."""
        half_length, half_width = view.field.length / 2.0, view.field.width / 2.0
        x, y = half_length * self.start[0], half_width * self.start[1]
        if view.ball is None:
            return x, y
        dx, dy = half_length * self.end[0] - x, half_width * self.end[1] - y
        along = ((view.ball.x - x) * dx + (view.ball.y - y) * dy) / hypot(dx, dy) ** 2
        part = min(max(along, 0.0), 1.0)
        return x + part * dx, y + part * dy


DEFENDER = Role("defender", (-0.56, -0.17), (-0.33, 0.67), (-1.0, -0.1))
MIDFIELDER = Role("midfielder", (-0.33, -0.5), (0.22, 0.33), (-0.5, 0.4))
STRIKER = Role("striker", (0.0, -0.27), (0.78, -0.27), (0.0, 1.0))
OTHER_MIDFIELDER = MIDFIELDER._replace(start=(-0.33, 0.5), end=(0.22, -0.33))
ROLES = (DEFENDER, MIDFIELDER, STRIKER, OTHER_MIDFIELDER)


class Positioning(Strategy):
    """Field players take the roles in the order in which they are listed."""

    target = 0.0, 0.0  # m, where a restart of ours goes

    def decide(self, view: View) -> Sequence[Command]:
        """One plays the ball, the keeper keeps, the others stand on their ways."""
        if view.ours and not view.started:
            self.target = receiving(view)
        team = [player for player in view.robots if player.role == "field"]
        roles = {player.number: ROLES[row % len(ROLES)] for row, player in enumerate(team)}
        first = on_the_ball(view, team, roles)
        second = skills.nearest([p for p in team if p is not first], *self.target)
        commands = []
        for player in view.robots:
            if player.role == "keeper":
                command = skills.block(view, player, 0.0 if view.phase is Phase.PENALTY else OUT)
            elif player is first and view.ours is None:
                command = play(view, player, roles[player.number])
            elif player is first:
                command = take(view, player, *self.target)
            elif player is second and view.ours:
                command = skills.keep_distance(view, player, *self.target)
            else:
                command = stand(view, player, roles[player.number])
            commands.append(command)
        return commands


def on_the_ball(view: View, team: list[Player], roles: dict[int, Role]) -> Player | None:
    """Who plays the ball: of those on whose beat it is, the nearest; at a restart of all."""
    if view.ball is None or not (view.ours or skills.may_play(view)):
        return None
    x = 2.0 * view.ball.x / view.field.length
    beats = {number: role.beat for number, role in roles.items()}
    on_beat = [p for p in team if p.in_play and beats[p.number][0] <= x <= beats[p.number][1]]
    return skills.nearest(team if view.ours or not on_beat else on_beat, view.ball.x, view.ball.y)


def play(view: View, player: Player, role: Role) -> Command:
    """Get the ball and pass it forward; the striker shoots, others only at an open goal."""
    goal = view.field.length / 2.0
    ahead = [p for p in view.robots if p is not player and p.in_play and p.x > player.x + 1.0]
    mate = max(ahead, key=lambda p: p.x, default=None)
    gap = skills.free_goal(view, player.x, player.y)[1] if player.x > 0.3 else 0.0
    if player.x > 0.3 and (role is STRIKER or gap > OPEN):
        command = skills.shoot(view, player)
    elif mate:
        command = skills.pass_to(view, player, mate)
    else:
        command = skills.kick_at(view, player, goal, 0.0, CLEAR, 0.2)
    if not player.has_ball:
        command = careful(view, player, command, FAIR)
    return replace(command, label=f"{role.name} plays")


def take(view: View, player: Player, x: float, y: float) -> Command:
    """A restart of ours: wait behind the ball for START, then pass."""
    if not view.started:
        return skills.stand_ready(view, player, x, y)
    if view.phase is Phase.PENALTY:
        return skills.shoot(view, player)
    speed = skills.kick_speed(view.field, skills.distance(player, x, y), 1.5)
    return skills.kick_at(view, player, x, y, speed, 0.12)


def stand(view: View, player: Player, role: Role) -> Command:
    """Go to where the own way comes nearest to the ball."""
    if view.phase is Phase.PLAY:
        command = skills.go_to(view, player, *role.nearest(view), area=False)
    else:
        command = skills.keep_distance(view, player, *role.nearest(view))
    return replace(careful(view, player, command), label=role.name)
