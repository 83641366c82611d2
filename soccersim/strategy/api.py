"""The messages between the game and a team: a View in, one Command a robot out.

Team frame throughout: the own goal at -x, y left, headings counter-clockwise from +x. Twists
(vx, vy, omega) are in the robot's body frame: x forward, y left. SI and radians.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Literal

from soccersim.sheet import (
    BALL,
    BALL_KNOWN,
    GOALS,
    HALF,
    HEADER,
    LEFT,
    OPPONENT,
    OPPONENTS_KNOWN,
    PHASE,
    PHASES,
    ROBOT,
    STARTED,
    TIME,
    WHOSE,
)

if TYPE_CHECKING:
    from numpy.random import Generator


class Phase(StrEnum):
    """What is being played; `View.ours` says whose restart it is."""

    STOP = "stop"
    KICK_OFF = "kick_off"
    THROW_IN = "throw_in"
    GOAL_KICK = "goal_kick"
    CORNER = "corner"
    FREE_KICK = "free_kick"
    PENALTY = "penalty"
    DROPPED_BALL = "dropped_ball"
    PLAY = "play"
    OVER = "over"


@dataclass(frozen=True, slots=True)
class Area:
    """A rectangle before each goal, m."""

    depth: float  # from the goal line into the field
    width: float  # along the goal line


@dataclass(frozen=True, slots=True)
class Body:
    """What a robot of the own team is able to do."""

    radius: float = 0.24  # m
    speed: float = 3.0  # m/s
    acceleration: float = 2.2  # m/s2
    turn_rate: float = 6.0  # rad/s
    turn_acceleration: float = 12.0  # rad/s2
    kick_speed: float = 12.0  # m/s, 0: it has no kicker
    has_dribbler: bool = True


@dataclass(frozen=True, slots=True)
class Rules:
    """The figures of the rules, under the scenario's names; None: that rule is not played."""

    lines: bool = True  # False: the boards are the bounds
    restart_time: float = 7.0  # s from STOP to START, at the latest
    play_time: float = 7.0  # s from START until defenders may play a ball that nobody has taken
    opponents: float = 3.0  # m, from the ball to the defenders until it is in play
    mates: float = 2.0  # m, from the ball to the taker's mates
    dropped_ball: float = 1.0  # m, from a dropped ball to everybody
    roll: float = 0.5  # m, before the taker's team may touch the ball again
    pass_at_restart: bool = True  # no goal before a mate has touched the ball
    own_half_goals: bool = False  # whether a goal counts that was kicked from the own half
    regain_roll: float | None = 1.0  # m, to a mate in the other half, after winning it in ours
    dribble: float | None = 3.0  # m, with the ball, from where it was caught
    area_time: float | None = 10.0  # s, of one robot besides its keeper in a penalty area
    keeper_protected: bool = True  # touching the keeper in its goal area is a foul
    stuck_time: float = 10.0  # s, then a ball that does not get away is dropped


@dataclass(frozen=True, slots=True)
class Pitch:
    """The field, the ball and the rules; the goals stand at x = -+length / 2."""

    length: float = 22.0  # m, between the goal lines
    width: float = 14.0  # m, between the touch lines
    border: float = 1.0  # m, from the lines to the board
    goal_width: float = 2.4  # m, between the posts
    goal_depth: float = 0.6  # m
    penalty_area: Area | None = Area(2.25, 6.9)
    goal_area: Area | None = Area(0.75, 3.9)
    penalty_mark: float | None = 3.6  # m from the goal line
    centre_circle: float | None = 2.0  # m, radius
    ball_radius: float = 0.11  # m
    ball_sliding: float = 3.92  # m/s2, a kicked ball slows like this until it rolls
    ball_rolling: float = 0.35  # m/s2, then like this
    rules: Rules = Rules()
    bodies: tuple[Body, ...] = ()  # of the own robots, in the order of View.robots


@dataclass(frozen=True, slots=True)
class Player:
    """A robot of the own team, as its last report told it, carried on to now."""

    number: int
    x: float  # m
    y: float  # m
    heading: float = 0.0  # rad
    vx: float = 0.0  # m/s, body frame
    vy: float = 0.0  # m/s, body frame
    omega: float = 0.0  # rad/s
    has_ball: bool = False  # its contact sensor feels the ball in its mouth
    role: Literal["keeper", "field"] = "field"
    in_play: bool = True  # False: out for repair or penalty; its command is not obeyed
    age: float = 0.0  # s since the report
    body: Body = Body()


