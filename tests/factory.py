"""Robots and scenarios for tests, from as few words as a test needs."""

from pathlib import Path

import numpy as np

from soccersim.control.plan import build_plan, follow, new_progress
from soccersim.control.position import build_position_loop, seek
from soccersim.geometry import rotate, se2_arc
from soccersim.simulation import Simulation
from soccersim.spec.robot import Robot
from soccersim.spec.scenario import Scenario
from soccersim.spec.validate import validate
from soccersim.spec.yaml12 import read
from soccersim.state import new_command, new_estimate

ROBOTS = Path(__file__).parents[1] / "scenarios" / "robots"
BUNDLED = sorted(path.stem for path in ROBOTS.glob("*.yaml"))

# three omni wheels, built as drawn, with sensors that are never wrong
EXACT = {
    "mass": 20.0,
    "mass_height": 0.0,
    "drive": {
        "azimuth_deg": [30, 150, 270],
        "distance": 0.19,
        "radius": 0.05,
        "encoder": {"perfect": True, "window": 0.02},
    },
    "gyro": {"perfect": True},
}
NO_SLIP = {"static": 5.0, "kinetic": 5.0, "creep_speed": 1e-4, "creep_ratio": 0.0, "roller": 0.0}
WIDE = {"length": 30.0, "width": 20.0, "goal": {"width": 2.0}}


def merged(old, new):
    """A mapping changed by another one, at any depth."""
    both = {**old, **new}
    for key in old.keys() & new.keys():
        if isinstance(old[key], dict) and isinstance(new[key], dict):
            both[key] = merged(old[key], new[key])
    return both


def robot(changes=None, /, **more):
    """The exact robot with changes: robot(mass=10, drive={"radius": 0.04})."""
    return Robot.model_validate(merged(merged(EXACT, changes or {}), more))


def bundled(name):
    """A robot of scenarios/robots."""
    return validate(Robot, read(ROBOTS / f"{name}.yaml"))


def changed(model, **changes):
    """A robot with changes."""
    return Robot.model_validate(merged(model.model_dump(exclude_unset=True), changes))


def player(model=None, *path, start=(0, 0, 0), **more):
    """A robot at its start; a leg of its path is x, y, degrees or a mapping."""
    legs = [leg if isinstance(leg, dict) else {"to": leg} for leg in path]
    plan = {"path": legs} if legs else {}
    return {"name": "r", "model": model or robot(), "start": start, **plan, **more}


def scenario(*players, **more):
    """A scenario on a wide empty field; players of one name are numbered."""
    names = [entry["name"] for entry in players]
    numbered = [
        {**entry, "name": f"{entry['name']}{i}" if names.count(entry["name"]) > 1 else names[i]}
        for i, entry in enumerate(players)
    ]
    written = {"version": 1, "name": "test", "field": WIDE, "robots": numbered}
    return Scenario.model_validate(merged(written, more))


def simulate(*players, **more):
    """The recording of a whole run."""
    return Simulation(scenario(*players, **more)).run()


def far(pose, other):
    """Distance of two poses, m."""
    return float(np.hypot(pose[0] - other[0], pose[1] - other[1]))


class Obedient:
    """Plan and position loop of one robot that does at once just what they say."""

    def __init__(self, model, *path, start=(0.0, 0.0, 0.0), **more):
        written = scenario(player(model, *path, start=start, **more))
        pose = np.array([written.coordinates.field_pose(written.robots[0].start)])
        self.dt, self.tick = written.dt, 0
        self.plan, self.progress = build_plan(written, 8), new_progress(pose)
        self.loop = build_position_loop([written.robots[0].model], pose)
        self.estimate, self.command = new_estimate(1, 8), new_command(1, 8)
        self.estimate.pose[:] = pose
        self.poses, self.velocities = [], []  # field frame

    @property
    def pose(self):
        """x, y, heading; write into it to move the robot."""
        return self.estimate.pose[0]

    def step(self, hold=None):
        """One control step; hold: the twist it really makes, in the body frame."""
        every = int(self.plan.every[0])
        follow(self.plan, self.progress, self.estimate, self.command, self.tick, self.dt)
        seek(
            self.loop,
            self.plan,
            self.progress,
            self.estimate,
            self.command,
            self.tick,
            self.dt,
        )
        twist = self.command.twist[0] if hold is None else np.asarray(hold, float)
        self.estimate.twist[0] = twist
        self.poses.append(self.pose.copy())
        self.velocities.append((*rotate(twist[0], twist[1], self.pose[2]), twist[2]))
        span = every * self.dt
        chord = se2_arc(twist[0] * span, twist[1] * span, twist[2] * span)
        self.pose[:2] += rotate(*chord, self.pose[2])
        self.pose[2] += twist[2] * span
        self.tick += every

    def run(self, seconds):
        """Many steps; returns itself."""
        while self.tick * self.dt < seconds:
            self.step()
        return self
