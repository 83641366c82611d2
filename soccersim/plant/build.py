"""From a robot as described to the arrays of the robot as built, its tolerances drawn."""

from collections.abc import Sequence
from math import inf

import numpy as np

from soccersim.kinematics import OmniBase
from soccersim.plant.drive import Drive
from soccersim.plant.traction import dry_friction
from soccersim.spec.base import per_item
from soccersim.spec.field import Field
from soccersim.spec.motor import PWM_MAX, RAD_S, Motor, table_speeds
from soccersim.spec.robot import GRAVITY, DeadWheels, DriveWheels, Robot, Wheels
from soccersim.state import Array
from soccersim.streams import stream


def wheel_sets(robot: Robot) -> list[Wheels]:
    """The driven wheels, then the dead ones: the order of every wheel array."""
    return [robot.drive, *([robot.dead] if robot.dead else [])]


def wheel_count(robot: Robot) -> int:
    """How many wheels stand on the floor."""
    return sum(len(wheels.azimuth_deg) for wheels in wheel_sets(robot))


def build_drive(robots: Sequence[Robot], field: Field, seed: int) -> Drive:
    """The plant's arrays; what differs from the drawing is drawn from (seed, robot, wheel set)."""
    shape = (len(robots), max([0, *map(wheel_count, robots)]))
    zeros = {
        name: np.zeros((*shape, *_tail(name)))
        for name in Drive._fields
        if name not in ("wheels", "mass", "inertia")
    }
    drive = Drive(
        wheels=np.array([wheel_count(robot) for robot in robots], np.int64),
        mass=np.array([robot.mass for robot in robots], float),
        inertia=np.array([robot.yaw_inertia for robot in robots], float),
        **zeros,
    )
    for i, robot in enumerate(robots):
        first = 0
        for wheels in wheel_sets(robot):
            last = first + len(wheels.azimuth_deg)
            _build_wheels(drive, robot, wheels, i, slice(first, last), field.grip, seed)
            first = last
    return drive


def _tail(name: str) -> tuple[int, ...]:
    """What follows (R, W) in the shape of an array of Drive."""
    tails = {
        "forward": (3,),
        "sideways": (3,),
        "load_shift": (2,),
        "duty": (2 * PWM_MAX + 1,),
    }
    return tails.get(name, ())


def _build_wheels(
    drive: Drive, robot: Robot, wheels: Wheels, i: int, at: slice, floor: float, seed: int
) -> None:
    """Fill the columns of one set of wheels of robot i."""
    kind = "drive" if isinstance(wheels, DriveWheels) else "dead"
    rng = stream(seed, i, f"build.{kind}")
    count, build = len(wheels.azimuth_deg), wheels.build
    radius = wheels.radius * (1 + build.radius_bias + build.radius_sd * rng.standard_normal(count))
    apart = 1 + build.distance_sd * rng.standard_normal(count)
    motors = 1 + build.motor_sd * rng.standard_normal(count)
    base = OmniBase.general(
        wheels.azimuth_deg,
        tuple(np.array(per_item(wheels.distance, count)) * apart),
        tuple(radius),
        directions_deg=wheels.direction_deg,
        roller_angles_deg=wheels.roller_deg,
    )
    drive.forward[i, at] = base.jacobian
    drive.sideways[i, at] = base.transverse
    drive.radius[i, at] = base.rolling_radius
    drive.mobility[i, at] = 1 / robot.mass + base.jacobian[:, 2] ** 2 / robot.yaw_inertia
    grip = wheels.grip
    drive.static[i, at] = floor * grip.static
    drive.kinetic[i, at] = floor * grip.kinetic
    drive.roller[i, at] = grip.roller
    drive.stribeck_speed[i, at] = grip.stribeck_speed
    drive.creep_speed[i, at] = grip.creep_speed
    drive.creep_ratio[i, at] = grip.creep_ratio
    if isinstance(wheels, DriveWheels):
        _build_motors(drive, wheels.motor, i, at, motors)
        dead = robot.dead
        carried = robot.mass * GRAVITY - (dead.load * len(dead.azimuth_deg) if dead else 0.0)
        drive.load[i, at], drive.load_shift[i, at] = loads(
            base, max(carried, 0.0), robot.mass * robot.mass_height * robot.load_transfer
        )
    elif isinstance(wheels, DeadWheels):
        drive.load[i, at] = wheels.load
        drive.spin_inertia[i, at] = wheels.inertia
        drive.friction_torque[i, at] = wheels.friction_torque
        drive.no_load_speed[i, at] = inf
        drive.torque_limit[i, at] = inf


def _build_motors(drive: Drive, motor: Motor, i: int, at: slice, scatter: Array) -> None:
    """Fill what belongs to the motors."""
    drive.spin_inertia[i, at] = motor.inertia
    drive.friction_torque[i, at] = motor.friction_torque
    drive.stall_torque[i, at] = motor.stall_torque
    drive.no_load_speed[i, at] = motor.no_load_speed_rpm * RAD_S
    drive.torque_limit[i, at] = motor.torque_limit or inf
    drive.coasts[i, at] = float(motor.at_zero == "coast")
    speeds = table_speeds(motor, len(scatter)) * scatter[:, None]
    for k, row in enumerate(speeds):
        forward = _duty(motor, row)
        drive.duty[i, at.start + k] = np.concatenate([-forward[:0:-1], forward])


def _duty(motor: Motor, speeds: Array) -> Array:
    """The voltage, as a share of full, at which the wheel settles on these speeds.

    Without a table the voltage is proportional to the PWM, and friction slows the wheel.
    """
    top = motor.no_load_speed_rpm * RAD_S
    if motor.pwm_table is None:
        return speeds / top
    friction = np.array([dry_friction(motor.friction_torque, w) * w for w in speeds])
    return (speeds + top * friction / motor.stall_torque) / top


def loads(base: OmniBase, weight: float, lean: float) -> tuple[Array, Array]:
    """How the wheels share a weight (N), and how it shifts a m/s2 of acceleration.

    Least squares of the three balances (model of docs/models.md, section 3.3); lean is mass times
    height of the centre of mass, kg m. Returns (n,) N and (n, 2) N per m/s2, body frame.
    """
    balance = np.vstack([np.ones(len(base.contact)), base.contact.T])
    share = np.linalg.pinv(balance)
    return share[:, 0] * weight, -lean * share[:, 1:]
