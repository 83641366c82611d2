"""What the referee looks at: who plays where, and the world of this moment as plain floats."""

from math import hypot

from soccersim.referee.events import SIDES, Place
from soccersim.spec.scenario import Scenario
from soccersim.state import Array


class Scene:
    """The players and the field, and from `look` on where everybody is. Rows as in the scenario."""

    def __init__(self, scenario: Scenario) -> None:
        match, ball = scenario.match, scenario.ball
        if match is None or ball is None:
            raise ValueError("a match and a ball are needed")
        players = scenario.robots
        self.rules = match.rules
        self.field = scenario.field
        self.hz = scenario.timing.physics_hz
        self.rows = range(len(players))
        self.names = [player.name for player in players]
        self.slot = [SIDES.index(player.team) for player in players]
        self.keeper = [player.keeper for player in players]
        self.radius = [player.model.radius for player in players]
        self.ball_radius = ball.radius
        self.direction = [1.0, -1.0]  # +1 where a slot attacks +x
        self.playing = [True] * len(players)  # not off the field
        self.tick = 0
        self.body: list[list[float]] = []  # x, y, heading, vx, vy, omega; field frame
        self.x = self.y = 0.0  # of the ball

    def ticks(self, seconds: float) -> int:
        """The nearest whole number of ticks."""
        return round(seconds * self.hz)

    def look(self, tick: int, body: Array) -> None:
        """Take in where everybody is. body: (R + 1, 6), the ball last."""
        self.tick = tick
        self.body = body.tolist()
        self.x, self.y = self.body[len(self.rows)][:2]

    def place(self, row: int) -> Place:
        """Where a robot is."""
        return self.body[row][0], self.body[row][1]

    def ahead(self, row: int, x: float) -> float:
        """x in the frame of the robot's team: negative in its own half."""
        return self.direction[self.slot[row]] * x

    def far(self, row: int, at: Place) -> float:
        """Distance of a robot's centre from a place."""
        return hypot(self.body[row][0] - at[0], self.body[row][1] - at[1])

    def apart(self, x: float, y: float) -> float:
        """Distance of a place from the ball."""
        return hypot(x - self.x, y - self.y)

    def speed(self, row: int) -> float:
        """m/s."""
        return hypot(self.body[row][3], self.body[row][4])
