"""One control loop of a robot to experiment on: open, for a relay, and closed, with any gains.

The robot is the simulated one, its wheels as built, its sensors and its floor, alone at the centre
of the field; only its control is changed. A relay stands in the controller's place: it sees what
the robot measures at a control step, and pushes until the next.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from typing import Any, TypeVar

import numpy as np

from soccersim.control.tuning import CONTROLLERS
from soccersim.estimation.odometry import reckon
from soccersim.geometry import rotate
from soccersim.sensing.encoder import read_encoders
from soccersim.sensing.gyro import read_gyros
from soccersim.simulation import Simulation
from soccersim.spec.control import Arrival, Control, Limits, Pi, Pid
from soccersim.spec.frame import Units
from soccersim.spec.motor import PWM_MAX, table_speeds
from soccersim.spec.player import Leg, Phase, Player
from soccersim.spec.robot import Robot
from soccersim.spec.scenario import Scenario, Timing
from soccersim.state import Array, Estimate, Readings

MOVES = {"x": 0.5, "y": 0.5, "heading": pi / 4}  # m and rad: what gains are compared by
CRUISE, FASTER = 0.2, 0.1  # of the wheels' top speed: at what they turn, and their step from there
RAMP, LEAD = 20, 1.6  # in so many small steps, that no wheel spins; s until they turn steadily
PATIENCE = 20.0  # s of a relay test
HARDEST = 0.25  # of what the motors can do: a relay stays within
FREE = 1e6  # what a scenario may give at most: no limit
RAISED = Limits(speed=FREE, acceleration=FREE, turn_rate=FREE, turn_acceleration=FREE)
UNENDING = Arrival(dwell=1e6, timeout=1e6)  # a move is watched after it has arrived
State = TypeVar("State")


@dataclass(frozen=True)
class Answer:
    """What a closed loop did after a step of its set-point."""

    time: Array  # s from the step
    value: Array  # from where it was
    full: bool  # whether a motor was at full PWM


def sensed(sim: Simulation) -> tuple[Readings, Estimate]:
    """What the robot will read and believe at the tick to come: its own sensors, on copies."""
    m, tick, dt = sim.machine, sim.tick, sim.scenario.dt
    encoders, gyros = _copy(m.encoders), _copy(m.gyros)
    readings, estimate = _copy(m.readings), _copy(m.estimate)
    sim.noise.prepare(tick, tick + 1)
    read_encoders(encoders, readings, m.truth, m.noise, tick, dt)
    read_gyros(gyros, readings, m.truth, m.noise, tick, dt)
    reckon(m.odometry, estimate, readings, tick, dt)
    return readings, estimate


def _copy(state: State) -> State:
    arrays: Any = state
    copied: State = type(arrays)(*(array.copy() for array in arrays))
    return copied


class Rig:
    """An open loop: call it with a push for what the robot measures one control step later."""

    def __init__(
        self,
        stage: Scenario,
        push: Callable[[Simulation, Estimate, float], None],
        measured: Callable[[Readings, Estimate], float],
    ) -> None:
        self.sim, self.model = Simulation(stage), stage.robots[0].model
        self.push, self.measured = push, measured
        self.readings, self.estimate = sensed(self.sim)
        self.rest = measured(self.readings, self.estimate)
        self.grip = 0.0  # the largest share of the floor's grip so far
        self.full = False  # whether a motor was at full PWM

    def __call__(self, push: float) -> float:
        """Hold a push for one control step; what is measured then, from rest."""
        self.push(self.sim, self.estimate, push)
        self.sim.advance(self.sim.scenario.every(self.model.control.rate_hz))
        self.readings, self.estimate = sensed(self.sim)
        self.grip = max(self.grip, self._grip())
        self.full |= bool(np.abs(self.sim.machine.command.pwm).max() >= PWM_MAX)
        return self.measured(self.readings, self.estimate) - self.rest

    def _grip(self) -> float:
        """How near the driven wheels are to sliding, by their slip: 0 to 1."""
        truth, grip, base = self.sim.machine.truth, self.model.drive.grip, self.model.drive.base
        slip = np.abs(truth.slip[0, : base.wheels])
        rim = np.abs(base.rolling_radius * truth.wheel_speed[0, : base.wheels])
        return float(np.max(slip / np.hypot(slip, grip.creep_speed + grip.creep_ratio * rim)))


class Loop:
    """What all loops have in common."""

    name = unit = push_unit = ""
    controllers: tuple[str, ...] = CONTROLLERS
    step = 0.0  # of the set-point, by which gains are compared
    hardest = 0.0  # push of a relay

    def __init__(self, scenario: Scenario, player: Player, model: Robot) -> None:
        self.scenario, self.model = scenario, model
        self.heading = scenario.coordinates.field_pose(player.start)[2]
        self.dt = 1.0 / model.control.rate_hz
        base = model.drive.base
        self.inverse = base.jacobian / base.rolling_radius[:, None]
        self.table = table_speeds(model.drive.motor, base.wheels)
        self.top = float(self.table[:, -1].min())  # rad/s of the slowest wheel

    def rig(self) -> Rig:
        """The loop without its controller."""
        raise NotImplementedError

    def control(self, gains: Pid) -> Control:
        """The robot's control with these gains instead."""
        raise NotImplementedError

    def answer(self, gains: Pid, step: float, seconds: float, raised: bool = False) -> Answer:
        """The loop with these gains, after a step; raised: without limits and profile."""
        raise NotImplementedError

    @property
    def present(self) -> Pid:
        """The gains that the scenario gives."""
        gains = getattr(self.model.control, self.name)
        return Pid(kp=gains.kp, ki=gains.ki, kd=getattr(gains, "kd", 0.0))

    def stage(self, control: Control, seconds: float, **plan: Any) -> Scenario:
        """The scenario of an experiment: the robot alone, heading as it starts."""
        hz, physics_hz = control.rate_hz, self.scenario.timing.physics_hz
        model = self.model.model_copy(update={"control": control})
        player = Player(name=self.name, model=model, start=(0.0, 0.0, self.heading), **plan)
        return Scenario(
            version=1,
            name="tune",
            units=Units(angle="rad"),
            seed=self.scenario.seed,
            duration=seconds,
            timing=Timing(physics_hz=physics_hz, record_hz=hz, frames_hz=hz),
            field=self.scenario.field,
            robots=(player,),
        )


