"""A robot as its builder describes it: body, wheels, motors, sensors, control."""

from functools import cached_property
from math import pi
from typing import Annotated, Literal

from pydantic import Field, model_validator

from soccersim.kinematics import OmniBase
from soccersim.spec.base import NonNegative, Number, Positive, Share, Spec, per_item
from soccersim.spec.control import Control
from soccersim.spec.handling import Dribbler, Kicker, Mouth
from soccersim.spec.motor import MAX_WHEELS, Motor
from soccersim.spec.sensors import Encoder, Gyro
from soccersim.spec.validate import Fault

FASTEST = 30.0  # m/s of a rim: what moves farther in a tick may pass through what it meets
GRAVITY = 9.81  # m/s2
Angles = Annotated[tuple[Number, ...], Field(strict=False, min_length=3, max_length=MAX_WHEELS)]
Size = Annotated[float, Field(ge=0.001, le=5)]  # m, of a wheel or a robot
Lengths = Annotated[tuple[Size, ...], Field(strict=False, max_length=MAX_WHEELS)]
Scatter = Annotated[float, Field(ge=0, le=0.1)]  # more, and one wheel of many has no size left


class Grip(Spec):
    """How a wheel holds the floor: Stribeck friction with slip-ratio creep."""

    static: Positive = 0.5
    """Friction coefficient before the wheel breaks away (estimate; dusty .3, carpet .6)."""
    kinetic: Positive = 0.425
    """Friction coefficient of a spinning wheel (estimate: .85 of static)."""
    stribeck_speed: Positive = 0.1
    """Slip speed over which static falls to kinetic, m/s."""
    creep_speed: Positive = 0.004
    """Slip speed of half the grip for a wheel at rest, m/s."""
    creep_ratio: NonNegative = 0.02
    """The same as a share of the rim's speed: rubber creeps."""
    roller: NonNegative = 0.03
    """Friction coefficient of the rollers across the wheel (estimate .02-.05)."""

    @model_validator(mode="after")
    def _kinetic_is_less(self) -> "Grip":
        if self.kinetic > self.static:
            raise Fault("must not exceed `static`", at=("kinetic",))
        return self


class Build(Spec):
    """How far wheels as built differ from wheels as drawn: relative, drawn once a seed and wheel.

    The robot's own code knows the drawn values only: this is where odometry goes wrong.
    """

    radius_bias: Annotated[float, Field(ge=-0.3, le=0.3)] = 0.0
    """Common error of the radius; -0.03: the wheels roll 3 % smaller than drawn."""
    radius_sd: Scatter = 0.0
    """Standard deviation of the radius from wheel to wheel."""
    distance_sd: Scatter = 0.0
    """Standard deviation of the distance from the centre."""
    motor_sd: Scatter = 0.0
    """Standard deviation of the motors' speed (driven wheels only)."""


class Wheels(Spec):
    """A set of omni or mecanum wheels round the robot's centre. Angles count from its front."""

    azimuth_deg: Angles
    """Where each wheel stands, counter-clockwise from straight ahead."""
    distance: Size | Lengths
    """From the robot's centre to the wheel's contact point, m: one, or one a wheel."""
    radius: Size
    """m."""
    direction_deg: Angles | None = None
    """Where each wheel drives to when it turns forward; null: azimuth + 90 (tangential)."""
    roller_deg: Number | Angles = 0.0
    """Angle of the rollers: 0 omni, 45 or -45 mecanum; one, or one a wheel."""
    grip: Grip = Grip()
    encoder: Encoder | None = None
    """null: the robot cannot tell how these wheels turn."""
    build: Build = Build()

    @cached_property
    def base(self) -> OmniBase:
        """The kinematics of these wheels as drawn."""
        return OmniBase.general(
            self.azimuth_deg,
            self.distance,
            self.radius,
            directions_deg=self.direction_deg,
            roller_angles_deg=self.roller_deg,
        )

    @model_validator(mode="after")
    def _wheels_move_the_robot(self) -> "Wheels":
        count = len(self.azimuth_deg)
        for name in ("distance", "direction_deg", "roller_deg"):
            value = getattr(self, name)
            if isinstance(value, tuple) and len(value) != count:
                raise Fault(f"needs {count} entries, one per azimuth, not {len(value)}", at=(name,))
        if any(abs(angle) > 80 for angle in per_item(self.roller_deg, count)):
            raise Fault("must lie within 80 degrees", at=("roller_deg",))
        try:
            _ = self.base
        except ValueError as error:
            raise Fault(str(error), at=("azimuth_deg",)) from None
        return self


