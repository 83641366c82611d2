"""A team in a process of its own: what it does there is told here, and hurts nobody else."""

import os
import textwrap
import time

import pytest
from stand_in import sheet
from test_faults import played

from soccersim.match import stopwatch
from soccersim.match.faults import Forfeit

pytestmark = pytest.mark.skipif(os.name != "posix", reason="pipes that can be waited for")

ENDS = {  # what ends or hurts the process: kind, and what its detail says
    "os._exit(0)": ("exit", "its process ended with exit code 0"),
    "os._exit(3)": ("exit", "its process ended with exit code 3"),
    "sys.exit('gone')": ("exit", "SystemExit: gone"),
    "raise KeyboardInterrupt": ("exit", "KeyboardInterrupt"),
    "1 / 0": ("exception", "ZeroDivisionError: division by zero"),
    "return None": ("bad_command", "decide() returned None, not a list of 5 commands"),
    "return [Command(float('nan'))] * 5": ("bad_command", "vx of command 1 of decide() is nan"),
    "os.abort()": ("crash", "its process was killed by SIGABRT"),
    "ctypes.string_at(0)": ("crash", "its process was killed by SIGSEGV"),
    "os.killpg(0, 9)": ("crash", "its process was killed by SIGKILL"),
    "signal.setitimer(signal.ITIMER_REAL, 0.1); time.sleep(9)": (
        "crash",
        "its process was killed by SIGALRM",
    ),
    "os.closerange(0, 99)": ("exit", "its process ended with exit code 1"),
    "input()": ("exception", "EOFError: EOF when reading a line"),
}
NONSENSE = {  # what is written into the pipe instead of an answer
    "b'hello, world' * 99": "a packet of",
    "bytes(5)": "a packet of kind 0 with 0 bytes",
    "b'\\x02\\x00\\x00\\x00\\x00'": "a packet of kind 2 with 0 bytes",
    "b'\\x04\\x02\\x00\\x00\\x00{}'": "a list of another length",
    "b'\\x05\\x02\\x00\\x00\\x00[]'": "a packet of kind 5",
}
HARMLESS = [
    "print('x' * 3_000_000, file=sys.stderr)",
    "threading.Thread(target=time.sleep, args=(99,)).start()",
    "subprocess.Popen(['sleep', '99'])",
    "os.fork()",
    "sys.stdin = sys.stdout = sys.stderr = None",
    "signal.signal(signal.SIGTERM, signal.SIG_IGN)",
    "math.sin = time.monotonic = time.thread_time = None",
    "soccersim.strategy.api.view_of = soccersim.strategy.api.Strategy = None",
    "import json, struct, numpy\njson.dumps = struct.Struct = numpy.array = None",
]
SAME = "[0.1, 0.2, 0.3, 0.4, 0.5]"


@pytest.mark.parametrize("trick", ENDS)
def test_how_its_process_ends_is_told_with_kind_and_words(team, apart, trick):
    decision, forfeit = played(apart(team(trick)))
    kind, words = ENDS[trick]
    assert (decision, forfeit.kind) == (2, kind)
    assert words in forfeit.detail.splitlines()[-1]
    if kind in ("crash", "exception") and "kill" not in trick and "timer" not in trick:
        assert 'mine.py", line 15' in forfeit.detail


@pytest.mark.parametrize("data", NONSENSE)
def test_nonsense_in_the_pipe_is_a_bad_command(team, apart, data):
    trick = f"""\
    for number in range(3, 99):
        try:
            if os.path.realpath(f"/proc/self/fd/{{number}}").count("pipe"):
                os.write(number, {data})
        except OSError:
            pass
    return fine
    """
    if not os.path.exists("/proc/self/fd"):
        pytest.skip("no /proc")
    _, forfeit = played(apart(team(trick)))
    assert forfeit.kind == "bad_command"
    assert NONSENSE[data] in forfeit.detail


@pytest.mark.parametrize("trick", HARMLESS)
def test_what_a_team_does_to_itself_is_its_own_affair(team, apart, trick, capfd):
    assert played(apart(team(f"{trick}\nreturn fine"))) == (5, None)
    assert capfd.readouterr().out == ""  # what it prints goes to standard error


def test_a_team_that_breaks_what_it_needs_itself_forfeits(team, apart):
    decision, forfeit = played(apart(team("soccersim.strategy.api.Player = None\nreturn fine")))
    assert (decision, forfeit.kind) == (3, "exception")


def test_it_answers_the_same_as_in_this_process(team, local, apart):
    code = """\
    return [Command(*self.rng.normal(size=3), 2.5, True, f"n {robot.number}",
            [Circle(robot.x, robot.y, 0.1), Text(0.0, view.time, "here")])
            for robot in view.robots]
    """
    path, told = team(f"self.asked = 2  # again\n{textwrap.dedent(code)}"), sheet()
    here, there = local(path, 1), apart(path, 1)
    for decision in range(6):
        told[0] = 0.04 * decision
        here.ask(told)
        there.ask(told)
        assert there.answer() == here.answer()


