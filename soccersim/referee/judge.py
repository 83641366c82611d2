"""The referee: at every decision it looks at the world and rules. It never asks a strategy.

STOP -> signal -> START -> in play -> STOP ...: the table stands in phases.py.
"""

from math import hypot, pi

import numpy as np

from soccersim.geometry import wrap_angle
from soccersim.referee.bench import Bench
from soccersim.referee.desk import Desk
from soccersim.referee.events import SIDES, Call, Ruling
from soccersim.referee.fouls import Fouls
from soccersim.referee.ground import Ground
from soccersim.referee.out import CENTRE, ball_out
from soccersim.referee.phases import RULES, TRANSITIONS, Cue, Phase
from soccersim.referee.restarts import Restart
from soccersim.referee.room import Room
from soccersim.referee.scene import Scene
from soccersim.referee.taking import Intruded, Played, Taking
from soccersim.referee.touches import Touch, Touches
from soccersim.referee.watch import Watch
from soccersim.spec.scenario import Scenario
from soccersim.state import Array

TIME = "Law 7: duration of the match"
DISTANCE = "Law 13: distance at restarts"
PUT_BACK = 0.05  # m by which the ball may have been moved before START (ours)


class Referee:
    """The referee of one match. HOME is slot 0 and kicks off the first half."""

    def __init__(self, scenario: Scenario) -> None:
        scene = self.scene = Scene(scenario)
        self.rules = scene.rules
        self.ground, self.room = Ground(scene), Room(scene)
        self.desk = Desk(scene, self.room)
        self.bench = Bench(scenario, scene, self.room, self.desk)
        self.touches, self.fouls = Touches(scene), Fouls(scene, self.ground)
        self.taking = Taking(scene, self.ground, self.touches)
        self.in_play = self.bench.in_play  # (R,)  0: off the field
        self.direction = np.array(scene.direction)  # (2,)  +1.0 where a slot attacks +x
        self.starts = [scenario.coordinates.field_pose(p.start) for p in scenario.robots]
        self.others = [(-x, -y, float(wrap_angle(turn + pi))) for x, y, turn in self.starts]
        if scenario.match and scenario.match.swap_ends:
            self._change_ends()
        self.end = max(1, round(scenario.duration * scene.hz))  # ticks
        self.phase, self.started = Phase.STOP, False
        self.whose: int | None = None  # slot that restarts; None: nobody's, or not yet signalled
        self.score, self.half = (0, 0), 1
        self.until = 0  # tick at which the phase times out
        self.restart = self._prepared(self._kick_off("begin", "the match begins", 0))

    def judge(self, tick: int, body: Array, watch: Watch) -> Ruling:
        """What is so now, and what is to be done. body: (R + 1, 6), the ball last; field frame."""
        self.scene.look(tick, body)
        self.desk.open()
        if self.phase is Phase.PLAY and self._time_is_up():
            self._play(watch, self.touches.read(watch))  # what came before the whistle counts
        if self.phase is not Phase.OVER:
            self._clock()
        if self.phase is not Phase.OVER:
            self.bench.update(watch)
            self._go_on(watch)
        ruling = self.desk.ruling
        ruling.out = tuple(self.bench.back)
        stands = self.phase in (Phase.STOP, Phase.OVER)
        ruling.halted = tuple(self.scene.rows) if stands else ruling.out
        return ruling

    def _go_on(self, watch: Watch) -> None:
        """What the phase asks for."""
        late = self.scene.tick >= self.until
        if self.phase is Phase.PLAY:
            self._play(watch, self.touches.read(watch))
        elif self.phase is Phase.STOP:
            if late:
                self._signal()
        elif self.started:
            self._follow(watch)
        elif late or self.restart.is_ready():
            self._start(watch)

    def _cue(self, cue: Cue) -> None:
        self.phase = TRANSITIONS[self.phase][cue]

    def _time_is_up(self) -> bool:
        """Whether this half is over."""
        return self.scene.tick >= (self.end if self.half == 2 else self.end // 2)

    def _clock(self) -> None:
        """Half-time and the end: the clock never stops."""
        if self.scene.tick >= self.end:
            self._cue(Cue.TIME_UP)
            self.whose, self.started = None, False
            self.desk.say("end", TIME, f"the match ends {self._standing()}", CENTRE)
        elif self.half == 1 and self._time_is_up():
            self.half = 2
            self._change_ends()
            text = f"half-time at {self._standing()}, ends are changed"
            self._whistle(self._kick_off("half_time", text, 1))
            self.desk.line_up(self.starts)
            self.bench.change_ends()

    def _standing(self) -> str:
        return f"{self.score[0]}:{self.score[1]}"

    def _change_ends(self) -> None:
        """All starts turned by half a turn, and who attacks where."""
        self.starts, self.others = self.others, self.starts
        self.scene.direction = [-d for d in self.scene.direction]
        self.direction[:] = self.scene.direction

    def _kick_off(self, kind: str, text: str, whose: int) -> Call:
        return Call(kind, TIME, text, CENTRE, Phase.KICK_OFF, whose, CENTRE)

    def _prepared(self, call: Call) -> Restart:
        return Restart(self.scene, self.ground, self.room, call)

    def _whistle(self, call: Call) -> None:
        """STOP, for this reason."""
        more = ""
        if call.goal is not None:
            home, away = self.score
            self.score = (home + 1, away) if call.goal == 0 else (home, away + 1)
            more = f", {self._standing()}"
        self.desk.say(call.kind, call.rule, call.text + more, call.at, call.robots, call.side)
        self._stop(self._prepared(call))

    def _stop(self, restart: Restart) -> None:
        """STOP; then this restart."""
        self._cue(Cue.WHISTLE)
        self.restart, self.whose, self.started = restart, None, False
        restart.stopped = self.scene.tick
        self.until = restart.stopped + self.scene.ticks(self.rules.stop_time)

    def _signal(self) -> None:
        """The signal: the ball lies in its place, robots go to theirs."""
        restart, rules = self.restart, self.rules
        call = restart.call
        self._cue(Cue(call.restart.value))
        restart.signal()
        self.whose = call.whose
        kick_off, places = call.restart is Phase.KICK_OFF, rules.restarts == "place"
        seconds = rules.kick_off_time if kick_off else rules.restart_time
        self.until = restart.stopped + self.scene.ticks(seconds)
        of = "" if call.whose is None else f" of {SIDES[call.whose]}"
        self._say(call.restart.value, f"{call.restart.value.replace('_', '-')}{of}")
        if kick_off and places:
            self.desk.line_up(self.starts)
        self.desk.put_ball(call.ball)
        if places:
            self._carry(0.0, "placed", "is put where it may stand")

    def _say(self, kind: str, text: str) -> None:
        """Something about the restart."""
        call = self.restart.call
        self.desk.say(kind, RULES[call.restart], text, call.ball, (), call.whose)

    def _carry(self, slack: float, kind: str, what: str) -> None:
        """Who stands wrong is carried to the nearest place where he may stand."""
        for row, pose in self.restart.carried(slack):
            at, text = self.scene.place(row), f"{self.scene.names[row]} {what}"
            self.desk.say(kind, DISTANCE, text, at, (row,), self.scene.slot[row])
            self.desk.put(row, pose)

    def _start(self, watch: Watch) -> None:
        """START: the ball may be played."""
        scene, call = self.scene, self.restart.call
        if hypot(scene.x - call.ball[0], scene.y - call.ball[1]) > PUT_BACK:
            self.desk.put_ball(call.ball)
        self._carry(self.rules.slack, "carried", "stands wrong at START and is carried away")
        self.started, self.restart.started = True, scene.tick
        self.touches.begin(watch, call.whose, call.ball, call.restart is Phase.PENALTY)
        watch.out[0] = watch.pushed[0] = -1.0
        watch.shove[:] = 0.0
        self._say("start", "START")

    def _follow(self, watch: Watch) -> None:
        """After START, until the ball is in play."""
        touches = self.touches.read(watch)
        outcome = self.taking.follow(self.restart, watch, touches)
        if isinstance(outcome, Call):
            self._whistle(outcome)
        elif isinstance(outcome, Intruded):
            self._intruded(outcome, watch)
        elif isinstance(outcome, Played):
            self._played(outcome)
            self._play(watch, touches)

    def _intruded(self, outcome: Intruded, watch: Watch) -> None:
        """Somebody was too near: once more; in the end, defenders go off and play goes on."""
        restart, scene, rows = self.restart, self.scene, outcome.rows
        if restart.retakes < (self.rules.retakes or 0):
            restart.retakes += 1
            names = ", ".join(scene.names[row] for row in rows)
            text = f"{names} too near the ball: the restart is taken again"
            at, side = scene.place(rows[0]), scene.slot[rows[0]]
            self.desk.say("too_near", DISTANCE, text, at, tuple(rows), side)
            self._stop(restart)
            return
        for row in rows:
            if scene.slot[row] != restart.call.whose:
                self.bench.take_off(row, "sent_off", "comes too near again", watch)
        if outcome.touched:
            self._played(Played("the defenders have played the ball"))

    def _played(self, outcome: Played) -> None:
        self._say("in_play", outcome.text)
        self._cue(Cue.IN_PLAY)
        self.whose = None
        self.fouls.begin()

    def _play(self, watch: Watch, touches: list[Touch]) -> None:
        """The ball is in play: lines, fouls, a ball that is stuck, robots that leave."""
        for touch in touches:
            self.touches.take(touch)
        if watch.out[0] >= 0.0:
            self._whistle(ball_out(self.scene, self.ground, self.touches, watch))
            return
        call = self.fouls.check(watch)
        if call:
            self._whistle(call)
            return
        for row in self.fouls.leavers():
            self.bench.take_off(row, "left", "has left the field", watch)
