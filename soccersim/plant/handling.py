"""What robots do to the ball in their mouths: hold it with rollers, kick it; and feel it.

A dribbler is a spring and damper of limited force between the ball and the middle of the mouth, a
kicker an impulse along the heading. Both act between ball and robot at the ball's centre, so they
keep momentum, also angular. docs/models.md, section 3.9, tells when the ball is lost.
"""

from collections.abc import Iterable
from math import cos, radians, sin, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.kernel import inner
from soccersim.spec.handling import Dribbler
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Command, Readings, Truth, Whole

NEVER = 2**62  # a tick that no run comes to


class Handling(NamedTuple):
    """Mouths, kickers and dribblers of R robots, and what they remember."""

    row: int  # of the ball in truth.body; -1: there is none
    ball_mass: float  # kg
    mass: Array  # (R,) kg
    inertia: Array  # (R,) kg m2 about the vertical
    ahead: Array  # (R,) m from the robot's centre to that of a ball that touches it
    far: Array  # (R,) m2, square of the farthest that a ball in the mouth may be
    cone: Array  # (R,) square of the cosine of the mouth's half angle
    kick_speed: Array  # (R,) m/s at most
    kick_speed_sd: Array  # (R,) relative
    kick_angle_sd: Array  # (R,) rad
    recharge: Whole  # (R,) ticks from one kick to the next
    force: Array  # (R,) N at most
    stiffness: Array  # (R,) N/m
    damping: Array  # (R,) N s/m
    pause: Whole  # (R,) ticks without pull after a loss or a kick
    inside: Whole  # (R,) 1: the ball is in the mouth
    held: Whole  # (R,) 1: the dribbler holds the ball
    kicks: Whole  # (R,) so far
    kicked: Whole  # (R,) tick of the last kick; -1: none yet
    charged: Whole  # (R,) tick from which the kicker can kick; NEVER: there is none
    rested: Whole  # (R,) tick from which the dribbler can draw; NEVER: there is none


def build_handling(scenario: Scenario) -> Handling:
    """All mouths empty, all kickers charged."""
    models = [player.model for player in scenario.robots]
    ball, hz = scenario.ball, scenario.timing.physics_hz
    mass, radius = (ball.mass, ball.radius) if ball else (1.0, 0.0)
    kickers, dribblers = [m.kicker for m in models], [m.dribbler for m in models]
    return Handling(
        row=len(models) if ball else -1,
        ball_mass=mass,
        mass=_numbers(m.mass for m in models),
        inertia=_numbers(m.yaw_inertia for m in models),
        ahead=_numbers(m.radius + radius for m in models),
        far=_numbers((m.radius + radius + m.mouth.reach) ** 2 for m in models),
        cone=_numbers(cos(radians(m.mouth.half_angle_deg)) ** 2 for m in models),
        kick_speed=_numbers(k.speed if k else 0.0 for k in kickers),
        kick_speed_sd=_numbers(k.speed_sd if k else 0.0 for k in kickers),
        kick_angle_sd=_numbers(radians(k.angle_sd_deg) if k else 0.0 for k in kickers),
        recharge=_ticks(round(k.recharge * hz) if k else 0 for k in kickers),
        force=_numbers(d.force if d else 0.0 for d in dribblers),
        stiffness=_numbers(d.stiffness if d else 0.0 for d in dribblers),
        damping=_numbers(_damping(d, mass) if d else 0.0 for d in dribblers),
        pause=_ticks(round(d.pause * hz) if d else 0 for d in dribblers),
        inside=_ticks(0 for _ in models),
        held=_ticks(0 for _ in models),
        kicks=_ticks(0 for _ in models),
        kicked=_ticks(-1 for _ in models),
        charged=_ticks(0 if k else NEVER for k in kickers),
        rested=_ticks(0 if d else NEVER for d in dribblers),
    )


def _numbers(values: Iterable[float]) -> Array:
    return np.array(list(values), float)


def _ticks(values: Iterable[int]) -> Whole:
    return np.array(list(values), np.int64)


def _damping(dribbler: Dribbler, ball: float) -> float:
    """N s/m; critical for a ball of this mass (kg) where nothing else is said."""
    if dribbler.damping is None:
        return 2.0 * sqrt(dribbler.stiffness * ball)
    return dribbler.damping


@inner
def feel_ball(handling: Handling, readings: Readings, truth: Truth) -> None:
    """Set readings.contact to 1 for the robots that have the ball in the mouth."""
    find_ball(handling, truth)
    for robot in range(handling.inside.shape[0]):
        readings.contact[robot] = handling.inside[robot]


@inner
def find_ball(handling: Handling, truth: Truth) -> int:
    """Note in whose mouths the ball is; returns how many there are."""
    row, near = handling.row, 0
    for robot in range(handling.inside.shape[0] if row >= 0 else 0):
        dx = truth.body[row, 0] - truth.body[robot, 0]
        dy = truth.body[row, 1] - truth.body[robot, 1]
        apart = dx * dx + dy * dy
        handling.inside[robot] = 0
        if apart <= handling.far[robot]:
            heading = truth.body[robot, 2]
            ahead = cos(heading) * dx + sin(heading) * dy
            if ahead > 0.0 and ahead * ahead >= handling.cone[robot] * apart:
                handling.inside[robot] = 1
                near += 1
        if handling.inside[robot] == 0:
            handling.held[robot] = 0
    return near


