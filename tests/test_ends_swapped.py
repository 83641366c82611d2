"""Both ends of the field are alike: turned by half a turn, a scenario plays the turned run.

Bit by bit where no heading comes in. With headings the runs differ in the last bit from the first
tick, because heading + pi is rounded: its sine and cosine are not quite the negative ones. A crowd
amplifies that, by chaos; what must not be is an order of walls or of contacts that favours an end.
"""

import numpy as np
import pytest
from factory import player, robot, scenario

from soccersim.plant.world import step_bodies
from soccersim.simulation import Simulation

LIMITS = {"acceleration": 3.0, "turn_acceleration": 10.0}
MODEL = robot(mass_height=0.15, control={"limits": LIMITS})
SECONDS = 5.0


def turned(numbers):
    """A point or a velocity, or a pose in degrees, as the other end sees it."""
    x, y, *heading = numbers
    return (-x, -y, *(degrees + 180 for degrees in heading))


def twins(players, ball=None, field=None):
    """The simulation and its turned twin; players are (start, target, target...)."""
    pair = []
    for view in (tuple, turned):
        written = [
            player(MODEL, *map(view, path), start=view(start), repeat=bool(path))
            for start, *path in players
        ]
        more = {"field": field} if field else {}
        if ball:
            more["ball"] = {"at": view(ball[:2]), "velocity": view(ball[2:])}
        pair.append(Simulation(scenario(*written, duration=2 * SECONDS, **more)))
    return pair


def play(pair):
    """The bodies of both over time, (T, B, 6)."""
    for simulation in pair:
        simulation.advance(round(SECONDS / simulation.scenario.dt))
    one, other = (simulation.recording().body for simulation in pair)
    assert len(one) == len(other) > 100
    return one, other


def off(one, other):
    """How far the twin, turned back, comes to be from the other, m."""
    return np.abs(one[..., :2] + other[..., :2]).max()


def bumps(body):
    """Whether somebody's velocity jumped, as only a contact makes it."""
    return np.abs(np.diff(body[..., 3:5], axis=0)).max() > 0.4


def same(one, other):
    """Whether the twin, turned back, is the same to the last bit, but for the headings."""
    turn = np.array([-1.0, -1.0, 0.0, -1.0, -1.0, 1.0])  # x, y, heading, vx, vy, omega
    return np.array_equal(one * abs(turn), other * turn)


@pytest.mark.parametrize("seed", range(6))
def test_a_ball_knows_no_end(seed):
    """Off boards and posts and in the nets: bit by bit."""
    rng = np.random.default_rng(seed)
    angle = rng.uniform(0, 2 * np.pi)
    ball = (*rng.uniform(-1, 1, 2) * (14, 9), 12 * np.cos(angle), 12 * np.sin(angle))
    one, other = play(twins([((0, 0.5, 30),)], ball))
    assert bumps(one)
    assert same(one[:, 1], other[:, 1])


FIELDS = {
    "wide": {"length": 30.0, "width": 20.0, "goal": {"width": 2.0}},
    "krsbi": {"length": 12.0, "width": 8.0, "goal": {"width": 2.0, "depth": 0.5}},
    "msl": {"length": 22.0, "width": 14.0, "goal": {"width": 2.4, "depth": 0.6}},
    "odd": {"length": 8.84, "width": 8.03, "border": 0.88, "goal": {"width": 3.26, "depth": 0.47}},
}


