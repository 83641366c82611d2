"""Bodies that meet: the only module that imports pymunk.

A tick hands the wrenches of all bodies to Chipmunk, lets it step, and reads all bodies back, each
in one call. The three C functions are called by their addresses, so that compiled kernels and
plain Python use the same path and a tick needs no Python at all. Chipmunk's own housekeeping
(bodies added or removed, callbacks) happens in Python between ticks: so no callbacks here.
"""

import ctypes
import weakref
from typing import Any, NamedTuple

import numpy as np
import pymunk
from pymunk._chipmunk_cffi import ffi, lib

from soccersim.kernel import kernel
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Truth

SOLVER_ITERATIONS = 10  # enough for bodies that touch one other; see crowd_iterations
CROWD_ITERATIONS = 200  # a ball squeezed by two robots needs as many; fewer favour one end
CONTACT_SLOP = 2e-4  # m of overlap left alone; pymunk's 0.1 is meant for pixels
OVERLAP_LEFT = 1e-8  # share of an overlap left after a second: pushed out within a few ticks
BOARD = 1.0  # m of the board's half thickness: nothing fast passes through
POSE = lib.POSITION | lib.ANGLE | lib.VELOCITY | lib.ANGULAR_VELOCITY
WRENCH = lib.FORCE | lib.TORQUE
CROWD_GAP = 0.02  # m: bodies nearer than this may touch within the tick
HUGE = 1e9  # N or N m that nothing here can push with: a number gone wrong
ROBOT_FRICTION = 0.3  # of shells against each other and the board (estimate)
NET_RADIUS = 0.02  # m, half the thickness of the net
SLACK = 8  # numbers of room behind the batch arrays: pymunk checks no bounds


class Chipmunk(NamedTuple):
    """Addresses and buffers of one space, as kernels take them."""

    step: Any  # cpSpaceStep(space, dt)
    each_body: Any  # cpSpaceEachBody(space, function, data)
    set_iterations: Any  # cpSpaceSetIterations(space, count)
    space: int
    getter: int
    setter: int
    read_data: int
    write_data: int
    read_count: Any  # (1,) int32: numbers read so far
    write_count: Any  # (1,) int32
    read: Array  # 6 numbers a body: x, y, angle, vx, vy, omega
    write: Array  # 3 numbers a body: fx, fy, torque
    radius: Array  # (B,) of the bodies, m
    edge: Array  # (2,) |x| of the goal lines and |y| of the boards, m


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
    chipmunk.set_iterations(chipmunk.space, iterations(chipmunk, truth))
    chipmunk.step(chipmunk.space, dt)
    chipmunk.read_count[0] = 0
    chipmunk.each_body(chipmunk.space, chipmunk.getter, chipmunk.read_data)
    for body in range(bodies):
        for k in range(6):
            truth.body[body, k] = chipmunk.read[6 * body + k]
    return True


@kernel
def iterations(chipmunk: Chipmunk, truth: Truth) -> int:
    """How often the solver must go over the contacts: more where a body touches two others."""
    bodies = truth.body.shape[0]
    for body in range(bodies):
        x, y = truth.body[body, 0], truth.body[body, 1]
        reach = chipmunk.radius[body] + CROWD_GAP
        touching = 0
        if abs(x) > chipmunk.edge[0] - reach or abs(y) > chipmunk.edge[1] - reach:
            touching = 1
        for other in range(bodies):
            near = reach + chipmunk.radius[other]
            dx, dy = truth.body[other, 0] - x, truth.body[other, 1] - y
            if other != body and dx * dx + dy * dy < near * near:
                touching += 1
        if touching > 1:
            return CROWD_ITERATIONS
    return SOLVER_ITERATIONS


