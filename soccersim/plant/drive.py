"""Motors and wheels: PWM in, the floor's push on each robot out.

All robots and wheels at once, dead wheels too (a wheel without a motor under a fixed load). The
update is linearly implicit, so that friction that is stiff against a 1-4 ms tick neither chatters
nor adds energy; docs/models.md derives it.
"""

from math import cos, nan, sin
from typing import NamedTuple

from soccersim.kernel import inner, kernel
from soccersim.plant.traction import ROLLER_CREEP, dry_friction, friction_coefficient, secant
from soccersim.spec.motor import PWM_MAX
from soccersim.state import Array, Truth, Whole

LOAD_LAG = 0.02  # s: the body takes this long to lean on its wheels
STILL = 1e-12  # m/s or rad/s; slower is at rest


class Drive(NamedTuple):
    """Motors, wheels and bodies as built; see plant/build.py."""

    wheels: Whole  # (R,) number of wheels, dead ones included
    mass: Array  # (R,) kg
    inertia: Array  # (R,) kg m2 about the vertical
    forward: Array  # (R, W, 3) twist to speed along the wheel: rows of G
    sideways: Array  # (R, W, 3) twist to speed across it: rows of H
    radius: Array  # (R, W) m, times the cosine of the roller's angle
    mobility: Array  # (R, W) 1/kg, how easily a push along one wheel moves the body under it
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
    free_speed: Array  # (R, W) rad/s after the tick if the floor stood still; kept for the tick
    follow: Array  # (R, W) rad/s more of it for each m/s of the floor; kept for the tick


@kernel
def drive_robots(drive: Drive, truth: Truth, pwm: Whole, dt: float) -> None:
    """Advance all wheels by dt and leave the floor's and the hand's push in truth.wrench.

    Works in the body frame that the body will have after this tick's move, without a Coriolis
    term: pymunk moves the body and integrates in the field frame.
    """
    for robot in range(drive.mass.shape[0]):
        mass, inertia = drive.mass[robot], drive.inertia[robot]
        omega = truth.body[robot, 5]
        heading = truth.body[robot, 2] + omega * dt
        c, s = cos(heading), sin(heading)
        vx, vy = _to_body(c, s, truth.body[robot, 3], truth.body[robot, 4])
        px, py = _to_body(c, s, truth.push[robot, 0], truth.push[robot, 1])
        bx, by = mass * vx + dt * px, mass * vy + dt * py
        bw = inertia * omega + dt * truth.push[robot, 2]
        ux, uy, uw = _solve(drive, truth, pwm, robot, dt, vx, vy, omega, bx, by, bw)
        ux, uy, uw = _settled(ux), _settled(uy), _settled(uw)
        _turn_wheels(drive, truth, robot, dt, ux, uy, uw)
        ax, ay = (ux - vx) / dt, (uy - vy) / dt
        _lean(truth, robot, dt, ax, ay)
        truth.wrench[robot, 0] = mass * (c * ax - s * ay)  # body to field
        truth.wrench[robot, 1] = mass * (s * ax + c * ay)
        truth.wrench[robot, 2] = inertia * (uw - omega) / dt


@inner
def _to_body(c: float, s: float, x: float, y: float) -> tuple[float, float]:
    """A vector of the field frame in the body frame of the heading with this cosine and sine."""
    return c * x + s * y, c * y - s * x


@inner
def _solve(
    drive: Drive,
    truth: Truth,
    pwm: Whole,
    robot: int,
    dt: float,
    vx: float,
    vy: float,
    omega: float,
    bx: float,
    by: float,
    bw: float,
) -> tuple[float, float, float]:
    """The twist after the tick: A u = b, where b is the momentum without the floor."""
    axx = ayy = drive.mass[robot]
    aww = drive.inertia[robot]
    axy = axw = ayw = 0.0
    for wheel in range(drive.wheels[robot]):
        gx, gy, gw = _row(drive.forward, robot, wheel)
        hx, hy, hw = _row(drive.sideways, robot, wheel)
        r = drive.radius[robot, wheel]
        rolling = gx * vx + gy * vy + gw * omega
        load = _load(drive, truth, robot, wheel)
        momentum, drag = _motor(drive, truth, pwm[robot, wheel], robot, wheel, dt)
        grip = dt * _grip(drive, truth, robot, wheel, dt, momentum / drag, drag, rolling, load)
        weight = 1.0 / (drag + r * r * grip)
        free, follow = momentum * weight, r * grip * weight
        drive.free_speed[robot, wheel], drive.follow[robot, wheel] = free, follow
        hold, thrust = grip * (1.0 - r * follow), grip * r * free
        axx, axy, axw = axx + hold * gx * gx, axy + hold * gx * gy, axw + hold * gx * gw
        ayy, ayw, aww = ayy + hold * gy * gy, ayw + hold * gy * gw, aww + hold * gw * gw
        bx, by, bw = bx + gx * thrust, by + gy * thrust, bw + gw * thrust
        across = hx * vx + hy * vy + hw * omega
        rub = dt * secant(drive.roller[robot, wheel] * load, across, ROLLER_CREEP)
        axx, axy, axw = axx + rub * hx * hx, axy + rub * hx * hy, axw + rub * hx * hw
        ayy, ayw, aww = ayy + rub * hy * hy, ayw + rub * hy * hw, aww + rub * hw * hw
    return _symmetric_solve(axx, axy, axw, ayy, ayw, aww, bx, by, bw)


