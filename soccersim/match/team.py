"""A team's own process: it reads sheets and writes answers, until nobody asks any more."""

import os
import time
import traceback
from pathlib import Path
from typing import Any

import numpy as np

from soccersim.match.endings import FULL
from soccersim.match.faults import Forfeit
from soccersim.match.memory import TEAM, limit_memory
from soccersim.match.packets import (
    FAULT,
    HEAD,
    MISTAKE,
    READY,
    Writer,
    document,
    packet,
    pitch_from,
    strict,
)
from soccersim.match.seats import LocalSeat
from soccersim.match.traces import keep_traces
from soccersim.match.turn import Turn
from soccersim.problems import InputError
from soccersim.processes import take_pipes
from soccersim.strategy.load import Origin


def main(trace: str) -> None:
    """What the process does; trace: the file that a crash is told in."""
    code = 1
    try:
        source, sink = take_pipes()
        keep_traces(Path(trace))
        serve(source, sink)
        code = 0
    except MemoryError:  # not in its turn, but its own: nobody else is here
        code = FULL
    except BaseException:  # the team has closed the pipes, say
        traceback.print_exc()
    finally:  # also threads that the team has left behind end here
        os._exit(code)


def serve(source: int, sink: int) -> None:
    """Make the team, then answer what is asked."""
    _, length = HEAD.unpack(receive(source, HEAD.size))
    setup = strict(receive(source, length))
    pitch = pitch_from(setup["pitch"])
    limit_memory(TEAM)
    try:
        seat = make_seat(setup, pitch)
        send(sink, packet(READY))
        writer = Writer(len(pitch.bodies))
        while True:
            seat.ask(np.frombuffer(receive(source, setup["sheet"]), "<f8"))
            send(sink, writer.packet(seat.answer()))
    except Forfeit as forfeit:
        send(sink, document(FAULT, [forfeit.kind, forfeit.detail]))
    except InputError as error:
        send(sink, document(MISTAKE, [str(problem) for problem in error.problems]))


def make_seat(setup: dict[str, Any], pitch: Any) -> LocalSeat:
    """The team, in this process."""
    origin = Origin(**setup["origin"])
    options, slot, seed = setup["options"], setup["slot"], setup["seed"]
    # all threads of this process are the team's
    return LocalSeat(slot, origin, options, pitch, seed, Turn(), time.process_time)


def receive(source: int, size: int) -> bytes:
    """So many bytes; the process ends where there are no more to come."""
    data = os.read(source, size)
    while len(data) < size:
        more = os.read(source, size - len(data))
        if not more:
            os._exit(0)
        data += more
    return data


def send(sink: int, data: bytes) -> None:
    """All of them."""
    while data:
        data = data[os.write(sink, data) :]
