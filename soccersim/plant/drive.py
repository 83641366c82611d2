"""Motors and wheels: PWM in, the floor's push on each robot out.

All robots and wheels at once, dead wheels too (a wheel without a motor under a fixed load). The
update is linearly implicit, so that friction that is stiff against a 1-4 ms tick neither chatters
nor adds energy; docs/models.md derives it.
"""

from math import cos, sin
from typing import NamedTuple

from soccersim.kernel import kernel
from soccersim.plant.traction import ROLLER_CREEP, dry_friction, friction_coefficient, secant
from soccersim.spec.motor import PWM_MAX
from soccersim.state import Array, Truth, Whole

ITERATIONS = 2  # of the friction's secant, from the last tick's slip; a third changes < 0.1 mm
LOAD_LAG = 0.02  # s: the body takes this long to lean on its wheels


class Drive(NamedTuple):
    """Motors, wheels and bodies as built; see plant/build.py."""

    wheels: Whole  # (R,) number of wheels, dead ones included
    mass: Array  # (R,) kg
    inertia: Array  # (R,) kg m2 about the vertical
    forward: Array  # (R, W, 3) twist to speed along the wheel: rows of G
    sideways: Array  # (R, W, 3) twist to speed across it: rows of H
    radius: Array  # (R, W) m, times the cosine of the roller's angle
    load: Array  # (R, W) N at rest
    load_shift: Array  # (R, W, 2) N per m/s2 of acceleration; body frame
    static: Array  # (R, W) friction coefficients
    kinetic: Array  # (R, W)
    roller: Array  # (R, W)
    stribeck_speed: Array  # (R, W) m/s
    creep_speed: Array  # (R, W) m/s
    creep_ratio: Array  # (R, W)
    spin_inertia: Array  # (R, W) kg m2 of wheel and reflected rotor
    friction_torque: Array  # (R, W) N m
    stall_torque: Array  # (R, W) N m; 0 for dead wheels
    no_load_speed: Array  # (R, W) rad/s
    torque_limit: Array  # (R, W) N m
    coasts: Array  # (R, W) 1 where the motor turns freely at PWM 0
    duty: Array  # (R, W, 511) share of full voltage at PWM -255..255
    work: Array  # (R, W, 5) what one tick keeps per wheel, see _motor and _grip


@kernel
def drive_robots(drive: Drive, truth: Truth, pwm: Whole, dt: float) -> None:
    """Advance all wheels by dt and leave the floor's and the hand's push in truth.wrench."""
    for robot in range(drive.mass.shape[0]):
        _drive_robot(drive, truth, pwm, robot, dt)


@kernel
def _drive_robot(drive: Drive, truth: Truth, pwm: Whole, robot: int, dt: float) -> None:
    """One robot's tick.

    Works in the body frame that the body will have after this tick's move, without a Coriolis
    term: pymunk moves the body and integrates in the field frame.
    """
    mass, inertia = drive.mass[robot], drive.inertia[robot]
    vx, vy, omega = truth.body[robot, 3], truth.body[robot, 4], truth.body[robot, 5]
    fx, fy, torque = truth.push[robot, 0], truth.push[robot, 1], truth.push[robot, 2]
    heading = truth.body[robot, 2] + omega * dt
    c, s = cos(heading), sin(heading)
    vx, vy = c * vx + s * vy, c * vy - s * vx  # field to body
    bx = mass * vx + dt * (c * fx + s * fy)
    by = mass * vy + dt * (c * fy - s * fx)
    bw = inertia * omega + dt * torque
    _lean(drive, truth, robot)
    for wheel in range(drive.wheels[robot]):
        _motor(drive, truth, pwm[robot, wheel], robot, wheel, dt)
        gx, gy, gw = _row(drive.forward, robot, wheel)
        rim = drive.radius[robot, wheel] * truth.wheel_speed[robot, wheel]
        truth.slip[robot, wheel] = rim - (gx * vx + gy * vy + gw * omega)
    ux, uy, uw = vx, vy, omega  # the twist after the tick
    for _ in range(ITERATIONS):
        ux, uy, uw = _solve(drive, truth, robot, dt, ux, uy, uw, bx, by, bw)
    for wheel in range(drive.wheels[robot]):
        # pymunk moves the body with the old velocity: so do the wheels
        truth.wheel_angle[robot, wheel] += truth.wheel_speed[robot, wheel] * dt
        truth.wheel_speed[robot, wheel] = drive.work[robot, wheel, 4]
    ax, ay = (ux - vx) / dt, (uy - vy) / dt
    truth.acceleration[robot, 0] += (ax - truth.acceleration[robot, 0]) * dt / (LOAD_LAG + dt)
    truth.acceleration[robot, 1] += (ay - truth.acceleration[robot, 1]) * dt / (LOAD_LAG + dt)
    truth.wrench[robot, 0] = mass * (c * ax - s * ay)  # body to field
    truth.wrench[robot, 1] = mass * (s * ax + c * ay)
    truth.wrench[robot, 2] = inertia * (uw - omega) / dt


@kernel
def _row(rows: Array, robot: int, wheel: int) -> tuple[float, float, float]:
    return rows[robot, wheel, 0], rows[robot, wheel, 1], rows[robot, wheel, 2]


