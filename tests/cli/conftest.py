"""The program as a user meets it: exit code, standard output, standard error."""

import os
import subprocess
import sys

import pytest
from ended import Ended

from soccersim import Simulation, load_scenario


@pytest.fixture(scope="session")
def compiled():
    """Lets the first run on a machine compile, which it says on standard error."""
    Simulation(load_scenario("linear", settings=["duration=0.01"])).run()


@pytest.fixture
def process(tmp_path, compiled):
    """Run a command line in a process of its own, in an empty folder."""

    def run(*words, env=(), **more):
        words = [sys.executable, "-m", "soccersim", *map(str, words)]
        where = {"cwd": tmp_path, "env": {**os.environ, **dict(env)}}
        ended = subprocess.run(words, capture_output=True, text=True, **{**where, **more})
        return Ended(ended.returncode, ended.stdout, ended.stderr)

    return run


SCENARIO = """\
version: 1
name: two
field: krsbi-2017
duration: 0.1
ball: {at: [2, 2]}
robots:
  - name: one
    model: garcia
    start: [0, 0, 0]
    path: [{to: [1, 0, 0]}]
  - name: two
    model: four-wheel
    start: [-2, 0, 0]
    open_loop: [{seconds: 1, pwm: [10, 10, 10, 10]}]
"""


@pytest.fixture
def scenario(tmp_path, monkeypatch, compiled):
    """Writes two.yaml, with texts replaced, into the working folder; gives its text."""
    monkeypatch.chdir(tmp_path)

    def write(*changes, add="", name="two.yaml"):
        text = SCENARIO
        for old, new in changes:
            if old not in text:
                raise ValueError(f"{old} does not stand in the scenario")
            text = text.replace(old, new)
        (tmp_path / name).write_text(text + add, encoding="utf-8")
        return text + add

    return write
