"""A robot in a scenario: which model, where it starts, what it does, what a paper printed of it."""

from typing import Annotated, Literal

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec.base import Name, NonNegative, Number, Pose, Positive, Spec
from soccersim.spec.motor import MAX_WHEELS
from soccersim.spec.robot import Robot
from soccersim.spec.validate import Fault

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
    keeper: bool = False
    """The one of its team that may stay in its own penalty area."""
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