@inner
def _row(rows: Array, robot: int, wheel: int) -> tuple[float, float, float]:
    return rows[robot, wheel, 0], rows[robot, wheel, 1], rows[robot, wheel, 2]


@inner
def _load(drive: Drive, truth: Truth, robot: int, wheel: int) -> float:
    """Load on a wheel while the body accelerates, left in truth.load too."""
    ax, ay = truth.acceleration[robot, 0], truth.acceleration[robot, 1]
    shift = drive.load_shift[robot, wheel, 0] * ax + drive.load_shift[robot, wheel, 1] * ay
    load: float = max(drive.load[robot, wheel] + shift, 0.0)
    truth.load[robot, wheel] = load
    return load


@inner
def _motor(
    drive: Drive, truth: Truth, pwm: int, robot: int, wheel: int, dt: float
) -> tuple[float, float]:
    """The wheel's equation without the floor: drag * speed = momentum after the tick.

    N m s and N m s2/rad.
    """
    speed = truth.wheel_speed[robot, wheel]
    drag = dry_friction(drive.friction_torque[robot, wheel], speed)
    torque = 0.0
    if pwm != 0 or drive.coasts[robot, wheel] == 0.0:
        stall, top = drive.stall_torque[robot, wheel], drive.no_load_speed[robot, wheel]
        limit = drive.torque_limit[robot, wheel]
        # no driver knows another level: the run ends rather than read beside the table
        duty = drive.duty[robot, wheel, pwm + PWM_MAX] if -PWM_MAX <= pwm <= PWM_MAX else nan
        wanted = stall * (duty - speed / top)
        if abs(wanted) > limit:
            torque = limit if wanted > 0.0 else -limit
        else:
            torque = stall * duty
            drag += stall / top
    spin = drive.spin_inertia[robot, wheel]
    return spin * speed + dt * torque, spin + dt * drag


@inner
def _grip(
    drive: Drive,
    truth: Truth,
    robot: int,
    wheel: int,
    dt: float,
    free: float,
    drag: float,
    rolling: float,
    load: float,
) -> float:
    """Friction's force over slip speed, N s/m, at the slip that the tick will come to.

    That is the last tick's, or as much as no friction can prevent if that is more: so a wheel
    that breaks away, or is knocked, is not held by more than its grip for even a tick.

    One solve with it comes as near as iterating: of 0.6 s at full voltage on spinning wheels (0.2
    to 0.5 m) it misses 0.2-2 mm at 2 ms, iterated to the end 0.7-2.5 mm; two solves from the slip
    before the tick missed 3-6 mm.
    """
    r, static = drive.radius[robot, wheel], drive.static[robot, wheel]
    prevented = dt * static * load * (r * r / drag + drive.mobility[robot, wheel])
    slip = max(abs(truth.slip[robot, wheel]), abs(r * free - rolling) - prevented)
    mu = friction_coefficient(
        slip, static, drive.kinetic[robot, wheel], drive.stribeck_speed[robot, wheel]
    )
    rim = abs(r * truth.wheel_speed[robot, wheel])
    creep = drive.creep_speed[robot, wheel] + drive.creep_ratio[robot, wheel] * rim
    return secant(mu * load, slip, creep)


@inner
def _turn_wheels(
    drive: Drive, truth: Truth, robot: int, dt: float, ux: float, uy: float, uw: float
) -> None:
    """Give the wheels the speeds that go with the twist after the tick."""
    for wheel in range(drive.wheels[robot]):
        gx, gy, gw = _row(drive.forward, robot, wheel)
        rolling = gx * ux + gy * uy + gw * uw
        speed = _settled(drive.free_speed[robot, wheel] + drive.follow[robot, wheel] * rolling)
        truth.slip[robot, wheel] = drive.radius[robot, wheel] * speed - rolling
        # pymunk moves the body with the old velocity: so do the wheels
        truth.wheel_angle[robot, wheel] += truth.wheel_speed[robot, wheel] * dt
        truth.wheel_speed[robot, wheel] = speed


@inner
def _lean(truth: Truth, robot: int, dt: float, ax: float, ay: float) -> None:
    """Low-pass of the acceleration, which shifts the loads of the next tick."""
    share = dt / (LOAD_LAG + dt)
    last_x, last_y = truth.acceleration[robot, 0], truth.acceleration[robot, 1]
    truth.acceleration[robot, 0] = _settled(last_x + (ax - last_x) * share)
    truth.acceleration[robot, 1] = _settled(last_y + (ay - last_y) * share)


@inner
def _settled(rate: float) -> float:
    """0 for what has all but died away: numbers near 1e-308 take a processor ten times as long."""
    return 0.0 if abs(rate) < STILL else rate


@inner
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
