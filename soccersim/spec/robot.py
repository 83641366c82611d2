"""A robot as its builder describes it: body, wheels, motors, sensors, control."""

from functools import cached_property
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field, model_validator

from soccersim.kinematics import OmniBase
from soccersim.spec.base import NonNegative, Number, Positive, Rate, Share, Spec, per_item
from soccersim.spec.sensors import Encoder, Gyro
from soccersim.spec.validate import Fault

MAX_WHEELS = 8
Angles = Annotated[tuple[Number, ...], Field(strict=False, min_length=3, max_length=MAX_WHEELS)]
Lengths = Annotated[tuple[Positive, ...], Field(strict=False, max_length=MAX_WHEELS)]
Row = Annotated[tuple[NonNegative, ...], Field(strict=False, min_length=2, max_length=256)]


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

    radius_bias: Annotated[float, Field(gt=-0.5, lt=0.5)] = 0.0
    """Common error of the radius; -0.03: the wheels roll 3 % smaller than drawn."""
    radius_sd: Share = 0.0
    """Standard deviation of the radius from wheel to wheel."""
    distance_sd: Share = 0.0
    """Standard deviation of the distance from the centre."""
    motor_sd: Share = 0.0
    """Standard deviation of the motors' speed (driven wheels only)."""


class PwmTable(Spec):
    """Measured speed of the unloaded wheel at some PWM levels (Idris, Tables 2-4)."""

    pwm: Row
    """Levels, rising from 0 to 255."""
    rpm: Annotated[tuple[Row, ...], Field(strict=False, min_length=1, max_length=MAX_WHEELS)]
    """Speeds at these levels: one row for all wheels or one row a wheel."""

    @model_validator(mode="after")
    def _rises(self) -> "PwmTable":
        if self.pwm[0] != 0 or self.pwm[-1] != 255:
            raise Fault("must run from 0 to 255", at=("pwm",))
        for name, row in [(("pwm",), self.pwm)] + [
            (("rpm", i), row) for i, row in enumerate(self.rpm)
        ]:
            if any(b <= a for a, b in pairwise(row)):
                raise Fault("must rise from one entry to the next", at=name)
        for i, row in enumerate(self.rpm):
            if len(row) != len(self.pwm):
                raise Fault(f"needs {len(self.pwm)} entries, one per PWM level", at=("rpm", i))
        return self


class Motor(Spec):
    """A DC motor with its gearbox and driver, seen at the wheel. Defaults: model of Idris/Utama."""

    no_load_speed_rpm: Positive = 530.0
    """Speed at full voltage without any friction (Idris, Tables 2-4: 528.8-530.3)."""
    stall_torque: Positive = 4.0
    """N m at the wheel at full voltage, wheel held (estimate)."""
    friction_torque: NonNegative = 0.05
    """N m of dry friction in motor and gearbox (estimate)."""
    torque_limit: Positive | None = None
    """N m at which the driver limits the current; null: none."""
    gear_ratio: Positive = 19.2
    """Turns of the rotor for one of the wheel (estimate)."""
    rotor_inertia: NonNegative = 8e-6
    """kg m2 of the rotor, before the gearbox (estimate)."""
    wheel_inertia: Positive = 4e-4
    """kg m2 of the wheel itself (estimate)."""
    at_zero: Literal["brake", "coast"] = "brake"
    """What the driver does at PWM 0: short the motor, or let it turn freely."""
    pwm_table: PwmTable | None = None
    """null: the speed is proportional to the PWM."""

    @property
    def inertia(self) -> float:
        """Wheel and reflected rotor, kg m2."""
        return self.wheel_inertia + self.gear_ratio**2 * self.rotor_inertia


class Wheels(Spec):
    """A set of omni or mecanum wheels round the robot's centre. Angles count from its front."""

    azimuth_deg: Angles
    """Where each wheel stands, counter-clockwise from straight ahead."""
    distance: Positive | Lengths
    """From the robot's centre to the wheel's contact point, m: one, or one a wheel."""
    radius: Positive
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
    def _one_table_a_wheel(self) -> "DriveWheels":
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


