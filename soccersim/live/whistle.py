"""A referee who also obeys the buttons of the league's referee box.

Between two buttons it judges as ever. After STOP it waits for the next button, as in the league,
where the referee box gives every signal.
"""

from collections import deque

from soccersim.live.messages import Referee as Button
from soccersim.live.messages import Wrong
from soccersim.referee.events import SIDES, Call, Place
from soccersim.referee.judge import Referee
from soccersim.referee.out import CENTRE
from soccersim.referee.phases import RESTARTS, RULES, Cue, Phase
from soccersim.referee.watch import Watch
from soccersim.spec.scenario import Scenario

BOX = "referee box"
SIDED = (
    *("kick_off", "free_kick", "goal_kick", "throw_in", "corner", "penalty"),
    *("goal", "subgoal"),
)
LATER = 2**53  # a tick that nobody will see
MOST = 20  # buttons that wait for the next decision


class Whistle(Referee):
    """The referee of a live match."""

    def __init__(self, scenario: Scenario) -> None:
        super().__init__(scenario)
        self._pressed: deque[Button] = deque(maxlen=MOST)

    def press(self, button: Button) -> None:
        """A button, heard at the next decision; Wrong where it makes no sense."""
        if self.phase is Phase.OVER:
            raise Wrong("referee: the match is over")
        if button.call in SIDED and button.side is None:
            raise Wrong(f"referee: {button.call} needs a side: home or away")
        if button.call == "repair" and button.robot is None:
            raise Wrong("referee: repair needs a robot")
        if button.call == "subgoal" and not self.score[SIDES.index(button.side or "home")]:
            raise Wrong(f"referee: {button.side} has no goal to take back")
        if button.call == "penalty" and self.ground.mark is None:
            raise Wrong("referee: this field has no penalty mark")
        if button.call == "half_time" and self.half == 2:
            raise Wrong("referee: it is the second half already")
        if button.call == "start" and self.phase is Phase.PLAY:
            raise Wrong("referee: the ball is in play")
        self._pressed.append(button)

    def _go_on(self, watch: Watch) -> None:
        """First what was pressed."""
        if not self._pressed:
            super()._go_on(watch)
            return
        button = self._pressed.popleft()
        if button.call == "start":
            self._started(watch)
        elif button.call == "repair":
            row = button.robot or 0
            self.bench.take_off(row, "repair", "is called off for repair", watch)
        elif button.call == "subgoal":
            self._take_back(SIDES.index(button.side or "home"))
        elif button.call == "half_time":
            self._halve()
        elif button.call == "end":
            self.end = self.scene.tick
            self._clock()
        else:
            self._whistle(self._call(button))
            if button.call == "stop":
                self.until = LATER
            elif button.call != "goal":
                self.until = self.scene.tick  # the signal comes with the next decision

    def _started(self, watch: Watch) -> None:
        """START, after the signal where that has not been given."""
        if self.phase is Phase.STOP:
            self._signal()
        if self.phase in RESTARTS and not self.started:
            self._start(watch)

    def _take_back(self, slot: int) -> None:
        """A goal of this slot does not count after all; play goes on as it is."""
        goals = [*self.score]
        goals[slot] = max(0, goals[slot] - 1)
        self.score = goals[0], goals[1]
        text = f"a goal of {SIDES[slot]} is taken back, {goals[0]}:{goals[1]}"
        self.desk.say("subgoal", BOX, text, (self.scene.x, self.scene.y), (), slot)

    def _halve(self) -> None:
        """The second half begins; it lasts as long as the clock says."""
        self.end = max(self.end, 2 * self.scene.tick)
        clock, self.end = self.end, min(self.end, 2 * self.scene.tick)
        self._clock()
        self.end = clock

    def _call(self, button: Button) -> Call:
        """The button as a whistle."""
        at = self.scene.x, self.scene.y
        slot = None if button.side is None else SIDES.index(button.side)
        if button.call == "goal" and slot is not None:
            text = f"goal for {SIDES[slot]}"
            return Call(
                "goal", BOX, text, at, Phase.KICK_OFF, 1 - slot, CENTRE, side=slot, goal=slot
            )
        if button.call in ("stop", "dropped_ball") or slot is None:
            ball = self.ground.dropped(*at)
            return Call("stop", BOX, "the referee stops play", at, Phase.DROPPED_BALL, None, ball)
        restart = Phase(Cue(button.call).value)
        text = f"the referee gives a {button.call.replace('_', '-')} to {SIDES[slot]}"
        ball = self._spot(restart, slot)
        return Call(button.call, RULES[restart], text, at, restart, slot, ball, side=slot)

    def _spot(self, restart: Phase, slot: int) -> Place:
        """Where this restart of this slot is, for a ball that lies where it does."""
        ground, ahead = self.ground, self.scene.direction[slot]
        x, y = self.scene.x, self.scene.y
        if restart is Phase.FREE_KICK:
            return ground.free_kick(x, y)
        if restart is Phase.THROW_IN:
            return ground.throw_in(x, y)
        if restart is Phase.GOAL_KICK:
            return ground.goal_kick(-ahead * ground.half_length, y)
        if restart is Phase.CORNER:
            return ground.corner(ahead * ground.half_length, y)
        if restart is Phase.PENALTY:
            return ahead * (ground.mark or 0.0), 0.0
        return CENTRE
