"""A match without physics: tests move robots and ball, watch and referee look on."""

from math import hypot

import numpy as np

from soccersim import load_scenario
from soccersim.kernel import kernel
from soccersim.referee.judge import Referee
from soccersim.referee.phases import RESTARTS, Phase
from soccersim.referee.watch import build_watch, watch
from soccersim.spec.scenario import Scenario
from soccersim.state import new_truth

BUNDLED = {}


@kernel
def watch_tick(w, truth, tick):
    watch(w, truth, tick)


def scenario(name="msl-match", changes=None, match=None, **rules):
    """A bundled match at 100 ticks a second, with changes of its keys and of its rules."""
    if name not in BUNDLED:
        BUNDLED[name] = load_scenario(name).model_dump(exclude_unset=True)
    tree = {**BUNDLED[name], "timing": {"physics_hz": 100}, **(changes or {})}
    tree["match"] = {**tree["match"], **(match or {})}
    tree["match"]["rules"] = {**tree["match"]["rules"], **rules}
    return Scenario.model_validate(tree)


class Rig:
    """Bodies go where they are put; velocities are what they are set to, and move nothing."""

    def __init__(self, written=None, **rules):
        self.scenario = written or scenario(**rules)
        players = self.scenario.robots
        self.names = [player.name for player in players]
        self.radius = [player.model.radius for player in players]
        self.truth = new_truth(len(players) + 1, len(players), 3)
        self.body = self.truth.body
        at = self.scenario.coordinates
        self.body[:-1, :3] = [at.field_pose(player.start) for player in players]
        if self.scenario.match.swap_ends:
            self.body[:, :2] *= -1.0
            self.body[:-1, 2] += np.pi
        self.watch = build_watch(self.scenario)
        self.referee = Referee(self.scenario)
        self.every = self.scenario.every(self.scenario.match.decide_hz)
        self.hz = self.scenario.timing.physics_hz
        self.tick, self.events, self.phases = 0, [], []
        self.ruling = None

    @property
    def phase(self):
        return self.referee.phase

    @property
    def kinds(self):
        return [event.kind for event in self.events]

    @property
    def ball(self):
        """x, y; write into it to move the ball."""
        return self.body[-1, :2]

    def place(self, name):
        """x, y of a robot."""
        return tuple(self.body[self.row(name), :2])

    def row(self, name):
        return self.names.index(name)

    def event(self, kind):
        """The last event of a kind."""
        return [event for event in self.events if event.kind == kind][-1]

    def far(self, name):
        """Distance of a robot's centre from the ball's."""
        x, y = self.place(name)
        return hypot(x - self.ball[0], y - self.ball[1])

    def put(self, name, x, y, heading=0.0, vx=0.0, vy=0.0):
        """A robot, or the ball."""
        self.body[-1 if name == "ball" else self.row(name)] = x, y, heading, vx, vy, 0

    def beside(self, name, dx=-1.0, dy=0.0, gap=0.001):
        """A robot beside the ball, touching it, on the side of (dx, dy)."""
        reach = self.radius[self.row(name)] + self.scenario.ball.radius + gap
        x, y = self.ball + np.array([dx, dy]) / hypot(dx, dy) * reach
        self.put(name, x, y)

    def away(self):
        """All robots at rest, far from the centre and from each other, in their own halves."""
        for row, name in enumerate(self.names):
            side = self.referee.direction[int(row >= 5)]
            if self.referee.in_play[row]:
                self.put(name, -side * 6.0, (row % 5) * 1.5 - 3.0)
        return self

    def judge(self):
        """One decision of the referee, carried out."""
        self.ruling = self.referee.judge(self.tick, self.body, self.watch)
        for row, pose in self.ruling.robots.items():
            self.body[row] = [*pose, 0, 0, 0]
        if self.ruling.ball:
            self.body[-1] = [*self.ruling.ball, 0, 0, 0, 0]
        self.events += self.ruling.events
        self.phases.append((self.tick, self.phase, self.referee.started))

    def step(self, move=None):
        """One tick; at decisions the referee judges first."""
        if self.tick % self.every == 0:
            self.judge()
        if move:
            move(self.tick)
        watch_tick(self.watch, self.truth, self.tick)
        self.tick += 1

    def run(self, seconds, move=None):
        """Many ticks; returns itself."""
        for _ in range(round(seconds * self.hz)):
            self.step(move)
        return self

    def until(self, test, seconds=60.0, move=None):
        """As long as the test fails."""
        for _ in range(round(seconds * self.hz)):
            if test():
                return self
            self.step(move)
        raise AssertionError(f"in vain: {self.phase} at {self.tick / self.hz} s, {self.kinds[-6:]}")

    def to_signal(self):
        """Up to the signal of the next restart."""
        return self.until(lambda: self.phase in RESTARTS)

    def to_start(self):
        """Up to the START of the next restart."""
        return self.until(lambda: self.phase in RESTARTS and self.referee.started)

    def roll(self, x, y, seconds=0.2):
        """The ball rolls straight to x, y."""
        steps = round(seconds * self.hz)
        for left in range(steps, 0, -1):
            self.ball[:] += (np.array([x, y]) - self.ball) / left
            self.step()
        return self

    def touch(self, name, dx=-1.0, dy=0.0):
        """A robot comes to the ball, touches it, and goes back to where it was."""
        self.run(0.25)  # it has let go of the ball if it was the last to have it
        was = self.body[self.row(name)].copy()
        self.beside(name, dx, dy)
        self.run(0.08)
        self.body[self.row(name)] = was
        return self

    def kick(self, name, x, y, seconds=0.2):
        """A robot comes to the ball, kicks it to x, y, and goes back to where it was."""
        was = self.body[self.row(name)].copy()
        self.beside(name, self.ball[0] - x, self.ball[1] - y)
        self.run(0.08)
        self.roll(x, y, seconds)
        self.body[self.row(name)] = was
        return self

    def stretches(self):
        """How long each phase lasted each time, before and after START: [phase, started, s]."""
        found = []
        for tick, phase, started in self.phases:
            if not found or found[-1][:2] != [phase, started]:
                found.append([phase, started, tick])
        ends = [tick for *_, tick in found[1:]] + [self.tick]
        return [(p, s, (b - a) / self.hz) for (p, s, a), b in zip(found, ends, strict=True)]

    def playing(self, x=1.0, y=0.0):
        """The ball in play at x, y after a kick-off by home-5, passed to home-4; all far away."""
        self.away().to_start()
        self.kick("home-5", 1.0, 0.0).touch("home-4").put("ball", x, y)
        assert self.phase is Phase.PLAY
        return self.run(0.3)
