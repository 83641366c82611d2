"""A scenario: everything one run needs, as its YAML file says it."""

from functools import cached_property
from math import hypot
from typing import Annotated, Literal

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec import MAX_ROBOTS
from soccersim.spec.base import Name, NonNegative, Number, Point, Pose, Positive, Rate, Spec
from soccersim.spec.field import Field
from soccersim.spec.frame import Coordinates, Frame, Units
from soccersim.spec.places import misplaced
from soccersim.spec.robot import FASTEST, MAX_WHEELS, Robot
from soccersim.spec.validate import Fault

MAX_RECORDING = 2**29  # bytes; while it is put together a run holds it twice
Pwm = Annotated[int, Key(ge=-255, le=255)]
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
    pwm: (
        Annotated[tuple[Pwm, ...], Key(strict=False, min_length=3, max_length=MAX_WHEELS)] | None
    ) = None
    """-255..255, one a driven wheel."""
    wheel_speeds: Speeds | None = None
    """rad/s, one a driven wheel."""
    twist: Pose | None = None
    """vx, vy, omega in the robot's body frame: m/s and rad/s."""

    @model_validator(mode="after")
    def _one_of_three(self) -> "Phase":
        if sum(v is not None for v in (self.pwm, self.wheel_speeds, self.twist)) != 1:
            raise ValueError("needs exactly one of pwm, wheel_speeds, twist")
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
        faults = [
            Fault(f"needs {wheels} entries, one a driven wheel", at=("open_loop", i, key))
            for i, phase in enumerate(self.open_loop or ())
            for key in ("pwm", "wheel_speeds")
            if len(getattr(phase, key) or range(wheels)) != wheels
        ]
        if faults:
            raise Fault.many(faults)
        return self


class Ball(Spec):
    """A football: a hollow shell that slides, then rolls."""

    at: Point = (0.0, 0.0)
    """Where it lies."""
    velocity: Point = (0.0, 0.0)
    """Its velocity at the start, in the scenario's length unit per second, without spin."""
    mass: Annotated[float, Key(ge=0.001, le=100)] = 0.43
    """kg (FIFA: .41-.45)."""
    radius: Annotated[float, Key(ge=0.01, le=1)] = 0.11
    """m."""
    shell: Annotated[float, Key(ge=0.01, le=1)] = 2 / 3
    """Moment of inertia over m r2: 2/3 hollow, 2/5 solid."""


class Timing(Spec):
    """Rates; each divides the physics rate."""

    physics_hz: Annotated[int, Key(ge=100, le=10_000)] = 500
    """Ticks a second; below 100 the floor's grip would not be told well."""
    record_hz: Rate = 50
    """Records a second."""
    frames_hz: Rate = 25
    """Frames of film a second; divides the record rate."""

    @model_validator(mode="after")
    def _divide(self) -> "Timing":
        if self.physics_hz % self.record_hz:
            raise Fault(_no_divisor(self.physics_hz), at=("record_hz",))
        if self.record_hz % self.frames_hz:
            wrong = f"must divide record_hz = {self.record_hz}: {_divisors(self.record_hz)}"
            raise Fault(wrong, at=("frames_hz",))
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
        faults = [*self._rates(), *self._names(), *self._speeds(), *self._size(), *misplaced(self)]
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

    def _speeds(self) -> list[Fault]:
        """No ball so fast that it passes through a net."""
        if self.ball is None:
            return []
        speed = hypot(*self.coordinates.field_vector(*self.ball.velocity))
        wrong = f"the ball moves at {speed:.4g} m/s: at most {FASTEST:.0f}"
        return [Fault(wrong, at=("ball", "velocity"))] if speed > FASTEST else []

    def _size(self) -> list[Fault]:
        """No recording that the memory cannot hold."""
        robots = len(self.robots)
        wheels = max(robot.model.wheel_count for robot in self.robots)
        numbers = 6 * (robots + 1) + robots * (7 + 4 * ("wheels" in self.record) * wheels)
        numbers += robots * (1 + wheels) * ("sensors" in self.record)
        numbers += robots * (3 + 2 * wheels) * ("control" in self.record)
        size = 8 * numbers * self.duration * self.timing.record_hz
        if size <= MAX_RECORDING:
            return []
        wrong = (
            f"makes a recording of {size / 2**30:.2g} GiB: at most {MAX_RECORDING / 2**30:.2g}; "
            "shorten it, lower timing.record_hz, or take words out of `record`"
        )
        return [Fault(wrong, at=("duration",))]
