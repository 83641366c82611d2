"""What goes on on the field, and what people may do to it, with or without a match.

All of it happens between two ticks, in the thread that simulates: nothing here knows of browsers.
"""

from math import hypot
from typing import Any

from soccersim.live import messages as say
from soccersim.live.messages import Wrong
from soccersim.simulation import Simulation
from soccersim.spec.scenario import Scenario

FOREVER = 2**53  # a tick that nobody will see
PUSHED = 0.3  # s that a hand pushes
ARMED = 1.0  # s that a kick waits for the ball
DRIVEN = 0.4  # s that a robot goes on as it is driven: who drives says it again
News = dict[str, Any]


class Play:
    """One scenario under way. Subclasses say how robots are sent somewhere."""

    def __init__(self, scenario: Scenario, simulation: Simulation) -> None:
        self.scenario, self.simulation = scenario, simulation
        self.hz = scenario.timing.physics_hz
        self.news: list[News] = []
        self.over = False
        self.targets: dict[int, tuple[float, float, float]] = {}  # robots sent somewhere
        self._timers: dict[tuple[str, int], int] = {}  # what ends of itself, and its tick
        keep_no_records(simulation)

    def advance(self, ticks: int) -> None:
        """Run so many ticks, or until it is over."""
        goal = self.simulation.tick + ticks
        while (now := self.simulation.tick) < goal and not self.over:
            self._expire(now)
            self._run(min([goal, *self._timers.values()]) - now)
        self._expire(self.simulation.tick)

    def obey(self, message: say.Message) -> None:
        """Do what a message says; Wrong where that cannot be."""
        robot = getattr(message, "robot", None)
        if robot is not None and robot >= len(self.scenario.robots):
            raise Wrong(f"robot: there are {len(self.scenario.robots)}, counted from 0")
        match message:
            case say.Go():
                self._inside(message.x, message.y)
                self.go(message)
            case say.Drive():
                self.drive(message)
                self._timers["drive", message.robot] = self.tick + self.ticks(DRIVEN)
            case say.Halt():
                self.halt(message.robot)
            case say.Release():
                self.release(message.robot)
            case say.Kick():
                self.kick(message)
            case say.Dribble():
                self.dribble(message)
            case say.Ball():
                self.ball(message)
            case say.Push():
                self.push(message)
            case say.Gains():
                self.gains(message)
            case say.Referee():
                self.referee(message)

    @property
    def tick(self) -> int:
        """Now."""
        return self.simulation.tick

    @property
    def seconds(self) -> float:
        """Now."""
        return self.simulation.tick / self.hz

    def ticks(self, seconds: float) -> int:
        """The nearest whole number of ticks."""
        return round(seconds * self.hz)

    def tell(self, text: str, kind: str = "", side: int | None = None) -> None:
        """Something for the list of events."""
        told = {"time": round(self.seconds, 3), "text": text, "kind": kind, "side": side}
        self.news.append(told)

    def close(self) -> None:
        """It is not looked at any more."""

    def labels(self) -> list[str]:
        """What teams call what their robots do."""
        return [""] * len(self.scenario.robots)

    def notes(self) -> list[list[list[Any]]]:
        """What teams drew, field frame: a list a team."""
        return [[], []]

    # what subclasses do in their own way

    def _run(self, ticks: int) -> None:
        raise NotImplementedError

    def go(self, message: say.Go) -> None:
        """Send a robot to a place."""
        raise NotImplementedError

    def drive(self, message: say.Drive) -> None:
        """Drive a robot by its twist."""
        raise NotImplementedError

    def halt(self, robot: int) -> None:
        """Stop a robot."""
        raise NotImplementedError

    def release(self, robot: int) -> None:
        """Let its team command a robot again."""
        raise Wrong("release: there is no team without a match")

    def referee(self, message: say.Referee) -> None:
        """A button of the referee's."""
        raise Wrong("referee: there is none without a match")

    def disarm(self, robot: int) -> None:
        """A kick has waited for the ball long enough."""
        raise NotImplementedError

    # what is the same with and without a match

    def kick(self, message: say.Kick) -> None:
        """Kick with the ball in the mouth, now or soon."""
        if self.scenario.robots[message.robot].model.kicker is None or not self.scenario.ball:
            raise Wrong("kick: this robot has no kicker, or there is no ball")
        self._timers["kick", message.robot] = self.tick + self.ticks(ARMED)

    def dribble(self, message: say.Dribble) -> None:
        """Hold the ball, or let go."""
        if self.scenario.robots[message.robot].model.dribbler is None:
            raise Wrong("dribble: this robot has no dribbler")

    def ball(self, message: say.Ball) -> None:
        """Put the ball somewhere."""
        if not self.scenario.ball:
            raise Wrong("ball: there is none in this scenario")
        self._inside(message.x, message.y)
        place = message.x, message.y, message.vx, message.vy
        self.simulation.world.place_ball(self.simulation.machine.truth, *place)

    def push(self, message: say.Push) -> None:
        """Push a robot, for a moment."""
        m = self.simulation.machine
        if m.hand.pushes[message.robot]:
            raise Wrong("push: the scenario's hand is on this robot; send it somewhere first")
        m.truth.push[message.robot] = message.fx, message.fy, 0.0
        self._timers["push", message.robot] = self.tick + self.ticks(PUSHED)

    def gains(self, message: say.Gains) -> None:
        """Other gains, from the next step of control on."""
        m, robot = self.simulation.machine, message.robot
        if message.loop == "wheel":
            if self.scenario.robots[robot].model.control.wheel_loop != "pi":
                raise Wrong("gains: the wheels of this robot have no loop, they have no encoders")
            m.wheels.kp[robot], m.wheels.ki[robot] = message.kp, message.ki
            m.wheels.sums[robot] = 0.0
            return
        axes = slice(0, 2) if message.loop == "position" else slice(2, 3)
        for gain in ("kp", "ki", "kd"):
            getattr(m.position, gain)[robot, axes] = getattr(message, gain)
        m.position.sums[robot, axes] = 0.0

    def told_gains(self) -> list[dict[str, list[float] | None]]:
        """The gains of all robots, as they are now: kp, ki, kd of each loop."""
        m = self.simulation.machine
        rows = []
        for robot, player in enumerate(self.scenario.robots):
            position, heading = (
                [float(gain[robot, axis]) for gain in (m.position.kp, m.position.ki, m.position.kd)]
                for axis in (0, 2)
            )
            has_loop = player.model.control.wheel_loop == "pi"
            wheel = [float(m.wheels.kp[robot]), float(m.wheels.ki[robot])] if has_loop else None
            rows.append({"position": position, "heading": heading, "wheel": wheel})
        return rows

    def off_target(self, robot: int) -> tuple[float, float]:
        """How far a robot is from where it was sent, m: in truth, and as it believes."""
        m, (x, y, _) = self.simulation.machine, self.targets[robot]
        true, believed = m.truth.body[robot], m.estimate.pose[robot]
        return hypot(true[0] - x, true[1] - y), hypot(believed[0] - x, believed[1] - y)

    def _inside(self, x: float, y: float) -> None:
        """Wrong where a place is not on the floor."""
        field = self.scenario.field
        length, width = field.half_length + field.border, field.half_width + field.border
        if abs(x) > length or abs(y) > width:
            raise Wrong(f"place: the floor ends at x = {length:g} and y = {width:g} m")

    def _expire(self, now: int) -> None:
        """End what lasts only a moment."""
        for what, robot in [key for key, due in self._timers.items() if due <= now]:
            del self._timers[what, robot]
            if what == "push":
                self.simulation.machine.truth.push[robot] = 0.0
            elif what == "kick":
                self.disarm(robot)
            else:
                self.halt(robot)

    def _cancel(self, what: str, robot: int) -> None:
        self._timers.pop((what, robot), None)


def keep_no_records(simulation: Simulation) -> None:
    """Whoever watches for hours keeps no recording; the digest still grows by each record."""
    simulation._pieces.clear()
