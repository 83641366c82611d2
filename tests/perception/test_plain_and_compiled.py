"""Compiled or plain, teams are told the same to the last bit."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

from watched import Watched, realistic

SECONDS = 4
PLAIN = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
CHILD = "from perception.test_plain_and_compiled import digest; print(digest())"


def digest():
    """Of all that both teams are told of a lively game, kicks and collisions of tracks included."""
    us, them = ((-2, 1, 30), (-6, -2, 90), (1, -3, 0)), ((3, 1, 170), (5, -3, -60), (0, 4, 0))
    game, told = Watched(*us, away=them, ball=(0, 2), senses=realistic()), hashlib.sha256()
    for i in range(6):
        game.truth.body[i, 3:] = (0.7 - 0.3 * i, 0.1 * i, 0.4 * (i - 2))
    for k in range(25 * SECONDS):
        if k % 20 == 10:
            game.ball[3:5] = (6.0 - k / 10, -5.0 + k / 10)
        game.go()
        for slot in (0, 1):
            told.update(game.sheet(slot).numbers.tobytes())
    return told.hexdigest()


def test_compiled_and_plain_perception_agree_in_every_bit():
    tests = Path(__file__).parents[1]
    ended = subprocess.run(
        [sys.executable, "-c", CHILD],
        cwd=tests,
        env=PLAIN,
        capture_output=True,
        text=True,
        check=True,
    )
    assert ended.stdout.strip() == digest()