@inner
def handle_ball(
    handling: Handling, chance: Array, command: Command, truth: Truth, tick: int, dt: float
) -> None:
    """Add to truth.wrench what dribblers and kickers do to the ball and, the other way, to robots.

    Comes after motors and floor have left their wrenches, before the bodies step. chance
    (BLOCK, R, 2) are standard normals: kick n of a robot uses row n % BLOCK. A kick that has been
    made is taken out of command.kick.
    """
    near = find_ball(handling, truth)
    if near == 0:
        return
    row, ball = handling.row, handling.ball_mass
    # alike for all robots: none knows what another does to the ball in this tick
    floor_x, floor_y = truth.wrench[row, 0] / ball, truth.wrench[row, 1] / ball
    for robot in range(handling.inside.shape[0]):
        kicks = command.kick[robot] > 0.0 and tick >= handling.charged[robot]
        draws = command.dribble[robot] != 0 and tick >= handling.rested[robot]
        if handling.inside[robot] == 0 or not (kicks or draws):
            handling.held[robot] = 0
            continue
        # from robot to ball, and the ball's velocity as seen on the robot, where pymunk, which
        # moves bodies first, will let the force act; field frame
        omega = truth.body[robot, 5]
        heading = truth.body[robot, 2] + omega * dt
        ux = truth.body[row, 3] - truth.body[robot, 3]
        uy = truth.body[row, 4] - truth.body[robot, 4]
        dx = truth.body[row, 0] - truth.body[robot, 0] + ux * dt
        dy = truth.body[row, 1] - truth.body[robot, 1] + uy * dt
        ux, uy = ux + omega * dy, uy - omega * dx
        if kicks:
            fx, fy = _kick(handling, chance, command, robot, tick, heading, ux, uy, dt)
        else:
            mass, inertia = handling.mass[robot], handling.inertia[robot]
            turn = truth.wrench[robot, 2] / inertia
            ux += dt * (floor_x - truth.wrench[robot, 0] / mass + turn * dy)
            uy += dt * (floor_y - truth.wrench[robot, 1] / mass - turn * dx)
            # all who are near may draw: each counts on its share of the ball alone
            ease = near / ball + 1.0 / mass + (dx * dx + dy * dy) / inertia
            sx = dx - handling.ahead[robot] * cos(heading)
            sy = dy - handling.ahead[robot] * sin(heading)
            fx, fy = _draw(handling, robot, tick, ease, sx, sy, ux, uy, dt)
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
    robot: int,
    tick: int,
    heading: float,
    ux: float,
    uy: float,
    dt: float,
) -> tuple[float, float]:
    """Force on the ball, N, of the one tick of a kick; field frame.

    It leaves with the speed wanted along the kick, as seen where the robot carries it before the
    kick. (ux, uy) is how it moves there now: across the kick that stays, and a ball that is faster
    already is not pulled back.
    """
    n = handling.kicks[robot] % chance.shape[0]
    heading += handling.kick_angle_sd[robot] * chance[n, robot, 1]
    speed = min(command.kick[robot], handling.kick_speed[robot])
    speed *= 1.0 + handling.kick_speed_sd[robot] * chance[n, robot, 0]
    command.kick[robot] = 0.0
    handling.kicks[robot] += 1
    handling.kicked[robot] = tick
    handling.charged[robot] = tick + handling.recharge[robot]
    handling.held[robot] = 0
    handling.rested[robot] = max(handling.rested[robot], tick + 1 + handling.pause[robot])
    c, s = cos(heading), sin(heading)
    force = handling.ball_mass * max(speed - (c * ux + s * uy), 0.0) / dt
    return force * c, force * s


@inner
def _draw(
    handling: Handling,
    robot: int,
    tick: int,
    ease: float,
    sx: float,
    sy: float,
    ux: float,
    uy: float,
    dt: float,
) -> tuple[float, float]:
    """Force on the ball, N, of a spring and damper stretched by (sx, sy) m; field frame.

    Taken at the end of the tick, so that no tick is too long for it: (ux, uy) is how fast it would
    stretch then without its own force, and ease, 1/kg, how much of that its force takes away.
    """
    stiffness = handling.stiffness[robot]
    hold = handling.damping[robot] + stiffness * dt
    share = -1.0 / (1.0 + dt * hold * ease)
    fx, fy = share * (stiffness * sx + hold * ux), share * (stiffness * sy + hold * uy)
    needed, most = sqrt(fx * fx + fy * fy), handling.force[robot]
    if needed <= most:
        handling.held[robot] = 1
    elif handling.held[robot] == 0:  # not caught yet
        fx, fy = fx * most / needed, fy * most / needed
    else:
        fx = fy = 0.0
        handling.held[robot] = 0
        handling.rested[robot] = tick + 1 + handling.pause[robot]
    return fx, fy
