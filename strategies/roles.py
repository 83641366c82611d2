"""Roles given anew at every moment: one plays the ball, one guards, the others support or mark.

The robot that can have the ball first plays it: in the opponents' half it shoots, if a goal would
count; else it passes to the mate farthest ahead, or kicks the ball forward. One of the others stays
between the ball and the own goal. With the ball, the rest go where a pass can reach them; without
it, each of them marks an opponent.

Its weakness: it sees this moment only. It gives the ball away rather than carry it, and no move is
planned.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import atan2, cos, hypot, sin

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills
from soccersim.strategy.manners import careful
from soccersim.strategy.possession import Possession

LOYAL = 0.3  # s by which another robot must be sooner at the ball to take over
CLEAR = 6.0  # m/s, of a ball kicked ahead to nobody
OUT = 0.9  # m before its line that the keeper stands
MARK = 1.2  # m from an opponent to the one that marks it
ROOM = 1.1  # m from an opponent to a robot that wants the ball

# where mates stand about the ball, the most important first; in lengths and widths of the field
BEHIND = ((-0.2, 0.0), (-0.1, 0.25), (-0.1, -0.25), (-0.3, 0.1), (-0.3, -0.1))
AHEAD = ((0.2, 0.2), (0.2, -0.2), (0.3, 0.0), (0.0, 0.3), (0.0, -0.3))

Spot = tuple[float, float, str]  # x, y, m; what the robot there is called


class Roles(Strategy):
    """Remembers who plays the ball, and whether a goal of his would count."""

    def __init__(self, rng: object) -> None:
        super().__init__(rng)
        self.ball = Possession()
        self.first: int | None = None  # number of the robot that plays the ball
        self.target = 0.0, 0.0  # where a restart of ours goes, m

    def decide(self, view: View) -> Sequence[Command]:
        """One command a robot."""
        self.ball.update(view)
        first = self.first_at_ball(view)
        if view.ours and not view.started:
            self.target = open_place(view)
        others = [p for p in view.robots if p.role == "field" and p.in_play and p is not first]
        if view.ours:
            spots = [(*self.target, "receive"), *supports(view)]
        elif view.ours is False:
            spots = wall(view)
        else:
            spots = supports(view) if self.ball.ours else marks(view)
        places = share(view, others, spots)
        return [
            self.play(view, player)
            if player is first
            else keep(view, player)
            if player.role == "keeper"
            else stand(view, player, places.get(player.number))
            for player in view.robots
        ]

    def first_at_ball(self, view: View) -> Player | None:
        """Who can have the ball first; the keeper only in its area."""
        ball = view.ball
        restart = view.phase is not Phase.PLAY
        if ball is None or (restart and not view.ours):
            return None
        first, soonest = None, 1e9
        for player in view.robots:
            if player.in_play and (player.role == "field" or (not restart and in_area(view))):
                if player.has_ball:
                    seconds = 0.0
                elif restart or hypot(ball.vx, ball.vy) < 0.5:
                    seconds = skills.time_to(player, ball.x, ball.y)
                else:
                    seconds = skills.meeting(view.field, ball, player)[2]
                seconds -= LOYAL * (player.number == self.first)
                if seconds < soonest:
                    first, soonest = player, seconds
        self.first = first.number if first else None
        return first

    def play(self, view: View, player: Player) -> Command:
        """Shoot from the opponents' half; else pass forward, or kick ahead."""
        if view.phase is not Phase.PLAY:
            return self.restart(view, player)
        rules = view.field.rules
        if player.x > 0.3 and (self.ball.may_score or rules.own_half_goals):
            return replace(skills.shoot(view, player), label="shoot")
        mates = [p for p in view.robots if p is not player and p.in_play and p.x > player.x + 1.0]
        mate = max(mates, key=lambda m: m.x, default=None)
        if mate:
            return replace(skills.pass_to(view, player, mate), label="pass")
        return replace(skills.kick_at(view, player, *goal(view), CLEAR, 0.2), label="clear")

    def restart(self, view: View, player: Player) -> Command:
        """Stand behind the ball, and pass after START."""
        x, y = self.target
        if not view.started:
            return skills.stand_ready(view, player, x, y)
        if view.phase is Phase.PENALTY:
            return skills.shoot(view, player)
        speed = skills.kick_speed(view.field, skills.distance(player, x, y), 1.5)
        return skills.kick_at(view, player, x, y, speed, 0.12)


