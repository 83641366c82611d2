"""The ball over a line: a goal or none, and whose throw-in, goal kick or corner it is."""

from soccersim.referee.events import SIDES, Call, Place
from soccersim.referee.ground import Ground
from soccersim.referee.phases import Phase
from soccersim.referee.scene import Scene
from soccersim.referee.touches import Touches
from soccersim.referee.watch import GOAL, TOUCH_LINE, Watch

CENTRE: Place = (0.0, 0.0)
SCORING, OUT = "Law 10: method of scoring", "Law 9: ball out of play"


def ball_out(scene: Scene, ground: Ground, touches: Touches, watch: Watch) -> Call:
    """The whistle for the ball that watch saw going out."""
    _, kind, x, y, touched = watch.out.tolist()
    last = int(touched)
    if kind == GOAL:
        kicked_from = float(watch.kicker[last, 0]) if last >= 0 else 0.0
        return _in_goal(scene, ground, touches, (x, y), last, kicked_from)
    if last < 0:
        text = "nobody has touched the ball that went out"
        restart, ball = Phase.DROPPED_BALL, ground.dropped(x, y)
        return Call("out", OUT, text, (x, y), restart, None, ball)
    loser, name = scene.slot[last], scene.names[last]
    if kind == TOUCH_LINE:
        restart, ball, line = Phase.THROW_IN, ground.throw_in(x, y), "the touch line"
    elif scene.direction[loser] * x > 0.0:
        restart, ball, line = Phase.GOAL_KICK, ground.goal_kick(x, y), "the goal line"
    else:
        restart, ball, line = Phase.CORNER, ground.corner(x, y), "their own goal line"
    text = f"over {line}, last touched by {name}"
    return Call("out", OUT, text, (x, y), restart, 1 - loser, ball, (last,), loser)


def _in_goal(
    scene: Scene, ground: Ground, touches: Touches, at: Place, last: int, kicked_from: float
) -> Call:
    attackers = 0 if scene.direction[0] * at[0] > 0.0 else 1
    no_goal = ("Law 9: ball out of play", "nobody has touched the ball")
    if last >= 0:
        reason = touches.no_goal(last, attackers, kicked_from)
        if reason is None:
            own = "own goal" if scene.slot[last] != attackers else "goal"
            text = f"{own} by {scene.names[last]} for {SIDES[attackers]}"
            return Call(
                "goal",
                SCORING,
                text,
                at,
                Phase.KICK_OFF,
                1 - attackers,
                CENTRE,
                (last,),
                attackers,
                goal=attackers,
            )
        no_goal = reason
    rule, text = no_goal
    if last >= 0 and scene.slot[last] != attackers:
        restart, whose, ball = Phase.CORNER, attackers, ground.corner(*at)
    else:
        restart, whose, ball = Phase.GOAL_KICK, 1 - attackers, ground.goal_kick(*at)
    robots = (last,) if last >= 0 else ()
    side = scene.slot[last] if last >= 0 else None
    return Call("no_goal", rule, f"no goal: {text}", at, restart, whose, ball, robots, side)
