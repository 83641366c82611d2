"""From START until the ball is in play: who may touch it, and when it has been taken."""

from math import hypot
from typing import NamedTuple

from soccersim.referee.events import Call
from soccersim.referee.ground import Ground
from soccersim.referee.phases import Phase
from soccersim.referee.restarts import Restart
from soccersim.referee.scene import Scene
from soccersim.referee.touches import Touch, Touches
from soccersim.referee.watch import Watch

TAKING = "RC-13.1.2: taking a restart"


class Played(NamedTuple):
    """The ball is in play."""

    text: str


class Intruded(NamedTuple):
    """Somebody came too near before; touched: he even played the ball."""

    rows: list[int]
    touched: bool


Outcome = Played | Intruded | Call | None


class Taking:
    """How a restart is taken."""

    def __init__(self, scene: Scene, ground: Ground, history: Touches) -> None:
        self.scene, self.ground, self.history = scene, ground, history

    def follow(self, restart: Restart, watch: Watch, touches: list[Touch]) -> Outcome:
        """What has come of it so far; the touches that count for it are taken off the list."""
        while touches:
            outcome = self._touched(restart, touches[0])
            if not isinstance(outcome, Played):
                self.history.take(touches.pop(0))
            if outcome:
                return outcome
        return self._rolled(restart, watch)

    def _touched(self, restart: Restart, touch: Touch) -> Outcome:
        """The taker's touch, and nobody else's before the ball has rolled."""
        scene, whose = self.scene, restart.call.whose
        roll = scene.rules.roll
        if restart.taken_by is not None:
            if touch.free >= roll:
                return Played("the ball is in play")
            if scene.slot[touch.robot] == whose:
                return self._not_released(touch.robot)
        if whose is not None and scene.slot[touch.robot] != whose:
            if scene.rules.retakes is None:
                return Played("the defenders have played the ball")
            return Intruded([touch.robot], True)
        restart.taken_by = touch.robot
        return None

    def _rolled(self, restart: Restart, watch: Watch) -> Outcome:
        """Whether the ball has rolled far enough, freely."""
        scene, place, roll = self.scene, restart.call.ball, self.scene.rules.roll
        is_out = watch.out[0] >= 0.0
        if restart.taken_by is not None:
            x, y = watch.last.tolist()
            dropped = restart.call.restart is Phase.DROPPED_BALL
            if dropped or is_out or hypot(scene.x - x, scene.y - y) >= roll:
                return Played("the ball is in play")
            if hypot(x - place[0], y - place[1]) > roll:
                return self._not_released(restart.taken_by)
        if is_out or self.is_over(restart, scene.tick):
            return Played("the time to take the restart is over")
        intruders = restart.intruders() if self.scene.rules.retakes is not None else []
        return Intruded(intruders, False) if intruders else None

    def is_over(self, restart: Restart, tick: int) -> bool:
        """Whether everybody may play the ball, taken or not."""
        return tick >= restart.started + self.scene.ticks(self.scene.rules.play_time)

    def _not_released(self, row: int) -> Call:
        """The taker's team touches the ball before it has rolled: a free kick for the others."""
        scene = self.scene
        slot, at = scene.slot[row], (scene.x, scene.y)
        text = f"{scene.names[row]} touches the ball before it has rolled {scene.rules.roll:g} m"
        ball = self.ground.free_kick(*at)
        restart = Phase.FREE_KICK
        return Call("double_touch", TAKING, text, at, restart, 1 - slot, ball, (row,), slot)
