"""The referee: at every decision it looks at the world and rules. It never asks a strategy.

STOP -> signal -> START -> in play -> STOP ...      (the table stands in phases.py)
"""

from math import hypot, pi

import numpy as np

from soccersim.referee.bench import REPAIR, Bench
from soccersim.referee.desk import Desk
from soccersim.referee.events import SIDES, Call, Ruling
from soccersim.referee.fouls import Fouls
from soccersim.referee.ground import Ground
from soccersim.referee.out import CENTRE, ball_out
from soccersim.referee.phases import RULES, TRANSITIONS, Cue, Phase
from soccersim.referee.restarts import Restart
from soccersim.referee.room import Room
from soccersim.referee.scene import Scene
from soccersim.referee.touches import Touch, Touches
from soccersim.referee.watch import Watch
from soccersim.spec.scenario import Scenario
from soccersim.state import Array

TIME = "Law 7: duration of the match"
DISTANCE = "Law 13: distance at restarts"
TAKING = "RC-13.1.2: taking a restart"
PUT_BACK = 0.05  # m by which the ball may have been moved before START (ours)
READY_AFTER, READY_FOR = 1.0, 0.4  # s after the signal, s that all must be ready (ours)


class Referee:
    """The referee of one match. HOME is slot 0 and kicks off the first half."""

    def __init__(self, scenario: Scenario) -> None:
        scene = self.scene = Scene(scenario)
        self.rules = scene.rules
        self.ground, self.room = Ground(scene), Room(scene)
        self.desk = Desk(scene, self.room)
        self.touches, self.fouls = Touches(scene), Fouls(scene, self.ground)
        self.bench = Bench(scenario, scene, self.room)
        self.starts = [scenario.coordinates.field_pose(p.start) for p in scenario.robots]
        self.direction = np.array(scene.direction)  # (2,)  +1.0 where a slot attacks +x
        if scenario.match and scenario.match.swap_ends:
            self._change_ends()
        self.in_play = np.ones(len(self.starts), np.int64)  # (R,)  0: off the field
        self.end = max(1, round(scenario.duration * scene.hz))  # ticks
        self.phase, self.started = Phase.STOP, False
        self.whose: int | None = None  # slot that restarts; None: nobody's, or not yet signalled
        self.score, self.half = (0, 0), 1
        self.stopped = self.until = 0  # tick of the last STOP, tick at which the phase times out
        self.ready_since: int | None = None
        self.restart = self._kick_off("begin", "the match begins", 0)

    def judge(self, tick: int, body: Array, watch: Watch) -> Ruling:
        """What is so now, and what is to be done. body: (R + 1, 6), the ball last; field frame."""
        self.scene.look(tick, body)
        self.desk.open()
        if self.phase is not Phase.OVER:
            self._clock()
            self._bench(watch)
        if self.phase is Phase.PLAY:
            self._play(watch, self.touches.read(watch))
        elif self.phase is Phase.STOP:
            if tick >= self.until:
                self._signal()
        elif self.phase is not Phase.OVER:
            if self.started:
                self._restart(watch)
            elif tick >= self.until or self._is_ready():
                self._start(watch)
        ruling = self.desk.ruling
        ruling.out = tuple(self.bench.back)
        stands = self.phase in (Phase.STOP, Phase.OVER)
        ruling.halted = tuple(self.scene.rows) if stands else ruling.out
        return ruling

    def _cue(self, cue: Cue) -> None:
        self.phase = TRANSITIONS[self.phase][cue]

    def _clock(self) -> None:
        """Half-time and the end: the clock never stops."""
        tick = self.scene.tick
        if tick >= self.end:
            self._cue(Cue.TIME_UP)
            self.whose, self.started = None, False
            text = f"the match ends {self.score[0]}:{self.score[1]}"
            self.desk.say("end", TIME, text, CENTRE)
        elif self.half == 1 and tick >= self.end // 2:
            self.half = 2
            self._change_ends()
            self.desk.line_up(self.starts)
            for row in self.bench.back:
                self.desk.put(row, self.bench.waiting_place(row))
            self._stop(self._kick_off("half_time", "half-time, ends are changed", 1))

    def _change_ends(self) -> None:
        """All starts turned by half a turn, and who attacks where."""
        self.starts = [(-x, -y, heading + pi) for x, y, heading in self.starts]
        self.scene.direction = [-d for d in self.scene.direction]
        self.direction[:] = self.scene.direction

    def _kick_off(self, kind: str, text: str, whose: int) -> Restart:
        call = Call(kind, TIME, text, CENTRE, Phase.KICK_OFF, whose, CENTRE)
        return Restart(self.scene, self.ground, self.room, call)

    def _bench(self, watch: Watch) -> None:
        """Robots that fail go off; those repaired come back."""
        for row, ticks in self.bench.failed():
            self._take_off(row, "failed", "does not answer", watch, ticks)
        for row in self.bench.due():
            pose = self.bench.come_back(row)
            if pose is not None:
                self.desk.put(row, pose)
                self.in_play[row] = watch.active[row] = 1
                text = f"{self.scene.names[row]} comes back"
                self.desk.say("back", REPAIR, text, pose[:2], (row,), self.scene.slot[row])

    def _take_off(self, row: int, kind: str, why: str, watch: Watch, ticks: int = 0) -> None:
        text = f"{self.scene.names[row]} {why} and goes off for repair"
        self.desk.say(kind, REPAIR, text, self.scene.place(row), (row,), self.scene.slot[row])
        self.desk.put(row, self.bench.take_off(row, ticks))
        self.in_play[row] = watch.active[row] = 0

    def _whistle(self, call: Call) -> None:
        """STOP, for this reason."""
        more = ""
        if call.goal is not None:
            home, away = self.score
            self.score = (home + 1, away) if call.goal == 0 else (home, away + 1)
            more = f", {self.score[0]}:{self.score[1]}"
        self.desk.tell(call, more)
        self._stop(Restart(self.scene, self.ground, self.room, call))

    def _stop(self, restart: Restart) -> None:
        self._cue(Cue.WHISTLE)
        if restart.call.kind == "half_time":
            self.desk.tell(restart.call)
        self.restart, self.whose, self.started = restart, None, False
        self.stopped = self.scene.tick
        self.until = self.stopped + self.scene.ticks(self.rules.stop_time)

    def _signal(self) -> None:
        """The signal: the ball lies in its place, robots go to theirs."""
        call, rules, scene = self.restart.call, self.rules, self.scene
        self._cue(Cue(call.restart.value))
        self.whose, self.ready_since = call.whose, None
        kick_off = call.restart is Phase.KICK_OFF
        seconds = rules.kick_off_time if kick_off else rules.restart_time
        self.until = self.stopped + scene.ticks(seconds)
        self.signalled = scene.tick
        if kick_off and rules.restarts == "place":
            self.desk.line_up(self.starts)
        self.desk.put_ball(call.ball)
        if rules.restarts == "place":
            self._carry(0.0)
        of = "" if call.whose is None else f" of {SIDES[call.whose]}"
        text = call.restart.value.replace("_", "-") + of
        self.desk.say(call.restart.value, RULES[call.restart], text, call.ball, (), call.whose)

    def _is_ready(self) -> bool:
        """Whether everybody has stood right for a moment."""
        scene = self.scene
        if not self.restart.is_ready():
            self.ready_since = None
            return False
        if self.ready_since is None:
            self.ready_since = scene.tick
        waited = scene.tick - self.signalled >= scene.ticks(READY_AFTER)
        return waited and scene.tick - self.ready_since >= scene.ticks(READY_FOR)

    def _carry(self, slack: float) -> None:
        """Who stands wrong is carried to the nearest place that is right."""
        for row in self.restart.wrong(slack):
            pose = self.restart.legal_place(row)
            if pose is not None:
                text = f"{self.scene.names[row]} is carried to a legal place"
                at, side = self.scene.place(row), self.scene.slot[row]
                self.desk.say("carried", DISTANCE, text, at, (row,), side)
                self.desk.put(row, pose)

    def _start(self, watch: Watch) -> None:
        """START: the ball may be played."""
        scene, call = self.scene, self.restart.call
        if hypot(scene.x - call.ball[0], scene.y - call.ball[1]) > PUT_BACK:
            self.desk.put_ball(call.ball)
        self._carry(self.rules.slack)
        self.started = True
        self.until = scene.tick + scene.ticks(self.rules.play_time)
        self.restart.taken_by = None
        self.touches.begin(watch, call.whose, call.ball, call.restart is Phase.PENALTY)
        watch.out[0] = watch.pushed[0] = -1.0
        self.desk.say("start", RULES[call.restart], "START", call.ball, (), call.whose)

    def _restart(self, watch: Watch) -> None:
        """After START, until the ball is in play."""
        touches = self.touches.read(watch)
        while touches and self.phase not in (Phase.PLAY, Phase.STOP):
            self._touched(touches.pop(0), watch)
        if self.phase not in (Phase.PLAY, Phase.STOP):
            self._await_play(watch)
        if self.phase is Phase.PLAY:
            self._play(watch, touches)

    def _touched(self, touch: Touch, watch: Watch) -> None:
        """The first touches of a restart: the taker's, and nobody's else before the ball rolls."""
        restart, roll = self.restart, self.rules.roll
        slot = self.scene.slot[touch.robot]
        if self.whose is not None and slot != self.whose:
            self._intrusion([touch.robot], watch)
            if self.phase is Phase.STOP:
                return
            self._in_play("the defenders have played the ball")
        elif restart.taken_by is None:
            restart.taken_by = touch.robot
            if self.whose is None or roll == 0.0:
                self._in_play("the ball is in play")
        elif touch.free >= roll:
            self._in_play("the ball is in play")
        else:
            self._not_released(touch.robot)
            return
        self.touches.take(touch)

    def _await_play(self, watch: Watch) -> None:
        scene, restart, roll = self.scene, self.restart, self.rules.roll
        place = restart.call.ball
        if restart.taken_by is not None:
            x, y = watch.last.tolist()
            if hypot(scene.x - x, scene.y - y) >= roll or watch.out[0] >= 0.0:
                return self._in_play("the ball is in play")
            if hypot(x - place[0], y - place[1]) > roll:
                return self._not_released(restart.taken_by)
        if scene.tick >= self.until or watch.out[0] >= 0.0:
            return self._in_play("the time to take the restart is over")
        intruders = restart.intruders()
        if intruders:
            self._intrusion(intruders, watch)
        return None

    def _in_play(self, text: str) -> None:
        self._cue(Cue.IN_PLAY)
        self.whose, self.started = None, True
        self.fouls.begin()
        call = self.restart.call
        self.desk.say("in_play", RULES[call.restart], text, (self.scene.x, self.scene.y))

    def _not_released(self, row: int) -> None:
        """The taker's team touches the ball before it has rolled: a free kick for the others."""
        slot, at = self.scene.slot[row], (self.scene.x, self.scene.y)
        text = (
            f"{self.scene.names[row]} touches the ball before it has rolled {self.rules.roll:g} m"
        )
        ball = self.ground.free_kick(*at)
        self._whistle(
            Call("double_touch", TAKING, text, at, Phase.FREE_KICK, 1 - slot, ball, (row,), slot)
        )

    def _intrusion(self, rows: list[int], watch: Watch) -> None:
        """Somebody is too near after START: once more, or who defends goes off."""
        restart, scene = self.restart, self.scene
        call = restart.call
        if restart.retakes < self.rules.retakes:
            restart.retakes += 1
            names = ", ".join(scene.names[row] for row in rows)
            text, side = f"{names} too near the ball: once more", scene.slot[rows[0]]
            self.desk.say("too_near", DISTANCE, text, scene.place(rows[0]), tuple(rows), side)
            return self._stop(restart)
        for row in rows:
            if scene.slot[row] != call.whose:
                self._take_off(row, "sent_off", "comes too near again", watch)
        return None

    def _play(self, watch: Watch, touches: list[Touch]) -> None:
        """The ball is in play: lines, fouls, a ball that is stuck, robots that leave."""
        out = watch.out[0]
        for touch in touches:
            if out < 0.0 or touch.tick <= out:
                self.touches.take(touch)
        if out >= 0.0:
            return self._whistle(ball_out(self.scene, self.ground, self.touches, watch))
        call = self.fouls.check(watch)
        if call:
            return self._whistle(call)
        for row in self.fouls.leavers():
            self._take_off(row, "left", "has left the field", watch)
        return None
