"""`soccersim match`: real matches, in processes of their own, as a user meets them."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

from soccersim import Recording
from soccersim.cli import main

FRIENDLY = ("--scenario", "friendly-match")
KEYS = {
    *("home", "away", "seed", "score", "digest", "duration", "events", "faults"),
    *("realtime_factor", "recording"),
}
OPTIONS = {
    *("--scenario", "--seed", "--duration", "--set", "--out", "--frames", "--video", "--isolate"),
    *("--force", "--json"),
    *("--from", "--to", "--speed", "--size"),  # of --video and --frames
}
TEAM = """\
from soccersim.strategy import Command, Strategy

class Mine(Strategy):
    def __init__(self, rng, speed=1.0, **others):
        super().__init__(rng)
        self.speed = speed
        print("made with", speed)

    def decide(self, view):
        if view.time > 0.5:
            raise ValueError("enough")
        return [Command(self.speed, label="going") for _ in view.robots]
"""


@pytest.fixture
def mine(tmp_path, monkeypatch, compiled):
    """Writes mine.py into the working folder."""
    monkeypatch.chdir(tmp_path)

    def write(*changes, name="mine.py"):
        text = TEAM
        for old, new in changes:
            text = text.replace(old, new)
        (tmp_path / name).write_text(text, encoding="utf-8")
        return f"./{name}"

    return write


def test_match_has_the_contracted_options():
    from soccersim.cli.match import command

    assert {o for p in command.params for o in p.opts} == OPTIONS | {"home", "away"}


def test_a_match_is_one_json_document_and_a_recording(soccersim, mine):
    team = mine(("view.time > 0.5", "False"))
    words = ("match", team, "still", *FRIENDLY, "--duration", 1, "--seed", 7, "--json")
    ended = soccersim(*words)
    told = json.loads(ended.out)
    assert ended.code == 0
    assert set(told) == KEYS
    assert (told["home"], told["away"], told["seed"]) == (team, "still", 7)
    assert (told["score"], told["faults"], told["duration"]) == ([0, 0], [], 1.0)
    assert told["recording"] == "match-7.npz"
    recording = Recording.load("match-7.npz")
    assert recording.digest == told["digest"]
    assert recording.match["events"] == told["events"]
    assert recording.scenario.match.home.strategy == team
    assert "made with 1.0" in ended.lines

    again = soccersim(*words)
    assert (again.code, again.out) == (2, "")
    assert again.lines == [
        "match-7.npz: is there already: add --force, or name a folder with --out"
    ]
    apart = soccersim(*words, "--force", "--isolate", "team")
    assert json.loads(apart.out)["digest"] == told["digest"]
    assert "made with 1.0" in apart.lines


def test_a_forfeit_counts_and_is_told_and_the_exit_code_says_so(soccersim, mine, tmp_path):
    ended = soccersim("match", "still", mine(), *FRIENDLY, "--duration", 2, "--out", "r/s")
    assert ended.code == 4
    assert "still 3 : 0 ./mine.py" in ended.out
    assert "forfeit of away: exception" in ended.out
    assert "./mine.py (away) forfeits at tick 260: exception" in ended.lines
    assert ended.lines[-1] == "  ValueError: enough"
    assert {path.name for path in (tmp_path / "r/s").iterdir()} == {"report.json", "recording.npz"}
    told = json.loads((tmp_path / "r/s/report.json").read_text())
    assert set(told) > KEYS
    (fault,) = told["faults"]
    assert (fault["side"], fault["kind"], fault["tick"]) == ("away", "exception", 260)
    assert told["duration"] == 0.52
    refused = soccersim("match", "still", mine(), *FRIENDLY, "--out", "r/s")
    assert refused.code == 2
    assert "r/s: holds report.json, recording.npz already" in refused.err


def test_options_stay_with_the_strategy_they_are_for(soccersim, mine, scenario, tmp_path):
    from soccersim.match.request import match_request

    team, other = mine(), mine(name="other.py")
    at = "match.home."
    words = {"scenario": "friendly-match", "settings": [f"{at}options.speed=2.5"]}
    asked = match_request(team, other, **words)
    assert asked.scenario.match.home.options == {"speed": 2.5}
    assert asked.scenario.match.away.options == {}
    # a scenario with options of its own: they are for the strategy that it names
    from soccersim import bundled

    text = bundled.find("scenario", "friendly-match").read_text()
    named = f"home: {{strategy: {team}, options: {{speed: 0.5}}}}"
    (tmp_path / "own.yaml").write_text(text.replace("home: {strategy: roles}", named))
    asked = match_request(team, other, "./own.yaml", settings=[f"{at}options.press=true"])
    assert asked.scenario.match.home.options == {"speed": 0.5, "press": True}
    assert match_request(other, other, "./own.yaml").scenario.match.home.options == {}


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (("match", "stil", "still"), "no strategy `stil` is bundled: did you mean `still`?"),
        (("match", "still", "./no.py"), "no.py: there is no such file"),
        (
            ("match", "still", "still", "--scenario", "defender"),
            "defender: is no match: `soccersim run defender` runs it",
        ),
        (
            ("run", "friendly-match"),
            "friendly-match: is a match: "
            "`soccersim match HOME AWAY --scenario friendly-match` plays it",
        ),
        (
            ("match", "still", "still", "--video"),
            "soccersim: --frames and --video need a folder: --out DIR; see soccersim --help",
        ),
    ],
)
def test_what_cannot_be_played_is_one_line(soccersim, tmp_path, monkeypatch, words, line):
    monkeypatch.chdir(tmp_path)
    ended = soccersim(*words)
    assert (ended.code, ended.out) == (main.BAD_INPUT, "")
    (said,) = ended.lines
    assert (
        said.replace("soccersim match:", "soccersim:").replace(
            "soccersim match --help", "soccersim --help"
        )
        == line
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("duration", ["0", "-1", "nan", "1e9"])
def test_a_duration_that_is_none_is_told(soccersim, tmp_path, monkeypatch, duration):
    monkeypatch.chdir(tmp_path)
    ended = soccersim("match", "still", "still", *FRIENDLY, "--duration", duration)
    assert ended.code == main.BAD_INPUT
    assert len(ended.lines) == 1
    assert "duration" in ended.err


def test_a_class_that_is_not_there_is_bad_input(soccersim, mine, tmp_path):
    ended = soccersim("match", "still", mine() + ":Main", *FRIENDLY, "--out", "r")
    assert (ended.code, ended.out) == (main.BAD_INPUT, "")
    assert ended.lines[-1] == "./mine.py:Main: `Main` is not there; there is `Mine`"
    assert not (tmp_path / "r").exists()


@pytest.mark.skipif(os.name != "posix", reason="signals as a terminal sends them")
def test_a_terminals_ctrl_c_ends_a_match_at_once_in_one_line(mine, tmp_path):
    team = mine(("view.time > 0.5", "False"))
    words = ["match", team, team, "--duration", "36000", "--isolate", "team", "--out", "r"]
    settings = ["--set", "timing.record_hz=1", "--set", "timing.frames_hz=1"]
    running = subprocess.Popen(
        [sys.executable, "-m", "soccersim", *words, *settings],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    said = b""
    while b"made with" not in said and running.poll() is None:
        said += os.read(running.stderr.fileno(), 4096)
    time.sleep(0.3)
    start = time.monotonic()
    os.killpg(running.pid, signal.SIGINT)
    out, err = running.communicate(timeout=60)
    lines = [line for line in (said + err).decode().splitlines() if "made with" not in line]
    assert time.monotonic() - start < 10
    assert (running.returncode, out) == (130, b"")
    assert lines[-1].startswith("stopped at ")
    assert lines[-1].endswith("run it again, or less of it with --duration SECONDS")
    assert not (tmp_path / "r").exists()
