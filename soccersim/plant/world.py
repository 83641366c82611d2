"""Bodies that meet: the only module that imports pymunk.

A tick hands the wrenches of all bodies to Chipmunk, lets it step, and reads all bodies back, each
in one call. The three C functions are called by their addresses, so that compiled kernels and
plain Python use the same path and a tick needs no Python at all. Chipmunk's own housekeeping
(bodies added or removed, callbacks) happens in Python between ticks: so no callbacks here.
"""

import ctypes
import weakref
from math import sqrt
from typing import Any, NamedTuple

import numpy as np
import pymunk
from pymunk._chipmunk_cffi import ffi, lib

from soccersim.kernel import kernel
from soccersim.plant.linkage import add_arms
from soccersim.spec.field import NET_RADIUS
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Truth

# Ends are alike whatever this is (see World._add_walls); it settles how deep robots squeeze the
# ball: 7 mm at 5, 4 mm at 10, 2 mm at 20. Ten robots in a heap take 10, 11.5, 13 us a tick then,
# and 48 us at 200.
SOLVER_ITERATIONS = 10
CONTACT_SLOP = 2e-4  # m of overlap left alone; pymunk's 0.1 is meant for pixels
OVERLAP_LEFT = 1e-8  # share of an overlap left after a second: a thirtieth a tick is pushed out
BOARD = 1.0  # m of the board's half thickness: nothing fast passes through
POSE = lib.POSITION | lib.ANGLE | lib.VELOCITY | lib.ANGULAR_VELOCITY
WRENCH = lib.FORCE | lib.TORQUE
HUGE = 1e9  # N or N m that nothing here can push with: a number gone wrong
SHELL_FRICTION = 0.3  # of robots against each other and the walls (estimate)
SLACK = 8  # numbers of room behind the batch arrays: pymunk checks no bounds


class Chipmunk(NamedTuple):
    """Addresses and buffers of one space, as kernels take them."""

    step: Any  # cpSpaceStep(space, dt)
    each_body: Any  # cpSpaceEachBody(space, function, data)
    space: int
    getter: int
    setter: int
    read_data: int
    write_data: int
    read_count: Any  # (1,) int32: numbers read so far
    write_count: Any  # (1,) int32
    read: Array  # 6 numbers a body: x, y, angle, vx, vy, omega
    write: Array  # 3 numbers a body: fx, fy, torque


@kernel
def step_bodies(chipmunk: Chipmunk, truth: Truth, dt: float) -> bool:
    """One tick of Chipmunk: wrenches in, poses and velocities out; False: no tick, bad numbers."""
    bodies = truth.body.shape[0]
    for body in range(bodies):
        for k in range(3):
            if not abs(truth.wrench[body, k]) < HUGE:  # also where it is nan
                return False
            chipmunk.write[3 * body + k] = truth.wrench[body, k]
    chipmunk.write_count[0] = 0
    chipmunk.each_body(chipmunk.space, chipmunk.setter, chipmunk.write_data)
    chipmunk.step(chipmunk.space, dt)
    chipmunk.read_count[0] = 0
    chipmunk.each_body(chipmunk.space, chipmunk.getter, chipmunk.read_data)
    for body in range(bodies):
        for k in range(6):
            truth.body[body, k] = chipmunk.read[6 * body + k]
    return True


