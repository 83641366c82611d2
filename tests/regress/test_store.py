"""The store keeps what it was given, all of it or nothing, from one run at a time."""

import os
import signal
import sqlite3
import subprocess
import sys
import textwrap
from dataclasses import replace

import pytest

from soccersim.problems import InputError, MachineError
from soccersim.regress.bundle import Bundle
from soccersim.regress.row import Row
from soccersim.regress.store import Contradiction, Store

FAULT = {"side": "home", "kind": "exception", "tick": 20, "detail": "ValueError: x"}
ROW = Row(
    key="k0",
    pair=0,
    leg=0,
    seed=7,
    home="a",
    away="b",
    score=(2, 1),
    digest="d0",
    duration=60.0,
    faults=(FAULT,),
    events=({"kind": "goal", "tick": 4, "at": [0.1, 1 / 3]},),
    seconds=1.5,
    overhead=0.1,
    again="home: deadline",
    recording="x.npz",
)


def row(number, **changes):
    return replace(ROW, key=f"k{number}", pair=number // 2, leg=number % 2, **changes)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "results.db"


def elsewhere(code, path, **more):
    """Run code in another process, with the store's path and row() at hand."""
    head = "import sys; sys.path.insert(0, sys.argv[2]); from pathlib import Path\n"
    head += "from test_store import *; path = Path(sys.argv[1])\n"
    here = os.path.dirname(__file__)
    words = [sys.executable, "-c", head + textwrap.dedent(code), str(path), here]
    return subprocess.Popen(words, stdout=subprocess.PIPE, text=True, **more)


def test_rows_come_back_as_they_were_in_order(path):
    rows = [row(3), row(0), row(2), row(1, void="lost")]
    with Store(path) as store:
        for each in rows:
            store.add(each)
        assert store.seconds > 0
    with Store(path) as store:
        assert list(store.rows()) == sorted(rows, key=lambda row: row.key)
        assert store.row("k2") == row(2)
        assert store.row("k9") is None
        assert store.count() == 4


def test_bundles_and_notes_come_back(path):
    with Store(path) as store:
        store.keep_bundles([Bundle("one", b"1"), Bundle("two", b"2"), Bundle("again", b"1")])
        store.note("command", "regress one two")
        store.note("command", "regress two one")
    with Store(path) as store:
        assert sorted(b.name for b in store.bundles().values()) == ["one", "two"]
        assert all(bundle.sha == sha for sha, bundle in store.bundles().items())
        assert store.noted("command") == "regress two one"
        assert store.noted("nothing") == ""


def test_a_leg_that_comes_twice_is_kept_once_and_told_if_it_came_out_otherwise(path):
    other = row(1, digest="another", score=(0, 0))
    with Store(path) as store:
        store.add(row(0), replace(row(1), faults=()))
        store.add(row(0, seconds=9.0, overhead=9.0))
        assert store.contradictions() == []
        store.add(other)
        store.add(other)
        assert store.contradictions() == [Contradiction("k1", 0, 1, "d0", "another")]
        assert store.row("k0") == row(0)
        assert store.row("k1").digest == "d0"


@pytest.mark.parametrize("kind", ["deadline", "memory", "crash"])
def test_a_busy_machine_is_no_contradiction(path, kind):
    with Store(path) as store:
        store.add(row(0))
        store.add(row(0, digest="another", faults=({**FAULT, "kind": kind},)))
        assert store.contradictions() == []


def test_what_is_void_gives_way_to_what_is_not(path):
    void = row(0, digest="", void="lost")
    with Store(path) as store:
        store.add(void)
        store.add(row(0))
        store.add(void)
        assert store.row("k0") == row(0)
        store.add(row(1, void="lost"))
        store.forget_void()
        assert [each.key for each in store.rows()] == ["k0"]
        assert store.contradictions() == []


def test_a_second_run_on_the_same_store_is_refused_in_one_line(path):
    line = r"results\.db: another run is using it: wait for that, or name another file"
    with Store(path) as store:
        with pytest.raises(InputError, match=line):
            Store(path)
        second = elsewhere(
            """\
            try:
                Store(path)
            except InputError as error:
                print(error)
            """,
            path,
        )
        assert "another run is using it" in second.communicate()[0]
        store.add(row(0))
    with Store(path) as store:
        assert store.count() == 1


def test_a_run_that_is_killed_gives_it_up(path):
    code = "store = Store(path)\nstore.add(row(0))\nprint('open', flush=True)\ninput()"
    first = elsewhere(code, path, stdin=subprocess.PIPE)
    assert first.stdout.readline() == "open\n"
    with pytest.raises(InputError):
        Store(path)
    first.send_signal(signal.SIGTERM)
    first.communicate()
    with Store(path) as store:
        assert list(store.rows()) == [row(0)]


def test_killed_at_any_moment_it_holds_whole_transactions(path):
    code = """\
    with Store(path) as store:
        for number in range(store.count() // 2, 999999):
            store.add(row(number), row(number + 1000000))
            print(number, flush=True)
    """
    said = -1
    for last in (20, 40, 80, 100, 120):
        writer = elsewhere(code, path)
        while said < last:
            said = int(writer.stdout.readline())
        writer.kill()
        said = max([said, *map(int, writer.communicate()[0].split())])
        with Store(path) as store:
            rows, count = list(store.rows()), store.count() // 2
            numbers = [*range(count), *range(1000000, 1000000 + count)]
            assert sorted(map(repr, rows)) == sorted(map(repr, map(row, numbers)))
            assert count in (said + 1, said + 2)


def test_a_full_disk_leaves_earlier_rows_and_goes_on_when_there_is_room(path):
    with Store(path) as store:
        store.add(row(0))
        pages = store.all("PRAGMA page_count")[0][0]
        store.all(f"PRAGMA max_page_count = {pages + 1}")
        large = {"events": tuple({"kind": os.urandom(20).hex()} for _ in range(999))}
        line = r"results\.db: cannot be written \(.*full\); what it holds is whole"
        with pytest.raises(MachineError, match=line):
            store.add(row(1), row(2, **large))
        assert list(store.rows()) == [row(0)]
        store.all("PRAGMA max_page_count = 1000000")
        store.add(row(1))
    with Store(path) as store:
        assert list(store.rows()) == [row(0), row(1)]


@pytest.mark.skipif(os.name != "posix", reason="limits as POSIX systems have them")
def test_a_file_that_may_not_grow_is_told_and_keeps_its_rows(path):
    code = """\
    import resource
    with Store(path) as store:
        store.add(row(0))
        resource.setrlimit(resource.RLIMIT_FSIZE, (path.stat().st_size,) * 2)
        try:
            for number in range(1, 999):
                store.add(row(number))
        except MachineError as error:
            print(error)
    """
    assert "cannot be written" in elsewhere(code, path).communicate()[0]
    with Store(path) as store:
        rows = list(store.rows())
        assert rows == [row(number) for number in range(len(rows))]
        store.add(row(len(rows)))


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ("PRAGMA user_version = 99", "has format 99; this soccersim reads format 1"),
        ("PRAGMA application_id = 5", "is a database of something else"),
    ],
)
def test_another_version_and_another_database_are_told_from_a_store(path, what, words):
    Store(path).close()
    base = sqlite3.connect(path)
    base.execute(what)
    base.close()
    with pytest.raises(InputError, match=words):
        Store(path)


def test_someone_elses_database_is_left_alone(path):
    base = sqlite3.connect(path)
    base.execute("CREATE TABLE mine (x)")
    base.close()
    before = path.read_bytes()
    with pytest.raises(InputError, match="is a database of something else"):
        Store(path)
    assert path.read_bytes() == before


def test_what_is_no_database_is_told(path, tmp_path):
    path.write_text("teams:\n  - roles\n" * 99)
    with pytest.raises(InputError, match=r"results\.db: is no store of results, or damaged"):
        Store(path)
    for wrong in (tmp_path, tmp_path / "nowhere" / "results.db"):
        with pytest.raises(MachineError, match="cannot be written"):
            Store(wrong)
