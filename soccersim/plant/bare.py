"""Bare pymunk over a scenario's bodies, from plain Python: the floor of the bench."""

import numpy as np
from pymunk import batch

from soccersim.plant.world import World
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, new_truth

POSE = (
    batch.BodyFields.POSITION
    | batch.BodyFields.ANGLE
    | batch.BodyFields.VELOCITY
    | batch.BodyFields.ANGULAR_VELOCITY
)
WRENCH = batch.BodyFields.FORCE | batch.BodyFields.TORQUE


class BareWorld:
    """The same space as a simulation's, moved by pymunk's own step and batch calls alone."""

    def __init__(self, scenario: Scenario) -> None:
        robots = len(scenario.robots)
        bodies = robots + (scenario.ball is not None)
        self._world = World(scenario, new_truth(bodies, robots, 1))
        # one row more than there are bodies: the static one comes last
        self._states = np.zeros((bodies + 1, 6))
        self._state_buffer, self._push_buffer = batch.Buffer(), batch.Buffer()
        self._state_buffer.set_float_buf(self._states)
        self._push_buffer.set_float_buf(np.zeros((bodies + 1, 3)))
        self._read_buffer = batch.Buffer()

    def set_states(self, body: Array) -> None:
        """Put all bodies where body (B, 6) says: x, y, heading, vx, vy, omega; field frame."""
        self._states[:-1] = body
        batch.set_space_bodies(self._world.space, POSE, self._state_buffer)

    def tick(self, dt: float) -> None:
        """One batch write, one step, one batch read."""
        batch.set_space_bodies(self._world.space, WRENCH, self._push_buffer)
        self._world.space.step(dt)
        self._read_buffer.clear()
        batch.get_space_bodies(self._world.space, POSE, self._read_buffer)