def open_place(view: View) -> tuple[float, float]:
    """Where a mate receives our restart: back and to the side that is clearer."""
    x, y = (view.ball.x, view.ball.y) if view.ball else (0.0, 0.0)
    far = view.field.rules.mates + 0.7
    places = [(x - 0.6 * far, y + side * 0.8 * far) for side in ((1, -1) if y < 0 else (-1, 1))]
    inside = [p for p in places if abs(p[1]) < view.field.width / 2.0 - 0.5]
    clear = {p: min(skills.clearance(view, x, y, *p, 3.0), 0.5) for p in inside}
    return max(clear, key=lambda p: clear[p], default=(x - far, 0.0))


def keep(view: View, player: Player) -> Command:
    """The keeper stands in the way; at a penalty on its line."""
    return skills.block(view, player, 0.0 if view.phase is Phase.PENALTY else OUT)


def stand(view: View, player: Player, spot: Spot | None) -> Command:
    """Go to a place where others have not the ball."""
    x, y, label = spot or (player.x, player.y, "")
    if view.phase is Phase.PLAY:
        command = skills.go_to(view, player, x, y, area=False)
    else:
        command = skills.keep_distance(view, player, x, y)
    return replace(careful(view, player, command), label=label)


def supports(view: View) -> list[Spot]:
    """With the ball: one behind it, the others where a pass can go."""
    x, y = (view.ball.x, view.ball.y) if view.ball else (0.0, 0.0)
    long, wide = view.field.length, view.field.width
    spots = [(*BEHIND[0], "guard")] + [(*at, "support") for at in AHEAD + BEHIND[1:]]
    return [(x + dx * long, y / 2.0 + dy * wide, label) for dx, dy, label in spots]


def wall(view: View) -> list[Spot]:
    """At a restart of theirs: one behind, the others about the ball as near as they may."""
    if view.ball is None:
        return supports(view)
    x, y = view.ball.x, view.ball.y
    home = atan2(-y, -view.field.length / 2.0 - x)
    far = view.field.rules.opponents + 0.4
    spots = [(*homeward(view, x, y, far + 2.5), "guard")]
    for turn in (0.5, -0.5, 1.2, -1.2, 0.0):
        spots.append((x + far * cos(home + turn), y + far * sin(home + turn), "wall"))
    return spots + supports(view)


def marks(view: View) -> list[Spot]:
    """Without it: one between ball and goal, the others between opponents and goal."""
    if view.ball is None:
        return supports(view)
    x, y = view.ball.x, view.ball.y
    threats = sorted(view.opponents, key=lambda o: hypot(o.x - x, o.y - y))[1:]
    threats.sort(key=lambda o: o.x)
    far = hypot(x + view.field.length / 2.0, y)
    guards = [(*homeward(view, x, y, far / 2.0), "guard")]
    marked = [(*homeward(view, o.x, o.y, MARK), "mark") for o in threats]
    return guards + marked + supports(view)[1:]


def homeward(view: View, x: float, y: float, step: float) -> tuple[float, float]:
    """A place so far from another towards the own goal."""
    home = -view.field.length / 2.0
    far = hypot(x - home, y) or 1.0
    return x + step / far * (home - x), y - step / far * y


def share(view: View, players: list[Player], spots: list[Spot]) -> dict[int, Spot]:
    """Each place, in order, to the robot that is nearest; on the field, off the opponents' area."""
    field, area = view.field, view.field.penalty_area
    most_x = field.length / 2.0 - (area.depth + 0.5 if area else 1.0)
    most_y = field.width / 2.0 - 0.7
    given, free = {}, list(players)
    for x, y, label in spots[: len(players)]:
        x, y = min(max(x, -most_x), most_x), min(max(y, -most_y), most_y)
        x, y = aside(view, x, y)
        player = min(free, key=lambda p: hypot(p.x - x, p.y - y))
        free.remove(player)
        given[player.number] = x, y, label
    return given


def aside(view: View, x: float, y: float) -> tuple[float, float]:
    """The place, or one beside the opponent that stands there."""
    for other in view.opponents:
        far = hypot(x - other.x, y - other.y)
        if 0.0 < far < ROOM:
            return other.x + ROOM / far * (x - other.x), other.y + ROOM / far * (y - other.y)
    return x, y


def goal(view: View) -> tuple[float, float]:
    """The middle of the opponents' goal."""
    return view.field.length / 2.0, 0.0


def in_area(view: View) -> bool:
    """Whether the ball is in the own penalty area, or where it would be."""
    area = view.field.penalty_area
    deep, wide = (area.depth, area.width) if area else (1.5, 4.0)
    return view.ball.x < deep - view.field.length / 2.0 and abs(view.ball.y) < wide / 2.0
