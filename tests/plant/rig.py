"""The plant of a scenario on a test bench: PWM in, motion out; no sensors, no robot code."""

import numpy as np
import pymunk
from factory import player, robot, scenario

from soccersim.plant.ball import Rolling, roll_ball
from soccersim.plant.build import build_drive, wheel_count
from soccersim.plant.drive import drive_robots
from soccersim.plant.world import World, step_bodies
from soccersim.state import new_truth

KIWI = {"azimuth_deg": [30, 150, 270], "distance": 0.19}
FOUR = {"azimuth_deg": [45, 135, 225, 315], "distance": 0.19}
MECANUM = {  # all wheels roll forward; they push along the sides of a square round the robot
    "azimuth_deg": [45, 135, 225, 315],
    "distance": 0.25,
    "direction_deg": [0, 0, 0, 0],
    "roller_deg": [-45, 45, -45, 45],
}
# no bearing drags and no floor creeps: what is left is the law under test
COULOMB = {"roller": 0.0, "creep_ratio": 0.0}


class Rig:
    """Players (and a ball) that move as the PWM levels in `pwm` say."""

    def __init__(self, *players, dt=0.002, **more):
        written = scenario(*players, **more)
        models = [each.model for each in written.robots]
        robots, wheels = len(models), max(map(wheel_count, models))
        self.dt = dt
        self.truth = new_truth(robots + (written.ball is not None), robots, wheels)
        self.world = World(written, self.truth)
        self.drive = build_drive(models, written.field, written.seed)
        self.pwm = np.zeros((robots, wheels), np.int64)
        self.ball = None
        if written.ball:
            ball, field = written.ball, written.field
            self.ball = Rolling(ball.mass, ball.shell, field.ball_friction, field.ball_rolling)

    @property
    def body(self):
        """(B, 6) x, y, heading, vx, vy, omega; field frame. Read it, and throw to change it."""
        return self.truth.body

    def throw(self, row, vx, vy, omega=0.0):
        """Give a body a velocity."""
        body = list(self.world.space.bodies)[row]
        body.velocity, body.angular_velocity = pymunk.Vec2d(vx, vy), omega
        self.body[row, 3:] = vx, vy, omega

    def tick(self, ticks=1):
        """So many ticks as a simulation does them; returns itself."""
        for _ in range(ticks):
            drive_robots(self.drive, self.truth, self.pwm, self.dt)
            if self.ball:
                roll_ball(self.ball, self.truth, self.dt)
            assert step_bodies(self.world.chipmunk, self.truth, self.dt)
        return self

    def run(self, seconds):
        """As many ticks as that takes; returns itself."""
        return self.tick(round(seconds / self.dt))

    def lift(self):
        """Take all wheels off the floor."""
        self.drive.load[:] = 0.0
        self.drive.load_shift[:] = 0.0

    def seize(self):
        """Make the wheels turn on as they do, whatever the floor and the motors say."""
        self.drive.spin_inertia[:] = 1e9

    def roll(self, twist):
        """Turn the wheels of robot 0 as this body twist needs without slip."""
        rolling = self.drive.forward[0] @ np.asarray(twist, float)
        self.truth.wheel_speed[0] = rolling / self.drive.radius[0]


def kiwi(**changes):
    """One robot on three wheels, at the centre spot with its x axis along the field's."""
    return player(robot(**changes))


def four_wheels(**changes):
    """One robot on four wheels at 45 degrees."""
    return player(robot({"drive": FOUR}, **changes))
