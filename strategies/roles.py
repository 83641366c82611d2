"""Roles given anew at every moment: one plays the ball, one guards, the others support or mark.

The robot that can have the ball first plays it: in the opponents' half it shoots at the free part
of the goal, if a goal would count; else it passes to the mate farthest ahead whom a pass reaches,
or kicks the ball forward. Of the others one stays between the ball and the own goal. While the ball
is ours the rest go where a pass can reach them; while it is not, each of them marks an opponent.

Its weakness: it sees this moment only. It gives the ball away rather than carry it, and no move is
planned.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import atan2, cos, hypot, sin
from typing import Any

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills
from soccersim.strategy.manners import careful
from soccersim.strategy.places import Spot, homeward, in_own_area, receiving, share
from soccersim.strategy.possession import Possession

LOYAL = 0.3  # s by which another robot must be sooner at the ball to take over
ARRIVE = 2.6  # m/s, of a pass
CLEAR = 6.0  # m/s, of a ball kicked ahead to nobody
OUT = 0.9  # m before its line that the keeper stands
MARK = 1.2  # m from an opponent to the robot that marks it
TOUCHING = -0.02  # m of air to an opponent, for who fights for the ball
# where mates stand about the ball, the most important first; in lengths and widths of the field
BEHIND = ((-0.2, 0.0), (-0.1, 0.25), (-0.1, -0.25), (-0.3, 0.1), (-0.3, -0.1))
AHEAD = ((0.2, 0.2), (0.2, -0.2), (0.3, 0.0), (0.0, 0.3), (0.0, -0.3))


class Roles(Strategy):
    """Remembers who plays the ball, and whether a goal of his would count."""

    def __init__(self, rng: Any) -> None:
        super().__init__(rng)
        self.ball = Possession()
        self.first: int | None = None  # number of the robot that plays the ball
        self.mate: int | None = None  # number of whom it passes to
        self.target = 0.0, 0.0  # m, where a restart of ours goes

    def decide(self, view: View) -> Sequence[Command]:
        """One plays the ball, the keeper keeps, the others go to the places of this moment."""
        self.ball.update(view)
        first = self.first_at_ball(view)
        if view.ours and not view.started:
            self.target = receiving(view)
        others = [p for p in view.robots if p.role == "field" and p.in_play and p is not first]
        places = share(view, others, self.spots(view))
        return [
            self.play(view, player)
            if player is first
            else skills.block(view, player, 0.0 if view.phase is Phase.PENALTY else OUT)
            if player.role == "keeper"
            else stand(view, player, places.get(player.number))
            for player in view.robots
        ]

    def first_at_ball(self, view: View) -> Player | None:
        """Who can have the ball first; the keeper only in its area."""
        ball, play = view.ball, view.ours is None and skills.may_play(view)
        if ball is None or not (play or view.ours):
            return None
        first, soonest = None, 1e9
        for player in view.robots:
            if player.in_play and (player.role == "field" or (play and in_own_area(view))):
                if player.has_ball:
                    seconds = 0.0
                elif play and hypot(ball.vx, ball.vy) > 0.5:
                    seconds = skills.meeting(view.field, ball, player)[2]
                else:
                    seconds = skills.time_to(player, ball.x, ball.y)
                seconds -= LOYAL * (player.number == self.first)
                if seconds < soonest:
                    first, soonest = player, seconds
        self.first = first.number if first else None
        return first

    def play(self, view: View, player: Player) -> Command:
        """Take a restart, or get the ball and play it on, fair to opponents on the way."""
        x, y = self.target
        if view.ours is None:
            command = self.play_on(view, player)
            return command if player.has_ball else careful(view, player, command, TOUCHING)
        if not view.started:
            return skills.stand_ready(view, player, x, y)
        if view.phase is Phase.PENALTY:
            return skills.shoot(view, player)
        speed = skills.kick_speed(view.field, skills.distance(player, x, y), 1.5)
        return skills.kick_at(view, player, x, y, speed, 0.12)

    def play_on(self, view: View, player: Player) -> Command:
        """Shoot from the opponents' half; else pass ahead, or kick ahead."""
        if player.x > 0.3 and (self.ball.may_score or view.field.rules.own_half_goals):
            return replace(skills.shoot(view, player), label="shoot")
        ahead = [p for p in view.robots if p is not player and p.in_play and p.x > player.x + 1.0]
        clear = [p for p in ahead if skills.clearance(view, player.x, player.y, p.x, p.y, 4.0) > 0]
        chosen = [p for p in clear if p.number == self.mate]  # stay with it: turning takes time
        mate = max(chosen or clear or ahead, key=lambda p: p.x, default=None)
        self.mate = mate.number if mate else None
        if mate:
            return replace(skills.pass_to(view, player, mate, ARRIVE), label="pass")
        goal = view.field.length / 2.0
        return replace(skills.kick_at(view, player, goal, 0.0, CLEAR, 0.2), label="clear")

    def spots(self, view: View) -> list[Spot]:
        """The places of this moment, the most important first."""
        if view.ours:
            return [(*self.target, "receive"), *supports(view)]
        if view.ours is False:
            return wall(view) + supports(view)
        return supports(view) if self.ball.ours else marks(view) + supports(view)[1:]


def supports(view: View) -> list[Spot]:
    """The ball is ours: one behind it, the others where a pass can go."""
    x, y = (view.ball.x, view.ball.y) if view.ball else (0.0, 0.0)
    long, wide = view.field.length, view.field.width
    spots = [(*BEHIND[0], "guard")] + [(*at, "support") for at in AHEAD + BEHIND[1:]]
    return [(x + dx * long, y / 2.0 + dy * wide, name) for dx, dy, name in spots]


def marks(view: View) -> list[Spot]:
    """The ball is theirs: one between it and our goal, the others before who waits for a pass."""
    if view.ball is None:
        return supports(view)[:1]
    x, y = view.ball.x, view.ball.y
    waiting = sorted(view.opponents, key=lambda o: hypot(o.x - x, o.y - y))[1:]
    waiting.sort(key=lambda o: o.x)
    half_way = hypot(x + view.field.length / 2.0, y) / 2.0
    guard = [(*homeward(view, x, y, half_way), "guard")]
    return guard + [(*homeward(view, o.x, o.y, MARK), "mark") for o in waiting]


def wall(view: View) -> list[Spot]:
    """A restart of theirs: one behind, the others as near to the ball as they may."""
    x, y = (view.ball.x, view.ball.y) if view.ball else (0.0, 0.0)
    home = atan2(-y, -view.field.length / 2.0 - x)
    far = view.field.rules.opponents + 0.4
    turns = [home + turn for turn in (0.5, -0.5, 1.2, -1.2, 0.0)]
    guard = [(*homeward(view, x, y, far + 2.5), "guard")]
    return guard + [(x + far * cos(way), y + far * sin(way), "wall") for way in turns]


def stand(view: View, player: Player, spot: Spot | None) -> Command:
    """Go to a place, away from the ball that others play."""
    x, y, name = spot or (player.x, player.y, "")
    if view.phase is Phase.PLAY:
        command = skills.go_to(view, player, x, y, area=False)
    else:
        command = skills.keep_distance(view, player, x, y)
    return replace(careful(view, player, command), label=name)
