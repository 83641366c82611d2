"""What a browser may say: one strict model a command. All else is answered, and changes nothing.

Places in the field frame, m and rad; `robot` counts the scenario's robots from 0.
"""

import json
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from soccersim.problems import one_line
from soccersim.spec import MAX_ROBOTS

LONGEST = 2000  # characters of a message
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
FAR = 100.0  # m: no field is larger

Robot = Annotated[int, Field(ge=0, lt=MAX_ROBOTS)]
Place = Annotated[float, Field(ge=-FAR, le=FAR)]
Velocity = Annotated[float, Field(ge=-20, le=20)]  # m/s, rad/s
Gain = Annotated[float, Field(ge=0, le=200)]
Named = Annotated[str, Field(min_length=1, max_length=300)]
Slot = Literal["home", "away"]


class Message(BaseModel):
    """What all have in common; `id` comes back in the answer."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)
    id: Annotated[int, Field(ge=0, lt=2**53)] = 0


class Go(Message):
    """A robot is sent to a place; without a heading it keeps its own."""

    do: Literal["go"]
    robot: Robot
    x: Place
    y: Place
    heading: Annotated[float, Field(ge=-100, le=100)] | None = None


class Drive(Message):
    """A robot is driven by hand, for a moment: say it again to go on."""

    do: Literal["drive"]
    robot: Robot
    vx: Velocity
    vy: Velocity
    omega: Velocity


class Halt(Message):
    """A robot stops where it is."""

    do: Literal["halt"]
    robot: Robot


class Release(Message):
    """In a match, a robot obeys its team again."""

    do: Literal["release"]
    robot: Robot


class Kick(Message):
    """A robot kicks as soon as it has the ball, within a second; m/s."""

    do: Literal["kick"]
    robot: Robot
    speed: Annotated[float, Field(gt=0, le=30)]


class Dribble(Message):
    """A robot holds the ball in its mouth, or lets go."""

    do: Literal["dribble"]
    robot: Robot
    on: bool


class Ball(Message):
    """The ball is put somewhere, and may roll from there."""

    do: Literal["ball"]
    x: Place
    y: Place
    vx: Velocity = 0.0
    vy: Velocity = 0.0


class Push(Message):
    """A hand pushes a robot for a moment; N, field frame."""

    do: Literal["push"]
    robot: Robot
    fx: Annotated[float, Field(ge=-500, le=500)]
    fy: Annotated[float, Field(ge=-500, le=500)]


class Gains(Message):
    """The gains of one control loop of a robot, from now on."""

    do: Literal["gains"]
    robot: Robot
    loop: Literal["position", "heading", "wheel"]
    kp: Gain
    ki: Gain
    kd: Gain = 0.0


class Pause(Message):
    """The simulation stands still."""

    do: Literal["pause"]


class Resume(Message):
    """The simulation goes on."""

    do: Literal["resume"]


class Speed(Message):
    """Seconds of simulation in a second."""

    do: Literal["speed"]
    factor: Annotated[float, Field(ge=SPEEDS[0], le=SPEEDS[-1])]


class Step(Message):
    """So many ticks, then it stands still."""

    do: Literal["step"]
    ticks: Annotated[int, Field(ge=1, le=1000)] = 1


class Open(Message):
    """Another scenario, from its start; the teams of a match by their names."""

    do: Literal["open"]
    scenario: Named
    home: Named | None = None
    away: Named | None = None
    seed: Annotated[int, Field(ge=0, lt=2**53)] | None = None


class Referee(Message):
    """A button of the league's referee box."""

    do: Literal["referee"]
    call: Literal[
        "stop",
        "start",
        "kick_off",
        "free_kick",
        "goal_kick",
        "throw_in",
        "corner",
        "penalty",
        "dropped_ball",
        "goal",
        "subgoal",
        "half_time",
        "end",
        "repair",
    ]
    side: Slot | None = None
    robot: Robot | None = None


class Ping(Message):
    """How long is the way? Answered at once."""

    do: Literal["ping"]


Command = (
    *(Go, Drive, Halt, Release, Kick, Dribble, Ball, Push, Gains),
    *(Pause, Resume, Speed, Step, Open, Referee, Ping),
)
_ADAPTER: TypeAdapter[Message] = TypeAdapter(
    Annotated[
        Go
        | Drive
        | Halt
        | Release
        | Kick
        | Dribble
        | Ball
        | Push
        | Gains
        | Pause
        | Resume
        | Speed
        | Step
        | Open
        | Referee
        | Ping,
        Field(discriminator="do"),
    ]
)


class Wrong(Exception):
    """A message that is not obeyed, and why, in one line; `id` is that of the message if known."""

    def __init__(self, why: str, id: int = 0) -> None:
        super().__init__(one_line(why, 300))
        self.id = id


def read(text: str | bytes) -> Message:
    """The message; Wrong with the first thing that is wrong with it."""
    if not isinstance(text, str):
        raise Wrong('messages are text: JSON objects such as {"do": "pause"}')
    if len(text) > LONGEST:
        raise Wrong(f"a message of {len(text)} characters: at most {LONGEST}")
    try:
        return _ADAPTER.validate_json(text)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False, include_context=False)[0]
        where = ".".join(str(part) for part in first["loc"][1:])
        raise Wrong(": ".join(filter(None, (where, first["msg"]))), _id(text)) from None


def _id(text: str) -> int:
    """The id of a message that is wrong otherwise."""
    try:
        told = json.loads(text)
    except (ValueError, RecursionError):
        return 0
    number = told.get("id", 0) if isinstance(told, dict) else 0
    return number if type(number) is int and 0 <= number < 2**53 else 0
