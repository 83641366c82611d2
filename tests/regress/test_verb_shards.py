"""`soccersim worker` and `merge`: shards that know nothing of each other give the same verdict."""

import json
from dataclasses import replace
from pathlib import Path

import make_believe
import pytest

from soccersim.regress.recordings import Recordings
from soccersim.regress.store import Store

WORDS = ("old.py", "new.py", "--scenario", "friendly-match", "--duration", "5", "--pairs", "11")


@pytest.fixture
def worker(verb, strategies):
    """Plays a shard of old.py against new.py."""
    strategies(new="GOOD", bad="FAULTY")

    def run(which, shards=3, *more, words=WORDS, out=None):
        shard = ("--shard", f"{which}/{shards}", "--out", out or f"s{which}.db")
        ended = verb("worker", *words, *shard, *more)
        assert ended.code == 0, ended.err
        return ended

    return run


def told(ended):
    document = json.loads(ended.out)
    del document["matches"], document["results"]
    return document


@pytest.mark.parametrize("more", [(), ("--against", "bad.py")])
def test_merged_shards_tell_what_one_run_tells(verb, worker, more):
    whole = verb("regress", *WORDS, *more, "--json")
    for which in (1, 2, 3):
        worker(which, words=(*WORDS, *more))
    merged = verb("merge", "s3.db", "s1.db", "s2.db", "--json")
    assert merged.code == whole.code
    assert told(merged) == told(whole)
    assert merged.err == ""
    shown = [verb("merge", "s1.db", "s2.db", "s3.db").out, verb("regress", *WORDS, *more).out]
    tables = [text[: text.index("this run")] for text in shown]
    assert tables[0] == tables[1]
    assert told(verb("regress", *WORDS, *more, "--results", "merged.db", "--json")) == told(whole)
    assert make_believe.Pool.opened == 4


def test_each_shard_plays_its_own_pairs_and_goes_on(verb, worker):
    ended = worker(2)
    assert ended.out.splitlines()[0] == "shard 2 of 3: 8 matches, 0 faults, 0 void, in s2.db"
    assert {pair for pair, _ in make_believe.Pool.begun} == {1, 4, 7, 10}
    document = json.loads(worker(2, 3, "--json").out)
    assert document == {
        "shard": [2, 3],
        "pairs": 11,
        "matches": 8,
        "faults": 0,
        "void": 0,
        "played": 0,
        "results": "s2.db",
    }


def test_a_missing_shard_is_told_and_can_be_put_in_later(verb, worker):
    for which in (1, 2, 3):
        worker(which)
    ended = verb("merge", "s1.db", "s3.db")
    assert (ended.code, ended.out) == (2, "")
    assert ended.lines == ["4 of 11 pairs are missing (1, 4, 7, 10): name the files of all shards"]
    assert verb("merge", "s2.db").code == 0  # the others are in merged.db


@pytest.mark.parametrize(
    ("words", "what"),
    [
        (("--pairs", "12"), "--pairs"),
        (("--seed", "5"), "--seed"),
        (("--seed", "5", "--duration", "6"), "the scenario, --set or --duration and --seed"),
        (("--duration", "6"), "the scenario, --set or --duration"),
        (("--against", "bad.py"), "the opponents"),
    ],
)
def test_mixed_plans_are_refused_in_one_line(verb, worker, words, what):
    worker(1)
    worker(2, words=(*WORDS, *words))
    ended = verb("merge", "s1.db", "s2.db")
    assert (ended.code, ended.out) == (2, "")
    assert ended.lines == [f"s2.db: differs from s1.db in {what}"]
    assert not Path("merged.db").exists()


def test_changed_code_between_two_shards_is_refused_and_another_path_is_not(verb, worker):
    worker(1, 2)
    worker(2, 2, words=("./old.py", "./new.py", *WORDS[2:]))
    assert verb("merge", "s1.db", "s2.db").code == 0
    Path("new.py").write_text(Path("new.py").read_text() + "# GOOD\n")
    worker(2, 2)
    ended = verb("merge", "s1.db", "s2.db")
    assert ended.lines == ["s2.db: differs from s1.db in the candidate's code or options"]


def test_a_match_in_two_shards_that_came_out_differently_is_invalid(verb, worker):
    worker(1, 2)
    worker(2, 2)
    worker(2, 2, out="again.db")
    assert verb("merge", "s1.db", "s2.db", "again.db").code == 0
    with Store(Path("again.db")) as store:
        row = next(store.rows())
        store.all("DELETE FROM legs WHERE key = ?", (row.key,))
        store.add(replace(row, digest="another"))
    ended = verb("merge", "s1.db", "s2.db", "again.db", "--out", "all.db")
    assert ended.code == 4
    assert ended.out.splitlines()[1] == "leg 0 of pair 1 was played twice and came out differently"
    assert verb("merge", "all.db", "--json", "--out", "more.db").code == 4  # it goes along


def test_recordings_come_with_the_shards(verb, worker):
    for which in (1, 2):
        worker(which, 2)
    with Store(Path("s1.db")) as store:
        row, gone = list(store.rows())[:2]
        folder = Recordings(store.path).folder
        folder.mkdir()
        (folder / "kept.npz").write_bytes(b"it")
        for each, name in ((row, "kept.npz"), (gone, "gone.npz")):
            store.all("UPDATE legs SET recording = ? WHERE key = ?", (name, each.key))
    assert verb("merge", "s1.db", "s2.db").code == 0
    with Store(Path("merged.db")) as store:
        assert store.row(row.key).recording == "kept.npz"
        assert store.row(gone.key).recording == ""
        assert (Recordings(store.path).folder / "kept.npz").read_bytes() == b"it"


MISTAKES = {
    ("merge",): "Missing argument 'FILE...'",
    ("merge", "no.db"): "no.db: there is no such file",
    ("merge", "old.py"): "is no store of results",
    ("merge", "s1.db", "--out", "s1.db"): "is one of the shards",
    ("merge", "sprt.db"): "sprt.db: is no shard",
    ("worker", *WORDS): "Missing option '--shard'",
    ("worker", *WORDS, "--shard", "1/2"): "--out FILE",
    ("worker", *WORDS, "--shard", "3/2", "--out", "x.db"): "I from 1 to N",
    ("worker", *WORDS, "--shard", "0/2", "--out", "x.db"): "I from 1 to N",
    ("worker", *WORDS[:-2], "--shard", "1/2", "--out", "x.db"): "Missing option '--pairs'",
}


@pytest.mark.parametrize("words", MISTAKES, ids=" ".join)
def test_a_mistake_gets_one_clear_line(verb, worker, words):
    if "s1.db" in words:
        worker(1)
    if "sprt.db" in words:
        verb("regress", *WORDS[:-2], "--max-pairs", "2", "--results", "sprt.db")
    ended = verb(*words)
    assert (ended.code, ended.out) == (2, "")
    assert len(ended.lines) == 1
    assert MISTAKES[words] in ended.err
