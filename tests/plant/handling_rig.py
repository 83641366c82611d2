"""Robots with kickers and dribblers on a test bench: a test pushes and commands them."""

from math import cos, hypot, radians, sin

import numpy as np
from factory import merged, player, robot, scenario

from soccersim.simulation import Simulation

BALL, RADIUS, TOUCH = 0.43, 0.11, 0.36  # kg, m, m: centres of ball and robot that touch
REACH = 0.05  # m, of the mouth beyond touching
MU, SHELL, GRAVITY = 0.4, 2 / 3, 9.81
SMOOTH = {"ball_friction": 0.0, "ball_rolling": 0.0}
STRAIGHT = {"speed_sd": 0.0, "angle_sd_deg": 0.0}


def handler(changes=None, /, **more):
    """The exact robot with a kicker that does not scatter and a dribbler, with changes."""
    return robot(merged({"kicker": STRAIGHT, "dribbler": {}}, changes or {}), **more)


class Bench:
    """A run of a scenario, its wheels off the floor unless told otherwise."""

    def __init__(self, *players, hz=500, lifted=True, **more):
        more = {"duration": 60, "timing": {"physics_hz": hz}, **more}
        self.sim = Simulation(scenario(*players, **more))
        self.machine, self.dt = self.sim.machine, 1 / hz
        self.truth, self.command = self.machine.truth, self.machine.command
        self.handling, self.body = self.machine.handling, self.machine.truth.body
        self.mass = np.append(self.machine.drive.mass, BALL)
        if lifted:
            self.machine.drive.load[:] = self.machine.drive.load_shift[:] = 0.0

    def tick(self, ticks=1):
        """So many ticks; returns itself."""
        self.sim.advance(ticks)
        return self

    def run(self, seconds):
        """As many ticks as that takes; returns itself."""
        return self.tick(round(seconds / self.dt))

    def throw(self, row, vx, vy, omega=0.0):
        """Give a body a velocity, field frame."""
        body = list(self.sim.world.space.bodies)[row]
        body.velocity, body.angular_velocity = (vx, vy), omega
        self.body[row, 3:] = vx, vy, omega

    def place(self, ahead, aside=0.0, vx=0.0, vy=0.0):
        """Put the ball before robot 0, m in the robot's frame, its velocity in the field's."""
        x, y, heading = self.body[0, :3]
        c, s = cos(heading), sin(heading)
        at = x + c * ahead - s * aside, y + s * ahead + c * aside
        self.sim.world.place_ball(self.truth, *at, vx, vy)

    @property
    def gap(self):
        """Distances from the robots' bodies to the ball, m."""
        apart = self.body[:-1, :2] - self.body[-1, :2]
        return np.hypot(*apart.T) - TOUCH

    @property
    def stretch(self):
        """How far the ball is from the middle of robot 0's mouth, m."""
        return self._stretch(self.body[:, :3])

    @property
    def stretch_soon(self):
        """The same where the forces will act next: bodies move first."""
        return self._stretch(self.body[:, :3] + self.dt * self.body[:, 3:])

    def _stretch(self, pose):
        x, y, heading = pose[0]
        return hypot(pose[-1, 0] - x - TOUCH * cos(heading), pose[-1, 1] - y - TOUCH * sin(heading))

    def motion(self):
        """Momentum along x and y and about the centre spot; the ball does not spin about z."""
        x, y, _, vx, vy, omega = self.body.T
        spin = self.machine.drive.inertia @ omega[:-1] + self.mass @ (x * vy - y * vx)
        return np.array([self.mass @ vx, self.mass @ vy, spin])

    def energy(self):
        """Of all motion, J."""
        _, _, _, vx, vy, omega = self.body.T
        return 0.5 * (self.mass @ (vx**2 + vy**2) + self.machine.drive.inertia @ omega[:-1] ** 2)


def alone(model=None, ahead=TOUCH + 1e-4, aside=0.0, heading=0.0, **more):
    """One robot at the centre spot, and the ball before it."""
    bench = Bench(
        player(model or handler(), start=(0, 0, heading)),
        **{"ball": {"at": (-3.0, 3.0)}, "field": SMOOTH, **more},
    )
    bench.place(ahead, aside)
    return bench


def off(angle_deg, far):
    """Ahead and aside of a place at this angle and distance from the robot's centre."""
    return far * cos(radians(angle_deg)), far * sin(radians(angle_deg))
