"""Who stands where at a restart: distances, readiness, and robots that are carried away."""

from collections.abc import Iterator
from math import hypot
from typing import NamedTuple

from soccersim.referee.events import Call, Place, Pose
from soccersim.referee.ground import Ground
from soccersim.referee.phases import Phase
from soccersim.referee.room import MARGIN, Room
from soccersim.referee.scene import Scene

# START before its time (ours): the taker waits at the ball, nobody stands where he may not
READY_SPEED, READY_REACH = 0.5, 0.6  # m/s of the taker, m between its shell and the ball
READY_AFTER, READY_FOR = 2.0, 0.4  # s after the signal at least, s that it must have been so


class Free(NamedTuple):
    """Who may stand at any distance from the ball."""

    taker: int | None  # row
    spared: list[int]  # a robot of each team in its own penalty area


class Restart:
    """One restart, from its whistle until the ball is in play."""

    def __init__(self, scene: Scene, ground: Ground, room: Room, call: Call) -> None:
        self.scene, self.ground, self.room, self.call = scene, ground, room, call
        self.end = 1.0 if call.ball[0] > 0.0 else -1.0  # where a penalty is taken
        self.retakes = 0
        self.taken_by: int | None = None  # the row that touched the ball first after START
        self.stopped = self.signalled = self.started = 0  # ticks of STOP, signal and START
        self.ready_since: int | None = None  # tick

    def signal(self) -> None:
        """The signal is given: from now on robots go to their places."""
        self.signalled, self.ready_since, self.taken_by = self.scene.tick, None, None

    def taker(self) -> int | None:
        """Who takes it: the robot of the restarting team that is nearest to the ball's place."""
        if self.taken_by is not None:
            return self.taken_by
        scene, ball = self.scene, self.call.ball
        rows = [r for r in scene.rows if scene.playing[r] and scene.slot[r] == self.call.whose]
        return min(rows, key=lambda row: scene.far(row, ball), default=None)

    def is_ready(self) -> bool:
        """Whether for a moment the taker has waited and everybody has been in a legal place."""
        scene = self.scene
        if not self._taker_waits() or self.wrong(scene.rules.slack):
            self.ready_since = None
            return False
        if self.ready_since is None:
            self.ready_since = scene.tick
        since_signal, since = scene.tick - self.signalled, scene.tick - self.ready_since
        return since_signal >= scene.ticks(READY_AFTER) and since >= scene.ticks(READY_FOR)

    def _taker_waits(self) -> bool:
        scene, taker = self.scene, self.taker()
        if self.call.whose is None:
            return True
        if taker is None:
            return False
        reach = scene.radius[taker] + scene.ball_radius + READY_REACH
        return scene.far(taker, self.call.ball) < reach and scene.speed(taker) < READY_SPEED

    def wrong(self, slack: float) -> list[int]:
        """All who may not stand where they are at START."""
        scene, free = self.scene, self._free()
        return [
            row
            for row in scene.rows
            if scene.playing[row] and self._is_wrong(row, *scene.place(row), free, slack)
        ]

    def intruders(self) -> list[int]:
        """Who is too near after START, before the ball is in play."""
        if self.call.restart is Phase.DROPPED_BALL:
            return []
        scene, slack = self.scene, self.scene.rules.slack
        near = [
            row
            for row in scene.rows
            if scene.playing[row] and self._is_near(row, *scene.place(row), slack)
        ]
        if not near or near == [self.taken_by]:
            return []
        free = self._free()
        return [row for row in near if row != free.taker and row not in free.spared]

    def carried(self, slack: float) -> Iterator[tuple[int, Pose]]:
        """Who stands wrong, and the nearest place where he may stand, one after the other."""
        for row in self.wrong(slack):
            pose = self._legal_place(row)
            if pose is not None:
                yield row, pose

    def _distance(self, row: int) -> float:
        """That the robot must keep from the ball if it is not the taker."""
        rules = self.scene.rules
        if self.call.restart is Phase.DROPPED_BALL:
            return rules.dropped_ball
        return rules.mates if self.scene.slot[row] == self.call.whose else rules.opponents

    def _is_near(self, row: int, x: float, y: float, slack: float) -> bool:
        """Whether a robot there would be too near the ball, if it is not free to be there."""
        ball = self.call.ball
        return hypot(x - ball[0], y - ball[1]) < self._distance(row) - slack

    def _free(self) -> Free:
        """Who may stand near the ball now; the keeper where several are in their penalty area."""
        scene = self.scene
        spared: list[int] = []
        if self.call.restart in (Phase.GOAL_KICK, Phase.PENALTY):
            return Free(self.taker(), spared)
        for slot in (0, 1):
            own = [
                row
                for row in scene.rows
                if scene.slot[row] == slot
                and scene.playing[row]
                and self.ground.penalty_end(*scene.place(row)) == -scene.direction[slot]
            ]
            spared += sorted(own, key=lambda row: not scene.keeper[row])[:1]
        return Free(self.taker(), spared)

    def _is_wrong(self, row: int, x: float, y: float, free: Free, slack: float) -> bool:
        """Whether the robot may not stand there at START."""
        scene, restart = self.scene, self.call.restart
        if restart is Phase.PENALTY and self._is_goalie(row):
            line = self.room.line - scene.radius[row]
            return abs(self.end * x - line) > slack + MARGIN or abs(y) > scene.field.goal.width / 2
        if row == free.taker:
            return False
        if restart is Phase.KICK_OFF and scene.ahead(row, x) > (slack or -scene.radius[row]):
            return True
        if restart is Phase.PENALTY and self.ground.penalty_end(x, y):
            return not (scene.keeper[row] and scene.ahead(row, x) < 0.0)
        return self._is_near(row, x, y, slack) and row not in free.spared

    def _is_goalie(self, row: int) -> bool:
        """Whether it keeps the goal that the penalty goes to."""
        scene = self.scene
        return scene.keeper[row] and scene.direction[scene.slot[row]] == -self.end

    def _legal_place(self, row: int) -> Pose | None:
        """The nearest place where the robot may stand at START; None: there is none."""
        scene, ball, free = self.scene, self.call.ball, self._free()
        x, y = scene.place(row)
        start: Place = (x, y)
        if self.call.restart is Phase.PENALTY and self._is_goalie(row):
            most = scene.field.goal.width / 2 - scene.radius[row] - MARGIN
            line = self.room.line - scene.radius[row]
            start = self.end * line, self.ground.clipped(y, max(most, 0.0))
        else:
            apart, keep = hypot(x - ball[0], y - ball[1]), self._distance(row)
            if 1e-9 < apart < keep:  # straight away from the ball
                share = keep / apart * (1.0 + 1e-9)
                start = ball[0] + (x - ball[0]) * share, ball[1] + (y - ball[1]) * share
        place = self.room.find(
            row, start, ball, lambda px, py: not self._is_wrong(row, px, py, free, 0.0)
        )
        return (*place, scene.body[row][2]) if place else None
