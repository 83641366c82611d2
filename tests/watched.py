"""A game that a test moves by hand, watched by both teams' cameras."""

import numpy as np
from factory import merged, player, scenario

from soccersim.perception import Perception
from soccersim.sheet import BALL, BALL_KNOWN, HEADER, OPPONENT, OPPONENTS_KNOWN, ROBOT, sheet_size
from soccersim.spec.senses import Senses
from soccersim.state import new_estimate, new_readings, new_truth

NOTHING = [0, 0, 0]
# exact, at once, always
SHARP = {
    "camera": {
        "delay": 0.0,
        "dropout": 0.0,
        "scale_sd": 0.0,
        "ball": {"range": 50.0, "radial": NOTHING, "tangential": NOTHING, "dropout": 0.0},
        "opponents": {"range": 50.0, "radial": NOTHING, "tangential": NOTHING, "dropout": 0.0},
        "lines": {"distance_sd": 0.0, "heading_sd_deg": 0.0, "dropout": 0.0},
    },
    "radio": {"delay": 0.0, "order_loss": 0.0, "report_loss": 0.0},
}
REALISTIC = Senses().model_dump(exclude={"about"})  # the defaults are those of the preset


def sharp(radio=None, **camera):
    """Perfect senses with changes to camera and radio."""
    return merged(SHARP, {"camera": camera, "radio": radio or {}})


def realistic(radio=None, **camera):
    """The usual senses with changes to camera and radio."""
    return merged(REALISTIC, {"camera": camera, "radio": radio or {}})


class Watched:
    """Robots at their starts and a ball; `go` lets time pass, all moving on as they move.

    The robots' odometry is exact, and so is what they believe at the start.
    """

    def __init__(self, *starts, away=(), senses=SHARP, ball=(0.0, -6.0), **more):
        sides = [("home", s) for s in starts] + [("away", s) for s in away]
        players = [
            player(start=start, team=team, name=team, number=i + 1, keeper=i == 0)
            for i, (team, start) in enumerate(sides)
        ]
        self.scenario = scenario(*players, senses=senses, ball={"at": ball}, **more)
        self.perception = Perception(self.scenario)
        count = len(sides)
        self.truth = new_truth(count + 1, count, 3)
        self.readings, self.estimate = new_readings(count, 3), new_estimate(count, 3)
        for i, robot in enumerate(self.scenario.robots):
            self.truth.body[i, :3] = self.scenario.coordinates.field_pose(robot.start)
        self.truth.body[count, :2] = ball
        self.estimate.pose[:] = self.truth.body[:count, :3]
        self.in_play = np.ones(count, np.int64)
        self.direction = np.array([1.0, -1.0])
        self.counts = (len(starts), len(away))
        self.tick, self.dt = 0, self.scenario.dt
        self.span = self.perception.beat * self.dt  # s from frame to frame
        self.look()

    @property
    def ball(self):
        """x, y, heading, vx, vy, omega of the ball; write into it to move it."""
        return self.truth.body[-1]

    @property
    def off(self):
        """What the robots believe of their poses less what is so."""
        return self.estimate.pose - self.truth.body[: len(self.estimate.pose), :3]

    def look(self):
        """One step of both teams."""
        self.perception.step(
            self.truth, self.readings, self.estimate, self.tick, self.in_play, self.direction
        )

    def go(self, frames=1, move=None):
        """Let frames pass; move(self) may change what is so before each."""
        body, robots = self.truth.body, len(self.estimate.pose)
        for _ in range(frames):
            if move:
                move(self)
            turned = body[:robots, 2] + 0.5 * self.span * body[:robots, 5]
            c, s = np.cos(turned), np.sin(turned)
            vx, vy = body[:robots, 3], body[:robots, 4]
            twist = np.stack([c * vx + s * vy, c * vy - s * vx, body[:robots, 5]], axis=1)
            self.estimate.twist[:] = twist
            drift = self.estimate.pose[:, 2] - body[:robots, 2]
            body[:, :3] += self.span * body[:, 3:]
            c, s = np.cos(drift), np.sin(drift)  # a robot that faces wrong reckons wrong
            self.estimate.pose[:, 0] += self.span * (c * vx - s * vy)
            self.estimate.pose[:, 1] += self.span * (s * vx + c * vy)
            self.estimate.pose[:, 2] += self.span * body[:robots, 5]
            self.tick += self.perception.beat
            self.look()
        return self

    def sheet(self, slot=0, later=0):
        """What a team is told now, or so many ticks later."""
        own, others = self.counts[slot], self.counts[1 - slot]
        sheet = np.full(sheet_size(own, others), np.nan)
        self.perception.fill(sheet, slot, self.tick + later)
        return Told(sheet, own)


class Told:
    """A sheet by its parts."""

    def __init__(self, sheet, robots):
        self.numbers, at = sheet, HEADER + robots * ROBOT
        self.ball_known = sheet[BALL_KNOWN]
        self.ball = sheet[BALL : BALL + 5]  # x, y, vx, vy, age
        self.robots = sheet[HEADER:at].reshape(robots, ROBOT)
        known = int(sheet[OPPONENTS_KNOWN])
        self.opponents = sheet[at : at + known * OPPONENT].reshape(known, OPPONENT)

    @property
    def met(self):
        """The opponents in the order of their x."""
        return self.opponents[np.argsort(self.opponents[:, 0])]


def rms(values):
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))
