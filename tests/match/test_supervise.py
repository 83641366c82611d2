"""A match in a process of its own: whatever happens in it, the one who asked learns it and goes on.

The game of these processes is tests/match/stand_in.py, which asks teams and plays nothing.
"""

import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest
from test_team_process import alive

from soccersim.match import stopwatch, supervise
from soccersim.match.prints import CUT, MOST
from soccersim.match.supervise import Request, play
from soccersim.problems import InputError, MachineError, RunError
from soccersim.strategy.load import locate

HERE = str(Path(__file__).parent)
LOST = {0: (0, 3), 1: (3, 0)}  # the stand-in's score is 1:2 before
BOTH = pytest.mark.parametrize("isolate", ["match", "team"])
posix = pytest.mark.skipif(os.name != "posix", reason="as POSIX systems have it")


@pytest.fixture
def match(friendly, team, tmp_path, monkeypatch):
    """Play a match with tricks of home and away, with the stand-in or another process."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)

    def run(home="return fine", away="return fine", isolate="match", child="stand_in", **more):
        origins = locate(team(home, "home.py")), locate(team(away, "away.py"))
        return play(Request(friendly, origins, isolate), child=child, **more)

    yield run
    assert list(tmp_path.glob("soccersim-*")) == []
    with pytest.raises(ChildProcessError):  # nobody is left to be waited for
        os.waitpid(-1, os.WNOHANG)


def fault(outcome):
    """Side, kind and tick of the one fault."""
    (only,) = outcome.faults
    return only["side"], only["kind"], only["tick"]


@BOTH
def test_a_match_without_faults_is_told_while_it_is_played(match, isolate):
    states = []
    outcome = match(isolate=isolate, progress=states.append)
    assert (outcome.score, outcome.faults, outcome.again) == ((1, 2), [], "")
    assert outcome.duration == pytest.approx(1.96)
    shares = [state.share for state in states]
    assert shares == sorted(shares)
    assert states[-1].score in ((0, 0), (1, 2))


WRONGS = {
    "raise ValueError('mine')": ("exception", "ValueError: mine"),
    "return None": ("bad_command", "decide() returned None"),
    "sys.exit(3)": ("exit", "SystemExit: 3"),
    "os._exit(3)": ("exit", "its process ended with exit code 3"),
    "ctypes.string_at(0)": ("crash", "its process was killed by SIGSEGV"),
}
# some in every run, all with -m slow
CASES = [
    (trick, isolate, slot) for trick in WRONGS for isolate in ("match", "team") for slot in (0, 1)
]
FEW = [0, 5, 11, 12, 17, 18]


@pytest.mark.parametrize(
    ("trick", "isolate", "slot"),
    [
        pytest.param(*case, marks=() if at in FEW else pytest.mark.slow)
        for at, case in enumerate(CASES)
    ],
)
def test_the_side_at_fault_is_blamed(match, trick, isolate, slot):
    kind, words = WRONGS[trick]
    outcome = match(*([trick], ["return fine", trick])[slot], isolate=isolate)
    assert fault(outcome) == (("home", "away")[slot], kind, 40)
    assert outcome.score == LOST[slot]
    detail = outcome.faults[0]["detail"]
    assert words in detail.splitlines()[-1]
    if kind in ("exception", "crash"):
        assert ("home.py", "away.py")[slot] in detail
    assert bool(outcome.again) == (kind == "crash" or (isolate == "match" and "_exit" in trick))


@pytest.mark.parametrize(
    "trick",
    [pytest.param("while True: pass", marks=pytest.mark.slow), "sum(itertools.repeat(0))"],
)
def test_a_loop_without_end_is_tried_again_before_it_is_blamed(match, monkeypatch, trick):
    monkeypatch.setattr(stopwatch, "DECISION", 0.3)  # of the first try: the second has its second
    outcome = match(away=trick)
    assert fault(outcome) == ("away", "deadline", 40)
    assert "in tricked" in outcome.faults[0]["detail"]
    assert outcome.again.startswith("away: no end after 0.")


def test_who_is_slow_only_once_is_not_blamed(match, monkeypatch, tmp_path):
    monkeypatch.setattr(stopwatch, "DECISION", 0.3)
    trick = f"""\
    import pathlib
    try:
        pathlib.Path(r"{tmp_path}/seen").touch(exist_ok=False)
    except FileExistsError:
        return fine
    while True: pass
    """
    outcome = match(textwrap.dedent(trick))
    assert (outcome.score, outcome.faults) == ((1, 2), [])
    assert outcome.again.startswith("home: no end")


def test_who_ends_the_process_in_the_other_teams_turn_is_found_out(match):
    outcome = match(
        "threading.Timer(0.2, os._exit, [5]).start()\nreturn fine",
        "self.asked -= 1\ntime.sleep(0.1)\nreturn fine",
    )
    side, kind, tick = fault(outcome)
    assert outcome.again == "away: its process ended with exit code 5"  # so it seemed
    assert (side, kind) == ("home", "exit")
    assert tick > 40


@pytest.mark.slow
@posix
@pytest.mark.parametrize("slot", [0, 1])
def test_who_eats_the_memory_is_found_out(match, slot):
    eater = "self.hoard = [bytearray(2**26) for _ in range(999)]"
    outcome = match(*([eater], ["return fine", eater])[slot])
    side, kind, tick = fault(outcome)
    assert (side, tick) == (("home", "away")[slot], 40)
    assert kind in ("memory", "deadline")
    assert outcome.again


@pytest.mark.slow
@posix
def test_what_one_left_does_not_lose_the_other_the_match(match):
    """HOME fills the memory to the brim; AWAY then asks for a little more than there is."""
    outcome = match(
        """\
