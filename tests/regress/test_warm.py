"""Warm processes are like cold ones, but for the time that they take; none of them is left over."""

import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest
from living import descendants, has_ended_soon, lives

from soccersim.match.child import REQUEST, TURN
from soccersim.match.endings import how_ended
from soccersim.match.turn import Turn
from soccersim.problems import MachineError
from soccersim.processes import end, has_ended, start
from soccersim.regress import warm as warms
from soccersim.regress.warm import CAN_FORK, Warm

pytestmark = pytest.mark.skipif(not CAN_FORK, reason="processes that fork")
HERE = str(Path(__file__).parent)


@pytest.fixture
def warm(tmp_path):
    """A server that has nothing to load; whatever it has started has ended when it is closed."""
    folder = tmp_path / "run"
    folder.mkdir()
    server = Warm(folder, "doings", "")
    yield server
    pids = descendants(server._server.pid) if server._server else []
    server.close()
    assert has_ended_soon(*pids)


def run(source, code):
    """A process that does this, to its end: exit code and prints."""
    process = source("doings", [textwrap.dedent(code)])
    while not has_ended(process):
        time.sleep(0.01)
    code = end(process)  # it may have left some who could print more
    with process.stdout:
        return code, process.stdout.read().decode()


def ended(process):
    """Its exit code, when it has been ended."""
    process.stdout.close()
    return end(process)


def cold(module, arguments):
    return start(module, arguments, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


ENDS = [
    "print('hello'); print('there', file=sys.stderr)",
    "os._exit(3)",
    "os.abort()",
    "ctypes.string_at(0)",
    "os.kill(os.getpid(), signal.SIGKILL)",
    "os.killpg(0, signal.SIGTERM)",
    "print(os.getpgid(0) == os.getsid(0) == os.getpid(), os.listdir('/proc/self/fd')[:3])",
    "print(subprocess.run(['true']).returncode, threading.active_count())",
    "print(os.environ['PYTHONHASHSEED'], sys.flags.hash_randomization)",
]


@pytest.mark.parametrize("code", ENDS)
def test_it_ends_and_prints_as_a_cold_one_does(warm, code):
    warm_code, warm_text = run(warm.begin, code)
    cold_code, cold_text = run(cold, code)
    assert how_ended(warm_code) == how_ended(cold_code)
    assert warm_text == cold_text


def test_chance_that_no_one_has_seeded_is_another_in_each(warm):
    code = "print(random.random(), numpy.random.rand())"
    assert len({run(warm.begin, code) for _ in range(3)}) == 3


def test_what_it_leaves_behind_ends_with_it(warm, tmp_path):
    """In its group, out of it, and grandchildren whose parents have ended."""
    code = f"""\
    def note(pid):
        print(pid, file=open(r"{tmp_path}/pids", "a"))
    for session in (False, True):
        note(subprocess.Popen(["sleep", "99"], start_new_session=session).pid)
    for _ in range(2):
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                note(os.getpid())
                time.sleep(99)
            os._exit(0)
    time.sleep(0.5)
    """
    assert run(warm.begin, code)[0] == 0
    pids = [int(line) for line in (tmp_path / "pids").read_text().split()]
    assert len(pids) == 4
    assert not any(map(lives, pids))


def test_one_that_is_not_wanted_any_more_is_ended(warm):
    process = warm.begin("doings", ["os.system('sleep 99')"])
    pids = descendants(warm._server.pid)
    assert process.pid in pids
    assert not has_ended(process)
    assert ended(process) == -signal.SIGKILL
    assert not lives(process.pid)
    assert has_ended_soon(*pids)


def test_closing_its_pipe_ends_it_too(warm):
    process = warm.begin("doings", ["time.sleep(99)"])
    process.stdin.close()
    assert has_ended_soon(process.pid)
    ended(process)


def test_when_its_keeper_is_killed_so_is_it(warm):
    process = warm.begin("doings", ["time.sleep(99)"])
    (keeper,) = set(descendants(warm._server.pid)) - {process.pid}
    os.kill(keeper, signal.SIGKILL)
    assert has_ended_soon(process.pid)
    assert has_ended(process)
    assert ended(process) == -signal.SIGKILL


def test_when_the_server_is_killed_matches_go_on_and_another_server_comes(warm):
    process = warm.begin("doings", ["time.sleep(0.5)\nprint('fine')"])
    os.kill(warm._server.pid, signal.SIGKILL)
    assert run(warm.begin, "print('also')") == (0, "also\n")
    assert process.stdout.read() == b"fine\n"
    assert ended(process) in (0, -signal.SIGKILL)


def test_a_server_that_cannot_begin_is_the_machines_failure(warm, monkeypatch):
    monkeypatch.setattr(warms, "SERVER", "no_such_module")
    with pytest.raises(MachineError, match=r"no process can be started: .*no_such_module"):
        warm.start()


def test_a_match_that_cannot_be_loaded_is_told(tmp_path):
    server = Warm(tmp_path, "doings", '{"version": 99}')
    with pytest.raises(MachineError, match="no process can be started"):
        server.start()


ASKER = """\
import sys, time
sys.path.insert(0, sys.argv[1])
from pathlib import Path
from soccersim.regress.reused import Reused
from soccersim.regress.warm import Warm
folder = Path(sys.argv[2])
source = Warm(folder, "doings", "") if sys.argv[3] == "forked" else Reused()
codes = ["os.system('sleep 99')"] if sys.argv[3] == "forked" else [str(folder)]
processes = [source.begin("doings", codes) for _ in range(3)]
while len(list(folder.glob("begun*"))) < (0 if sys.argv[3] == "forked" else 3):
    time.sleep(0.01)
print("ready", flush=True)
time.sleep(99)
"""


@pytest.mark.parametrize(("how", "processes"), [("forked", 7), ("reused", 6)])
def test_all_end_with_the_one_who_asked(tmp_path, how, processes):
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / TURN).write_bytes(bytes(Turn().buffer))
    (tmp_path / "run" / REQUEST).write_text("{}")
    words = [sys.executable, "-c", ASKER, HERE, str(tmp_path / "run"), how]
    asker = subprocess.Popen(words, stdout=subprocess.PIPE)
    assert asker.stdout.readline() == b"ready\n"
    pids = descendants(asker.pid)
    assert len(pids) >= processes
    asker.kill()
    asker.communicate()
    assert has_ended_soon(*pids)
    if how == "forked":  # the server takes the folder away
        assert not (tmp_path / "run").exists()
