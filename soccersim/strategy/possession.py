"""Whose ball it is, where it was caught, and whether a goal of ours would count."""

from math import hypot

from soccersim.strategy.api import Phase, View

BESIDE = 0.55  # m from a robot's centre to a ball that it may have: it touches, or nearly


class Possession:
    """A team's memory of the ball: call `update` once at every decision.

    It goes by what the robots report and see, so it may be wrong where the referee is not.
    """

    def __init__(self) -> None:
        self.holder: int | None = None
        """The number of our robot that has the ball, or had it last; None: the others had it."""
        self.caught = 0.0, 0.0
        """Where that robot was when it got the ball, m."""
        self.may_score = True
        """Whether a goal of that robot counts by what was before: passes asked for were played."""

    @property
    def ours(self) -> bool:
        """Whether our team had the ball last."""
        return self.holder is not None

    def update(self, view: View) -> None:
        """Take in what has happened since the last decision."""
        rules, playing = view.field.rules, view.phase is Phase.PLAY
        if not playing:
            self.holder = None
            self.may_score = not rules.pass_at_restart or view.phase is Phase.PENALTY
        for player in view.robots:
            if player.has_ball and player.in_play:
                if player.number != self.holder:
                    self.holder, self.caught = player.number, (player.x, player.y)
                    if playing:  # passed into the opponents' half, or won there
                        self.may_score = rules.regain_roll is None or player.x > 0.0
                return
        if self.holder and self._theirs(view):
            self.holder = None

    @staticmethod
    def _theirs(view: View) -> bool:
        """Whether an opponent is at the ball and none of ours is."""
        ball = view.ball
        if ball is None:
            return False
        theirs = any(hypot(o.x - ball.x, o.y - ball.y) < BESIDE for o in view.opponents)
        return theirs and not any(hypot(p.x - ball.x, p.y - ball.y) < BESIDE for p in view.robots)
