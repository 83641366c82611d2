"""A match's process whose game takes no time: teams are asked, and what they answer is the digest.

Teams of these matches see nothing; the score is drawn from the digest.
"""

import hashlib
import time
from pathlib import Path

import numpy as np

from soccersim.match.child import serve
from soccersim.match.faults import Forfeit, TeamFault, forfeited
from soccersim.match.keep import is_kept
from soccersim.match.seating import take_seats
from soccersim.match.turn import SIDES
from soccersim.sheet import HEADER, PHASE, PHASES, ROBOT, TIME, sheet_size
from soccersim.spec.scenario import Scenario
from soccersim.strategy.load import Origin

EVERY = 20  # ticks a decision


def main(folder):
    serve(Path(folder), play)


def sheet(robots=5, opponents=5):
    """A sheet of play without a ball."""
    numbers = np.zeros(sheet_size(robots, opponents))
    numbers[PHASE] = PHASES.index("play")
    for row in range(robots):
        at = HEADER + ROBOT * row
        numbers[at : at + 5] = 1, row + 1, row == 0, -1 - row, 0.5 * row
    return numbers


def play(request, turn, folder):
    scenario = Scenario.model_validate_json(request["scenario"])
    origins = tuple(Origin(**origin) for origin in request["origins"])
    seats = take_seats(scenario, origins, request["isolate"], turn, folder)
    start, chain = time.perf_counter(), hashlib.sha256(str(scenario.seed).encode())
    ticks = round(scenario.duration * scenario.timing.physics_hz)
    told, faults, score = sheet(), [], None
    for tick in range(0, ticks, EVERY):
        turn.tick, turn.share = tick, tick / ticks
        told[TIME] = tick * scenario.dt
        for seat in seats:
            seat.ask(told)
        try:
            for seat in seats:
                chain.update(repr(seat.answer().orders).encode())
        except Forfeit as forfeit:
            slot = seats.index(seat)
            faults.append(TeamFault(SIDES[slot], forfeit.kind, tick, forfeit.detail))
            score = forfeited((1, 2), slot)
            break
    for seat in seats:
        seat.close()
    drawn = chain.digest()
    score = score or (drawn[0] % 4, drawn[1] % 3)
    if request["recording"] and is_kept(request["keep"], request["watched"], score, faults):
        Path(request["recording"]).write_bytes(b"recording of " + chain.hexdigest().encode())
    duration = tick * scenario.dt
    return {
        "score": list(score),
        "digest": chain.hexdigest(),
        "duration": duration,
        "events": [{"kind": "goal", "tick": drawn[2]}],
        "faults": [fault.document() for fault in faults],
        "realtime_factor": duration / (time.perf_counter() - start),
    }