class DriveWheels(Wheels):
    """The wheels that push the robot, each with a motor."""

    motor: Motor = Motor()

    @model_validator(mode="after")
    def _motor_suits_the_wheels(self) -> "DriveWheels":
        rim = self.motor.top_speed_rpm * 2 * pi / 60 * self.radius
        if rim > FASTEST:
            wrong = f"turns the rim at {rim:.0f} m/s: at most {FASTEST:.0f}"
            raise Fault(wrong, at=("motor", "no_load_speed_rpm"))
        table = self.motor.pwm_table
        if table and len(table.rpm) not in (1, len(self.azimuth_deg)):
            raise Fault(
                f"needs 1 row or {len(self.azimuth_deg)}, one a wheel, not {len(table.rpm)}",
                at=("motor", "pwm_table", "rpm"),
            )
        return self


class DeadWheels(Wheels):
    """Small wheels without motors, pressed on the floor by springs, that carry encoders."""

    load: Positive = 5.0
    """N by which the spring presses each wheel on the floor (estimate)."""
    inertia: Positive = 2e-5
    """kg m2 (estimate)."""
    friction_torque: NonNegative = 5e-4
    """N m in the bearing (estimate)."""


class Odometry(Spec):
    """How the robot reckons its pose from its readings."""

    wheels: Literal["drive", "dead"] = "drive"
    """Whose encoders it counts."""
    heading: Literal["gyro", "wheels"] = "gyro"
    """Where the turn of each step comes from."""
    integrate: Literal["exact", "midpoint"] = "exact"
    """A step as an arc of constant twist, or straight along the mean heading."""


class Robot(Spec):
    """One model of robot. x points to its front, y to its left."""

    about: str = ""
    """Where the figures come from."""
    mass: Annotated[float, Field(ge=0.01, le=1000)] = 20.0
    """kg."""
    inertia: Positive | None = None
    """kg m2 about the vertical, at most mass * radius^2 (a ring); null: a uniform disc."""
    radius: Annotated[float, Field(ge=0.01, le=5)] = 0.25
    """m of the round body."""
    mass_height: Annotated[float, Field(ge=0, le=5)] = 0.15
    """Height of the centre of mass, m (estimate)."""
    load_transfer: bool = True
    """Whether accelerating shifts load from wheel to wheel."""
    elasticity: Share = 0.4
    """Of a bounce against the ball (estimate .3-.5)."""
    drive: DriveWheels
    dead: DeadWheels | None = None
    gyro: Gyro | None = None
    mouth: Mouth = Mouth()
    kicker: Kicker | None = None
    dribbler: Dribbler | None = None
    odometry: Odometry = Odometry()
    control: Control = Control()

    @property
    def yaw_inertia(self) -> float:
        """kg m2 about the vertical axis."""
        return self.inertia or 0.5 * self.mass * self.radius**2

    @property
    def wheel_count(self) -> int:
        """How many wheels stand on the floor."""
        return len(self.drive.azimuth_deg) + (len(self.dead.azimuth_deg) if self.dead else 0)

    @property
    def odometry_wheels(self) -> Wheels:
        """The wheels the odometry counts on."""
        wheels = self.drive if self.odometry.wheels == "drive" else self.dead
        if wheels is None:
            raise ValueError("odometry counts on dead wheels, and there are none")
        return wheels

    @model_validator(mode="after")
    def _senses_what_it_uses(self) -> "Robot":
        faults = []
        if self.odometry.wheels == "dead" and self.dead is None:
            wrong = "there are no `dead` wheels: describe them, or write `drive`"
            faults.append(Fault(wrong, at=("odometry", "wheels")))
        elif self.odometry_wheels.encoder is None:
            faults.append(
                Fault(
                    f"odometry counts on {self.odometry.wheels}.encoder, and there is none: add it",
                    at=("odometry", "wheels"),
                )
            )
        if self.odometry.heading == "gyro" and self.gyro is None:
            wrong = "there is no gyro: add `gyro: {}`, or write `wheels`"
            faults.append(Fault(wrong, at=("odometry", "heading")))
        if self.control.wheel_loop == "pi" and self.drive.encoder is None:
            faults.append(
                Fault(
                    "`pi` needs drive.encoder, and there is none: add it, or write `table`",
                    at=("control", "wheel_loop"),
                )
            )
        if faults:
            raise Fault.many(faults)
        return self

    @model_validator(mode="after")
    def _can_be_built(self) -> "Robot":
        ring = self.mass * self.radius**2
        if self.inertia and self.inertia > ring:
            wrong = f"is more than a ring of this mass and radius has: at most {ring:.3g}"
            raise Fault(wrong, at=("inertia",))
        if self.dead and len(self.dead.azimuth_deg) * self.dead.load >= self.mass * GRAVITY:
            weight = self.mass * GRAVITY
            wrong = f"lifts the robot off its driven wheels: it weighs {weight:.3g} N in all"
            raise Fault(wrong, at=("dead", "load"))
        return self
