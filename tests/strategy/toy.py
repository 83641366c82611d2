"""A toy world for skills: robots that accelerate as told, a ball, delays. No wheels, no noise.

Everything is in the team frame. Robots are told apart by their row; opponents never move unless
they have a velocity, and the ball goes through them.
"""

from collections import deque
from dataclasses import replace
from math import atan2, cos, hypot, pi, sin, sqrt

from soccersim.strategy import Ball, Body, Command, Pitch, Player, View
from soccersim.strategy.motion import wrap

DT = 0.004  # s
DECIDE = 10  # ticks: 25 Hz
REPORT = 10  # ticks from the state to the view that tells it
ORDER = 5  # ticks from the answer to the robot
WHEELS = 0.04  # s, time constant of the robot's speed
MOUTH, REACH = 25 * pi / 180, 0.05  # rad, m
STIFF, DAMP, HOLD = 150.0, 16.0, 5.0  # N/m, N s/m, N
MASS, SHELL, BOUNCE = 0.43, 2 / 3, 0.4


class Robot:
    def __init__(self, x, y, heading=0.0, role="field"):
        self.x, self.y, self.heading, self.role = x, y, heading, role
        self.vx = self.vy = self.omega = 0.0  # as it moves; field frame
        self.asked = [0.0, 0.0, 0.0]  # as its limiter asks its wheels to
        self.command, self.orders = Command(), deque()
        self.ready = 0.0  # s, when the kicker is charged


def carried_on(player):
    """A late report, brought forward to now as the game does."""
    c, s = cos(player.heading), sin(player.heading)
    return replace(
        player,
        x=player.x + player.age * (c * player.vx - s * player.vy),
        y=player.y + player.age * (s * player.vx + c * player.vy),
        heading=wrap(player.heading + player.age * player.omega),
    )


