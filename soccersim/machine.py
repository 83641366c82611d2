"""All that a tick reads and changes, put together from a scenario."""

from typing import NamedTuple

import numpy as np

from soccersim.control.orders import PERFECT, Orders, build_orders
from soccersim.control.plan import Plan, Progress, build_plan, new_progress
from soccersim.control.position import PositionLoop, build_position_loop
from soccersim.control.wheels import WheelLoop, build_wheel_loop
from soccersim.estimation.odometry import Odometry, build_odometry
from soccersim.limbs import Limbs, build_limbs
from soccersim.plant.ball import Rolling, build_ball
from soccersim.plant.build import build_drive, wheel_count
from soccersim.plant.drive import Drive
from soccersim.plant.hand import Hand
from soccersim.plant.handling import Handling, build_handling
from soccersim.plant.world import Chipmunk, World
from soccersim.record.log import Log, new_log
from soccersim.referee.watch import Watch, build_watch
from soccersim.sensing.encoder import Encoders, build_encoders
from soccersim.sensing.gyro import Gyros, build_gyros
from soccersim.sensing.noise import Noise, NoiseSource
from soccersim.spec.scenario import Scenario
from soccersim.state import (
    LINKS,
    Command,
    Estimate,
    Readings,
    Truth,
    Whole,
    new_command,
    new_estimate,
    new_readings,
    new_truth,
)


class Machine(NamedTuple):
    """All that a tick reads and changes."""

    truth: Truth
    readings: Readings
    estimate: Estimate
    command: Command
    encoders: Encoders
    gyros: Gyros
    noise: Noise
    odometry: Odometry
    plan: Plan
    progress: Progress
    position: PositionLoop
    wheels: WheelLoop
    orders: Orders
    hand: Hand
    drive: Drive
    ball: Rolling
    handling: Handling
    limbs: Limbs
    chipmunk: Chipmunk
    watch: Watch
    log: Log
    sense_every: int  # ticks: at no others is a sensor due
    control_every: int  # ticks: at no others is a robot's code due
    endless: bool  # nobody has a plan that comes to an end
    match: bool  # orders come by radio, and the referee watches


def build_machine(scenario: Scenario, world: World, truth: Truth) -> tuple[Machine, NoiseSource]:
    """Everything at its start, and what draws the noise; the world has put the bodies in truth."""
    models = [player.model for player in scenario.robots]
    robots, wheels = len(models), wheels_at_most(scenario)
    arms, hz, seed = len(scenario.arms), scenario.timing.physics_hz, scenario.seed
    estimate = new_estimate(robots, wheels)
    estimate.pose[:] = truth.body[:robots, :3]
    start = estimate.pose.copy()
    encoders, count_angle = build_encoders(models, wheels, hz, seed)
    gyros = build_gyros(models, hz, seed)
    plan, handling = build_plan(scenario, wheels), build_handling(scenario)
    noise = NoiseSource(models, wheels, hz, seed, handling.kicks)
    match, radio = scenario.match, scenario.senses.radio
    decide_every = scenario.every(match.decide_hz) if match else 1
    drive = build_drive(models, scenario.field, seed)
    machine = Machine(
        truth=truth,
        readings=new_readings(robots, wheels, arms),
        estimate=estimate,
        command=new_command(robots, wheels),
        encoders=encoders,
        gyros=gyros,
        noise=noise.noise,
        odometry=build_odometry(models, count_angle, hz),
        plan=plan,
        progress=new_progress(start),
        position=build_position_loop(models, start),
        wheels=build_wheel_loop(models, wheels),
        orders=build_orders(
            models,
            PERFECT if scenario.perception == "truth" else radio,
            decide_every,
            hz,
            seed,
        ),
        hand=Hand(plan.pushed, np.stack([drive.mass, drive.mass, drive.inertia], axis=1)),
        drive=drive,
        ball=build_ball(scenario),
        handling=handling,
        limbs=build_limbs(scenario),
        chipmunk=world.chipmunk,
        watch=build_watch(scenario)._replace(held=handling.held, kicked=handling.kicked),
        log=new_log(
            scenario.every(scenario.timing.record_hz),
            len(truth.body),
            robots,
            wheels,
            plan.kind.shape[1],
            arms,
        ),
        sense_every=_often(np.append(encoders.every, gyros.every)),
        control_every=_often(plan.every),
        endless=not any(plan.legs) and not any(arm.reaches for arm in scenario.arms),
        match=match is not None,
    )
    return machine, noise


def empty_truth(scenario: Scenario) -> Truth:
    """Room for the bodies: the robots, the ball, each arm's links."""
    robots, ball = len(scenario.robots), scenario.ball is not None
    bodies = robots + ball + LINKS * len(scenario.arms)
    return new_truth(bodies, robots, wheels_at_most(scenario))


def wheels_at_most(scenario: Scenario) -> int:
    """Of any robot, driven and dead ones."""
    return max([0, *(wheel_count(player.model) for player in scenario.robots)])


def _often(every: Whole) -> int:
    """The longest period at which all of these are due; 0 stands for never."""
    return int(np.gcd.reduce(every, axis=None)) or 1
