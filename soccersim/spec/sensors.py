"""What a robot senses with: wheel encoders and a gyro, with their faults."""

from typing import Annotated, Literal

from pydantic import Field

from soccersim.spec.base import NonNegative, Positive, Rate, Share, Spec


class Encoder(Spec):
    """An incremental encoder that counts whole pulses of a wheel's turning."""

    pulses_per_turn: Annotated[int, Field(gt=0, le=1_000_000)] = 270
    """Pulses of one channel in one turn of the wheel."""
    decoding: Literal[1, 2, 4] = 1
    """Edges counted per pulse: x1, x2 or x4."""
    rate_hz: Rate = 100
    """How often the counter is read."""
    window: Annotated[float, Field(ge=0.001, le=1)] = 0.1
    """Seconds over which pulses are counted to tell the wheel's speed (Idris: 0.1)."""
    missed: Share = 0.0
    """Chance that an edge is not counted."""
    perfect: bool = False
    """True: the wheel's exact angle, at the same rate."""

    @property
    def edges_per_turn(self) -> int:
        """Counts in one turn of the wheel."""
        return self.pulses_per_turn * self.decoding


class Gyro(Spec):
    """A rate gyro about the vertical axis. Defaults: MPU-6050, PS-MPU-6000A rev 3.4, p. 12."""

    rate_hz: Rate = 100
    """Samples a second."""
    scale_sd: Share = 0.01
    """Relative scale error: its standard deviation over robots (estimate)."""
    bias_deg_s: Annotated[float, Field(gt=-1000, lt=1000)] = 0.0
    """Offset every gyro of this model has, on top of the drawn one."""
    bias_sd_deg_s: NonNegative = 0.03
    """Offset left after calibration at rest: standard deviation over robots (estimate)."""
    walk_deg_s_rts: NonNegative = 4e-4
    """Random walk of the offset, deg/s per root second (estimate)."""
    noise_deg_s_rthz: NonNegative = 0.005
    """Density of the white noise, deg/s per root hertz, one-sided."""
    resolution_deg_s: NonNegative = 1 / 131
    """One step of the output; 0 = continuous."""
    full_scale_deg_s: Positive = 250.0
    """The largest rate it can tell."""
    perfect: bool = False
    """True: the exact mean rate since the last sample."""
