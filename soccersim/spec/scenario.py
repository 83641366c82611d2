"""A scenario: everything one run needs, as its YAML file says it."""

from functools import cached_property
from itertools import combinations
from math import hypot
from typing import Annotated, Literal

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec.base import Name, NonNegative, Number, Point, Pose, Positive, Rate, Spec
from soccersim.spec.field import Field
from soccersim.spec.frame import Coordinates, Frame, Units
from soccersim.spec.robot import MAX_WHEELS, Robot
from soccersim.spec.validate import Fault

MAX_ROBOTS = 22
Speeds = Annotated[tuple[Number, ...], Key(strict=False, min_length=3, max_length=MAX_WHEELS)]


class Paper(Spec):
    """What a paper printed for a leg, in the scenario's units; shown beside ours."""

    source: str = ""
    """Paper and table, or page."""
    odometry: Pose | None = None
    """Where the robot's sensors put it."""
    truth: Annotated[tuple[Number, Number, Number | None], Key(strict=False)] | None = None
    """Where it was measured; null for a heading that was not."""
    time: Positive | None = None
    """Seconds."""


class Leg(Spec):
    """A move to one target."""

    to: Pose
    """x, y, heading."""
    turn: Literal["shortest", "as_written"] = "shortest"
    """as_written: 0 to 270 degrees turns by 270, not by -90."""
    timeout: Positive | None = None
    """Seconds; null: as the robot's `arrival` says."""
    paper: Paper | None = None


class Phase(Spec):
    """A stretch of open-loop driving: one of the three, held for a while."""

    seconds: Positive
    pwm: Annotated[tuple[int, ...], Key(strict=False, min_length=3)] | None = None
    """-255..255, one a driven wheel."""
    wheel_speeds: Speeds | None = None
    """rad/s, one a driven wheel."""
    twist: Pose | None = None
    """vx, vy, omega in the robot's body frame: m/s and rad/s."""

    @model_validator(mode="after")
    def _one_of_three(self) -> "Phase":
        if sum(v is not None for v in (self.pwm, self.wheel_speeds, self.twist)) != 1:
            raise ValueError("needs exactly one of pwm, wheel_speeds, twist")
        if self.pwm and any(abs(level) > 255 for level in self.pwm):
            raise Fault("levels lie in -255..255", at=("pwm",))
        return self


class Hand(Spec):
    """A hand that pushes the robot along its path while the motors are idle (Idris, Table 6)."""

    speed: Positive = 0.2
    """m/s (estimate)."""
    acceleration: Positive = 0.5
    """m/s2 (estimate)."""
    turn_rate: Positive = 1.5
    """rad/s (estimate)."""
    settle: NonNegative = 0.6
    """Seconds it holds the robot on each mark before the reading is taken (estimate)."""


class Player(Spec):
    """One robot in the scenario: which model, where it starts, what it does."""

    name: Name
    team: Literal["home", "away"] = "home"
    number: Annotated[int, Key(ge=0, le=99)] = 1
    model: Robot
    """A bundled model by name, a file, or the model itself."""
    start: Pose
    """x, y, heading."""
    path: Annotated[tuple[Leg, ...], Key(strict=False, min_length=1, max_length=1000)] | None = None
    """Targets, one after the other."""
    repeat: bool = False
    """Whether the path starts again at its end, until the time is up."""
    open_loop: (
        Annotated[tuple[Phase, ...], Key(strict=False, min_length=1, max_length=1000)] | None
    ) = None
    """Driving without feedback of position."""
    pushed_by: Hand | None = None
    """The path is not driven but pushed by a hand, with the motors idle."""

    @model_validator(mode="after")
    def _one_plan(self) -> "Player":
        if self.path and self.open_loop:
            raise Fault("has a `path` too: keep one of them", at=("open_loop",))
        if not self.path:
            for key in ("pushed_by", "repeat"):
                if getattr(self, key):
                    raise Fault("needs a `path`", at=(key,))
        wheels = len(self.model.drive.azimuth_deg)
        for i, phase in enumerate(self.open_loop or ()):
            for key in ("pwm", "wheel_speeds"):
                value = getattr(phase, key)
                if value is not None and len(value) != wheels:
                    raise Fault(f"needs {wheels} entries, one a wheel", at=("open_loop", i, key))
        return self


class Ball(Spec):
    """A football: a hollow shell that slides, then rolls."""

    at: Point = (0.0, 0.0)
    """Where it lies."""
    velocity: Point = (0.0, 0.0)
    """Its speed at the start, in the scenario's length unit per second, without spin."""
    mass: Annotated[float, Key(gt=0, le=100)] = 0.43
    """kg (FIFA: .41-.45)."""
    radius: Annotated[float, Key(gt=0, le=1)] = 0.11
    """m."""
    shell: Annotated[float, Key(gt=0, le=1)] = 2 / 3
    """Moment of inertia over m r2: 2/3 hollow, 2/5 solid."""


class Timing(Spec):
    """Rates; each divides the physics rate."""

    physics_hz: Rate = 500
    record_hz: Rate = 50
    frames_hz: Rate = 25
    """Frames of film a second; divides the record rate."""

    @model_validator(mode="after")
    def _divide(self) -> "Timing":
        if self.physics_hz % self.record_hz:
            raise Fault(_no_divisor(self.physics_hz), at=("record_hz",))
        if self.record_hz % self.frames_hz:
            raise Fault(f"must divide record_hz = {self.record_hz}", at=("frames_hz",))
        if self.physics_hz < 100:
            raise Fault("must be at least 100: the floor's grip needs it", at=("physics_hz",))
        return self


