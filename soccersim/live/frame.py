"""A moment of play as bytes: little-endian float64 in a fixed order, which `layout` tells.

head, ball, robots one after the other (each followed by its wheels), links of arms.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.live.match import MatchPlay
from soccersim.live.play import Play
from soccersim.sheet import PHASES
from soccersim.spec.scenario import Scenario

HEAD = (
    *("tick", "age", "factor", "speed", "paused", "over", "phase", "whose", "started"),
    *("home", "away", "half", "direction", "left", "viewers"),
    *("home_x", "home_y", "home_age", "away_x", "away_y", "away_age"),
)
BALL = ("x", "y", "heading", "vx", "vy", "known")
ROBOT = (
    *("x", "y", "heading", "vx", "vy", "omega", "bx", "by", "bheading", "bvx", "bvy", "bomega"),
    *("cx", "cy", "cturn", "rx", "ry", "rheading", "tx", "ty", "theading"),
    *("gyro", "leg", "contact", "playing", "kick", "dribble", "taken"),
    *("sx", "sy"),  # where its camera put the ball, m
)
WHEEL = ("counts", "read", "true", "wanted", "pwm", "slip")  # rad/s but for counts, pwm, slip m/s
LINK = ("x", "y", "heading")
NAN = float("nan")


@dataclass(frozen=True)
class Poses:
    """Where everything is: bodies (B, 3) and beliefs (R, 3), and who is in play."""

    body: NDArray[np.float64]
    believed: NDArray[np.float64]
    playing: list[int]
    targets: NDArray[np.float64]  # (R, 3), nan where there is none


def poses(numbers: NDArray[np.float64], scenario: Scenario) -> Poses:
    """The poses of a moment that was packed."""
    robots, links = len(scenario.robots), 3 * len(scenario.arms) * len(LINK)
    start, end = len(HEAD) + len(BALL), len(numbers) - links
    rows = numbers[start:end].reshape(robots, -1)
    body = [rows[:, :3]]
    if scenario.ball:
        body.append(numbers[len(HEAD) : len(HEAD) + 3][None])
    body.append(numbers[end:].reshape(-1, 3))
    playing = rows[:, ROBOT.index("playing")].astype(int).tolist()
    return Poses(np.concatenate(body), rows[:, 6:9], playing, rows[:, 18:21])


class Framer:
    """Packs the moments of one play."""

    def __init__(self, play: Play) -> None:
        self.play = play
        m = play.simulation.machine
        self.robots, self.wheels = m.truth.wheel_speed.shape
        self.arms = len(play.scenario.arms)
        self.size = len(ROBOT) + self.wheels * len(WHEEL)
        self.numbers = np.zeros(
            len(HEAD) + len(BALL) + self.robots * self.size + 3 * self.arms * len(LINK)
        )
        start = len(HEAD) + len(BALL)
        end = start + self.robots * self.size
        self.rows = self.numbers[start:end].reshape(self.robots, self.size)
        self.links = self.numbers[end:].reshape(-1, len(LINK))
        self.at = {name: i for i, name in enumerate(ROBOT)}

    def layout(self) -> dict[str, Any]:
        """What stands where."""
        return {
            "head": HEAD,
            "ball": BALL,
            "robot": ROBOT,
            "wheel": WHEEL,
            "link": LINK,
            "robots": self.robots,
            "wheels": self.wheels,
            "links": 3 * self.arms,
        }

    def packed(self, told: dict[str, float]) -> bytes:
        """This moment; told: what the session knows of the head."""
        head = self._match_head() | told | {"tick": self.play.tick}
        self.numbers[: len(HEAD)] = [head.get(name, NAN) for name in HEAD]
        self._ball()
        self._robots()
        if self.arms:
            m = self.play.simulation.machine
            first = self.robots + (self.play.scenario.ball is not None)
            self.links[:] = m.truth.body[first:, :3]
        return self.numbers.astype("<f8", copy=False).tobytes()

    def _match_head(self) -> dict[str, float]:
        play = self.play
        if not isinstance(play, MatchPlay):
            return {"direction": 1.0}
        referee = play.game.referee
        head = {
            "phase": PHASES.index(referee.phase),
            "whose": -1.0 if referee.whose is None else referee.whose,
            "started": referee.started,
            "home": referee.score[0],
            "away": referee.score[1],
            "half": referee.half,
            "direction": referee.direction[0],
            "left": max(0, referee.end - play.tick) / play.hz,
        }
        for slot, side in enumerate(("home", "away")):
            names = f"{side}_x", f"{side}_y", f"{side}_age"
            head |= dict(zip(names, play.seen(slot), strict=True))
        return head

    def _ball(self) -> None:
        """Where it is, and 1; without one, zeros."""
        if self.play.scenario.ball:
            body = self.play.simulation.machine.truth.body[self.robots]
            self.numbers[len(HEAD) : len(HEAD) + len(BALL)] = *body[:5], 1.0

    def _robots(self) -> None:
        m, at, rows = self.play.simulation.machine, self.at, self.rows
        rows[:, 0:6] = m.truth.body[: self.robots]
        rows[:, 6:9], rows[:, 9:12] = m.estimate.pose, m.estimate.twist
        rows[:, 12:15], rows[:, 15:18] = m.command.twist, m.command.reference
        rows[:, 18:21] = NAN
        for robot, target in self.play.targets.items():
            rows[robot, 18:21] = target
        rows[:, at["gyro"]], rows[:, at["leg"]] = m.readings.gyro, m.progress.leg
        rows[:, at["contact"]], rows[:, at["playing"]] = m.readings.contact, m.watch.active
        rows[:, at["kick"]], rows[:, at["dribble"]] = m.command.kick, m.command.dribble
        rows[:, at["taken"]], rows[:, [at["sx"], at["sy"]]] = 0.0, NAN
        if isinstance(self.play, MatchPlay):
            rows[list(self.play.pilot.taken), at["taken"]] = 1.0
            rows[:, [at["sx"], at["sy"]]] = self.play.game.sighted
        wheels = rows[:, len(ROBOT) :].reshape(self.robots, self.wheels, len(WHEEL))
        for k, values in enumerate(
            (
                *(m.readings.counts, m.readings.wheel_speed, m.truth.wheel_speed),
                *(m.command.wheel_speed, m.command.pwm, m.truth.slip),
            )
        ):
            wheels[:, :, k] = values
