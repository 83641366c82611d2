"""Who sits where: the seats of a match, in its own process or in the teams'."""

from pathlib import Path
from typing import Literal

from soccersim.match.faults import Forfeit
from soccersim.match.pitch import pitch_of, team_rows
from soccersim.match.seats import LocalSeat, LostSeat, Seat
from soccersim.match.turn import AWAY, HOME, Turn
from soccersim.sheet import sheet_size
from soccersim.spec.scenario import Scenario
from soccersim.strategy.load import Origin

Isolate = Literal["match", "team"]
Origins = tuple[Origin, Origin]


def take_seats(
    scenario: Scenario, origins: Origins, isolate: Isolate, turn: Turn, folder: Path
) -> list[Seat]:
    """HOME's and AWAY's seat, their teams ready; InputError where a strategy is not there.

    folder: for the traces of the teams' processes.
    """
    if isolate == "team":
        return _processes(scenario, origins, turn, folder)
    seats: list[Seat] = []
    for slot in (HOME, AWAY):
        pitch, options = pitch_of(scenario, slot), options_of(scenario, slot)
        try:
            seats.append(LocalSeat(slot, origins[slot], options, pitch, scenario.seed, turn))
        except Forfeit as forfeit:
            seats.append(LostSeat(forfeit))
    return seats


def _processes(scenario: Scenario, origins: Origins, turn: Turn, folder: Path) -> list[Seat]:
    """Both start before one is waited for."""
    from soccersim.match.process_seat import ProcessSeat

    robots = [len(team_rows(scenario, slot)) for slot in (HOME, AWAY)]
    started: list[ProcessSeat] = []
    seats: list[Seat] = []
    try:
        for slot in (HOME, AWAY):
            pitch, options = pitch_of(scenario, slot), options_of(scenario, slot)
            sheet = sheet_size(robots[slot], robots[1 - slot])
            trace = folder / f"trace-{slot}"
            seat = ProcessSeat(
                slot, origins[slot], options, pitch, scenario.seed, turn, sheet, trace
            )
            started.append(seat)
        for seat in started:
            try:
                seat.ready()
                seats.append(seat)
            except Forfeit as forfeit:
                seat.close()
                seats.append(LostSeat(forfeit))
    except BaseException:
        for seat in started:
            seat.close()
        raise
    return seats


def options_of(scenario: Scenario, slot: int) -> dict[str, object]:
    """What a slot's strategy is made with."""
    match = scenario.match
    if match is None:
        raise ValueError(f"{scenario.name} is no match")
    return dict((match.home, match.away)[slot].options)