@dataclass(frozen=True, slots=True)
class Ball:
    """The ball, as the team's robots saw it, carried on to now."""

    x: float  # m
    y: float  # m
    vx: float = 0.0  # m/s, team frame
    vy: float = 0.0  # m/s, team frame
    age: float = 0.0  # s since it was last seen


@dataclass(frozen=True, slots=True)
class Opponent:
    """A robot of the other team that one of ours has seen; nobody can tell its number."""

    x: float  # m
    y: float  # m
    vx: float = 0.0  # m/s, team frame
    vy: float = 0.0  # m/s, team frame
    age: float = 0.0  # s since it was last seen


@dataclass(frozen=True, slots=True)
class View:
    """What a team knows at one decision."""

    robots: tuple[Player, ...]
    ball: Ball | None = None  # None: not seen yet
    opponents: tuple[Opponent, ...] = ()
    field: Pitch = Pitch()
    phase: Phase = Phase.PLAY
    ours: bool | None = None  # the restart: True ours, False theirs, None nobody's
    started: bool = True  # START was given: whose restart it is may play the ball
    time: float = 0.0  # s since the match began
    time_left: float = 0.0  # s to the end of the match
    half: int = 1
    score: tuple[int, int] = (0, 0)  # ours, theirs


@dataclass(frozen=True, slots=True)
class Line:
    """A line on the frames, in the team frame, m."""

    x1: float
    y1: float
    x2: float
    y2: float


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle on the frames, in the team frame, m."""

    x: float
    y: float
    radius: float


@dataclass(frozen=True, slots=True)
class Text:
    """A few words on the frames, in the team frame."""

    x: float
    y: float
    text: str


Note = Line | Circle | Text


@dataclass(frozen=True, slots=True)
class Command:
    """What one robot shall do until the next decision; faster than it can is as fast as it can."""

    vx: float = 0.0  # m/s forward
    vy: float = 0.0  # m/s to its left
    omega: float = 0.0  # rad/s counter-clockwise
    kick: float = 0.0  # m/s, once, as soon as the ball is in the mouth; 0: no
    dribble: bool = False  # hold the ball in the mouth
    label: str = ""  # shown beside the robot
    notes: Sequence[Note] = ()  # drawn on the frames


class Strategy(ABC):
    """A team's mind. Any class with the same two methods is one as well.

    `rng` is the team's own numpy Generator: chance taken from it, and from nowhere else, makes
    matches repeatable. Options come by name from the scenario; declare the ones you take:

    >>> class Mine(Strategy):
    ...     def __init__(self, rng, press=True):
    ...         super().__init__(rng)
    ...         self.press = press
    """

    def __init__(self, rng: "Generator") -> None:
        self.rng = rng

    @abstractmethod
    def decide(self, view: View) -> Sequence[Command]:
        """One command a robot, in the order of view.robots."""


_PHASES = tuple(Phase(name) for name in PHASES)


def view_of(sheet: Sequence[float], pitch: Pitch) -> View:
    """The view that a sheet (soccersim.sheet) tells, as a list of floats: 7 us for five a side.

    A sheet has as many own robots as pitch.bodies.
    """
    robots = []
    at = HEADER
    for body in pitch.bodies:
        playing, number, keeper, x, y, heading, vx, vy, omega, has_ball, age = sheet[
            at : at + ROBOT
        ]
        role: Literal["keeper", "field"] = "keeper" if keeper else "field"
        robots.append(
            Player(
                int(number),
                x,
                y,
                heading,
                vx,
                vy,
                omega,
                has_ball > 0,
                role,
                playing > 0,
                age,
                body,
            )
        )
        at += ROBOT
    end = at + OPPONENT * int(sheet[OPPONENTS_KNOWN])
    whose = sheet[WHOSE]
    return View(
        tuple(robots),
        Ball(*sheet[BALL:OPPONENTS_KNOWN]) if sheet[BALL_KNOWN] else None,
        tuple([Opponent(*sheet[row : row + OPPONENT]) for row in range(at, end, OPPONENT)]),
        pitch,
        _PHASES[int(sheet[PHASE])],
        None if whose < 0 else whose > 0,
        sheet[STARTED] > 0,
        sheet[TIME],
        sheet[LEFT],
        int(sheet[HALF]),
        (int(sheet[GOALS]), int(sheet[GOALS + 1])),
    )
