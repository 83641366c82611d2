"""The parts put together: the loop of one run.

    each tick:  sense -> estimate -> decide -> control -> record -> actuate
                Truth -> Readings -> Estimate -> Command -> Truth

`run_ticks` is that line. It is compiled, and runs whole pieces of a run without any Python.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from soccersim import __version__
from soccersim.control.plan import (
    TARGET,
    Plan,
    Progress,
    build_plan,
    finished,
    follow,
    new_progress,
)
from soccersim.control.position import PositionLoop, build_position_loop, seek
from soccersim.control.reach import through
from soccersim.control.wheels import WheelLoop, build_wheel_loop, turn_wheels
from soccersim.estimation.odometry import Odometry, build_odometry, reckon
from soccersim.kernel import kernel
from soccersim.limbs import Limbs, build_limbs, ends, move_arms
from soccersim.plant.arm import LINKS
from soccersim.plant.ball import Rolling, build_ball, roll_ball
from soccersim.plant.build import build_drive, wheel_count
from soccersim.plant.drive import Drive, drive_robots
from soccersim.plant.hand import Hand, push_robots
from soccersim.plant.world import Chipmunk, World, step_bodies
from soccersim.problems import RunError
from soccersim.record import Recording
from soccersim.record.digest import Digest, fingerprint
from soccersim.record.log import RECORDS, Log, new_log, record, record_legs
from soccersim.record.recording import FORMAT, GROUPS
from soccersim.sensing.encoder import Encoders, build_encoders, read_encoders
from soccersim.sensing.gyro import Gyros, build_gyros, read_gyros
from soccersim.sensing.noise import Noise, NoiseSource
from soccersim.spec.scenario import Scenario
from soccersim.state import (
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

PIECE = 10_000  # ticks at most without Python: Ctrl-C is heard within half a second


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
    hand: Hand
    drive: Drive
    ball: Rolling
    limbs: Limbs
    chipmunk: Chipmunk
    log: Log
    sense_every: int  # ticks: at no others is a sensor due
    control_every: int  # ticks: at no others is a robot's code due
    endless: bool  # nobody has a plan that comes to an end


@kernel
def run_ticks(m: Machine, tick: int, end: int, dt: float) -> int:
    """Run from tick to end, or to where all plans are through; returns the tick reached.

    A negative answer -1 - t says that the forces of tick t were no numbers.
    """
    while tick < end:
        if tick % m.sense_every == 0:
            read_encoders(m.encoders, m.readings, m.truth, m.noise, tick, dt)
            read_gyros(m.gyros, m.readings, m.truth, m.noise, tick, dt)
        if tick % m.control_every == 0:
            reckon(m.odometry, m.estimate, m.readings, tick, dt)
            follow(m.plan, m.progress, m.estimate, m.command, tick, dt)
            seek(m.position, m.plan, m.progress, m.estimate, m.command, tick, dt)
            turn_wheels(m.wheels, m.position, m.plan, m.progress, m.readings, m.command, tick, dt)
            p = m.progress
            record_legs(m.log, p.ended, p.ended_leg, p.ended_reached, m.truth, m.estimate, tick)
        record(m.log, m.truth, m.readings, m.estimate, m.command, m.progress.leg, tick)
        if (
            tick % m.control_every == 0
            and not m.endless
            and finished(m.plan, m.progress)
            and through(m.limbs.plan, m.limbs.progress)
        ):
            return tick
        push_robots(m.hand, m.command.reference, m.progress.motion, m.truth)
        drive_robots(m.drive, m.truth, m.command.pwm, dt)
        if m.ball.mass > 0.0:
            roll_ball(m.ball, m.truth, dt)
        move_arms(m.limbs, m.truth, m.readings, m.estimate, tick, dt)
        if not step_bodies(m.chipmunk, m.truth, dt):
            return -1 - tick
        tick += 1
    return tick


class Simulation:
    """One run of a scenario: `run()` does it all.

    `advance(ticks)` goes on in steps, with the state in `machine` free to be looked at between.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self.tick = 0
        self.done = False
        self.end = max(1, round(scenario.duration * scenario.timing.physics_hz))
        models = [player.model for player in scenario.robots]
        robots, wheels = len(models), max([0, *map(wheel_count, models)])
        arms, ball = len(scenario.arms), scenario.ball
        hz, seed = scenario.timing.physics_hz, scenario.seed
        truth = new_truth(robots + (ball is not None) + LINKS * arms, robots, wheels)
        self.world = World(scenario, truth)
        estimate = new_estimate(robots, wheels)
        estimate.pose[:] = truth.body[:robots, :3]
        start = estimate.pose.copy()
        encoders, count_angle = build_encoders(models, wheels, hz, seed)
        gyros = build_gyros(models, hz, seed)
        self.noise = NoiseSource(models, wheels, hz, seed)
        plan = build_plan(scenario, wheels)
        drive = build_drive(models, scenario.field, seed)
        self.machine = Machine(
            truth=truth,
            readings=new_readings(robots, wheels, arms),
            estimate=estimate,
            command=new_command(robots, wheels),
            encoders=encoders,
            gyros=gyros,
            noise=self.noise.noise,
            odometry=build_odometry(models, count_angle, hz),
            plan=plan,
            progress=new_progress(start),
            position=build_position_loop(models, start),
            wheels=build_wheel_loop(models, wheels),
            hand=Hand(plan.pushed, np.stack([drive.mass, drive.mass, drive.inertia], axis=1)),
            drive=drive,
            ball=build_ball(scenario),
            limbs=build_limbs(scenario),
            chipmunk=self.world.chipmunk,
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
        )
        self._shots = list(ball.shots) if ball else []
        self._pieces: dict[str, list[np.ndarray[Any, Any]]] = {
            key: [] for group in ("poses", *scenario.record) for key in GROUPS[group]
        }
        self._digest = Digest()

    def run(self, progress: Callable[[float], None] | None = None) -> Recording:
        """The whole run; progress is told the share done now and then."""
        while not self.done:
            self.advance(self.end - self.tick, pieces=1)
            if progress:
                progress(1.0 if self.done else self.tick / self.end)
        return self.recording()

    def step(self) -> None:
        """One physics tick."""
        self.advance(1)

    def advance(self, ticks: int, pieces: int | None = None) -> None:
        """Run so many ticks, or until the run is over; or only so many pieces of them."""
        goal = min(self.tick + ticks, self.end)
        while self.tick < goal and not self.done and pieces != 0:
            every = self.machine.log.every
            room = (-(-self.tick // every) + RECORDS) * every
            shot = self._shoot()
            piece = self.noise.prepare(self.tick, min(goal, room, self.tick + PIECE, shot))
            reached = run_ticks(self.machine, self.tick, piece, self.scenario.dt)
            self._check(reached)
            self.done = reached < piece or reached == self.end
            self.tick = reached
            self._collect()
            pieces = None if pieces is None else pieces - 1

    def recording(self) -> Recording:
        """What has been recorded so far."""
        log = self.machine.log  # its empty start makes a run of no records one too
        arrays = {
            key: np.concatenate([getattr(log, key)[:0], *parts])
            for key, parts in self._pieces.items()
        }
        return Recording(
            {
                "format": FORMAT,
                "soccersim": __version__,
                "scenario": self.scenario.model_dump(mode="json"),
                "seed": self.scenario.seed,
                "digest": self._digest.hex,
                "physics_hz": self.scenario.timing.physics_hz,
                "ticks": self.tick,
                "platform": fingerprint(),
                "legs": [self._legs(robot) for robot in range(len(self.scenario.robots))],
                "arms": ends(self.machine.limbs),
            },
            arrays,
        )

    def _shoot(self) -> int:
        """Place the ball where a shot is due; returns the tick of the next one, or the end."""
        hz, at = self.scenario.timing.physics_hz, self.scenario.coordinates
        while self._shots and round(self._shots[0].time * hz) <= self.tick:
            shot = self._shots.pop(0)
            place, velocity = at.field_pose((*shot.at, 0.0)), at.field_vector(*shot.velocity)
            self.world.place_ball(self.machine.truth, *place[:2], *velocity)
        return round(self._shots[0].time * hz) if self._shots else self.end

    def _check(self, reached: int) -> None:
        """Nothing may go on from a state that is not made of numbers."""
        m = self.machine
        if reached < 0 or not all(np.isfinite(a).all() for a in (m.truth.body, m.estimate.pose)):
            records = slice(int(m.log.filled[0]))
            finite = np.isfinite(m.log.body[records]).all(axis=(1, 2))
            finite &= np.isfinite(m.log.estimate[records]).all(axis=(1, 2))
            wrong = [*m.log.tick[records][~finite], -1 - reached if reached < 0 else reached]
            where = int(wrong[0])
            what = f"{self.scenario.name}: the state stopped being a number at tick {where}"
            raise RunError(f"{what} ({where * self.scenario.dt:.3f} s)")

    def _collect(self) -> None:
        """Move the log's records to where the run is kept, and link them into the digest."""
        log = self.machine.log
        count = int(log.filled[0])
        if count == 0:
            return
        log.filled[0] = 0
        for key, parts in self._pieces.items():
            parts.append(getattr(log, key)[:count].copy())
        chained = (log.body, log.wheel_angle, log.wheel_speed, log.estimate)
        self._digest.add([array[:count] for array in chained])

    def _legs(self, robot: int) -> list[dict[str, Any]]:
        """The legs that ended, and the one that the end of the run cut short; field frame."""
        m, legs = self.machine, []
        for k in range(int(m.plan.legs[robot])):
            start, end = map(int, m.log.leg_ticks[robot, k])
            reached = bool(m.log.leg_reached[robot, k])
            odometry, truth = m.log.leg_estimate[robot, k], m.log.leg_truth[robot, k]
            aimed = m.plan.kind[robot, k] == TARGET
            if end < 0:
                if not self.done or start == self.tick:
                    break
                end = self.tick
                reached = not aimed and end - start >= m.plan.ticks[robot, k]
                odometry, truth = m.estimate.pose[robot], m.truth.body[robot, :3]
            legs.append(
                {
                    "target": m.plan.value[robot, k, :3].tolist() if aimed else None,
                    "start_tick": start,
                    "end_tick": end,
                    "reached": bool(reached),
                    "odometry": odometry.tolist(),
                    "truth": truth.tolist(),
                }
            )
            if end == self.tick:
                break
        return legs


def _often(every: Whole) -> int:
    """The longest period at which all of these are due; 0 stands for never."""
    return int(np.gcd.reduce(every, axis=None)) or 1
