"""How a robot is controlled: gains, limits, when a target counts as reached."""

from typing import Literal

from pydantic import model_validator

from soccersim.spec.base import NonNegative, Positive, Rate, Spec
from soccersim.spec.validate import Fault


class Pi(Spec):
    """Gains of a wheel's speed."""

    kp: NonNegative
    ki: NonNegative = 0.0


class Pid(Spec):
    """Gains of one axis; the derivative acts on the measurement, not on the set-point."""

    kp: NonNegative
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
    wheel: Pi = Pi(kp=8.0, ki=15.0)
    """Wheel speed, rad/s to PWM, on top of the inverse PWM table."""
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
