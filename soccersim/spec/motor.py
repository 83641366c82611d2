"""What the PWM table of a motor says, shared by the motor itself and by the robot's own code."""

from math import pi
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from soccersim.spec.robot import Motor

PWM_MAX = 255
RAD_S = 2 * pi / 60  # of one turn a minute


def table_speeds(motor: "Motor", wheels: int) -> NDArray[np.float64]:
    """Speed of each unloaded wheel at PWM 0..255, rad/s: (wheels, 256)."""
    levels = np.arange(PWM_MAX + 1.0)
    table = motor.pwm_table
    if table is None:
        return np.tile(levels / PWM_MAX * motor.no_load_speed_rpm * RAD_S, (wheels, 1))
    rows = table.rpm if len(table.rpm) == wheels else table.rpm * wheels
    return np.array([np.interp(levels, table.pwm, row) for row in rows]) * RAD_S