def heap(field, spot, rng):
    """Where five robots and a ball stand apart near the corner, or within the goal's reach."""
    x, y = field["length"] / 2, field["width"] / 2
    border, goal = field.get("border", 1.0), field["goal"]["width"] / 2
    middle = {"left corner": (x, y), "right corner": (x, -y), "goal": (x - 0.2, 0.0)}[spot]
    places = [(middle[0] - 1.0, middle[1] * 0.6)]  # of the ball
    while len(places) < 6:
        px, py = np.array(middle) + rng.uniform(-1.5, 1.5, 2)
        free = all(np.hypot(px - qx, py - qy) > 0.55 for qx, qy in places)
        inside = abs(px) < x + border - 0.3 and abs(py) < y + border - 0.3
        if free and inside and (px < x - 0.4 or abs(py) > goal + 0.4):
            places.append((px, py))
    return places


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("spot", ["left corner", "right corner", "goal"])
@pytest.mark.parametrize("name", FIELDS)
def test_bodies_that_are_pushed_together_know_no_end(name, spot, seed):
    """Robots that no wheel holds, heaped into a corner or a goal over the ball: bit by bit."""
    field, rng = FIELDS[name], np.random.default_rng(seed)
    places = heap(field, spot, rng)
    velocities = rng.uniform(-4, 4, (6, 2))
    push = np.array((200.0, {"left corner": 200.0, "right corner": -200.0, "goal": 0.0}[spot]))
    pair = twins(
        [((*place, 40 * i),) for i, place in enumerate(places[1:])], (*places[0], 0, 0), field
    )
    runs = []
    for simulation, sign in zip(pair, (1, -1), strict=True):
        world, truth = simulation.world, simulation.machine.truth
        for body, velocity in zip(world.space.bodies, velocities, strict=True):
            body.velocity = tuple(sign * velocity)
        truth.wrench[:5, :2] = sign * push
        truth.wrench[5, :2] = sign * push / 50
        bodies = []
        for _ in range(400):
            assert step_bodies(world.chipmunk, truth, 0.002)
            bodies.append(truth.body.copy())
        runs.append(np.array(bodies))
    assert np.abs(runs[0][:, :5, 5]).max() > 0.1  # they rubbed against each other
    assert same(*runs)


FREE = [
    ((1, 2, 13), (4, 3, 100), (-3, 5, 0)),
    ((-4, -2, 100), (-7, -5, 20)),
    ((9, 7, -60), (9, -7, -60)),
]


def test_robots_alone_know_no_end():
    """No contact: what the last bit of a heading makes of a path is not worth a nanometre."""
    assert off(*play(twins(FREE))) < 1e-9


CROWDS = {
    "two at one ball": (
        [((-1.5, 0.02, 0), (3, 0.1, 0)), ((1.5, 0.03, 150), (-3, 0, 90))],
        (0, 0.03),
    ),
    "a ball between two": (
        [((-0.5, 0, 0), (0.5, 0, 0)), ((0.5, 0, 180), (-0.5, 0, 180))],
        (0, 0.01),
    ),
    "three in a row": (
        [
            ((-1.5, 0, 0), (1, 0, 0)),
            ((0, 0.01, 180), (0.1, 0, 180)),
            ((1.5, 0, 180), (-1, 0, 180)),
        ],
        (-0.5, 0.02),
    ),
    "a ball at the board": ([((0, 9.8, 0), (0, 12, 0)), ((1, 9.8, 0), (0, 12, 0))], (0.3, 10.5)),
    "in the corner": ([((14.5, 9.5, 0), (17, 12, 0)), ((15, 8.5, 0), (17, 11, 90))], (15.3, 10.2)),
    "through the goal": (
        [((14, 0.3, 0), (17, 0.7, 0)), ((14.2, -0.5, 0), (16, 0, 0))],
        (14.6, 0.2),
    ),
    "at a post": (
        [
            ((14.2, 1.1, 0), (15.4, 1.0, 0)),
            ((14.6, 0.5, 70), (15.3, 1.1, 0)),
            ((15.2, 1.8, -90), (15.1, 0.6, 0)),
            ((15.7, 1.9, -90), (15.2, 0.9, 0)),
        ],
        (14.75, 1.2),
    ),
    "a heap": (
        [((1.5 * np.cos(i), 1.5 * np.sin(i), 17 * i), (0.05 * i, 0.03 * i, 0)) for i in range(6)],
        (0.1, 0.05),
    ),
}


@pytest.mark.parametrize("name", CROWDS)
def test_a_crowd_knows_no_end(name):
    players, ball = CROWDS[name]
    one, other = play(twins(players, (*ball, 0.5, -0.2)))
    assert bumps(one)
    assert off(one, other) < 1e-6
