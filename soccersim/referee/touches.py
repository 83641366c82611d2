"""Who has had the ball since the last restart, and whether a goal would count."""

from typing import NamedTuple

from soccersim.referee.events import SIDES, Place
from soccersim.referee.scene import Scene
from soccersim.referee.watch import LOG, NEVER, Watch

OWN_HALF = "RC-12.3: goals only from the opponents' half"


class Touch(NamedTuple):
    """A robot has got the ball that another had, or has caught it anew."""

    robot: int
    tick: int
    x: float  # of the ball, m; field frame
    y: float
    free: float  # m that it was from where it was touched before
    before: int  # who touched it before; -1: nobody since START


class Touches:
    """The history of the ball from one START on."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.read_to = 0
        self.holder: int | None = None  # slot that has the ball
        self.bound: int | None = None  # slot whose taker must pass before it may score
        self.taker: int | None = None  # row
        self.dropped: int | None = None  # row that alone has touched a dropped ball
        self.drop_pending = False  # a dropped ball that two robots have not touched yet
        self.pass_needed = [False, False]  # slot must pass in the other half before it may score

    def begin(self, watch: Watch, whose: int | None, place: Place, free: bool = False) -> None:
        """START: the ball lies in its place. free: a penalty, from which a goal counts at once."""
        scene, rules = self.scene, self.scene.rules
        self.read_to = int(watch.logged[0])
        watch.latest[0] = -1
        watch.touched[:] = NEVER
        watch.last[0], watch.last[1] = place
        self.holder = whose
        self.bound = whose if rules.pass_at_restart and not free else None
        self.taker = self.dropped = None
        self.drop_pending = whose is None and rules.pass_at_restart
        self.pass_needed = [False, False]
        if whose is not None and rules.regain_roll is not None:
            self.pass_needed[whose] = scene.direction[whose] * place[0] < 0.0

    def read(self, watch: Watch) -> list[Touch]:
        """The touches since the last call, in order, up to where the ball went out."""
        logged = int(watch.logged[0])
        if logged == self.read_to:
            return []
        first = max(self.read_to, logged - LOG)
        self.read_to = logged
        rows = (watch.log[k % LOG].tolist() for k in range(first, logged))
        touches = [Touch(int(r[0]), int(r[1]), r[2], r[3], r[4], int(r[5])) for r in rows]
        out = watch.out[0]
        return [touch for touch in touches if out < 0.0 or touch.tick <= out]

    def take(self, touch: Touch) -> None:
        """Go on in the history by a touch."""
        slot, roll = self.scene.slot[touch.robot], self.scene.rules.regain_roll
        ahead = self.scene.direction[slot] * touch.x
        if self.drop_pending:
            self.drop_pending = self.dropped is None or self.dropped == touch.robot
            self.dropped = touch.robot
        if self.bound is not None:
            if slot != self.bound:
                self.bound = None  # the others have had it
            elif self.taker is None:
                self.taker = touch.robot
            elif touch.robot != self.taker:
                self.bound = None
        if roll is None:
            return
        if slot != self.holder:
            self.pass_needed[slot] = ahead < 0.0
            self.holder = slot
        elif touch.before not in (touch.robot, -1) and touch.free >= roll and ahead > 0.0:
            self.pass_needed[slot] = False

    def no_goal(self, robot: int, attackers: int, kicked_from: float) -> tuple[str, str] | None:
        """Why a ball in the attackers' goal is none: rule and text; None: it counts.

        robot: who touched the ball last, standing at x = kicked_from.
        """
        scene = self.scene
        slot = scene.slot[robot]
        if slot != attackers:  # an own goal, unless straight from a restart
            if self.bound == slot and self.taker == robot:
                return "Law 13: free kick", "straight from a restart into the own goal"
            return None
        if self.drop_pending:
            return "Law 8: dropped ball", "only one robot has touched the dropped ball"
        if self.bound == slot:
            text = f"no other robot of {SIDES[slot]} has touched the ball since the restart"
            return "Law 13: free kick", text
        if not scene.rules.own_half_goals and scene.direction[slot] * kicked_from < 0.0:
            return OWN_HALF, "kicked from the own half"
        if self.pass_needed[slot]:
            return OWN_HALF, "won in the own half and not passed since"
        return None
