"""What a Dask cluster loses on the way: workers, all of them, its scheduler, its coordinator."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from dask_cluster import Programs, asked, locally, matches_of, table, until, worker_of
from living import has_ended_soon

import soccersim
from soccersim.problems import MachineError
from soccersim.regress.cluster import cluster_pool
from soccersim.regress.runner import run
from soccersim.regress.store import Store

pytestmark = [pytest.mark.slow, pytest.mark.skipif(os.name != "posix", reason="signals")]


@pytest.fixture
def own(tmp_path):
    """A scheduler of a test's own."""
    started = Programs(tmp_path / "dask")
    yield started
    started.close()


def test_workers_killed_on_the_way_cost_no_match_and_double_none(own, tmp_path):
    nannies = [own.worker(), own.worker()]
    legs = asked(20)
    with (
        Store(tmp_path / "dask.db") as store,
        cluster_pool(own.address, legs[0].scenario) as pool,
    ):
        assert until(lambda: pool.width == 2)
        for at, (_, row) in enumerate(run(legs, store, pool)):
            assert not row.void
            if at in (5, 12, 20):
                worker = worker_of(nannies[at % 2])
                played = matches_of(worker)
                os.kill(worker, signal.SIGKILL)
                assert has_ended_soon(*played, seconds=5)
        there = table(store)
        assert store.contradictions() == []
    assert there == locally(tmp_path / "local.db", legs)


def test_all_workers_gone_end_the_run_and_others_go_on_with_it(own, tmp_path):
    nanny = own.worker()
    legs = asked(4)
    with (
        Store(tmp_path / "dask.db") as store,
        cluster_pool(own.address, legs[0].scenario) as pool,
    ):
        pool.patience = 3.0
        rows = run(legs, store, pool)
        next(rows)
        nanny.kill()
        with pytest.raises(MachineError, match=r"tcp://\S+ has no worker any more; .* goes on$"):
            list(rows)
    kept = store_count(tmp_path / "dask.db")
    assert 0 < kept < 8
    own.worker()
    with (
        Store(tmp_path / "dask.db") as store,
        cluster_pool(own.address, legs[0].scenario) as pool,
    ):
        list(run(legs, store, pool))
        assert table(store) == locally(tmp_path / "local.db", legs)


def store_count(path):
    with Store(path) as store:
        return store.count()


def test_a_scheduler_that_is_gone_ends_the_run_in_one_line(own, tmp_path):
    own.worker()
    legs = asked(20)
    with (
        Store(tmp_path / "dask.db") as store,
        cluster_pool(own.address, legs[0].scenario) as pool,
    ):
        rows = run(legs, store, pool)
        next(rows)
        own.scheduler.kill()
        start = time.monotonic()
        with pytest.raises(MachineError, match=r"^the Dask scheduler at tcp://\S+ is gone; .*$"):
            list(rows)
    assert time.monotonic() - start < 20


def test_a_worker_that_comes_later_and_plays_other_matches_is_told_of_and_left_out(own, tmp_path):
    own.worker()
    legs, told = asked(25), []
    with (
        Store(tmp_path / "dask.db") as store,
        cluster_pool(own.address, legs[0].scenario, told.append) as pool,
    ):
        rows = run(legs, store, pool)
        next(rows)
        own.worker(PYTHONPATH=fake(tmp_path))
        for _, row in rows:
            assert not row.void
            if not told:
                time.sleep(0.3)
        assert store.count() == 50
    (line,) = told
    assert "has its code" in line
    assert line.endswith("it plays none of this run's matches")


def fake(folder):
    """A folder for PYTHONPATH where soccersim is one with another line of code."""
    there = folder / "fake" / "soccersim"
    shutil.copytree(Path(soccersim.__file__).parent, there, ignore=lambda *_: ["__pycache__"])
    with open(there / "geometry.py", "a") as file:
        file.write("# another one\n")
    return str(there.parent)


def test_whoever_has_seen_enough_leaves_no_match_on_the_workers(own, tmp_path):
    worker = worker_of(own.worker("--nthreads", "2"))
    legs = asked(1, seconds=600)
    with cluster_pool(own.address, legs[0].scenario) as pool:
        for leg in legs:
            pool.submit(leg, False)
        assert until(lambda: len(matches_of(worker)) >= 2)
        played = matches_of(worker)
    assert has_ended_soon(*played, seconds=3)
    legs = asked(1)
    with Store(tmp_path / "dask.db") as store, cluster_pool(own.address, "") as pool:
        assert len(list(run(legs, store, pool))) == 2  # the worker plays on


COORDINATOR = """\
from dask_cluster import asked
from soccersim.regress.cluster import cluster_pool
import sys, time
legs = asked(1, seconds=600)
with cluster_pool(sys.argv[1], legs[0].scenario) as pool:
    [pool.submit(leg, False) for leg in legs]
    time.sleep(99)
"""


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_a_coordinator_that_is_killed_leaves_no_match_on_the_workers(own, how):
    worker = worker_of(own.worker("--nthreads", "2"))
    path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
    program = subprocess.Popen(
        [sys.executable, "-c", COORDINATOR, own.address],
        env={**os.environ, "PYTHONPATH": path},
        stderr=subprocess.DEVNULL,
    )
    assert until(lambda: len(matches_of(worker)) >= 2)
    played = matches_of(worker)
    program.send_signal(how)
    program.wait(20)
    assert has_ended_soon(*played, seconds=20)


def test_a_worker_that_is_asked_to_end_leaves_nothing(own):
    nanny = own.worker("--nthreads", "2")
    worker = worker_of(nanny)
    legs = asked(1, seconds=600)
    with cluster_pool(own.address, legs[0].scenario) as pool:
        for leg in legs:
            pool.submit(leg, False)
        assert until(lambda: len(matches_of(worker)) >= 2)
        played = matches_of(worker)
        nanny.send_signal(signal.SIGTERM)
        assert has_ended_soon(*played, seconds=20)
        nanny.wait(20)
    assert until(lambda: not list(own.temporary.glob("soccersim-run-*")), 20)
