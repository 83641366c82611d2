"""Three robots fight for the ball with kickers and dribblers: the same fight at either end."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from factory import bundled, player
from handling_rig import Bench

PLACES = [  # start, then there and back
    ((-0.6, 0.02, 0), (3, 0.4, 0), (-3, 1, 40)),
    ((0.9, 0.1, 180), (-3, 0, 180), (2, 2, 100)),
    ((0.3, -1.2, 90), (0, 0, 90), (0, 3, -90)),
]


def scrum(end=1, seconds=3.0):
    """Where all bodies are, ten times a second (T, B, 6), at home (1) or turned (-1); the bench."""

    def view(pose):
        x, y, heading = pose
        return end * x, end * y, heading + 90 * (1 - end)

    model = bundled("msl")
    players = [
        player(model, *map(view, path), start=view(start), repeat=True) for start, *path in PLACES
    ]
    ball = {"at": (0.0, 0.03 * end), "velocity": (0.1 * end, 0.2 * end)}
    bench = Bench(*players, ball=ball, lifted=False)
    bench.command.dribble[:] = 1
    bodies = []
    for tenth in range(round(10 * seconds)):
        if tenth % 4 == 3:
            bench.command.kick[tenth % 3] = 4.0
        bench.run(0.1)
        bodies.append(bench.body.copy())
    return np.array(bodies), bench


def test_a_fight_for_the_ball_knows_no_end():
    """Kicks scatter alike too: chance belongs to the robot, not to the end it plays from."""
    (one, bench), (other, turned) = scrum(1), scrum(-1)
    assert bench.handling.kicks.sum() >= 2
    assert (bench.handling.kicks == turned.handling.kicks).all()
    assert np.abs(one[:, :, :2] + other[:, :, :2]).max() < 1e-9


def test_plain_python_fights_as_compiled_does():
    here = Path(__file__).parent
    code = "from test_scrum import *; print(hashlib.sha256(scrum(1, 1.5)[0].tobytes()).hexdigest())"
    ended = subprocess.run(
        [sys.executable, "-c", code],
        env={
            **os.environ,
            "NUMBA_DISABLE_JIT": "1",
            "PYTHONPATH": os.pathsep.join(map(str, (here, here.parent))),
        },
        capture_output=True,
        text=True,
        check=True,
    )
    assert ended.stdout.strip() == hashlib.sha256(scrum(1, 1.5)[0].tobytes()).hexdigest()