class World:
    """The space of one run: robots and ball as bodies, board, posts and nets as walls.

    `truth.body` is filled with the start; the space outlives its buffers only together with this
    object, so keep it while kernels run.
    """

    def __init__(self, scenario: Scenario, truth: Truth) -> None:
        space = pymunk.Space(threaded=False)
        space.collision_slop = CONTACT_SLOP
        space.collision_bias = OVERLAP_LEFT
        self.space = space
        at = scenario.coordinates
        radii = []
        for row, player in enumerate(scenario.robots):
            model = player.model
            body = pymunk.Body(model.mass, model.yaw_inertia)
            x, y, body.angle = at.field_pose(player.start)
            body.position = x, y
            self._add_disc(body, model.radius, model.elasticity, ROBOT_FRICTION)
            truth.body[row, :3] = x, y, body.angle
            radii.append(model.radius)
        if scenario.ball:
            ball = scenario.ball
            body = pymunk.Body(ball.mass, ball.shell * ball.mass * ball.radius**2)
            body.position = at.field_pose((*ball.at, 0.0))[:2]
            body.velocity = at.field_vector(*ball.velocity)
            # elasticities multiply: 1 leaves the bounce to what the ball meets; smooth, since
            # nothing here slows a ball that turns about the vertical
            self._add_disc(body, ball.radius, elasticity=1.0, friction=0.0)
            truth.body[-1] = *body.position, 0.0, *body.velocity, 0.0
            radii.append(ball.radius)
        self._add_walls(scenario)
        field = scenario.field
        self._keep: list[Any] = []
        edge = np.array([field.half_length, field.half_width + field.border])
        self.chipmunk = self._connect(np.array(radii, float), edge)
        weakref.finalize(self, _free, space)

    def _add_disc(
        self, body: pymunk.Body, radius: float, elasticity: float, friction: float
    ) -> None:
        shape = pymunk.Circle(body, radius)
        shape.elasticity, shape.friction = elasticity, friction
        self.space.add(body, shape)

    def _add_walls(self, scenario: Scenario) -> None:
        """The board round the field, and on each side a goal of two posts and a net."""
        field, goal = scenario.field, scenario.field.goal
        x, y = field.half_length + field.border + BOARD, field.half_width + field.border + BOARD
        corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
        for k in range(4):
            self._add_wall(corners[k], corners[(k + 1) % 4], BOARD, field.board_elasticity)
        half = goal.width / 2 + goal.post_radius
        for side in (-1, 1):
            line, back = side * field.half_length, side * (field.half_length + goal.depth)
            for end in (-half, half):
                self._add_wall((line, end), (line, end), goal.post_radius, goal.post_elasticity)
                self._add_wall((line, end), (back, end), NET_RADIUS, goal.net_elasticity)
            self._add_wall((back, -half), (back, half), NET_RADIUS, goal.net_elasticity)

    def _add_wall(
        self, a: tuple[float, float], b: tuple[float, float], radius: float, elasticity: float
    ) -> None:
        body = self.space.static_body
        shape = pymunk.Circle(body, radius, a) if a == b else pymunk.Segment(body, a, b, radius)
        shape.elasticity, shape.friction = elasticity, ROBOT_FRICTION
        self.space.add(shape)

    def _connect(self, radius: Array, edge: Array) -> Chipmunk:
        """Buffers for the batch functions, and the addresses of what kernels call."""
        pointer, whole = ctypes.c_void_p, ctypes.c_int
        bodies = len(radius)
        read, read_count, read_data = self._buffer(6 * (bodies + 1), POSE)
        write, write_count, write_data = self._buffer(3 * (bodies + 1), WRENCH)
        return Chipmunk(
            step=ctypes.CFUNCTYPE(None, pointer, ctypes.c_double)(_address("cpSpaceStep")),
            each_body=ctypes.CFUNCTYPE(None, pointer, pointer, pointer)(
                _address("cpSpaceEachBody")
            ),
            set_iterations=ctypes.CFUNCTYPE(None, pointer, whole)(_address("cpSpaceSetIterations")),
            space=int(ffi.cast("uintptr_t", self.space._space)),
            getter=_address("pmSpaceBodyGetIteratorFuncBatched"),
            setter=_address("pmSpaceBodySetIteratorFuncBatched"),
            read_data=read_data,
            write_data=write_data,
            read_count=read_count,
            write_count=write_count,
            read=read,
            write=write,
            radius=radius,
            edge=edge,
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
