"""Robots that are off the field: why, where they wait, and when they come back."""

from collections.abc import Iterator
from math import pi

from soccersim.referee.events import Place, Pose
from soccersim.referee.room import MARGIN, Room
from soccersim.referee.scene import Scene
from soccersim.spec.scenario import Scenario

REPAIR = "RC-3: repair"
BESIDE_BALL = 1.0  # m that a robot keeps from the ball when it comes back (ours)


class Bench:
    """Who is off, and until when."""

    def __init__(self, scenario: Scenario, scene: Scene, room: Room) -> None:
        self.scene, self.room = scene, room
        self.back: dict[int, int] = {}  # row that is off: the tick from which it may come back
        failures = scenario.match.failures if scenario.match else ()
        self.failures = sorted(
            (scene.ticks(f.time), scene.names.index(f.robot), scene.ticks(f.seconds))
            for f in failures
        )

    def failed(self) -> list[tuple[int, int]]:
        """Robots that stop answering now: row, and for how many ticks."""
        failed = []
        while self.failures and self.failures[0][0] <= self.scene.tick:
            _, row, ticks = self.failures.pop(0)
            failed.append((row, ticks))
        return failed

    def take_off(self, row: int, ticks: int = 0) -> Pose | None:
        """The robot goes off, for repair_time at least; where it waits, if it was on the field."""
        scene = self.scene
        until = scene.tick + max(ticks, scene.ticks(scene.rules.repair_time))
        self.back[row] = max(until, self.back.get(row, 0))
        if not scene.playing[row]:
            return None
        scene.playing[row] = False
        return self.waiting_place(row)

    def waiting_place(self, row: int) -> Pose | None:
        """Beside the touch line on its team's right, in its own half, facing the field."""
        scene = self.scene
        side = scene.direction[scene.slot[row]]
        for x, y in self._beside(row):
            place = side * x, side * y
            if self.room.is_free(row, *place):
                return (*place, side * pi / 2)
        edge = scene.field.half_width
        start = scene.place(row)
        free = self.room.find(row, start, (start[0], 0.0), lambda x, y: abs(y) > edge)
        return (*free, side * pi / 2) if free else None

    def _beside(self, row: int) -> Iterator[Place]:
        """Places between touch line and board, from the half-way line on; team frame."""
        field, radius = self.scene.field, self.scene.radius[row]
        beyond = min(field.border / 2, field.border - radius - MARGIN)
        step = 2 * radius + 0.1
        x = -step
        while x > -field.half_length:
            yield x, -(field.half_width + beyond)
            x -= step

    def due(self) -> list[int]:
        """Robots whose time off is over."""
        return [row for row, tick in self.back.items() if self.scene.tick >= tick]

    def come_back(self, row: int) -> Pose | None:
        """Where the robot enters at the touch line; None: there is no room, it waits on."""
        scene = self.scene
        side = scene.direction[scene.slot[row]]
        y = -(scene.field.half_width - scene.radius[row])
        start = scene.place(row)[0], side * y
        keep = max(BESIDE_BALL, scene.rules.opponents)

        def test(x: float, y: float) -> bool:
            return scene.ahead(row, x) < 0.0 and scene.apart(x, y) > keep

        place = self.room.find(row, start, (start[0], 0.0), test)
        if place is None:
            return None
        del self.back[row]
        scene.playing[row] = True
        return (*place, side * pi / 2)