def test_teams_with_modules_of_the_same_name_and_imports_inside_decide(tmp_path, apart):
    answers = []
    for number in (1, 2):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "utils.py").write_text(f"SPEED = {number}.5")
        (folder / "strategy.py").write_text(
            "from soccersim.strategy import *\nclass S(Strategy):\n"
            "    def decide(self, view):\n        from utils import SPEED\n"
            "        return [Command(SPEED)] * len(view.robots)\n"
        )
        seat = apart(str(folder / "strategy.py"), number - 1)
        seat.ask(sheet())
        answers.append(seat.answer().orders[0][0])
    assert answers == [1.5, 2.5]


LOOPS = {
    "while True: pass": "mine.py",
    "sum(itertools.repeat(0))": "mine.py",  # in C, and it never gives way
    "re.match('(a+)+b', 'a' * 40)": "mine.py",
}


@pytest.mark.parametrize("trick", LOOPS)
def test_a_loop_without_end_is_ended_and_told_where_it_is(team, apart, trick, monkeypatch):
    monkeypatch.setattr(stopwatch, "DECISION", 0.2)
    start = time.monotonic()
    decision, forfeit = played(apart(team(trick)))
    assert (decision, forfeit.kind) == (2, "deadline")
    assert LOOPS[trick] in forfeit.detail
    assert "of processor time: at most 0.2" in forfeit.detail
    assert time.monotonic() - start < stopwatch.WALL


def test_a_team_that_sleeps_is_waited_for_only_so_long(team, apart, monkeypatch):
    monkeypatch.setattr(stopwatch, "WALL", 0.5)
    decision, forfeit = played(apart(team("time.sleep(99)")))
    assert (decision, forfeit.kind) == (2, "deadline")
    assert "no end after" in forfeit.detail
    assert "in tricked" in forfeit.detail


def test_a_loop_at_import_is_ended(team, apart, monkeypatch):
    monkeypatch.setattr(stopwatch, "LOADING", 3.0)  # also the interpreter starts in it
    with pytest.raises(Forfeit) as caught:
        apart(team("while True: pass", whole=True))
    assert caught.value.kind == "deadline"
    assert 'mine.py", line 1' in caught.value.detail


def test_bytes_that_drip_do_not_keep_the_clock_from_being_looked_at(team, apart, monkeypatch):
    monkeypatch.setattr(stopwatch, "WALL", 0.5)
    trick = """\
    pipes = [n for n in range(3, 99) if "pipe" in os.path.realpath(f"/proc/self/fd/{n}")]
    os.write(max(pipes), b"\\x02\\xff")
    while True:
        time.sleep(0.01)
        os.write(max(pipes), b"\\x00")
    """
    _, forfeit = played(apart(team(trick)))
    assert forfeit.kind in ("deadline", "bad_command")


def test_answers_to_what_was_never_asked_hold_nobody_up(team, apart):
    trick = """\
    pipes = [n for n in range(3, 99) if "pipe" in os.path.realpath(f"/proc/self/fd/{n}")]
    for _ in range(200):
        os.write(max(pipes), b"\\x02" + (200).to_bytes(4, "little") + bytes(200))
    time.sleep(99)
    """
    decision, forfeit = played(apart(team(trick)), 200)
    assert 2 < decision < 199
    assert forfeit.detail.endswith("answers to what it was not asked")


@pytest.mark.parametrize(
    "trick",
    [
        "self.hoard = bytearray(2**30)",
        "self.hoard = [bytearray(2**26) for _ in range(99)]",
        "import mmap\nself.hoard = mmap.mmap(-1, 2**33)",
    ],
)
def test_a_team_gets_its_share_of_the_memory_and_no_more(team, apart, trick, monkeypatch):
    monkeypatch.setattr(stopwatch, "DECISION", 9.0)  # filling it may take a busy machine a second
    if not os.path.exists("/proc/self/statm"):
        pytest.skip("no limits that hold")
    decision, forfeit = played(apart(team(trick)))
    assert decision == 2
    assert forfeit.kind in ("memory", "exception")
    assert "MemoryError" in forfeit.detail or "Cannot allocate memory" in forfeit.detail


def test_four_hundred_mebibytes_are_a_teams_good_right(team, apart):
    trick = "self.hoard = [bytearray(2**20) for _ in range(400)]\nreturn fine"
    assert played(apart(team(trick))) == (5, None)


def test_nothing_a_team_has_started_outlives_its_seat(team, apart, tmp_path):
    trick = f"""\
    child = subprocess.Popen(["sleep", "99"])
    open(r"{tmp_path}/pid", "w").write(str(child.pid))
    return fine
    """
    seat = apart(team(trick))
    assert played(seat) == (5, None)
    seat.close()
    pid = int((tmp_path / "pid").read_text())
    end = time.monotonic() + 5
    while alive(pid) and time.monotonic() < end:
        time.sleep(0.01)
    assert not alive(pid)


def alive(pid):
    """Whether a process still does anything; the dead may wait for their burial."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False
