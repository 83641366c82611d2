"""Robots that are off the field: why, where they wait, and when they come back."""

from collections.abc import Iterator
from math import pi

import numpy as np

from soccersim.referee.desk import Desk
from soccersim.referee.events import Place, Pose
from soccersim.referee.room import MARGIN, Room
from soccersim.referee.scene import Scene
from soccersim.referee.watch import Watch
from soccersim.spec.scenario import Scenario

REPAIR = "Law 3: repair"


class Bench:
    """Who is off, and until when."""

    def __init__(self, scenario: Scenario, scene: Scene, room: Room, desk: Desk) -> None:
        self.scene, self.room, self.desk = scene, room, desk
        self.in_play = np.ones(len(scene.names), np.int64)  # (R,)  0: off the field
        self.back: dict[int, int] = {}  # row that is off: the tick from which it may come back
        failures = scenario.match.failures if scenario.match else ()
        self.failures = sorted(
            (scene.ticks(f.time), scene.names.index(f.robot), scene.ticks(f.seconds))
            for f in failures
        )

    def update(self, watch: Watch) -> None:
        """Robots that fail go off; those whose time is over come back."""
        tick = self.scene.tick
        while self.failures and self.failures[0][0] <= tick:
            _, row, ticks = self.failures.pop(0)
            self.take_off(row, "failed", "does not answer", watch, ticks)
        for row in [row for row, due in self.back.items() if tick >= due]:
            self._come_back(row, watch)

    def take_off(self, row: int, kind: str, why: str, watch: Watch, ticks: int = 0) -> None:
        """The robot goes off, for so many ticks and for repair_time at least."""
        scene = self.scene
        text = f"{scene.names[row]} {why} and goes off"
        self.desk.say(kind, REPAIR, text, scene.place(row), (row,), scene.slot[row])
        due = scene.tick + max(ticks, scene.ticks(scene.rules.repair_time))
        self.back[row] = max(due, self.back.get(row, 0))
        if scene.playing[row]:
            self._enter(row, False, watch)
            self.desk.put(row, self._waiting_place(row))

    def change_ends(self) -> None:
        """Who is off waits in his team's new half."""
        for row in self.back:
            self.desk.put(row, self._waiting_place(row))

    def _enter(self, row: int, plays: bool, watch: Watch) -> None:
        self.scene.playing[row] = plays
        self.in_play[row] = watch.active[row] = int(plays)

    def _come_back(self, row: int, watch: Watch) -> None:
        """The robot enters at the touch line, far from the ball; without room it waits on."""
        scene, field = self.scene, self.scene.field
        side = scene.direction[scene.slot[row]]
        start = scene.place(row)[0], -side * (field.half_width - scene.radius[row])
        keep = min(scene.rules.opponents, field.width / 4)
        place = self.room.find(
            row,
            start,
            (start[0], 0.0),
            lambda x, y: scene.ahead(row, x) < 0.0 and scene.apart(x, y) > keep,
        )
        if place is None:
            return
        del self.back[row]
        self._enter(row, True, watch)
        self.desk.put(row, (*place, side * pi / 2))
        text = f"{scene.names[row]} comes back"
        self.desk.say("back", REPAIR, text, place, (row,), scene.slot[row])

    def _waiting_place(self, row: int) -> Pose | None:
        """Beside the touch line on its team's right, in its own half, facing the field."""
        scene, edge = self.scene, self.scene.field.half_width
        side = scene.direction[scene.slot[row]]
        for x, y in self._beside(row):
            place = side * x, side * y
            if self.room.is_free(row, *place):
                return (*place, side * pi / 2)
        start = scene.place(row)
        free = self.room.find(row, start, (start[0], 0.0), lambda x, y: abs(y) > edge)
        return (*free, side * pi / 2) if free else None

    def _beside(self, row: int) -> Iterator[Place]:
        """Places between touch line and board, from the half-way line on; team frame."""
        field, radius = self.scene.field, self.scene.radius[row]
        beyond = min(field.border / 2, field.border - radius - 2 * MARGIN)
        step = 2 * radius + 0.1
        x = -step
        while x > -field.half_length:
            yield x, -(field.half_width + beyond)
            x -= step
