"""What robots do to the ball in their mouths: hold it with rollers, kick it; and feel it.

A dribbler is a spring and damper of limited force between the ball and the middle of the mouth, a
kicker an impulse along the heading. Both act between ball and robot at the ball's centre, so they
keep momentum, also angular. docs/models.md, section 3.9, says what is lost when.
"""

from collections.abc import Iterable
from math import cos, radians, sin, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.kernel import inner
from soccersim.spec.handling import Dribbler
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Command, Readings, Truth, Whole


class Handling(NamedTuple):
    """Mouths, kickers and dribblers of R robots, and what they remember."""

    row: int  # of the ball in truth.body; -1: there is none
    ball_mass: float  # kg
    mass: Array  # (R,) kg
    inertia: Array  # (R,) kg m2 about the vertical
    ahead: Array  # (R,) m from the robot's centre to that of a ball that touches it
    far: Array  # (R,) m2, square of the farthest that a ball in the mouth may be
    cone: Array  # (R,) square of the cosine of the mouth's half angle
    kick_speed: Array  # (R,) m/s at most; 0: no kicker
    kick_speed_sd: Array  # (R,) relative
    kick_angle_sd: Array  # (R,) rad
    recharge: Whole  # (R,) ticks
    force: Array  # (R,) N at most; 0: no dribbler
    stiffness: Array  # (R,) N/m
    damping: Array  # (R,) N s/m
    pause: Whole  # (R,) ticks without pull after a loss or a kick
    kicks: Whole  # (R,) so far
    kicked: Whole  # (R,) tick of the last kick; -1: none yet
    held: Whole  # (R,) 1: the dribbler holds the ball
    rests: Whole  # (R,) tick before which the dribbler does not pull


def build_handling(scenario: Scenario) -> Handling:
    """All mouths empty, all kickers charged."""
    models = [player.model for player in scenario.robots]
    ball, hz = scenario.ball, scenario.timing.physics_hz
    mass, radius = (ball.mass, ball.radius) if ball else (0.0, 0.0)
    kickers, rollers = [m.kicker for m in models], [m.dribbler for m in models]
    return Handling(
        row=len(models) if ball else -1,
        ball_mass=mass,
        mass=_column(m.mass for m in models),
        inertia=_column(m.yaw_inertia for m in models),
        ahead=_column(m.radius + radius for m in models),
        far=_column((m.radius + radius + m.mouth.reach) ** 2 for m in models),
        cone=_column(cos(radians(m.mouth.half_angle_deg)) ** 2 for m in models),
        kick_speed=_column(k.speed if k else 0.0 for k in kickers),
        kick_speed_sd=_column(k.speed_sd if k else 0.0 for k in kickers),
        kick_angle_sd=_column(radians(k.angle_sd_deg) if k else 0.0 for k in kickers),
        recharge=_ticks(k.recharge * hz if k else 0.0 for k in kickers),
        force=_column(d.force if d else 0.0 for d in rollers),
        stiffness=_column(d.stiffness if d else 0.0 for d in rollers),
        damping=_column(_damping(d, mass) for d in rollers),
        pause=_ticks(d.pause * hz if d else 0.0 for d in rollers),
        kicks=_ticks(0.0 for _ in models),
        kicked=_ticks(-1.0 for _ in models),
        held=_ticks(0.0 for _ in models),
        rests=_ticks(0.0 for _ in models),
    )


def _column(numbers: Iterable[float]) -> Array:
    """A number for each robot."""
    return np.array(list(numbers), float)


def _ticks(numbers: Iterable[float]) -> Whole:
    """A whole number for each robot."""
    return np.array([round(number) for number in numbers], np.int64)


def _damping(dribbler: Dribbler | None, ball: float) -> float:
    """N s/m, critical for a ball of this mass (kg) where nothing else is said."""
    if dribbler is None:
        return 0.0
    if dribbler.damping is None:
        return 2.0 * sqrt(dribbler.stiffness * ball)
    return dribbler.damping


@inner
def feel_ball(handling: Handling, readings: Readings, truth: Truth) -> None:
    """Set readings.contact to 1 for the robots that have the ball in the mouth."""
    for robot in range(handling.mass.shape[0]):
        readings.contact[robot] = 1 if _in_mouth(handling, truth, robot) else 0


@inner
def handle_ball(
    handling: Handling, chance: Array, command: Command, truth: Truth, tick: int, dt: float
) -> None:
    """Add what dribblers and kickers do to ball and robots to truth.wrench; wind up the kicks.

    Comes after motors and floor have left their wrenches, before the bodies step. chance
    (BLOCK, R, 2) are standard normals: kick n of a robot uses row n % BLOCK. A kick that has been
    made is taken out of command.kick.
    """
    near = 0
    for robot in range(handling.mass.shape[0]):
        if _in_mouth(handling, truth, robot):
            near += 1
        else:
            handling.held[robot] = 0
    if near == 0:
        return
    # alike for all robots: what one does to the ball is not known to the next
    ax = truth.wrench[handling.row, 0] / handling.ball_mass
    ay = truth.wrench[handling.row, 1] / handling.ball_mass
    for robot in range(handling.mass.shape[0]):
        if not _in_mouth(handling, truth, robot):
            continue
        if _kicks(handling, command, robot, tick):
            _kick(handling, chance, command, truth, robot, tick, dt)
        elif _draws(handling, command, robot, tick):
            _dribble(handling, truth, robot, near, ax, ay, tick, dt)
        else:
            handling.held[robot] = 0


