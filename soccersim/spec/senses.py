"""What robots see and hear of a match: camera, self-localisation, radio, with their faults."""

from typing import Annotated

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec.base import NonNegative, Number, Positive, Rate, Share, Spec
from soccersim.spec.validate import Fault

Seconds = Annotated[float, Key(ge=0, le=2)]  # of delay: later news is of no use
Reach = Annotated[float, Key(ge=0.1, le=200)]  # m
Spread = Annotated[tuple[Number, Number, Number], Key(strict=False)]


class Sight(Spec):
    """How well one kind of thing is seen. A spread [a, b, c] is a + b d + c d2 m at d metres."""

    range: Reach = 8.0
    """m from the robot's centre beyond which it is not seen."""
    radial: Spread = (0.039, -0.01, 0.01)
    """Standard deviation along the line of sight, m (CAMBADA, IntegrateBall.cpp)."""
    tangential: Spread = (0.01, 0.02, 0.0)
    """Standard deviation across it, m (Falcons, worldModel.yaml)."""
    dropout: Share = 0.05
    """Chance that a frame misses it (ER-Force, Realistic.txt: ball .05, robots .02)."""

    @model_validator(mode="after")
    def _spreads_are_spreads(self) -> "Sight":
        faults = [
            Fault("is negative at a distance within `range`", at=(name,))
            for name in ("radial", "tangential")
            if lowest(getattr(self, name), self.range) < 0
        ]
        if faults:
            raise Fault.many(faults)
        return self


def lowest(spread: Spread, range_: float) -> float:
    """The least value of a + b d + c d2 for d in 0..range."""
    a, b, c = spread
    at = [0.0, range_] + ([-b / (2 * c)] if c > 0 and 0 < -b / (2 * c) < range_ else [])
    return min(a + b * d + c * d * d for d in at)


class Lines(Spec):
    """How well a frame's field lines tell the robot's own pose."""

    distance_sd: NonNegative = 0.06
    """Standard deviation of x and of y, m (estimate; Falcons test theirs, filtered, for .03)."""
    heading_sd_deg: NonNegative = 2.0
    """Standard deviation of the heading (estimate)."""
    dropout: Share = 0.1
    """Chance that no pose is found in a frame (estimate)."""


class Camera(Spec):
    """An omnidirectional camera on each robot; all take their frames at the same moments."""

    rate_hz: Rate = 25
    """Frames a second."""
    delay: Seconds = 0.045
    """Seconds from a frame to what the robot makes of it (ER-Force: .035 and .01)."""
    dropout: Share = 0.01
    """Chance that a whole frame is lost (estimate)."""
    scale_sd: Annotated[float, Key(ge=0, le=0.2)] = 0.01
    """Relative error of all distances, drawn once a robot: its mirror's calibration (estimate)."""
    ball: Sight = Sight()
    opponents: Sight = Sight(
        range=7.0, radial=(0.06, 0.0, 0.01), tangential=(0.02, 0.02, 0.0), dropout=0.02
    )
    """Spreads are estimates: the ball's, a little wider."""
    lines: Lines = Lines()


class Localisation(Spec):
    """How far a robot trusts its odometry between two fixes: the more, the slower it corrects."""

    slip: NonNegative = 0.1
    """Error of a step as a share of it (estimate; Tribots and CAMBADA count on .375)."""
    wander: NonNegative = 0.1
    """Random walk on top, m per root second (estimate)."""
    turn_slip: NonNegative = 0.02
    """Error of a turn as a share of it (estimate: a gyro's scale)."""
    turn_wander_deg: NonNegative = 1.0
    """Random walk of the heading on top, degrees per root second (estimate)."""


class Radio(Spec):
    """Packets between each robot and its team's computer."""

    delay: Seconds = 0.015
    """Seconds a packet is under way (estimate)."""
    order_loss: Share = 0.03
    """Chance that an order never arrives (ER-Force, Realistic.txt)."""
    report_loss: Share = 0.1
    """Chance that a robot's report never arrives (ER-Force, Realistic.txt)."""
    silence: Positive = 0.5
    """Seconds without an order after which a robot stops."""


class Senses(Spec):
    """What a team can know, and how late."""

    about: str = ""
    """Where the figures come from."""
    camera: Camera = Camera()
    localisation: Localisation = Localisation()
    radio: Radio = Radio()
