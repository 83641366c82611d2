"""Processes side by side: results in order, and no end but a clear one."""

import multiprocessing
import os
import time

import pytest

from soccersim.problems import MachineError
from soccersim.workers import Workers


def test_results_come_in_the_order_of_the_work():
    others = multiprocessing.active_children()
    with Workers(2) as workers:
        assert list(workers.map(divmod, [7, 8, 9], [2, 2, 2])) == [(3, 1), (4, 0), (4, 1)]
        assert list(workers.map(abs, range(-3, 0))) == [3, 2, 1]
    assert multiprocessing.active_children() == others


def test_a_process_that_is_killed_is_the_machines_fault():
    with (
        pytest.raises(MachineError, match="a process ended before its work was done"),
        Workers(1) as workers,
    ):
        list(workers.map(os._exit, [9]))


def test_what_fails_there_fails_here_and_ends_the_others_at_once():
    def work():
        with Workers(2) as workers:
            next(workers.map(time.sleep, [0, 3600]))
            list(workers.map(divmod, [1], [0]))

    others = set(multiprocessing.active_children())  # of tests that keep a pool
    with pytest.raises(ZeroDivisionError):
        work()
    children = set(multiprocessing.active_children()) - others
    for child in children:
        child.join(10)
    assert not any(child.is_alive() for child in children)
