"""A match's process whose game is nothing but questions: who tests what teams do needs no physics.

Every decision each team is told the same sheet but for the time.
"""

from pathlib import Path

import numpy as np

from soccersim.match.child import serve
from soccersim.match.faults import Forfeit, TeamFault, forfeited
from soccersim.match.seating import take_seats
from soccersim.match.turn import SIDES
from soccersim.sheet import BALL, BALL_KNOWN, HEADER, PHASE, PHASES, ROBOT, TIME, sheet_size
from soccersim.spec.scenario import Scenario
from soccersim.strategy.load import Origin

EVERY = 20  # ticks a decision


def main(folder):
    serve(Path(folder), play)


def sheet(robots=5, opponents=5):
    """A sheet of play: the ball in the middle, own robots behind it."""
    numbers = np.zeros(sheet_size(robots, opponents))
    numbers[PHASE] = PHASES.index("play")
    numbers[BALL_KNOWN] = 1
    numbers[BALL : BALL + 2] = 0.5, -0.25
    for row in range(robots):
        at = HEADER + ROBOT * row
        numbers[at : at + 5] = 1, row + 1, row == 0, -1 - row, 0.5 * row
    return numbers


def play(request, turn, folder):
    scenario = Scenario.model_validate_json(request["scenario"])
    origins = tuple(Origin(**origin) for origin in request["origins"])
    seats = take_seats(scenario, origins, request["isolate"], turn, folder)
    ticks = round(scenario.duration * scenario.timing.physics_hz)
    told, score, faults = sheet(), (1, 2), []
    turn.score = score
    for tick in range(0, ticks, EVERY):
        turn.tick, turn.share = tick, tick / ticks
        told[TIME] = tick * scenario.dt
        for seat in seats:
            seat.ask(told)
        for slot, seat in enumerate(seats):
            try:
                seat.answer()
            except Forfeit as forfeit:
                faults.append(TeamFault(SIDES[slot], forfeit.kind, tick, forfeit.detail))
                score = forfeited(score, slot)
                break
        if faults:
            break
    for seat in seats:
        seat.close()
    return {
        "score": list(score),
        "digest": "",
        "duration": tick * scenario.dt,
        "events": [],
        "faults": [fault.document() for fault in faults],
        "realtime_factor": 1.0,
    }
