"""The parts put together: the loop of one run.

    each tick:  sense -> estimate -> decide -> control -> record -> actuate
                Truth -> Readings -> Estimate -> Command -> Truth

`run_ticks` is that line. It is compiled, and runs whole pieces of a run without any Python.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from soccersim import __version__
from soccersim.control.orders import forget, obey
from soccersim.control.plan import TARGET, finished, follow
from soccersim.control.position import seek
from soccersim.control.reach import through
from soccersim.control.wheels import turn_wheels
from soccersim.estimation.odometry import reckon
from soccersim.kernel import kernel, settled
from soccersim.limbs import ends, move_arms
from soccersim.machine import Machine, build_machine, empty_truth
from soccersim.plant.ball import roll_ball
from soccersim.plant.drive import drive_robots
from soccersim.plant.hand import push_robots
from soccersim.plant.handling import feel_ball, handle_ball
from soccersim.plant.world import World, step_bodies
from soccersim.problems import RunError
from soccersim.record import Recording
from soccersim.record.compact import rounded
from soccersim.record.digest import KEPT, Chain, Digest, fingerprint
from soccersim.record.log import RECORDS, record, record_legs
from soccersim.record.recording import FORMAT, GROUPS, PLANS
from soccersim.referee.watch import watch
from soccersim.sensing.encoder import read_encoders
from soccersim.sensing.gyro import read_gyros
from soccersim.spec.scenario import Scenario

PIECE = 10_000  # ticks at most without Python: Ctrl-C is heard within half a second


@kernel
def run_ticks(m: Machine, tick: int, end: int, dt: float) -> int:
    """Run from tick to end, or to where all plans are through; returns the tick reached.

    A negative answer -1 - t says that the forces of tick t were no numbers.
    """
    while tick < end:
        if tick % m.sense_every == 0:
            read_encoders(m.encoders, m.readings, m.truth, m.noise, tick, dt)
            read_gyros(m.gyros, m.readings, m.truth, m.noise, tick, dt)
            feel_ball(m.handling, m.readings, m.truth)
        if tick % m.control_every == 0:
            reckon(m.odometry, m.estimate, m.readings, tick, dt)
            follow(m.plan, m.progress, m.estimate, m.command, tick, dt)
            seek(m.position, m.plan, m.progress, m.estimate, m.command, tick, dt)
            if m.match:
                obey(m.orders, m.estimate, m.command, tick, dt)
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
            handle_ball(m.handling, m.noise.kick, m.command, m.truth, tick, dt)
        move_arms(m.limbs, m.truth, m.readings, m.estimate, tick, dt)
        if not step_bodies(m.chipmunk, m.truth, dt):
            return -1 - tick
        tick += 1
        if m.match:
            watch(m.watch, m.truth, tick)
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
        truth = empty_truth(scenario)
        self.world = World(scenario, truth)
        self.machine, self.noise = build_machine(scenario, self.world, truth)
        self._shots = list(scenario.ball.shots) if scenario.ball else []
        self._lasts = 0  # tick up to which the noise that is drawn and the room in the log last
        self._pieces: dict[str, list[np.ndarray[Any, Any]]] = {
            key: []
            for group in ("poses", *scenario.record)
            for key in GROUPS[group]
            if not scenario.match or key not in PLANS
        }
        self._digest = Digest()
        self._ticks = settled(run_ticks)

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
            self._make_room()
            self._run(min(goal, self._lasts, self.tick + PIECE))
            self.collect()
            pieces = None if pieces is None else pieces - 1

    def hurry(self, ticks: int) -> None:
        """The same for many short steps: what is recorded stays in the log until it is full."""
        goal = min(self.tick + ticks, self.end)
        while self.tick < goal and not self.done:
            if self.tick >= self._lasts:
                self.collect()
                self._make_room()
            self._run(min(goal, self._lasts))

    def place_robot(self, robot: int, x: float, y: float, heading: float) -> None:
        """Carry a robot somewhere, at rest; it is told where it is. Field frame."""
        m = self.machine
        self.world.place_robot(m.truth, robot, x, y, heading)
        m.estimate.pose[robot] = m.truth.body[robot, :3]
        m.estimate.twist[robot] = 0.0
        m.gyros.heading[robot] = m.truth.body[robot, 2]
        m.wheels.sums[robot] = 0.0
        forget(m.orders, robot)

    def place_ball(self, x: float, y: float) -> None:
        """Put the ball somewhere, at rest. Field frame."""
        self.world.place_ball(self.machine.truth, x, y, 0.0, 0.0)

    def _make_room(self) -> None:
        """See to the shots, and find out how long the noise and the log last."""
        every = self.machine.log.every
        room = (-(-self.tick // every) + RECORDS) * every
        self._lasts = self.noise.prepare(self.tick, min(self.end, room, self._shoot()))

    def _run(self, end: int) -> None:
        reached = self._ticks(self.machine, self.tick, end, self.scenario.dt)
        if reached < 0:
            self._check(reached)
        self.done = reached < end or reached == self.end
        self.tick = reached

    def recording(self) -> Recording:
        """What has been recorded so far."""
        self.collect()
        empty = np.empty((0, KEPT), np.uint8)
        arrays = {
            key: np.concatenate(parts or [self._kept(key, 0, empty)])
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

    def collect(self) -> None:
        """Move the log's records to where the run is kept, and link them into the digest."""
        log = self.machine.log
        count = int(log.filled[0])
        self._check(self.tick)
        if count == 0:
            return
        log.filled[0] = 0
        chained = (log.body, log.wheel_angle, log.wheel_speed, log.estimate)
        chain = self._digest.add([array[:count] for array in chained])
        for key, parts in self._pieces.items():
            parts.append(self._kept(key, count, chain))

    def _kept(self, key: str, count: int, chain: Chain) -> np.ndarray[Any, Any]:
        """The first records of an array of the log, as they are kept."""
        array = chain if key == "chain" else getattr(self.machine.log, key)[:count]
        return rounded(key, array.copy()) if self.scenario.match else array.copy()

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
