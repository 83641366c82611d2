"""The rules of a match: which of the league's rules are played, and their figures.

Where sources differ the figure is a key here. Sources are named as in docs/rules.md: 2016 is the
Middle Size League's rulebook of that year, RefBox 2024 the set-up of its referee box, simatch the
referee of its simulation league; "ours" marks what we found nowhere.
"""

from typing import Annotated, Literal

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.spec.base import NonNegative, Positive, Spec
from soccersim.spec.validate import Fault

Seconds = Annotated[float, Key(ge=0, le=600)]


class Rules(Spec):
    """What the referee rules by: times in seconds, distances in metres; null: not played."""

    about: str = ""
    """Where the figures come from."""
    lines: bool = True
    """Whether a ball over a line is out of play; false: the boards are the bounds."""
    restarts: Literal["drive", "place"] = "drive"
    """How robots come to their places: by themselves, or put there by the referee."""
    stop_time: Seconds = 2.0
    """From STOP to the signal: robots halt, the ball is carried to its place (ours)."""
    restart_time: Seconds = 7.0
    """From STOP to START at the latest; sooner when everybody stands right (2016: 7 s)."""
    kick_off_time: Seconds = 10.0
    """The same for a kick-off, to which robots come from farther (ours)."""
    play_time: Seconds = 7.0
    """From START until defenders may play a ball that nobody has taken (2016; RefBox 2024)."""
    opponents: NonNegative = 3.0
    """From the ball to the defenders until it is in play (2016)."""
    mates: NonNegative = 2.0
    """From the ball to the taker's team mates until it is in play (2016)."""
    dropped_ball: NonNegative = 1.0
    """From a dropped ball to everybody (2016)."""
    slack: NonNegative = 0.3
    """How much nearer is forgiven: robots know where they are no better (ours)."""
    retakes: Annotated[int, Key(ge=0, le=10)] | None = 1
    """How often a restart is taken again when somebody comes too near after START; a defender that
    does it once more goes off (ours). null: nobody minds."""
    roll: NonNegative = 0.5
    """That a ball must roll from its place before the taker's team touches it again (2016;
    RC-13.1.2 of the same book says 0.2)."""
    pass_at_restart: bool = True
    """No goal from a restart before another robot of the team has touched the ball (2016)."""
    own_half_goals: bool = False
    """Whether a goal counts that was kicked from the own half (2016: no)."""
    regain_roll: NonNegative | None = 1.0
    """After winning the ball in the own half a team may score once a mate has touched it in the
    opponents' half, after the ball rolled free so far (2016)."""
    dribble: Positive | None = 3.0
    """How far from where a robot caught the ball it may go in contact with it (2016)."""
    area_time: Seconds | None = 10.0
    """How long one robot may stay in a penalty area, besides the area's keeper (2016)."""
    area_grace: Seconds = 1.0
    """How long a second one may be in it, on its way (ours; the book: not at all)."""
    keeper_protected: bool = True
    """Whether touching the keeper in its goal area is a foul (2016)."""
    pushing: Positive | None = 0.6
    """How far a robot may shove an opponent (2016 forbids pushing; the measure is ours)."""
    penalties: bool = True
    """Whether pushing by a defender in its own penalty area gives a penalty (2016), not a kick."""
    stuck_time: Annotated[float, Key(ge=1, le=600)] = 10.0
    """After which a ball that does not get away is dropped (2016)."""
    stuck_distance: Positive = 0.5
    """Within which a ball has not got away (ours)."""
    repair_time: Seconds = 20.0
    """That a robot stays off at least (RefBox 2024: 20 s; 2016: 30 s)."""
    leave_time: Seconds | None = 10.0
    """After which a robot wholly outside the lines is taken off for repair (ours)."""

    @model_validator(mode="after")
    def _stops_before_it_starts(self) -> "Rules":
        for name in ("restart_time", "kick_off_time"):
            if getattr(self, name) < self.stop_time:
                wrong = f"must be at least stop_time = {self.stop_time:g}"
                raise Fault(wrong, at=(name,))
        return self
