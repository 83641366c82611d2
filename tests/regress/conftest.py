"""Teams, legs and pools of quick matches."""

import textwrap
from concurrent.futures import Future

import make_believe
import pytest

from soccersim import load_scenario
from soccersim.regress.bundle import bundle
from soccersim.regress.database import Database
from soccersim.regress.ground import Ground
from soccersim.regress.leg import pair_of
from soccersim.regress.pool import LocalPool

TEAM = """\
import ctypes, itertools, os, subprocess, sys, time
from pathlib import Path

from soccersim.strategy import Command, Strategy

class Team(Strategy):
    asked = 0

    def decide(self, view):
        self.asked += 1
        fine = [Command(self.rng.random()) for _ in view.robots]
        return self.tricked(view, fine) if self.asked == 3 else fine

    def tricked(self, view, fine):
"""


@pytest.fixture(scope="session")
def friendly():
    """Half a second of a friendly match."""
    return load_scenario("friendly-match", settings=["duration=0.5"])


@pytest.fixture
def team(tmp_path):
    """The bundle of a team that does this at its third decision."""

    def write(trick="return fine", name="mine.py"):
        path = tmp_path / name
        code = textwrap.indent(textwrap.dedent(trick), " " * 8)
        path.write_text(TEAM + code, encoding="utf-8")
        return bundle(str(path))

    return write


@pytest.fixture
def legs(friendly, team):
    """The legs of so many pairs."""

    def make(pairs=3, first=None, second=None, **more):
        teams = first or team(), second or team("return fine[::-1]", "other.py")
        return [
            leg
            for number in range(pairs)
            for leg in pair_of(friendly, teams, number, number + 1, **more)
        ]

    return make


@pytest.fixture
def pool(tmp_path, monkeypatch):
    """A pool of quick matches on this machine."""
    (tmp_path / "tmp").mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "tmp"))

    def make(jobs=2, **more):
        return LocalPool(jobs, Ground(child="quick", **more))

    yield make
    assert list((tmp_path / "tmp").iterdir()) == []


class Told:
    """A pool that plays nothing: what becomes of a leg, a function tells."""

    quiet = True

    def __init__(self, what, width=2):
        self.what, self.width, self.begun = what, width, []

    def submit(self, leg, alone):
        self.begun.append((leg.pair, leg.leg, alone))
        future = Future()
        try:
            future.set_result(self.what(leg, alone))
        except Exception as error:
            future.set_exception(error)
        return future


@pytest.fixture
def told():
    """Makes such a pool."""
    return Told


@pytest.fixture
def verb(soccersim, tmp_path, monkeypatch):
    """Runs a command line in an empty folder; the matches are make-believe ones."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("soccersim.kernel.will_compile", lambda: False)  # it would say so
    monkeypatch.setattr("soccersim.regress.ground.Ground", make_believe.Ground)
    monkeypatch.setattr("soccersim.regress.pool.LocalPool", make_believe.Pool)
    make_believe.Pool.opened, make_believe.Pool.begun = 0, []
    take = Database._take

    def hasty(self, tables):
        take(self, tables)
        self.all("PRAGMA synchronous = OFF")
        self.all("PRAGMA journal_mode = MEMORY")

    monkeypatch.setattr(Database, "_take", hasty)

    return soccersim


@pytest.fixture
def strategies(tmp_path):
    """Writes teams for make-believe matches: old.py, and more with what is said of them."""

    def write(**said):
        for name, words in {"old": "", **said}.items():
            text = f"# {words}\nclass Team:\n    def decide(self, view):\n        return []\n"
            (tmp_path / f"{name}.py").write_text(text, encoding="utf-8")

    return write