class Pid(Spec):
    """Gains of one axis; the derivative acts on the measurement, not on the set-point."""

    kp: NonNegative = 0.0
    ki: NonNegative = 0.0
    kd: NonNegative = 0.0


class Arrival(Spec):
    """When a target counts as reached, by the robot's own estimate."""

    distance: Positive = 0.02
    """m."""
    angle_deg: Positive = 2.0
    dwell: NonNegative = 0.2
    """Seconds it must stay within."""
    timeout: Positive = 20.0
    """Seconds after which a leg is given up."""


class Limits(Spec):
    """What the position controller may ask for."""

    speed: Positive = 1.5
    """m/s, along any direction."""
    acceleration: Positive | None = None
    """m/s2; null: the command may jump. A profile needs it."""
    turn_rate: Positive = 3.0
    """rad/s."""
    turn_acceleration: Positive | None = None
    """rad/s2; null as above."""


class Control(Spec):
    """Set-point to PWM, as in Utama's Fig. 5."""

    rate_hz: Rate = 100
    """Control and odometry steps a second."""
    x: Pid = Pid(kp=1.5)
    """Position along the field's x, m to m/s."""
    y: Pid = Pid(kp=1.5)
    heading: Pid = Pid(kp=3.0)
    """rad to rad/s."""
    limits: Limits = Limits()
    profile: Literal["none", "trapezoid"] = "none"
    """trapezoid: the set-point itself moves within the limits, bang-bang with a cruise."""
    wheel: Pid = Pid(kp=8.0, ki=15.0)
    """Wheel speed, rad/s to PWM, on top of the inverse PWM table; kd is not used."""
    wheel_loop: Literal["pi", "table"] = "pi"
    """table: the inverse PWM table alone, for wheels without encoders."""
    arrival: Arrival = Arrival()

    @model_validator(mode="after")
    def _profile_has_limits(self) -> "Control":
        if self.profile == "trapezoid":
            for key in ("acceleration", "turn_acceleration"):
                if getattr(self.limits, key) is None:
                    raise Fault("a trapezoid profile needs a number here", at=("limits", key))
        return self


class Robot(Spec):
    """One model of robot. x points to its front, y to its left."""

    about: str = ""
    """Where the figures come from."""
    mass: Annotated[float, Field(gt=0, le=1000)] = 20.0
    """kg."""
    inertia: Positive | None = None
    """kg m2 about the vertical; null: a uniform disc."""
    radius: Annotated[float, Field(gt=0, le=5)] = 0.25
    """m of the round body."""
    mass_height: NonNegative = 0.15
    """Height of the centre of mass, m (estimate)."""
    load_transfer: bool = True
    """Whether accelerating shifts load from wheel to wheel."""
    elasticity: Share = 0.4
    """Of a bounce against the ball (model.md 3.5: .3-.5)."""
    drive: DriveWheels
    dead: DeadWheels | None = None
    gyro: Gyro | None = None
    odometry: Odometry = Odometry()
    control: Control = Control()

    @property
    def yaw_inertia(self) -> float:
        """kg m2 about the vertical axis."""
        return self.inertia or 0.5 * self.mass * self.radius**2

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
            faults.append(Fault("there are no `dead` wheels", at=("odometry", "wheels")))
        elif self.odometry_wheels.encoder is None:
            faults.append(
                Fault("odometry needs an encoder here", at=(self.odometry.wheels, "encoder"))
            )
        if self.odometry.heading == "gyro" and self.gyro is None:
            faults.append(Fault("there is no `gyro`", at=("odometry", "heading")))
        if self.control.wheel_loop == "pi" and self.drive.encoder is None:
            faults.append(
                Fault("`pi` needs drive.encoder; use `table` without", at=("control", "wheel_loop"))
            )
        if faults:
            raise Fault.many(faults)
        return self
