"""A field: its lines, goals, border and floor. Origin at the centre spot, x along the length."""

from typing import Annotated

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec.base import NonNegative, Positive, Share, Spec
from soccersim.spec.validate import Fault

Length = Annotated[float, Key(ge=0.001, le=200)]
NET_RADIUS = 0.02  # m, half the thickness of the net


class Area(Spec):
    """A rectangle before each goal."""

    depth: Length
    """From the goal line into the field, m."""
    width: Length
    """Along the goal line, m."""


class Goal(Spec):
    """Both goals are alike."""

    width: Length
    """Between the posts, m."""
    depth: Length = 0.5
    """From the goal line to the back net, m."""
    post_radius: Length = 0.0625
    """m."""
    post_elasticity: Share = 0.6
    net_elasticity: Share = 0.1
    """The net stops the ball (estimate)."""

    @property
    def post_centre(self) -> float:
        """|y| of the posts' centres, m."""
        return self.width / 2 + self.post_radius


class Field(Spec):
    """A soccer field with a board round it."""

    about: str = ""
    """Where the dimensions come from."""
    length: Length
    """Between the goal lines, m."""
    width: Length
    """Between the touch lines, m."""
    border: Length = 1.0
    """From the lines to the board, m."""
    line_width: Length = 0.125
    goal: Goal
    penalty_area: Area | None = None
    goal_area: Area | None = None
    penalty_mark: Length | None = None
    """From the goal line, m."""
    centre_circle: Length | None = None
    """Radius, m."""
    corner_arc: Length | None = None
    """Radius, m."""
    board_elasticity: Share = 0.6
    """Of the ball's bounce off the board (estimate)."""
    grip: Positive = 1.0
    """Multiplies the friction of every wheel: 0.6 = a dusty floor."""
    ball_friction: NonNegative = 0.4
    """Friction coefficient of a sliding ball (estimate)."""
    ball_rolling: NonNegative = 0.35
    """Deceleration of a rolling ball, m/s2 (ER-Force's simulator: .33-.35)."""

    @model_validator(mode="after")
    def _goals_fit(self) -> "Field":
        if self.goal.width + 4 * self.goal.post_radius > self.width:
            raise Fault("with its posts is wider than the field", at=("goal", "width"))
        if self.goal.depth + 2 * self.goal.post_radius > self.border:
            most = self.border - 2 * self.goal.post_radius
            wrong = f"reaches into the board: at most {most:.3g} m, the border less a post"
            raise Fault(wrong, at=("goal", "depth"))
        for name in ("penalty_area", "goal_area"):
            area = getattr(self, name)
            if area and (area.width > self.width or 2 * area.depth > self.length):
                raise Fault("is larger than the field", at=(name,))
        for name, most, what in (
            ("penalty_mark", self.length / 2, "half the length"),
            ("centre_circle", self.width / 2, "half the width"),
            ("corner_arc", self.width / 2, "half the width"),
            ("line_width", self.width / 2, "half the width"),
        ):
            if (getattr(self, name) or 0.0) > most:
                raise Fault(f"must not exceed {what} of the field: {most:g} m", at=(name,))
        return self

    @property
    def half_length(self) -> float:
        """x of the goal line, m."""
        return self.length / 2

    @property
    def half_width(self) -> float:
        """y of the touch line, m."""
        return self.width / 2
