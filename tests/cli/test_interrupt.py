"""Ctrl-C: one line, exit code 130, what is whole is kept, and it says how to go on."""

import json
import os
import signal
import subprocess
import sys
import time
from pydoc import locate

import pytest

from soccersim import Simulation
from soccersim.repeat import run_seed

LONG = ("duration=30000", "timing.record_hz=1", "timing.frames_hz=1")


def interrupt(after):
    """A stand-in that is interrupted at its call number `after`."""
    calls = iter(range(after))

    def wrap(function):
        def called(*arguments, **named):
            if next(calls, None) is None:
                raise KeyboardInterrupt
            return function(*arguments, **named)

        return called

    return wrap


def test_a_run_that_is_stopped_says_where_and_keeps_nothing(
    soccersim, scenario, monkeypatch, tmp_path
):
    scenario(("duration: 0.1", "duration: 9"), ("0, 0]}]\n", "0, 0]}]\n    repeat: true\n"))
    monkeypatch.setattr(Simulation, "advance", interrupt(1)(Simulation.advance))
    ended = soccersim("run", "./two.yaml", "--out", "a/b", "--json")
    assert (ended.code, ended.out) == (130, "")
    assert ended.lines == [
        "stopped at 5.1 s of 9 s; nothing was kept: run it again, "
        "or less of it with --set duration=SECONDS"
    ]
    assert not (tmp_path / "a").exists()


def test_seeds_that_were_through_are_kept_and_it_says_how_to_run_the_rest(
    soccersim, scenario, monkeypatch, tmp_path
):
    scenario()
    monkeypatch.setattr("soccersim.repeat.run_seed", interrupt(2)(run_seed))
    words = ("run", "./two.yaml", "--seed", 5, "--json", "--no-plot")
    ended = soccersim(*words, "--runs", 9, "--out", "r")
    assert ended.code == 130
    assert ended.lines[-1] == "stopped after 3 of 9 seeds; the rest: --seed 8 --runs 6"
    told = json.loads(ended.out)
    assert told == json.loads((tmp_path / "r" / "report.json").read_text())
    assert [run["seed"] for run in told["runs"]] == [5, 6, 7]
    monkeypatch.undo()
    monkeypatch.chdir(tmp_path)
    rest = json.loads(soccersim(*words, "--seed", 8, "--runs", 6).out)
    assert [run["seed"] for run in rest["runs"]] == [8, 9, 10, 11, 12, 13]


@pytest.mark.parametrize(
    ("function", "name"),
    [
        ("soccersim.render.frames._png", "frames"),
        ("soccersim.render.colours.Colours.follow", "video.mp4"),
        ("soccersim.render.plots.trajectory_figure", "trajectory.png"),
    ],
)
def test_no_half_of_a_file_is_left_and_what_was_whole_is_named(
    soccersim, scenario, monkeypatch, tmp_path, function, name
):
    scenario()
    whole = locate(function)
    monkeypatch.setattr(function, interrupt(1 if name != "trajectory.png" else 0)(whole))
    ended = soccersim("run", "./two.yaml", "--out", "r", "--frames", "--video")
    order = ["report.json", "recording.npz", "trajectory.png", "frames", "video.mp4"]
    kept = order[: order.index(name)]
    assert ended.code == 130
    assert ended.lines == [
        f"stopped while writing {name}; kept: {', '.join(f'r/{path}' for path in kept)}; "
        "the same command with --force starts anew"
    ]
    assert {path.name for path in (tmp_path / "r").iterdir()} == set(kept)


def test_a_ctrl_c_that_the_compiler_swallows_still_ends_in_one_line(
    soccersim, scenario, monkeypatch
):
    scenario()

    def compile_interrupted(*_, **__):
        sys.unraisablehook(Lost(KeyboardInterrupt()))
        raise RuntimeError("no compiled object yet for <Library 'follow'>")

    monkeypatch.setattr(Simulation, "advance", compile_interrupted)
    ended = soccersim("run", "./two.yaml")
    assert (ended.code, ended.out) == (130, "")
    assert ended.lines == ["stopped; nothing was kept: run it again"]


def test_a_ctrl_c_that_a_callback_swallows_comes_again(soccersim, scenario, monkeypatch):
    scenario()

    def swallowed(*_, **__):
        sys.unraisablehook(Lost(KeyboardInterrupt()))
        for _ in range(1000):
            time.sleep(0.01)

    monkeypatch.setattr(Simulation, "advance", swallowed)
    begun = time.monotonic()
    ended = soccersim("run", "./two.yaml")
    assert ended.code == 130
    assert len(ended.lines) == 1
    assert time.monotonic() < begun + 5


def test_a_ctrl_c_that_a_library_makes_an_error_of_is_a_ctrl_c(soccersim, scenario, monkeypatch):
    scenario()

    def turned(*_, **__):
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            raise ImportError("numba._devicearray failed to import") from None

    monkeypatch.setattr(Simulation, "advance", turned)
    ended = soccersim("run", "./two.yaml")
    assert (ended.code, ended.lines) == (130, ["stopped; nothing was kept: run it again"])


class Lost:
    """What Python tells its hook about an exception that could not be raised."""

    def __init__(self, error):
        self.exc_type, self.exc_value, self.exc_traceback = type(error), error, None
        self.err_msg, self.object = "Exception ignored on calling ctypes callback function", None


@pytest.mark.skipif(os.name != "posix", reason="signals as a terminal sends them")
@pytest.mark.parametrize(
    "more",
    [
        pytest.param((), id="one"),
        pytest.param(("--runs", "50", "--jobs", "2"), id="workers"),
    ],
)
def test_a_terminals_ctrl_c_ends_all_processes_at_once_in_one_line(compiled, tmp_path, more):
    settings = [word for setting in LONG for word in ("--set", setting)]
    settings = settings if not more else []
    words = [sys.executable, "-m", "soccersim", "run", "kickabout", "--out", "r", "--no-plot"]
    running = subprocess.Popen(
        [*words, *settings, *more],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while not (tmp_path / "r").exists() and running.poll() is None:
        time.sleep(0.01)
    time.sleep(1.5)  # it may be anywhere by now; each is right
    os.killpg(running.pid, signal.SIGINT)
    _, err = running.communicate(timeout=60)
    said = err.splitlines()
    assert running.returncode == 130
    assert said[-1].startswith(("stopped ", "stopped; "))
    assert all(line.startswith("wrote ") for line in said[:-1])
    assert not (tmp_path / "r").exists() or (more and (tmp_path / "r" / "report.json").exists())
    assert within(10, lambda: gone(running.pid))


def gone(group):
    """Whether nobody of a process group is left; the dead may wait a moment for their burial."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return True
    return False


def within(seconds, condition):
    """Whether a condition comes true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True