class AxisLoop(Loop):
    """The position loop of x, y or heading: place in, velocity out."""

    def __init__(self, scenario: Scenario, player: Player, model: Robot, name: str) -> None:
        super().__init__(scenario, player, model)
        self.name, self.axis, self.step = name, list(MOVES).index(name), MOVES[name]
        self.unit, self.push_unit = ("rad", "rad/s") if self.axis == 2 else ("m", "m/s")
        self.hardest = HARDEST * self.top / float(np.abs(self.inverse[:, self.axis]).max())

    def control(self, gains: Pid) -> Control:
        """The robot's control with these gains on this axis."""
        return self.model.control.model_copy(update={self.name: gains})

    def rig(self) -> Rig:
        """A velocity along the axis in, the believed place out; no path: nobody else commands."""
        stage = self.stage(self.model.control, PATIENCE + self.dt)
        return Rig(stage, self._push, lambda _, estimate: float(estimate.pose[0, self.axis]))

    def _push(self, sim: Simulation, estimate: Estimate, push: float) -> None:
        """From the field frame into the body frame at the step's middle, as the controller does."""
        velocity = [push if axis == self.axis else 0.0 for axis in range(3)]
        heading = estimate.pose[0, 2] + 0.5 * estimate.twist[0, 2] * self.dt
        vx, vy = rotate(velocity[0], velocity[1], -heading)
        sim.machine.command.twist[0] = vx, vy, velocity[2]

    def answer(self, gains: Pid, step: float, seconds: float, raised: bool = False) -> Answer:
        """A move to a target, as the odometry sees it."""
        control = self.control(gains).model_copy(update={"arrival": UNENDING})
        if raised:
            control = control.model_copy(update={"limits": RAISED, "profile": "none"})
        target = np.array([0.0, 0.0, self.heading])
        start = target[self.axis]
        target[self.axis] += step
        leg = Leg(to=(float(target[0]), float(target[1]), float(target[2])))
        run = Simulation(self.stage(control, seconds, path=(leg,))).run()
        return _answer(run.estimate[:, 0, self.axis] - start, run.arrays["pwm"], self.dt)


