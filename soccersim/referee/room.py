"""Where a robot can be put: on the floor, clear of everybody, of posts and of nets."""

from collections.abc import Callable, Iterator
from math import cos, hypot, pi, sin

from soccersim.referee.events import Place
from soccersim.referee.scene import Scene
from soccersim.spec.field import NET_RADIUS

MARGIN = 0.02  # m between bodies that are put down
STEP, GROWTH = 0.05, 1.08  # of the rings on which a free place is looked for
TURNS = [(cos(k * pi / 12), sin(k * pi / 12)) for k in range(13)]  # half the directions of a ring

Test = Callable[[float, float], bool]


class Room:
    """Finds free places. Robots that have been put somewhere stand there in the scene already."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        field = scene.field
        self.x = field.half_length + field.border
        self.y = field.half_width + field.border
        self.line, self.back = field.half_length, field.half_length + field.goal.depth
        self.post, self.post_radius = field.goal.post_centre, field.goal.post_radius

    def is_free(self, row: int, x: float, y: float, ball: bool = True) -> bool:
        """Whether the robot can stand there; ball: clear of the ball as well."""
        scene, radius = self.scene, self.scene.radius[row]
        if not self.on_floor(x, y, radius):
            return False
        if ball and hypot(x - scene.x, y - scene.y) < radius + scene.ball_radius + MARGIN:
            return False
        for other in scene.rows:
            if other != row:
                body = scene.body[other]
                if hypot(x - body[0], y - body[1]) < radius + scene.radius[other] + MARGIN:
                    return False
        return True

    def on_floor(self, x: float, y: float, radius: float) -> bool:
        """Whether a disc is inside the boards and clear of posts and nets."""
        x, y = abs(x), abs(y)
        room = radius + MARGIN
        if x > self.x - room or y > self.y - room:
            return False
        if hypot(x - self.line, y - self.post) < room + self.post_radius:
            return False
        side = hypot(x - min(max(x, self.line), self.back), y - self.post)
        rear = hypot(x - self.back, y - min(y, self.post))
        return min(side, rear) >= room + NET_RADIUS

    def find(self, row: int, start: Place, away: Place, test: Test) -> Place | None:
        """The free place nearest to start that passes the test; None: there is none.

        It is looked for on rings, first in the direction from `away` to start (from there towards
        the team's own goal where they are one), so that half a turn of all turns what is found.
        """
        for x, y in self._rings(row, start, away):
            if self.is_free(row, x, y) and test(x, y):
                return x, y
        return None

    def _rings(self, row: int, start: Place, away: Place) -> Iterator[Place]:
        ux, uy = start[0] - away[0], start[1] - away[1]
        length = hypot(ux, uy)
        if length < 1e-9:
            ux, uy, length = -self.scene.direction[self.scene.slot[row]], 0.0, 1.0
        ux, uy = ux / length, uy / length
        yield start
        ring = STEP
        while ring < 2.0 * (self.x + self.y):
            for c, s in TURNS:
                yield start[0] + ring * (c * ux - s * uy), start[1] + ring * (s * ux + c * uy)
                yield start[0] + ring * (c * ux + s * uy), start[1] + ring * (c * uy - s * ux)
            ring = ring * GROWTH + STEP