@kernel
def _lean(drive: Drive, truth: Truth, robot: int) -> None:
    """Load on each wheel while the body accelerates."""
    ax, ay = truth.acceleration[robot, 0], truth.acceleration[robot, 1]
    for wheel in range(drive.wheels[robot]):
        shift = drive.load_shift[robot, wheel, 0] * ax + drive.load_shift[robot, wheel, 1] * ay
        truth.load[robot, wheel] = max(drive.load[robot, wheel] + shift, 0.0)


@kernel
def _motor(drive: Drive, truth: Truth, pwm: int, robot: int, wheel: int, dt: float) -> None:
    """The wheel's equation without the floor, and what does not change while solving.

    drag * speed' = momentum - floor: work[0] is momentum, work[1] drag, N m s and N m s2/rad.
    """
    speed = truth.wheel_speed[robot, wheel]
    stall, top = drive.stall_torque[robot, wheel], drive.no_load_speed[robot, wheel]
    duty = drive.duty[robot, wheel, pwm + PWM_MAX]
    drag = dry_friction(drive.friction_torque[robot, wheel], speed)
    torque = 0.0
    if pwm != 0 or drive.coasts[robot, wheel] == 0.0:
        limit = drive.torque_limit[robot, wheel]
        wanted = stall * (duty - speed / top)
        if abs(wanted) > limit:
            torque = limit if wanted > 0.0 else -limit
        else:
            torque = stall * duty
            drag += stall / top
    spin = drive.spin_inertia[robot, wheel]
    drive.work[robot, wheel, 0] = spin * speed + dt * torque
    drive.work[robot, wheel, 1] = spin + dt * drag
    rim = abs(drive.radius[robot, wheel] * speed)
    drive.work[robot, wheel, 2] = (
        drive.creep_speed[robot, wheel] + drive.creep_ratio[robot, wheel] * rim
    )


@kernel
def _solve(
    drive: Drive,
    truth: Truth,
    robot: int,
    dt: float,
    ux: float,
    uy: float,
    uw: float,
    bx: float,
    by: float,
    bw: float,
) -> tuple[float, float, float]:
    """The twist after the tick, with the friction's secants at the slip known so far."""
    axx = ayy = drive.mass[robot]
    aww = drive.inertia[robot]
    axy = axw = ayw = 0.0
    for wheel in range(drive.wheels[robot]):
        gx, gy, gw = _row(drive.forward, robot, wheel)
        hx, hy, hw = _row(drive.sideways, robot, wheel)
        load, slip, r = truth.load[robot, wheel], truth.slip[robot, wheel], drive.radius[robot, wheel]
        mu = friction_coefficient(
            slip,
            drive.static[robot, wheel],
            drive.kinetic[robot, wheel],
            drive.stribeck_speed[robot, wheel],
        )
        grip = dt * secant(mu * load, slip, drive.work[robot, wheel, 2])
        across = hx * ux + hy * uy + hw * uw
        rub = dt * secant(drive.roller[robot, wheel] * load, across, ROLLER_CREEP)
        weight = 1.0 / (drive.work[robot, wheel, 1] + r * r * grip)
        free = drive.work[robot, wheel, 0] * weight  # speed' = free + gain * floor speed
        gain = r * grip * weight
        drive.work[robot, wheel, 3], drive.work[robot, wheel, 4] = free, gain
        hold = grip * (1.0 - r * gain)
        thrust = grip * r * free
        axx, axy, axw = axx + hold * gx * gx, axy + hold * gx * gy, axw + hold * gx * gw
        ayy, ayw, aww = ayy + hold * gy * gy, ayw + hold * gy * gw, aww + hold * gw * gw
        axx, axy, axw = axx + rub * hx * hx, axy + rub * hx * hy, axw + rub * hx * hw
        ayy, ayw, aww = ayy + rub * hy * hy, ayw + rub * hy * hw, aww + rub * hw * hw
        bx, by, bw = bx + gx * thrust, by + gy * thrust, bw + gw * thrust
    ux, uy, uw = _symmetric_solve(axx, axy, axw, ayy, ayw, aww, bx, by, bw)
    for wheel in range(drive.wheels[robot]):
        gx, gy, gw = _row(drive.forward, robot, wheel)
        rolling = gx * ux + gy * uy + gw * uw
        speed = drive.work[robot, wheel, 3] + drive.work[robot, wheel, 4] * rolling
        drive.work[robot, wheel, 4] = speed
        truth.slip[robot, wheel] = drive.radius[robot, wheel] * speed - rolling
    return ux, uy, uw


@kernel
def _symmetric_solve(
    axx: float,
    axy: float,
    axw: float,
    ayy: float,
    ayw: float,
    aww: float,
    bx: float,
    by: float,
    bw: float,
) -> tuple[float, float, float]:
    """Solve the symmetric positive 3 x 3 system by LDL'."""
    lxy, lxw = axy / axx, axw / axx
    dyy = ayy - lxy * axy
    eyw = ayw - lxy * axw
    lyw = eyw / dyy
    dww = aww - lxw * axw - lyw * eyw
    cy = by - lxy * bx
    uw = (bw - lxw * bx - lyw * cy) / dww
    uy = cy / dyy - lyw * uw
    return bx / axx - lxy * uy - lxw * uw, uy, uw