def _no_divisor(physics_hz: int) -> str:
    return f"must divide physics_hz = {physics_hz}: {_divisors(physics_hz)}"


def _divisors(rate: int) -> str:
    return ", ".join(str(d) for d in range(1, rate + 1) if rate % d == 0 and d >= 10) or str(rate)


class Scenario(Spec):
    """Robots, a ball and a field, and what shall happen."""

    version: Literal[1]
    """Format of this file."""
    name: Name
    about: str = ""
    """What it shows, and where its numbers come from."""
    units: Units = Units()
    frame: Frame = Frame()
    seed: Annotated[int, Key(ge=0, lt=2**63)] = 0
    duration: Annotated[float, Key(gt=0, le=36_000)] = 60.0
    """Seconds after which the run ends, if its paths have not ended before."""
    timing: Timing = Timing()
    field: Field
    """A bundled field by name, a file, or the field itself."""
    ball: Ball | None = None
    robots: Annotated[tuple[Player, ...], Key(strict=False, min_length=1, max_length=MAX_ROBOTS)]
    record: Annotated[tuple[Literal["wheels", "sensors", "control"], ...], Key(strict=False)] = (
        "wheels",
        "sensors",
        "control",
    )
    """What is recorded besides the poses."""

    @cached_property
    def coordinates(self) -> Coordinates:
        """From the author's units and frame to the field and back."""
        return Coordinates(self.units, self.frame)

    @property
    def dt(self) -> float:
        """Seconds a physics tick."""
        return 1.0 / self.timing.physics_hz

    def every(self, rate_hz: int) -> int:
        """Ticks from one step at this rate to the next."""
        return self.timing.physics_hz // rate_hz

    @model_validator(mode="after")
    def _fits(self) -> "Scenario":
        faults = [*self._rates(), *self._names(), *self._places()]
        if faults:
            raise Fault.many(faults)
        return self

    def _rates(self) -> list[Fault]:
        faults = []
        physics = self.timing.physics_hz
        for i, robot in enumerate(self.robots):
            model, at = robot.model, ("robots", i, "model")
            rates: list[tuple[tuple[str | int, ...], int]] = [
                ((*at, "control", "rate_hz"), model.control.rate_hz)
            ]
            if model.drive.encoder:
                rates.append(((*at, "drive", "encoder", "rate_hz"), model.drive.encoder.rate_hz))
            if model.dead and model.dead.encoder:
                rates.append(((*at, "dead", "encoder", "rate_hz"), model.dead.encoder.rate_hz))
            if model.gyro:
                rates.append(((*at, "gyro", "rate_hz"), model.gyro.rate_hz))
            faults += [Fault(_no_divisor(physics), at=p) for p, rate in rates if physics % rate]
        return faults

    def _names(self) -> list[Fault]:
        names = [robot.name for robot in self.robots]
        return [
            Fault(f"`{name}` is taken by robots.{names.index(name)}", at=("robots", i, "name"))
            for i, name in enumerate(names)
            if names.index(name) < i
        ]

    def _places(self) -> list[Fault]:
        """Nobody off the floor, nobody inside another, no ball in a wall."""
        at = self.coordinates
        bodies: list[tuple[tuple[str | int, ...], str, float, float, float]] = [
            (
                ("robots", i, "start"),
                robot.name,
                *at.field_pose(robot.start)[:2],
                robot.model.radius,
            )
            for i, robot in enumerate(self.robots)
        ]
        if self.ball:
            x, y, _ = at.field_pose((*self.ball.at, 0.0))
            bodies.append((("ball", "at"), "ball", x, y, self.ball.radius))
        faults = [
            Fault(
                f"{name} is off the floor: at ({x:.2f}, {y:.2f}) m on the field, "
                f"inside is |x| < {self._room(r)[0]:.2f}, |y| < {self._room(r)[1]:.2f}",
                at=place,
            )
            for place, name, x, y, r in bodies
            if abs(x) > self._room(r)[0] or abs(y) > self._room(r)[1]
        ]
        goal_line, post = self.field.half_length, self.field.goal.post_centre
        posts = [(sx * goal_line, sy * post) for sx in (-1, 1) for sy in (-1, 1)]
        for place, name, x, y, r in bodies:
            if any(hypot(x - px, y - py) < r + self.field.goal.post_radius for px, py in posts):
                faults.append(Fault(f"{name} stands in a goal post", at=place))
        for (_, first, x1, y1, r1), (place, name, x2, y2, r2) in combinations(bodies, 2):
            if hypot(x1 - x2, y1 - y2) < r1 + r2:
                faults.append(
                    Fault(
                        f"{name} and {first} are in one place: "
                        f"keep {r1 + r2:.2f} m between their centres",
                        at=place,
                    )
                )
        return faults

    def _room(self, radius: float) -> tuple[float, float]:
        """How far from the centre spot a body of this radius may be."""
        return (
            self.field.half_length + self.field.border - radius,
            self.field.half_width + self.field.border - radius,
        )