class WheelLoop(Loop):
    """The driven wheels' loops, which are alike: speed in, PWM out.

    The robot turns on the spot, all wheels at once: that needs no room, and its wheels carry less
    inertia than in driving straight, so that what is calm here is calm there.
    """

    name, unit, push_unit, controllers = "wheel", "rad/s", "PWM", CONTROLLERS[:2]

    def __init__(self, scenario: Scenario, player: Player, model: Robot) -> None:
        super().__init__(scenario, player, model)
        self.turning = self.inverse[:, 2] / np.abs(self.inverse[:, 2]).max()  # shares of the speed
        self.turns = np.flatnonzero(np.abs(self.turning) > 0.1)  # wheels that have a part in it
        self.cruise, self.step = CRUISE * self.top, FASTER * self.top
        self.hardest = HARDEST * PWM_MAX
        self.stride = max(1, round(0.5 * LEAD / RAMP / self.dt)) * self.dt  # of the ramp
        self.lead = 2 * RAMP * self.stride
        speeds = np.abs(self.cruise * self.turning)
        span = np.arange(PWM_MAX + 1.0)
        levels = [np.interp(v, row, span) for v, row in zip(speeds, self.table, strict=True)]
        self.level = np.array(levels) * np.sign(self.turning)

    def control(self, gains: Pid) -> Control:
        """The robot's control with these gains of its wheels; there is no derivative."""
        return self.model.control.model_copy(update={"wheel": Pi(kp=gains.kp, ki=gains.ki)})

    def rig(self) -> Rig:
        """PWM above what keeps the robot turning in, the encoders' speed above that out."""
        seconds = self.lead + PATIENCE + self.dt
        idle = Phase(seconds=seconds, pwm=(0,) * len(self.turning))
        stage = self.stage(self.model.control, seconds, open_loop=(idle,))
        rig = Rig(stage, self._push, lambda readings, _: self._speed(readings.wheel_speed[:1])[0])
        speeds = [rig(0.0) for _ in range(round(self.lead / self.dt))]
        rig.rest, rig.grip = rig.rest + float(np.mean(speeds[len(speeds) // 2 :])), 0.0
        return rig

    def _push(self, sim: Simulation, estimate: Estimate, push: float) -> None:
        """Write the levels into the open-loop leg that the robot is on."""
        levels = np.round(self.level + push * np.sign(self.turning))
        sim.machine.plan.value[0, 0, : len(levels)] = np.clip(levels, -PWM_MAX, PWM_MAX)

    def _speed(self, wheel_speed: Array) -> Array:
        """(T, W) speeds of all wheels to (T,): the mean, each as the fastest one's."""
        speeds: Array = np.mean(wheel_speed[:, self.turns] / self.turning[self.turns], axis=1)
        return speeds

    def answer(self, gains: Pid, step: float, seconds: float, raised: bool = False) -> Answer:
        """A faster turn on the spot: the true speed of the wheels."""
        ramp = [self.cruise * (k + 1) / RAMP for k in range(RAMP)]
        spans = [self.stride] * RAMP + [0.5 * self.lead, seconds]
        phases = tuple(
            Phase(seconds=span, wheel_speeds=tuple(float(v) for v in speed * self.turning))
            for span, speed in zip(spans, [*ramp, self.cruise, self.cruise + step], strict=True)
        )
        stage = self.stage(self.control(gains), self.lead + seconds, open_loop=phases)
        run = Simulation(stage).run()
        after = slice(round(self.lead / self.dt), None)
        speed = self._speed(run.arrays["wheel_speed"][after, 0])
        return _answer(speed - self.cruise, run.arrays["pwm"][after], self.dt)


def _answer(value: Array, pwm: Array, dt: float) -> Answer:
    time: Array = np.arange(len(value), dtype=float) * dt
    return Answer(time, value, bool(np.abs(pwm).max() >= PWM_MAX))
