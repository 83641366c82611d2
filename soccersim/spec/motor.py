"""A motor as its data sheet and a measured PWM table tell it, and the speeds that these lead to.

The plant builds the motor from them, and the robot's own code its wheel control.
"""

from itertools import pairwise
from math import pi
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from soccersim.spec.base import NonNegative, Positive, Spec
from soccersim.spec.validate import Fault

MAX_WHEELS = 8  # of a robot
PWM_MAX = 255
RAD_S = 2 * pi / 60  # of one turn a minute
Row = Annotated[tuple[NonNegative, ...], Field(strict=False, min_length=2, max_length=256)]


class PwmTable(Spec):
    """Measured speed of the unloaded wheel at some PWM levels (Idris, Tables 2-4)."""

    pwm: Row
    """Levels, rising from 0 to 255."""
    rpm: Annotated[tuple[Row, ...], Field(strict=False, min_length=1, max_length=MAX_WHEELS)]
    """Speeds at these levels, from 0 up: one row for all wheels or one row a wheel.

    A dead zone is a few zeros.
    """

    @model_validator(mode="after")
    def _rises(self) -> "PwmTable":
        if self.pwm[0] != 0 or self.pwm[-1] != 255:
            raise Fault("must run from 0 to 255", at=("pwm",))
        if any(b <= a for a, b in pairwise(self.pwm)):
            raise Fault("must rise from one entry to the next", at=("pwm",))
        for i, row in enumerate(self.rpm):
            if len(row) != len(self.pwm):
                raise Fault(f"needs {len(self.pwm)} entries, one per PWM level", at=("rpm", i))
            if row[0] != 0 or row[-1] == 0 or any(b < a for a, b in pairwise(row)):
                raise Fault("must start with 0 and nowhere fall, but rise at last", at=("rpm", i))
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
    def top_speed_rpm(self) -> float:
        """The fastest that any wheel turns by itself."""
        rows = self.pwm_table.rpm if self.pwm_table else ()
        return max(self.no_load_speed_rpm, *(row[-1] for row in rows), 0.0)

    @property
    def inertia(self) -> float:
        """Wheel and reflected rotor, kg m2."""
        return self.wheel_inertia + self.gear_ratio**2 * self.rotor_inertia


def table_speeds(motor: Motor, wheels: int) -> NDArray[np.float64]:
    """Speed of each unloaded wheel at PWM 0..255, rad/s: (wheels, 256)."""
    levels = np.arange(PWM_MAX + 1.0)
    table = motor.pwm_table
    if table is None:
        return np.tile(levels / PWM_MAX * motor.no_load_speed_rpm * RAD_S, (wheels, 1))
    rows = table.rpm if len(table.rpm) == wheels else table.rpm * wheels
    return np.array([np.interp(levels, table.pwm, row) for row in rows]) * RAD_S