import resource
self.hoard = []
pages = lambda: int(open("/proc/self/statm").read().split()[5]) * resource.getpagesize()
while resource.getrlimit(resource.RLIMIT_DATA)[0] - pages() > 2**24:
    self.hoard.append(bytearray(2**23))
return fine""",
        "self.hoard = bytearray(2**26)\nreturn fine",
    )
    assert not outcome.faults or outcome.faults[0]["side"] == "home"


@BOTH
def test_megabytes_of_prints_are_cut_and_hold_nobody_up(match, isolate, capfd):
    texts = []
    trick = "for _ in range(99): print('x' * 50_000)\nos.write(2, b'y' * 3_000_000)\nreturn fine"
    outcome = match(trick, isolate=isolate, printed=texts.append)
    text = "".join(texts)
    assert not outcome.faults
    assert text.endswith(CUT)
    assert text.count("x") + text.count("\n") == MOST + CUT.count("\n")
    assert capfd.readouterr() == ("", "")


@BOTH
def test_nobody_is_left_behind(match, isolate, tmp_path):
    trick = f"""\
threading.Thread(target=time.sleep, args=(99,)).start()
for words in (["sleep", "99"], [sys.executable, "-c", "while True: pass"]):
    child = subprocess.Popen(words)
    print(child.pid, file=open(r"{tmp_path}/pids", "a"))
if os.fork() == 0:
    time.sleep(99)
return fine"""
    outcome = match(trick, trick, isolate)
    assert not outcome.faults
    pids = [int(line) for line in (tmp_path / "pids").read_text().split()]
    assert len(pids) == 4
    end = time.monotonic() + 5
    while any(map(alive, pids)) and time.monotonic() < end:
        time.sleep(0.01)
    assert not any(map(alive, pids))


@posix
def test_closed_files_and_patched_modules(match):
    # a patch that hurts the game itself is no team's loss: it is played with teams apart
    trick = """\
math.sqrt = time.time = None
if game := sys.modules.get("stand_in"):
    game.enumerate = None
return fine"""
    outcome = match("os.closerange(0, 99)\nreturn fine")
    assert not outcome.faults
    assert not outcome.again
    outcome = match(trick)
    assert not outcome.faults
    assert outcome.again == "'NoneType' object is not callable"


def test_a_strategy_that_is_not_there_is_bad_input(friendly, tmp_path):
    (tmp_path / "empty.py").write_text("x = 1")
    origin = locate(str(tmp_path / "empty.py"))
    with pytest.raises(InputError, match=r"empty\.py: defines no class with a method decide"):
        play(Request(friendly, (origin, origin)), child="stand_in")


@pytest.mark.parametrize(
    ("how", "error", "words"),
    [
        ("dies", RunError, "its process ended with exit code 7, at tick 0 in nobody's turn"),
        ("raises", RunError, "the match could not be played: our own mistake"),
        ("disk", MachineError, "/x: No space left on device"),
    ],
)
def test_what_no_team_has_done_is_no_teams_loss(match, monkeypatch, how, error, words):
    monkeypatch.setenv("HOW", how)
    with pytest.raises(error, match=words) as caught:
        match(child="failing")
    if how == "raises":
        assert "ZeroDivisionError" in caught.value.__notes__[0]  # which --debug shows


def test_a_game_that_stalls_is_ended(match, monkeypatch):
    monkeypatch.setenv("HOW", "stalls")
    monkeypatch.setattr(stopwatch, "STALL", 0.2)
    with pytest.raises(RunError, match="nothing for 0 s, at tick 0 in nobody's turn"):
        match(child="failing")


@BOTH
def test_an_interrupted_match_leaves_nothing(match, isolate):
    pids = []

    def stop(state):
        if state.tick:
            pids.extend(pid for pid in state.processes if pid)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        match("self.asked = 0\ntime.sleep(0.2)\nreturn fine", isolate=isolate, progress=stop)
    assert len(pids) == (2 if isolate == "team" else 0)
    assert not any(map(alive, pids))


ASKER = """\
import sys
sys.path.insert(0, sys.argv[1])
from soccersim import load_scenario
from soccersim.match.supervise import Request, play
from soccersim.strategy.load import locate
spec = load_scenario("friendly-match", settings=["duration=2"])
team = locate(sys.argv[2])
play(Request(spec, (team, team), sys.argv[3]), lambda s: print(*s.processes, flush=True),
     child="stand_in")
"""


@posix
@BOTH
def test_a_match_ends_with_the_one_who_asked_for_it(team, tmp_path, isolate):
    path = team(f"open(r'{tmp_path}/pid', 'a').write(f'{{os.getpid()}} ')\nwhile True: pass")
    words = [sys.executable, "-c", ASKER, HERE, path, isolate]
    env = {**os.environ, "TMPDIR": str(tmp_path)}
    asker = subprocess.Popen(words, stdout=subprocess.PIPE, env=env)
    end = time.monotonic() + 30
    while not (tmp_path / "pid").exists() and time.monotonic() < end:
        time.sleep(0.01)
    asker.send_signal(signal.SIGKILL)
    asker.communicate()
    pids = [int(pid) for pid in (tmp_path / "pid").read_text().split()]
    assert pids
    while any(map(alive, pids)) and time.monotonic() < end:
        time.sleep(0.01)
    assert not any(map(alive, pids))


def test_where_no_team_can_be_apart_the_second_try_is_like_the_first(match, monkeypatch):
    monkeypatch.setattr(supervise, "APART", "match")  # as on Windows
    outcome = match(away="os._exit(3)")
    assert fault(outcome) == ("away", "exit", 40)
    assert outcome.score == (3, 0)
    assert outcome.digest == ""
    with pytest.raises(InputError, match="--isolate team needs a POSIX system"):
        match(isolate="team")
