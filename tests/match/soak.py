"""Many short matches between the teams that come with the program, and what must hold in each."""

from itertools import pairwise, product

import numpy as np
from play import game

TEAMS = ("still", "chaser", "positioning", "roles")
PAIRINGS = list(product(TEAMS, TEAMS))
SCENARIOS = ("msl-match", "krsbi-match", "friendly-match")
LONGEST = 12.0  # s that any phase but play may last: to set up, and to take a restart


def soak(number: int, seconds: float) -> str:
    """Play match `number`; what is wrong with it, or nothing."""
    home, away = PAIRINGS[number % len(PAIRINGS)]
    scenario = SCENARIOS[number // len(PAIRINGS) % len(SCENARIOS)]
    match, seats = game(home, away, f"duration={seconds}", scenario=scenario, seed=1000 + number)
    result = match.play(seats)
    wrong = [*faults(result), *bodies(match, result.recording), *phases(result.recording)]
    return f"{scenario} {home} {away} seed {1000 + number}: {'; '.join(wrong)}" if wrong else ""


def faults(result):
    """No team that comes with the program may forfeit."""
    return [f"{fault.side}: {fault.kind}" for fault in result.faults]


def bodies(match, recording):
    """Every number is one, and everybody is inside the boards."""
    field, body = match.scenario.field, recording.body
    if not (np.isfinite(body).all() and np.isfinite(recording.estimate).all()):
        yield "a number that is none"
    for axis, half in ((0, field.half_length), (1, field.half_width)):
        beyond = np.abs(body[:, :, axis]).max() - (half + field.border)
        if beyond > 0.0:
            yield f"a centre {beyond:.2f} m beyond the board"


def phases(recording):
    """No phase lasts longer than it can, but play."""
    arrays = recording.arrays
    state = np.stack([arrays["phase"], arrays["started"], arrays["whose"]], axis=1)
    changes = np.flatnonzero((np.diff(state, axis=0) != 0).any(axis=1)) + 1
    edges = [0, *changes, len(state)]
    play, over = 8, 9  # places in sheet.PHASES
    for first, last in pairwise(edges):
        if state[first, 0] not in (play, over) and (last - first) / 25.0 > LONGEST:
            yield f"phase {state[first, 0]} for {(last - first) / 25.0:.1f} s"
