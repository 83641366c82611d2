"""Where rulings are written: events, and robots and ball that are put somewhere."""

from math import hypot

from soccersim.referee.events import SIDES, Event, Place, Pose, Ruling
from soccersim.referee.room import MARGIN, Room
from soccersim.referee.scene import Scene


class Desk:
    """The ruling of this decision. What is put somewhere stands there in the scene at once."""

    def __init__(self, scene: Scene, room: Room) -> None:
        self.scene, self.room = scene, room
        self.ruling = Ruling()

    def open(self) -> None:
        """A new ruling."""
        self.ruling = Ruling()

    def say(
        self,
        kind: str,
        rule: str,
        text: str,
        at: Place,
        robots: tuple[int, ...] = (),
        side: int | None = None,
    ) -> None:
        """Write an event down."""
        scene = self.scene
        self.ruling.events.append(
            Event(
                tick=scene.tick,
                time=scene.tick / scene.hz,
                kind=kind,
                rule=rule,
                x=at[0],
                y=at[1],
                robots=tuple(scene.names[row] for row in robots),
                side=None if side is None else SIDES[side],
                text=text,
            )
        )

    def put(self, row: int, pose: Pose | None) -> None:
        """The robot is put there; None: it stays."""
        if pose is not None:
            self.ruling.robots[row] = pose
            self.scene.body[row][:] = [*pose, 0.0, 0.0, 0.0]

    def put_ball(self, place: Place) -> None:
        """The ball is put there at rest; whoever stands there is put beside it."""
        scene = self.scene
        self.ruling.ball = place
        scene.x, scene.y = place
        for row in scene.rows:
            x, y = scene.place(row)
            if hypot(x - place[0], y - place[1]) < self._beside(row):
                self._shift(row, place)

    def line_up(self, poses: list[Pose]) -> None:
        """Everybody who plays is put on his place."""
        scene = self.scene
        for row in scene.rows:
            if scene.playing[row]:
                self.put(row, poses[row])
        for row in scene.rows:
            x, y = scene.place(row)
            if scene.playing[row] and not self.room.is_free(row, x, y, ball=False):
                self._shift(row, (scene.x, scene.y))

    def _beside(self, row: int) -> float:
        return self.scene.radius[row] + self.scene.ball_radius + MARGIN

    def _shift(self, row: int, away: Place) -> None:
        """To the nearest free place."""
        start, heading = self.scene.place(row), self.scene.body[row][2]
        place = self.room.find(row, start, away, lambda x, y: True)
        if place is not None:
            self.put(row, (*place, heading))
