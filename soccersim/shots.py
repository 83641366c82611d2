"""Passes and shots of a match, from who played the ball when."""

from bisect import bisect_right
from math import hypot

from soccersim.sheet import PHASES
from soccersim.spec.rules import Rules
from soccersim.touches import BallPlay, Kick, Touch

ROLL = 0.5  # m that a ball must have rolled from one mate to the other to be a pass
WIDE = 1.0  # m beside a post that a shot may miss by
ROLLING = 0.6  # share of its speed that a hollow ball keeps when it has come to roll
PENALTY = PHASES.index("penalty")


def passes(play: BallPlay) -> list[Touch]:
    """A ball that a robot gets from a mate, having rolled half a metre at least, with nobody else
    touching it between and no stoppage. Whether it was meant is not known."""
    return [touch for touch in play.touches if _is_pass(play, touch)]


def _is_pass(play: BallPlay, touch: Touch) -> bool:
    if touch.before < 0 or play.sides[touch.before] != play.sides[touch.robot]:
        return False
    x, y = (play.ball[touch.record, :2] - play.ball[touch.left, :2]).tolist()
    return hypot(x, y) >= ROLL


def shots(play: BallPlay) -> list[tuple[Kick, bool]]:
    """Kicks at the opponents' goal, and whether each was on it.

    A shot is a kick from which a goal could count by the rules of the match, after which the ball,
    left alone, would roll over the goal line between the posts (on goal) or within a metre beside
    one, and that no mate gets next. A kick that an opponent stops within 20 ms is none, for nobody
    sees where it would have gone.
    """
    scenario, passed = play.recording.scenario, set(passes(play))
    if scenario.match is None or scenario.ball is None:
        return []
    half_goal, found = scenario.field.goal.width / 2, []
    for kick in play.kicks:
        ahead = float(play.recording.arrays["direction"][play.decision[kick.record]])
        ahead *= 1 - 2 * play.sides[kick.robot]
        crosses = _crosses(play, kick, ahead)
        if crosses is None or crosses > half_goal + WIDE or _next_touch(play, kick) in passed:
            continue
        if _could_count(play, kick, ahead, scenario.match.rules):
            found.append((kick, crosses < half_goal - scenario.ball.radius))
    return found


def _crosses(play: BallPlay, kick: Kick, ahead: float) -> float | None:
    """How far from the goal's middle the ball would cross the goal line, if it got there; m."""
    field = play.recording.scenario.field
    to_go, forward = field.half_length - ahead * kick.x, ahead * kick.vx
    if forward <= 0.0 or to_go <= 0.0:
        return None
    y = kick.y + kick.vy * to_go / forward
    far = hypot(to_go, y - kick.y)
    speed = ROLLING * hypot(kick.vx, kick.vy)
    return abs(y) if speed * speed >= 2 * field.ball_rolling * far else None


def _could_count(play: BallPlay, kick: Kick, ahead: float, rules: Rules) -> bool:
    """Whether the kick was from the right half, and a mate had touched the ball after a restart."""
    if not rules.own_half_goals and ahead * kick.x < 0.0:
        return False
    last = _touch_before(play, kick.record)
    if not rules.pass_at_restart or last is None or last.before >= 0:
        return True
    phase = play.recording.arrays["phase"][play.decision[last.record]]
    return bool(phase == PENALTY)


def _touch_before(play: BallPlay, record: int) -> Touch | None:
    """The last time up to a record that a robot got the ball."""
    after = bisect_right(play.touches, record, key=lambda touch: touch.record)
    return play.touches[after - 1] if after else None


def _next_touch(play: BallPlay, kick: Kick) -> Touch | None:
    """Who got the ball after the kick; None: nobody before the next stoppage, or the kicker."""
    after = bisect_right(play.touches, kick.record, key=lambda touch: touch.record)
    touch = play.touches[after] if after < len(play.touches) else None
    return touch if touch and touch.before == kick.robot else None
