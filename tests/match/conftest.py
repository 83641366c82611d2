"""Teams that do wrong, and seats to put them on."""

import textwrap

import pytest

from soccersim import load_scenario
from soccersim.match.pitch import pitch_of
from soccersim.match.process_seat import ProcessSeat
from soccersim.match.seats import LocalSeat
from soccersim.match.turn import Turn
from soccersim.sheet import sheet_size
from soccersim.strategy.load import locate

TEAM = """\
import ctypes, itertools, math, os, re, signal, subprocess, sys, threading, time

import soccersim.strategy.api
from soccersim.strategy import Circle, Command, Strategy, Text

class Team(Strategy):
    asked = 0

    def decide(self, view):
        self.asked += 1
        fine = [Command(0.1 * robot.number, label="to the ball") for robot in view.robots]
        return self.tricked(view, fine) if self.asked == 3 else fine

    def tricked(self, view, fine):
"""
THIRD = 2  # decisions are answered well before the team is tricked


@pytest.fixture(scope="session")
def friendly():
    """Two seconds of a friendly match."""
    return load_scenario("friendly-match", settings=["duration=2"])


@pytest.fixture
def team(tmp_path):
    """Writes the file of a team that does this at its third decision, or of this whole code."""

    def write(trick, name="mine.py", whole=False):
        code = textwrap.dedent(trick)
        path = tmp_path / name
        path.write_text(code if whole else TEAM + textwrap.indent(code, " " * 8), encoding="utf-8")
        return str(path)

    return write


@pytest.fixture
def local(friendly):
    """A seat in this process."""

    def sit(path, slot=0, **options):
        pitch, seed = pitch_of(friendly, slot), friendly.seed
        return LocalSeat(slot, locate(path), options, pitch, seed, Turn())

    return sit


@pytest.fixture
def apart(friendly, tmp_path):
    """A seat in a process of its own; all are closed at the end."""
    seats = []

    def sit(path, slot=0, **options):
        trace = tmp_path / f"trace-{len(seats)}"
        pitch, seed = pitch_of(friendly, slot), friendly.seed
        args = (slot, locate(path), options, pitch, seed, Turn(), sheet_size(5, 5), trace)
        seats.append(ProcessSeat(*args))
        seats[-1].ready()
        return seats[-1]

    yield sit
    for seat in seats:
        seat.close()
