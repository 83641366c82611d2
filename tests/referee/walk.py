"""Robots and a ball that wander about, for laws that must hold whatever happens."""

from math import hypot

import numpy as np

from soccersim.referee.phases import Phase


class Walk:
    """Moves the bodies of a rig inside the boards; the same seed wanders the same way.

    Robots run after the ball, to random places, or stand; they go through each other. halts: they
    mind STOP; polite: they also wait until the ball is in play.
    side = -1.0 wanders as the same seed does with +1.0, turned by half a turn.
    """

    def __init__(self, rig, seed, side=1.0, halts=True, polite=False):
        self.rig, self.side, self.halts, self.polite = rig, side, halts, polite
        self.rng = np.random.default_rng(seed)
        field = rig.scenario.field
        self.room = np.array([field.half_length + field.border, field.half_width + field.border])
        self.targets = np.zeros((len(rig.names), 2))
        self.moods = np.zeros(len(rig.names), int)
        self.ball = np.zeros(2)  # velocity, turned by side
        self.sticky = -1  # the robot that carries the ball along once it touches it

    def __call__(self, tick):
        rig, rng = self.rig, self.rng
        if tick % 20 == 0:
            self._decide()
        body = rig.body * self.side
        for row in range(len(rig.names)):
            to = body[-1, :2] if self.moods[row] == 1 else self.targets[row]
            way = to - body[row, :2]
            speed = min(3.0, 5.0 * hypot(*way)) if self.moods[row] else 0.0
            stands = self.halts and row in rig.ruling.halted
            stands |= self.polite and rig.phase is not Phase.PLAY
            v = np.zeros(2) if stands else way / max(hypot(*way), 1e-9) * speed
            self._move(row, v, rig.radius[row])
        for row in range(len(rig.names)):  # the ball bounces off robots, now and then hard
            away = body[-1, :2] - body[row, :2]
            if hypot(*away) < rig.radius[row] + 0.11 and rng.random() < 0.3:
                if row == self.sticky:
                    self.ball = body[row, 3:5].copy()
                    continue
                self.ball = away / max(hypot(*away), 1e-9) * rng.choice([0.5, 2.0, 8.0])
        self.ball *= 0.995
        place = body[-1, :2] + self.ball / rig.hz
        self.ball[np.abs(place) > self.room - 0.11] *= -0.6
        self._move(-1, self.ball, 0.11)

    def _decide(self):
        rng, count = self.rng, len(self.moods)
        change = rng.random(count) < 0.1
        if change[0]:
            self.sticky = rng.integers(count)
        self.moods[change] = rng.integers(0, 3, count)[change]
        places = rng.uniform(-1, 1, (count, 2)) * (self.room - 0.3)
        self.targets[change] = places[change]

    def _move(self, row, v, radius):
        body, room = self.rig.body, self.room - radius - 0.001
        body[row, :2] = np.clip(body[row, :2] + self.side * v / self.rig.hz, -room, room)
        body[row, 3:5] = self.side * v
