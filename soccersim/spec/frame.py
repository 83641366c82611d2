"""The units and the frame in which a scenario's author writes, turned into SI field poses once."""

from cmath import rect
from math import pi, radians
from typing import Literal

from soccersim.spec.base import Number, Point, Spec

METRES = {"m": 1.0, "cm": 0.01, "mm": 0.001}
RADIANS = {"rad": 1.0, "deg": pi / 180}
Vector = tuple[float, float, float]


class Units(Spec):
    """Units of the poses, paths and reference numbers of a scenario (not of robots and fields)."""

    length: Literal["m", "cm", "mm"] = "m"
    angle: Literal["rad", "deg"] = "deg"


class Frame(Spec):
    """Where the author's axes lie on the field, and which way his headings turn."""

    origin: Point = (0.0, 0.0)
    """The author's origin on the field: metres from the centre spot, whatever the units."""
    rotation_deg: Number = 0.0
    """How far the author's x axis is turned counter-clockwise from the field's."""
    mirror_y: bool = False
    """True: the author's y axis points the other way (Idris)."""
    heading: Literal["ccw", "cw"] = "ccw"
    """Which way his headings grow, seen from above (Utama's compass: cw)."""


class Coordinates:
    """Converts between a scenario's own numbers, its SI frame and the field.

    *Written*: as in the file. *Framed*: the scenario's axes, in metres and radians, headings
    counter-clockwise (what reports give). *Field*: metres and radians on the field.
    """

    def __init__(self, units: Units, frame: Frame) -> None:
        self.metres = METRES[units.length]
        self.radians = RADIANS[units.angle]
        self.turns = 1.0 if frame.heading == "ccw" else -1.0
        self.mirror = -1.0 if frame.mirror_y else 1.0
        self.origin = complex(*frame.origin)
        self.rotation = radians(frame.rotation_deg)

    def framed(self, written: Vector) -> Vector:
        """A pose as written, in metres and radians, counter-clockwise."""
        x, y, heading = written
        return x * self.metres, y * self.metres, heading * self.radians * self.turns

    def local(self, written: Vector) -> Vector:
        """A pose in a right-handed frame of its own, as an arm's: the units alone are turned."""
        x, y, heading = written
        return x * self.metres, y * self.metres, heading * self.radians

    def to_field(self, framed: Vector) -> Vector:
        """A framed pose on the field."""
        x, y, heading = framed
        place = self.origin + complex(x, y * self.mirror) * rect(1.0, self.rotation)
        return place.real, place.imag, heading + self.rotation

    def from_field(self, pose: Vector) -> Vector:
        """A field pose in the scenario's frame: to_field undone."""
        x, y, heading = pose
        place = (complex(x, y) - self.origin) * rect(1.0, -self.rotation)
        return place.real, place.imag * self.mirror, heading - self.rotation

    def field_pose(self, written: Vector) -> Vector:
        """A pose as written, on the field in SI."""
        return self.to_field(self.framed(written))

    def field_vector(self, x: float, y: float) -> tuple[float, float]:
        """A displacement or a velocity as written, on the field in SI."""
        turned = complex(x, y * self.mirror) * self.metres * rect(1.0, self.rotation)
        return turned.real, turned.imag
