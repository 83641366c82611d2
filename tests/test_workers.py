"""Processes side by side: results in order, and no end but a clear one."""

import os
import subprocess
import sys
import time

import pytest

from soccersim.problems import InputError, MachineError, Problem
from soccersim.processes import has_ended
from soccersim.workers import Workers


def all_ended(workers):
    return [has_ended(process) for process in workers._processes] == [True] * workers._jobs


def test_results_come_in_the_order_of_the_work():
    with Workers(2) as workers:
        assert list(workers.map(divmod, [7, 8, 9], [2, 2, 2])) == [(3, 1), (4, 0), (4, 1)]
        assert list(workers.map(abs, range(-300, 0))) == list(range(300, 0, -1))
        slow_first = workers.map(pause, [0.3, 0.0, 0.0])
        assert list(slow_first) == [0.3, 0.0, 0.0]
        assert list(workers.map(abs, [])) == []
    assert all_ended(workers)


def pause(seconds):
    time.sleep(seconds)
    return seconds


def test_the_work_of_one_is_shared_by_all():
    with Workers(2) as workers:
        where = set(workers.map(pid_after, [0.1] * 6))
    assert len(where) == 2
    assert os.getpid() not in where


def pid_after(seconds):
    time.sleep(seconds)
    return os.getpid()


def test_a_process_that_is_killed_is_the_machines_fault():
    with (
        pytest.raises(MachineError, match="a process ended before its work was done"),
        Workers(1) as workers,
    ):
        list(workers.map(os._exit, [9]))
    assert all_ended(workers)


def test_what_fails_there_fails_here_and_ends_the_others_at_once():
    start = time.monotonic()
    with pytest.raises(ZeroDivisionError), Workers(2) as workers:  # noqa: PT012
        next(workers.map(time.sleep, [0, 3600]))
        list(workers.map(divmod, [1], [0]))
    assert all_ended(workers)
    assert time.monotonic() - start < 60


def test_all_of_an_error_comes_over_and_of_a_strange_one_its_words():
    with pytest.raises(InputError, match="x: wrong\ny: too") as caught, Workers(1) as workers:
        list(workers.map(refuse, [1]))
    assert len(caught.value.problems) == 2
    with pytest.raises(RuntimeError, match="Strange: words"), Workers(1) as workers:
        list(workers.map(be_strange, [1]))


def refuse(_):
    raise InputError([Problem("wrong", "x"), Problem("too", "y")])


class Strange(Exception):
    """Cannot be put together again from its arguments."""

    def __init__(self, one, two):
        super().__init__(f"{one}{two}")


def be_strange(_):
    raise Strange("wor", "ds")


def test_prints_and_much_data_do_not_get_in_each_others_way(capfd):
    with Workers(1) as workers:
        (data,) = workers.map(shout, [bytes(3_000_000)])
    assert data == bytes(3_000_001)
    assert capfd.readouterr().out == ""


def shout(data):
    print("x" * 200_000)
    return data + b"\0"


def test_what_cannot_be_sent_is_told_and_the_work_goes_on():
    with Workers(1) as workers:
        with pytest.raises((AttributeError, TypeError), match="pickle"):
            list(workers.map(lambda x: x, [1]))
        assert list(workers.map(abs, [-1])) == [1]


def test_what_is_begun_is_finished_and_what_is_not_is_left():
    with Workers(1) as workers:
        workers.map(pause, [0.1] * 1000)
        start = time.monotonic()
    assert time.monotonic() - start < 30
    assert all_ended(workers)


def test_processes_end_with_the_one_who_started_them():
    code = (
        "import time; from soccersim.workers import Workers; w = Workers(2);"
        "r = w.map(time.sleep, [0, 0, 0.5, 0.5]); next(r);"
        "print(*(p.pid for p in w._processes), flush=True); import os; os.kill(os.getpid(), 9)"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    pids = [int(pid) for pid in ended.stdout.split()]
    assert len(pids) == 2
    end = time.monotonic() + 20
    while any(map(alive, pids)) and time.monotonic() < end:
        time.sleep(0.02)
    assert not any(map(alive, pids))


def alive(pid):
    """Whether a process still does anything."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False