@inner
def _in_mouth(handling: Handling, truth: Truth, robot: int) -> bool:
    """Whether the ball's centre is in the sector of the robot's mouth."""
    row = handling.row
    if row < 0:
        return False
    dx = truth.body[row, 0] - truth.body[robot, 0]
    dy = truth.body[row, 1] - truth.body[robot, 1]
    apart = dx * dx + dy * dy
    if not apart <= handling.far[robot]:
        return False
    heading = truth.body[robot, 2]
    ahead = cos(heading) * dx + sin(heading) * dy
    inside: bool = ahead > 0.0 and ahead * ahead >= handling.cone[robot] * apart
    return inside


@inner
def _kicks(handling: Handling, command: Command, robot: int, tick: int) -> bool:
    """Whether a kick is wanted, and the kicker there and charged."""
    if not (command.kick[robot] > 0.0 and handling.kick_speed[robot] > 0.0):
        return False
    last = handling.kicked[robot]
    charged: bool = last < 0 or tick - last >= handling.recharge[robot]
    return charged


@inner
def _draws(handling: Handling, command: Command, robot: int, tick: int) -> bool:
    """Whether the dribbler is there, on, and over its last loss."""
    there: bool = command.dribble[robot] != 0 and handling.force[robot] > 0.0
    return there and tick >= handling.rests[robot]


@inner
def _meeting(
    handling: Handling, truth: Truth, robot: int, dt: float
) -> tuple[float, float, float, float, float]:
    """From the robot's centre to the ball's, the ball's speed as seen on the robot, the heading.

    m, m/s, rad; field frame; where pymunk, which moves first, will let the wrenches act.
    """
    row = handling.row
    ux = truth.body[row, 3] - truth.body[robot, 3]
    uy = truth.body[row, 4] - truth.body[robot, 4]
    omega = truth.body[robot, 5]
    dx = truth.body[row, 0] - truth.body[robot, 0] + ux * dt
    dy = truth.body[row, 1] - truth.body[robot, 1] + uy * dt
    return dx, dy, ux + omega * dy, uy - omega * dx, truth.body[robot, 2] + omega * dt


@inner
def _act(
    handling: Handling, truth: Truth, robot: int, dx: float, dy: float, fx: float, fy: float
) -> None:
    """A force (N) of the robot on the ball, and the opposite on the robot, at the ball's centre."""
    row = handling.row
    truth.wrench[row, 0] += fx
    truth.wrench[row, 1] += fy
    truth.wrench[robot, 0] -= fx
    truth.wrench[robot, 1] -= fy
    truth.wrench[robot, 2] -= dx * fy - dy * fx


@inner
def _kick(
    handling: Handling,
    chance: Array,
    command: Command,
    truth: Truth,
    robot: int,
    tick: int,
    dt: float,
) -> None:
    """One tick of force that sends the ball off; across the kick its speed stays what it was.

    The speed wanted is that along the kick, seen from where the robot carries the ball before.
    """
    row = handling.kicks[robot] % chance.shape[0]
    dx, dy, ux, uy, heading = _meeting(handling, truth, robot, dt)
    direction = heading + handling.kick_angle_sd[robot] * chance[row, robot, 1]
    spread = 1.0 + handling.kick_speed_sd[robot] * chance[row, robot, 0]
    speed = min(command.kick[robot], handling.kick_speed[robot]) * max(spread, 0.0)
    c, s = cos(direction), sin(direction)
    force = handling.ball_mass * max(speed - (c * ux + s * uy), 0.0) / dt  # it cannot pull
    _act(handling, truth, robot, dx, dy, force * c, force * s)
    command.kick[robot] = 0.0
    handling.kicks[robot] += 1
    handling.kicked[robot] = tick
    _let_go(handling, robot, tick)


@inner
def _let_go(handling: Handling, robot: int, tick: int) -> None:
    handling.held[robot] = 0
    handling.rests[robot] = tick + 1 + handling.pause[robot]


@inner
def _dribble(
    handling: Handling,
    truth: Truth,
    robot: int,
    near: int,
    ax: float,
    ay: float,
    tick: int,
    dt: float,
) -> None:
    """One tick of spring and damper, taken at the end of the tick so that no tick is too long.

    near is how many robots have the ball in their mouths: each reckons with its share of the
    ball, as all may pull. ax, ay: what the floor alone makes of the ball, m/s2, field frame.
    """
    dx, dy, ux, uy, heading = _meeting(handling, truth, robot, dt)
    mass, inertia = handling.mass[robot], handling.inertia[robot]
    turn = truth.wrench[robot, 2] / inertia
    ux += dt * (ax - truth.wrench[robot, 0] / mass + turn * dy)
    uy += dt * (ay - truth.wrench[robot, 1] / mass - turn * dx)
    k = handling.stiffness[robot]
    hold = handling.damping[robot] + k * dt
    ease = near / handling.ball_mass + 1.0 / mass + (dx * dx + dy * dy) / inertia  # 1/kg
    share = 1.0 / (1.0 + dt * hold * ease)
    fx = -share * (k * (dx - handling.ahead[robot] * cos(heading)) + hold * ux)
    fy = -share * (k * (dy - handling.ahead[robot] * sin(heading)) + hold * uy)
    needed = sqrt(fx * fx + fy * fy)
    if needed <= handling.force[robot]:
        handling.held[robot] = 1
    elif handling.held[robot] != 0:
        _let_go(handling, robot, tick)
        return
    else:  # not caught yet
        fx, fy = fx * handling.force[robot] / needed, fy * handling.force[robot] / needed
    _act(handling, truth, robot, dx, dy, fx, fy)
