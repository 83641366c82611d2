"""Matches on a real Dask cluster on this machine: the same as here, whatever is lost on the way."""

import os
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from dask_cluster import Programs, asked, locally, table, until

from soccersim.problems import InputError, MachineError
from soccersim.regress import cluster, remote
from soccersim.regress.cluster import cluster_pool
from soccersim.regress.runner import run
from soccersim.regress.scheduler import compare
from soccersim.regress.store import Store

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals")


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """A scheduler and two workers."""
    started = Programs(tmp_path_factory.mktemp("dask"))
    for _ in range(2):
        started.worker()
    yield started
    started.close()


def test_a_cluster_plays_the_same_table_bit_for_bit_and_brings_recordings(programs, tmp_path):
    legs = asked(2, keep="all")
    address = f"file:{programs.file}"
    with Store(tmp_path / "dask.db") as store, cluster_pool(address, legs[0].scenario) as pool:
        assert until(lambda: pool.width == 2)
        rows = [row for _, row in run(legs, store, pool)]
        assert len(rows) == store.count() == 4
        assert store.contradictions() == []
        there = table(store)
    assert there == locally(tmp_path / "local.db", legs)
    assert len({row.digest for row in rows}) == 4
    for row in rows:
        assert not row.void
        assert (tmp_path / "dask.db.recordings" / row.recording).stat().st_size > 1000


def test_a_strategy_that_is_not_there_is_bad_input(programs, tmp_path):
    (tmp_path / "empty.py").write_text("x = 1")
    legs = asked(1, first=str(tmp_path / "empty.py"))
    with (
        Store(tmp_path / "dask.db") as store,
        cluster_pool(programs.address, legs[0].scenario) as pool,
        pytest.raises(InputError, match=r"empty\.py: defines no class with a method decide"),
    ):
        list(run(legs, store, pool))


def test_another_soccersim_there_is_refused_at_the_start_naming_both(programs, monkeypatch):
    ours = {"soccersim": "9.9", "python": "2.7", remote.LOADED: "x"}
    monkeypatch.setattr("soccersim.regress.crew.told", lambda: ours)
    pool = cluster_pool(programs.address, asked(1)[0].scenario)
    theirs = (
        r"the worker tcp://\S+ (\(and 1 more\) )?has soccersim 0\.1\.0, python 3\.\S+; here it is"
    )
    with pytest.raises(InputError, match=rf"^{theirs} soccersim 9\.9, python 2\.7$"), pool:
        pass


def test_other_versions_on_the_scheduler_are_refused_at_the_start_naming_both():
    class Client:
        scheduler = SimpleNamespace(address="tcp://there:1")

        def get_versions(self, packages):
            ours = {
                "soccersim": "0.1.0",
                "python": "3.11.2.final.0",
                "dask": "7",
                "distributed": "7",
            }
            theirs = {**ours, "python": "3.12.9.final.0", "soccersim": None}
            return {"scheduler": {"packages": theirs}, "client": {"packages": ours}}

    told = (
        r"at tcp://there:1 has soccersim none, python 3\.12; here it is soccersim 0\.1\.0, python"
    )
    with pytest.raises(InputError, match=told):
        compare(Client())


def test_no_scheduler_is_told_in_one_line(monkeypatch):
    monkeypatch.setattr(cluster, "CONNECT", 0.3)
    told = r"^no Dask scheduler answers at tcp://127\.0\.0\.1:9 within 0\.3 s: .*$"
    with pytest.raises(MachineError, match=told):
        cluster_pool("tcp://127.0.0.1:9", "")


ADDRESSES = {
    "cluster": "is no address: tcp://HOST:PORT or file:PATH would be right",
    "tcp://": "is no address",
    "teapot://here:1": "teapot",
    "file:there.json": r"^there\.json: there is no such file: `dask scheduler --scheduler-file",
    "file:odd.json": r"^odd\.json: is no scheduler file of Dask",
    "file:text.json": r"^text\.json: is no scheduler file of Dask",
}


@pytest.mark.parametrize("address", ADDRESSES)
def test_an_address_that_is_none_is_bad_input(address, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("odd.json").write_text("[1]")
    Path("text.json").write_text("tcp://")
    with pytest.raises(InputError, match=ADDRESSES[address]):
        cluster_pool(address, "")


def test_without_dask_the_user_is_told_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InputError, match=r"needs dask: pip install 'soccersim\[cluster\]'"):
        cluster_pool("tcp://127.0.0.1:9", "")