class Toy:
    """step() lets a decision's time pass; now() is what the team sees, as late as it does."""

    def __init__(self, robots, ball=None, opponents=(), **view):
        self.robots = robots
        self.ball = [*ball, 0.0, 0.0][:4] if ball else None
        self.spin = [self.ball[2], self.ball[3]] if ball else None
        self.opponents = list(opponents)
        self.body, self.pitch = Body(), Pitch(bodies=(Body(),) * len(robots))
        self.view, self.tick = view, 0
        self.past = deque([self.reports()] * (REPORT + 1), maxlen=REPORT + 1)
        self.kicks = []

    @property
    def time(self):
        return self.tick * DT

    def reports(self):
        return [
            Player(
                row + 1,
                r.x,
                r.y,
                wrap(r.heading),
                cos(r.heading) * r.vx + sin(r.heading) * r.vy,
                cos(r.heading) * r.vy - sin(r.heading) * r.vx,
                r.omega,
                self.in_mouth(r),
                r.role,
                age=REPORT * DT,
            )
            for row, r in enumerate(self.robots)
        ]

    def now(self):
        ball = Ball(*self.ball) if self.ball else None
        robots = tuple(carried_on(player) for player in self.past[0])
        opponents = tuple(self.opponents)
        return View(robots, ball, opponents, self.pitch, time=self.time, **self.view)

    def in_mouth(self, r):
        if not self.ball:
            return False
        dx, dy = self.ball[0] - r.x, self.ball[1] - r.y
        gap = hypot(dx, dy) - self.body.radius - self.pitch.ball_radius
        return gap < REACH and abs(wrap(atan2(dy, dx) - r.heading)) < MOUTH

    def step(self, commands):
        """Give each robot its command, and let the time of a decision pass."""
        for robot, command in zip(self.robots, commands, strict=True):
            robot.orders.append((self.tick + ORDER, command))
        for _ in range(DECIDE):
            self.tick += 1
            push = [0.0, 0.0]
            for robot in self.robots:
                while robot.orders and robot.orders[0][0] <= self.tick:
                    robot.command = robot.orders.popleft()[1]
                self.move(robot)
                self.handle(robot, push)
            self.roll(push)
            self.opponents = [
                replace(o, x=o.x + o.vx * DT, y=o.y + o.vy * DT) for o in self.opponents
            ]
            self.past.append(self.reports())

    def play(self, seconds, mind):
        """Let mind(view) command the robots; stops early when it returns None."""
        end = self.tick + round(seconds / DT)
        while self.tick < end:
            commands = mind(self.now())
            if commands is None:
                break
            self.step(commands if isinstance(commands, list) else [commands])
        return self

    def move(self, r):
        """The robot's own limits, then its wheels, which lag."""
        c, s, order = cos(r.heading), sin(r.heading), r.command
        wx, wy = c * order.vx - s * order.vy, s * order.vx + c * order.vy
        fast = hypot(wx, wy)
        if fast > self.body.speed:
            wx, wy = wx * self.body.speed / fast, wy * self.body.speed / fast
        dx, dy = wx - r.asked[0], wy - r.asked[1]
        most, size = self.body.acceleration * DT, hypot(dx, dy)
        part = min(1.0, most / size) if size else 0.0
        turn = min(max(order.omega, -self.body.turn_rate), self.body.turn_rate) - r.asked[2]
        most = self.body.turn_acceleration * DT
        r.asked[0] += part * dx
        r.asked[1] += part * dy
        r.asked[2] += min(max(turn, -most), most)
        r.vx += (r.asked[0] - r.vx) * DT / WHEELS
        r.vy += (r.asked[1] - r.vy) * DT / WHEELS
        r.omega += (r.asked[2] - r.omega) * DT / WHEELS
        r.x, r.y, r.heading = r.x + r.vx * DT, r.y + r.vy * DT, r.heading + r.omega * DT

    def handle(self, r, push):
        """Bounce, dribble and kick; leaves the ball's push, N."""
        if not self.ball:
            return
        b = self.ball
        dx, dy = b[0] - r.x, b[1] - r.y
        far = hypot(dx, dy)
        nx, ny = dx / far, dy / far
        gap = far - self.body.radius - self.pitch.ball_radius
        if gap < 0:
            b[0], b[1] = b[0] - gap * nx, b[1] - gap * ny
            into = (b[2] - r.vx) * nx + (b[3] - r.vy) * ny
            if into < 0:
                b[2], b[3] = b[2] - (1 + BOUNCE) * into * nx, b[3] - (1 + BOUNCE) * into * ny
        if not self.in_mouth(r):
            return
        c, s, reach = cos(r.heading), sin(r.heading), self.body.radius + self.pitch.ball_radius
        mx, my = r.vx - r.omega * reach * s, r.vy + r.omega * reach * c
        if r.command.kick > 0 and self.time >= r.ready:
            b[2], b[3] = mx + r.command.kick * c, my + r.command.kick * s
            self.spin[:] = 0.0, 0.0
            r.ready, r.command = self.time + 1.0, replace(r.command, kick=0.0)
            self.kicks.append((self.time, b[2], b[3]))
        elif r.command.dribble and self.time >= r.ready - 0.8:
            fx = STIFF * (r.x + reach * c - b[0]) + DAMP * (mx - b[2])
            fy = STIFF * (r.y + reach * s - b[1]) + DAMP * (my - b[3])
            size = hypot(fx, fy)
            part = min(1.0, HOLD / size) if size else 0.0
            push[0] += part * fx
            push[1] += part * fy

    def roll(self, push):
        """Slide, then roll: as soccersim.plant.ball."""
        if not self.ball:
            return
        b, w, p = self.ball, self.spin, self.pitch
        b[2], b[3] = b[2] + push[0] / MASS * DT, b[3] + push[1] / MASS * DT
        sx, sy = b[2] - w[0], b[3] - w[1]
        slide, loss = hypot(sx, sy), p.ball_sliding * DT
        if slide > loss * (1 + 1 / SHELL):
            b[2], b[3] = b[2] - loss * sx / slide, b[3] - loss * sy / slide
            w[0], w[1] = w[0] + loss / SHELL * sx / slide, w[1] + loss / SHELL * sy / slide
        else:
            vx, vy = (b[2] + SHELL * w[0]) / (1 + SHELL), (b[3] + SHELL * w[1]) / (1 + SHELL)
            speed = sqrt(vx * vx + vy * vy)
            keep = max(0.0, 1 - p.ball_rolling * DT / speed) if speed > 0.01 else 0.0
            b[2], b[3] = vx * keep, vy * keep
            w[0], w[1] = b[2], b[3]
        b[0], b[1] = b[0] + b[2] * DT, b[1] + b[3] * DT
