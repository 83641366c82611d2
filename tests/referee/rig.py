"""A match without physics: tests move robots and ball, watch and referee look on."""

from math import hypot

import numpy as np

from soccersim import load_scenario
from soccersim.kernel import kernel
from soccersim.referee.judge import Referee
from soccersim.referee.phases import Phase
from soccersim.referee.watch import build_watch, watch
from soccersim.spec.scenario import Scenario
from soccersim.state import new_truth


@kernel
def watch_tick(w, truth, tick):
    watch(w, truth, tick)


BASE = {}


def scenario(name="msl-match", changes=None, **rules):
    """A bundled match with changes of its keys and of its rules."""
    if name not in BASE:
        BASE[name] = load_scenario(name).model_dump(exclude_unset=True)
    tree = {**BASE[name], **(changes or {})}
    match = {**tree["match"]}
    match["rules"] = {**match["rules"], **rules}
    return Scenario.model_validate({**tree, "match": match})


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
        self.watch = build_watch(self.scenario)
        self.referee = Referee(self.scenario)
        self.every = self.scenario.every(self.scenario.match.decide_hz)
        self.hz = self.scenario.timing.physics_hz
        self.tick, self.events, self.rulings = 0, [], []
        self.phases = []

    @property
    def phase(self):
        return self.referee.phase

    @property
    def kinds(self):
        return [event.kind for event in self.events]

    def last(self, kind):
        return [event for event in self.events if event.kind == kind][-1]

    def row(self, name):
        return self.names.index(name)

    def put(self, name, x, y, heading=0.0):
        """A robot, or the ball, at rest."""
        row = -1 if name == "ball" else self.row(name)
        self.body[row] = x, y, heading, 0, 0, 0

    def beside(self, name, dx=-1.0, dy=0.0):
        """A robot beside the ball, touching it, on the side of (dx, dy)."""
        reach = self.radius[self.row(name)] + self.scenario.ball.radius + 0.001
        x, y = self.body[-1, :2] + np.array([dx, dy]) / hypot(dx, dy) * reach
        self.put(name, x, y)

    def judge(self):
        ruling = self.referee.judge(self.tick, self.body, self.watch)
        for row, pose in ruling.robots.items():
            self.body[row] = [*pose, 0, 0, 0]
        if ruling.ball:
            self.body[-1] = [*ruling.ball, 0, 0, 0, 0]
        self.events += ruling.events
        self.rulings.append(ruling)
        self.phases.append((self.tick, self.referee.phase, self.referee.started))
        return ruling

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

    def to_start(self):
        """Up to the START of the restart that is on."""
        return self.until(
            lambda: self.phase not in (Phase.STOP, Phase.PLAY) and self.referee.started
        )

    def to_play(self):
        """Up to where the ball is in play, after nobody has touched it."""
        return self.until(lambda: self.phase is Phase.PLAY)

    def away(self):
        """All robots far from the ball and from each other, each in its own half."""
        for row, player in enumerate(self.scenario.robots):
            side = self.referee.direction[row >= 5]
            self.put(player.name, -side * 6.0, (row % 5) * 1.5 - 3.0)

    def shove_ball(self, dx, dy, steps=10):
        """The ball moves so far in so many ticks."""
        for _ in range(steps):
            self.body[-1, :2] += np.array([dx, dy]) / steps
            self.step()
