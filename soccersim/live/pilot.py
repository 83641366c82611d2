"""Orders for robots that people have taken over in a match: they go by what the robot believes."""

from math import hypot, pi, sqrt

from soccersim.geometry import rotate
from soccersim.spec.scenario import Scenario
from soccersim.state import Array
from soccersim.strategy.check import Order

GAIN = 2.5  # 1/s; orders are 40 ms apart and some ticks under way
BRAKING = 0.5  # of the acceleration is counted on to stop: orders come late
BRISK = 2.0  # m/s2, of a robot that tells no limit
NEAR, STRAIGHT = 0.03, 0.06  # m, rad: arrived
Pose = tuple[float, float, float]


class Pilot:
    """Who is taken over, and what he shall do."""

    def __init__(self, scenario: Scenario) -> None:
        self.limits = [player.model.control.limits for player in scenario.robots]
        self.targets: dict[int, Pose] = {}
        self.twists: dict[int, Pose] = {}
        self.kicks: dict[int, tuple[float, int]] = {}  # m/s, and how many it had made before
        self.dribbles: set[int] = set()
        self._told: set[int] = set()

    @property
    def taken(self) -> set[int]:
        """The robots that do not hear their teams."""
        return self.targets.keys() | self.twists.keys()

    def go(self, robot: int, target: Pose) -> None:
        """Send a robot to a pose."""
        self.twists.pop(robot, None)
        self.targets[robot] = target
        self._told.discard(robot)

    def drive(self, robot: int, twist: Pose) -> None:
        """Let a robot drive as it is told."""
        self.targets.pop(robot, None)
        self.twists[robot] = twist

    def release(self, robot: int) -> None:
        """Its team may have it back."""
        self.targets.pop(robot, None)
        self.twists.pop(robot, None)
        self.dribbles.discard(robot)

    def kick(self, robot: int, speed: float, made: int) -> None:
        """Kick with the next orders; made: its kicks so far."""
        self.kicks[robot] = speed, made

    def made(self, kicks: list[int]) -> None:
        """So many kicks the robots have made: those that were waited for are done."""
        for row in [row for row, (_, before) in self.kicks.items() if kicks[row] > before]:
            del self.kicks[row]

    def dribble(self, robot: int, on: bool) -> None:
        """Hold the ball, or not."""
        (self.dribbles.add if on else self.dribbles.discard)(robot)

    def take_over(self, orders: list[Order], rows: list[int], poses: Array) -> None:
        """Put our orders in the place of a team's; rows are its robots."""
        for at, row in enumerate(rows):
            vx, vy, omega, kick, dribble = orders[at]
            if row in self.targets:
                vx, vy, omega = self._towards(row, poses[row].tolist())
            elif row in self.twists:
                vx, vy, omega = self.twists[row]
            if row in self.taken:
                kick, dribble = 0.0, row in self.dribbles
            if row in self.kicks:
                kick = self.kicks[row][0]
            orders[at] = vx, vy, omega, kick, dribble

    def arrived(self, poses: Array) -> list[tuple[int, float]]:
        """Who has just got where he was sent, and how far off he believes to be."""
        found = []
        for row in self.targets.keys() - self._told:
            (x, y, heading), pose = self.targets[row], poses[row].tolist()
            off = hypot(x - pose[0], y - pose[1])
            if off < NEAR and abs(wrapped(heading - pose[2])) < STRAIGHT:
                self._told.add(row)
                found.append((row, off))
        return found

    def _towards(self, row: int, pose: list[float]) -> Pose:
        """The twist that leads from a pose to the target and can still stop there; body frame."""
        (x, y, heading), limits = self.targets[row], self.limits[row]
        dx, dy, turn = x - pose[0], y - pose[1], wrapped(heading - pose[2])
        away = hypot(dx, dy)
        brake = BRAKING * (limits.acceleration or BRISK)
        speed = min(limits.speed, GAIN * away, sqrt(2.0 * brake * away))
        share = speed / away if away > 0.0 else 0.0
        vx, vy = rotate(share * dx, share * dy, -pose[2])  # field to body
        omega = min(max(GAIN * turn, -limits.turn_rate), limits.turn_rate)
        return vx, vy, omega


def wrapped(angle: float) -> float:
    """The angle between -pi and pi."""
    return (angle + pi) % (2.0 * pi) - pi
