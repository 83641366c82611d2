"""Orders that reach a robot by radio: late or never, and obeyed within its own limits.

A packet holds a twist in the body frame, a kick and whether to dribble. A robot goes on with the
last one it heard, and stops when it has heard none for a while.
"""

from collections.abc import Sequence
from math import inf
from typing import NamedTuple

import numpy as np

from soccersim.control.position import limited
from soccersim.geometry import rotate
from soccersim.kernel import inner
from soccersim.spec.robot import Robot
from soccersim.spec.senses import Radio
from soccersim.state import Array, Command, Estimate, Whole
from soccersim.streams import stream

BLOCK = 512  # packets whose chance is drawn at once
NEVER = -1  # a tick at which nothing happened
VALUES = 5  # of a packet: vx, vy (m/s), omega (rad/s), kick (m/s), dribble (0 or 1)
PERFECT = Radio(delay=0.0, order_loss=0.0, report_loss=0.0)


class Orders(NamedTuple):
    """Packets under way, and what the robots made of the last ones."""

    every: Whole  # (R,) ticks from step to step of a robot's control
    limits: Array  # (R, 4) speed, acceleration, turn rate, turn acceleration; inf: none
    arrival: Whole  # (R, K) tick at which a packet is there; -1: no packet
    packet: Array  # (R, K, 5) vx, vy, omega in the body frame, kick, dribble
    chance: Array  # (R, BLOCK) uniform in [0, 1): below `loss` a packet is lost
    sent: Whole  # (1,) packets to each robot so far
    heard: Whole  # (R,) tick of the last packet that arrived; -1: none yet
    wanted: Array  # (R, 3) its twist; body frame
    velocity: Array  # (R, 3) vx, vy, omega asked for at the last step; field frame
    halted: Whole  # (R,) 1: the motors stop the robot, whatever is ordered
    delay: int  # ticks a packet is under way
    silence: int  # ticks without a packet after which a robot stops
    loss: float  # chance that a packet is lost
    seed: int


def build_orders(
    robots: Sequence[Robot], radio: Radio, decide_every: int, physics_hz: int, seed: int
) -> Orders:
    """Nothing sent, every robot at rest; decide_every is the ticks from packet to packet."""
    count = len(robots)
    delay = round(radio.delay * physics_hz)
    slots = delay // decide_every + 2
    every = [physics_hz // robot.control.rate_hz for robot in robots]
    most = [robot.control.limits for robot in robots]
    limits = [
        (m.speed, m.acceleration or inf, m.turn_rate, m.turn_acceleration or inf) for m in most
    ]
    return Orders(
        every=np.array(every, np.int64),
        limits=np.array(limits, float).reshape(count, 4),
        arrival=np.full((count, slots), NEVER),
        packet=np.zeros((count, slots, VALUES)),
        chance=np.zeros((count, BLOCK)),
        sent=np.zeros(1, np.int64),
        heard=np.full(count, NEVER),
        wanted=np.zeros((count, 3)),
        velocity=np.zeros((count, 3)),
        halted=np.zeros(count, np.int64),
        delay=delay,
        silence=round(radio.silence * physics_hz),
        loss=radio.order_loss,
        seed=seed,
    )


def post(orders: Orders, values: Array, tick: int) -> None:
    """Send a packet to every robot; values (R, 5) as in Orders.packet.

    Whether it arrives is a matter of the robot's own stream, one draw a packet.
    """
    number, arrival = int(orders.sent[0]), tick + orders.delay
    orders.sent[0] = number + 1
    slot, draw = number % orders.arrival.shape[1], number % BLOCK
    orders.packet[:, slot] = values
    orders.arrival[:, slot] = arrival
    if orders.loss > 0.0:
        if draw == 0:
            name = f"radio.order.{number // BLOCK}"
            for robot in range(len(orders.chance)):
                orders.chance[robot] = stream(orders.seed, robot, name).random(BLOCK)
        orders.arrival[orders.chance[:, draw] < orders.loss, slot] = NEVER


def forget(orders: Orders, robot: int) -> None:
    """A robot was put somewhere by hand: it stands, and waits for its next packet."""
    orders.arrival[robot] = orders.heard[robot] = NEVER
    orders.wanted[robot] = orders.velocity[robot] = 0.0


@inner
def obey(orders: Orders, estimate: Estimate, command: Command, tick: int, dt: float) -> None:
    """Set twist, kick and dribble of the robots that are due.

    A kick is passed on once a packet, so that one that has been made is not made again.
    """
    for robot in range(orders.every.shape[0]):
        if tick % orders.every[robot] != 0:
            continue
        _hear(orders, command, robot, tick)
        heard = orders.heard[robot]
        silent = heard == NEVER or tick - heard > orders.silence
        if silent or orders.halted[robot] == 1:
            command.kick[robot] = 0.0
            command.dribble[robot] = 0
            for k in range(3):
                orders.wanted[robot, k] = 0.0
        _steer(orders, estimate, command, robot, orders.every[robot] * dt)


@inner
def _hear(orders: Orders, command: Command, robot: int, tick: int) -> None:
    """Take the packets that have arrived; the newest one counts."""
    newest, slot = NEVER, 0
    for k in range(orders.arrival.shape[1]):
        arrival = orders.arrival[robot, k]
        if arrival == NEVER or arrival > tick:
            continue
        orders.arrival[robot, k] = NEVER
        if arrival > newest:
            newest, slot = arrival, k
    if newest == NEVER:
        return
    orders.heard[robot] = newest
    for k in range(3):
        orders.wanted[robot, k] = orders.packet[robot, slot, k]
    command.kick[robot] = orders.packet[robot, slot, 3]
    command.dribble[robot] = 1 if orders.packet[robot, slot, 4] > 0.0 else 0


@inner
def _steer(orders: Orders, estimate: Estimate, command: Command, robot: int, dt: float) -> None:
    """The wanted twist within the robot's limits, whose accelerations are the field's."""
    # while this command holds the body goes on turning: aim at the middle of the step
    heading = estimate.pose[robot, 2] + 0.5 * estimate.twist[robot, 2] * dt
    wx, wy = orders.wanted[robot, 0], orders.wanted[robot, 1]
    wx, wy = rotate(wx, wy, heading)  # body to field
    vx, vy, omega = limited(
        orders.limits, orders.velocity, robot, wx, wy, orders.wanted[robot, 2], dt
    )
    orders.velocity[robot, 0], orders.velocity[robot, 1], orders.velocity[robot, 2] = vx, vy, omega
    bx, by = rotate(vx, vy, -heading)  # field to body
    command.twist[robot, 0], command.twist[robot, 1], command.twist[robot, 2] = bx, by, omega