class World:
    """The space of one run: robots and ball as bodies, board, posts and nets as walls.

    `truth.body` is filled with the start; the space outlives its buffers only together with this
    object, so keep it while kernels run.
    """

    def __init__(self, scenario: Scenario, truth: Truth) -> None:
        space = pymunk.Space(threaded=False)
        space.iterations = SOLVER_ITERATIONS
        space.collision_slop = CONTACT_SLOP
        space.collision_bias = OVERLAP_LEFT
        self.space = space
        at = scenario.coordinates
        robots: list[pymunk.Body] = []
        for row, player in enumerate(scenario.robots):
            model = player.model
            body = pymunk.Body(model.mass, model.yaw_inertia)
            x, y, body.angle = at.field_pose(player.start)
            body.position = x, y
            self._add_disc(body, model.radius, model.elasticity, sqrt(SHELL_FRICTION))
            truth.body[row, :3] = x, y, body.angle
            robots.append(body)
        self.robots = robots
        self.ball, self.ball_row = None, len(robots)
        if scenario.ball:
            ball = scenario.ball
            body = pymunk.Body(ball.mass, ball.shell * ball.mass * ball.radius**2)
            body.position = at.field_pose((*ball.at, 0.0))[:2]
            body.velocity = at.field_vector(*ball.velocity)
            # elasticities multiply: 1 leaves the bounce to what the ball meets; smooth, since
            # nothing here slows a ball that turns about the vertical
            self._add_disc(body, ball.radius, elasticity=1.0, friction=0.0)
            truth.body[len(robots)] = *body.position, 0.0, *body.velocity, 0.0
            self.ball = body
        add_arms(space, scenario, robots, truth)
        self._add_walls(scenario)
        self._keep: list[Any] = []
        self.chipmunk = self._connect(len(truth.body))
        weakref.finalize(self, _free, space)

    def place_ball(self, truth: Truth, x: float, y: float, vx: float, vy: float) -> None:
        """Put the ball somewhere with a velocity and no spin, field frame; between two ticks."""
        if self.ball:
            self.ball.position, self.ball.velocity = (x, y), (vx, vy)
            self.ball.angle = self.ball.angular_velocity = 0.0
            self.space.reindex_shapes_for_body(self.ball)
            truth.body[self.ball_row] = x, y, 0.0, vx, vy, 0.0
            truth.ball_roll[:] = 0.0

    def place_robot(self, truth: Truth, row: int, x: float, y: float, heading: float) -> None:
        """Put a robot somewhere at rest, its wheels too, field frame; between two ticks."""
        body = self.robots[row]
        body.position, body.angle, body.velocity, body.angular_velocity = (x, y), heading, (0, 0), 0
        self.space.reindex_shapes_for_body(body)
        truth.body[row] = x, y, heading, 0.0, 0.0, 0.0
        truth.acceleration[row] = truth.wheel_speed[row] = 0.0

    def _add_disc(
        self, body: pymunk.Body, radius: float, elasticity: float, friction: float
    ) -> None:
        shape = pymunk.Circle(body, radius)
        shape.elasticity, shape.friction = elasticity, friction
        self.space.add(body, shape)

    def _add_walls(self, scenario: Scenario) -> None:
        """The board round the field, and on each side a goal of two posts and a net.

        Both ends must be alike to the solver too, which takes a body's contacts in the order of
        Chipmunk's tree of walls. So each wall is followed by itself turned by half a turn, and
        none is added that lies midway between two others: where the tree would have to choose,
        rounding would choose differently at the two ends. Hence the boards that stop before a
        corner, where the next one goes on, and the back of the net before its sides.
        """
        field, goal = scenario.field, scenario.field.goal
        x, y = field.half_length + field.border + BOARD, field.half_width + field.border + BOARD
        self._add_pair((x, -y), (x, y), BOARD, field.board_elasticity)
        self._add_pair((x - BOARD, y), (-x, y), BOARD, field.board_elasticity)
        x, y = field.half_length, goal.width / 2 + goal.post_radius
        back = x + goal.depth
        self._add_pair((back, -y), (back, y), NET_RADIUS, goal.net_elasticity)
        for end in (-y, y):
            self._add_pair((x, end), (x, end), goal.post_radius, goal.post_elasticity)
            self._add_pair((x, end), (back, end), NET_RADIUS, goal.net_elasticity)

    def _add_pair(
        self, a: tuple[float, float], b: tuple[float, float], radius: float, elasticity: float
    ) -> None:
        """A wall, and the same turned by half a turn."""
        self._add_wall(a, b, radius, elasticity)
        self._add_wall((-a[0], -a[1]), (-b[0], -b[1]), radius, elasticity)

    def _add_wall(
        self, a: tuple[float, float], b: tuple[float, float], radius: float, elasticity: float
    ) -> None:
        body = self.space.static_body
        shape = pymunk.Circle(body, radius, a) if a == b else pymunk.Segment(body, a, b, radius)
        shape.elasticity, shape.friction = elasticity, sqrt(SHELL_FRICTION)  # they multiply
        self.space.add(shape)

    def _connect(self, bodies: int) -> Chipmunk:
        """Buffers for the batch functions, and the addresses of what kernels call."""
        pointer = ctypes.c_void_p
        read, read_count, read_data = self._buffer(6 * (bodies + 1), POSE)
        write, write_count, write_data = self._buffer(3 * (bodies + 1), WRENCH)
        return Chipmunk(
            step=ctypes.CFUNCTYPE(None, pointer, ctypes.c_double)(_address("cpSpaceStep")),
            each_body=ctypes.CFUNCTYPE(None, pointer, pointer, pointer)(
                _address("cpSpaceEachBody")
            ),
            space=int(ffi.cast("uintptr_t", self.space._space)),
            getter=_address("pmSpaceBodyGetIteratorFuncBatched"),
            setter=_address("pmSpaceBodySetIteratorFuncBatched"),
            read_data=read_data,
            write_data=write_data,
            read_count=read_count,
            write_count=write_count,
            read=read,
            write=write,
        )

    def _buffer(self, numbers: int, fields: int) -> tuple[Array, Any, int]:
        """An array that pymunk's batch functions read or write, its counter, its address."""
        array = np.zeros(numbers + SLACK)
        floats = ffi.new("pmFloatArray *")
        floats.arr, floats.max, floats.num = ffi.from_buffer("cpFloat[]", array), len(array), 0
        data = ffi.new("pmBatchedData *")
        ints = ffi.new("pmIntArray *")
        data.fields, data.floatArray, data.intArray = fields, floats, ints
        self._keep += [array, floats, ints, data]
        count = np.frombuffer(ffi.buffer(ffi.addressof(floats, "num"), 4), np.int32)
        return array, count, int(ffi.cast("uintptr_t", data))


def _address(name: str) -> int:
    """Where a function of Chipmunk lies in this process."""
    return int(ffi.cast("uintptr_t", ffi.addressof(lib, name)))


def _free(space: pymunk.Space) -> None:
    """Let go of the C space while Python is whole: at exit, pymunk's own way comes too late."""
    vars(space).pop("_space", None)
