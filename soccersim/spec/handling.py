"""What a robot handles the ball with: its mouth, its kicker, its dribbler."""

from typing import Annotated

from pydantic import Field

from soccersim.spec.base import Spec


class Mouth(Spec):
    """The place before the robot where kicker, dribbler and contact sensor reach the ball.

    Defaults: CAMBADA's simulator takes 25 degrees and no gap.
    """

    half_angle_deg: Annotated[float, Field(ge=1, le=80)] = 25.0
    """How far to each side of straight ahead the ball's centre may be."""
    reach: Annotated[float, Field(ge=0.001, le=0.5)] = 0.05
    """m of gap at most between the robot's body and the ball (estimate)."""


class Kicker(Spec):
    """A kicker that gives the ball a set speed straight ahead."""

    speed: Annotated[float, Field(ge=0.1, le=15)] = 12.0
    """m/s at most (the league's robots: 8 to 12)."""
    recharge: Annotated[float, Field(ge=0.1, le=60)] = 1.0
    """Seconds from one kick to the next at least (estimate)."""
    speed_sd: Annotated[float, Field(ge=0, le=0.2)] = 0.03
    """Standard deviation of the ball's speed, relative (estimate)."""
    angle_sd_deg: Annotated[float, Field(ge=0, le=20)] = 1.0
    """Standard deviation of the kick's direction (estimate)."""


class Dribbler(Spec):
    """Rollers that draw the ball to the middle of the mouth, as a spring and damper of some force.

    The ball is lost when to hold it takes more than that.
    """

    force: Annotated[float, Field(ge=0.01, le=100)] = 5.0
    """N at most (estimate)."""
    stiffness: Annotated[float, Field(ge=1, le=1e4)] = 150.0
    """N/m (estimate)."""
    damping: Annotated[float, Field(ge=0, le=1e4)] | None = None
    """N s/m; null: critical, twice the root of stiffness times the ball's mass."""
    pause: Annotated[float, Field(ge=0, le=10)] = 0.2
    """Seconds after a loss or a kick before it draws again (estimate)."""
