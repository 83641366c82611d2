"""A scenario: everything one run needs, as its YAML file says it."""

from functools import cached_property
from itertools import pairwise
from math import hypot
from typing import Annotated, Literal

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec import MAX_ROBOTS
from soccersim.spec.arm import Arm, unreachable
from soccersim.spec.base import Name, NonNegative, Point, Rate, Spec
from soccersim.spec.field import Field
from soccersim.spec.frame import Coordinates, Frame, Units
from soccersim.spec.match import Match, line_up_faults
from soccersim.spec.places import misplaced
from soccersim.spec.player import Player
from soccersim.spec.robot import FASTEST
from soccersim.spec.senses import Senses
from soccersim.spec.validate import Fault

MAX_RECORDING = 2**29  # bytes; while it is put together a run holds it twice


class Shot(Spec):
    """The ball is taken, put somewhere, and set off again."""

    time: NonNegative
    """Seconds from the start."""
    at: Point
    """Where it is put."""
    velocity: Point
    """In the scenario's length unit per second, without spin."""


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
    shots: Annotated[tuple[Shot, ...], Key(strict=False, max_length=1000)] = ()
    """Later starts of the ball, in order of time: one shot after the other."""

    @model_validator(mode="after")
    def _one_after_the_other(self) -> "Ball":
        for i, (first, then) in enumerate(pairwise(self.shots)):
            if then.time <= first.time:
                raise Fault("must be later than the shot before", at=("shots", i + 1, "time"))
        return self


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
    robots: Annotated[tuple[Player, ...], Key(strict=False, max_length=MAX_ROBOTS)] = ()
    arms: Annotated[tuple[Arm, ...], Key(strict=False, max_length=MAX_ROBOTS)] = ()
    """Planar arms, on the floor or on robots."""
    match: Match | None = None
    """A match of two teams; the robots' paths are left out then."""
    perception: Literal["truth", "onboard"] = "onboard"
    """What teams are told in a match: what is so, or what cameras and radio bring."""
    senses: Senses = Senses()
    """Cameras, localisation and radio of a match: bundled ones by name, a file, or themselves."""
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
        if not self.robots and not self.arms:
            raise Fault("needs a robot or an arm", at=("robots",))
        faults = [*self._rates(), *self._names(), *self._speeds(), *self._size(), *misplaced(self)]
        faults += [*unreachable(self), *line_up_faults(self)]
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
        starts = [(("ball", "velocity"), self.ball.velocity)] + [
            (("ball", "shots", i, "velocity"), shot.velocity)
            for i, shot in enumerate(self.ball.shots)
        ]
        speeds = [(at, hypot(*self.coordinates.field_vector(*v))) for at, v in starts]
        return [
            Fault(f"the ball moves at {speed:.4g} m/s: at most {FASTEST:.0f}", at=at)
            for at, speed in speeds
            if speed > FASTEST
        ]

    def _size(self) -> list[Fault]:
        """No recording that the memory cannot hold."""
        robots = len(self.robots)
        wheels = max([0, *(robot.model.wheel_count for robot in self.robots)])
        numbers = (
            6 * (robots + 1 + 3 * len(self.arms))
            + 6 * len(self.arms)
            + robots * (7 + 4 * ("wheels" in self.record) * wheels)
        )
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
