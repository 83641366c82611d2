"""`soccersim regress` with something wrong: one clear line, and nothing is played."""

import sqlite3
from pathlib import Path

import make_believe
import pytest

from soccersim.regress.store import Store

MISTAKES = {
    ("old.py", "nwe.py"): "nwe.py: there is no such file; did you mean `new.py`?",
    ("rols", "new.py"): "no strategy `rols` is bundled: did you mean `roles`?",
    ("old.py", "new.py", "--against", "chasr"): "no strategy `chasr` is bundled",
    ("old.py",): "Missing argument 'CANDIDATE'",
    ("old.py", "new.py", "weak.py"): "unexpected extra argument (weak.py)",
    ("old.py", "new.py", "--sprt", "5"): "two numbers with a comma",
    ("old.py", "new.py", "--sprt", "9,2"): "the lower one first",
    ("old.py", "new.py", "--alpha", "0.7"): "--alpha: alpha and beta are chances",
    ("old.py", "new.py", "--pairs", "5", "--sprt", "0,5"): "leave --sprt out",
    ("old.py", "new.py", "--pairs", "0"): "0 is not in the range",
    ("old.py", "new.py", "--scenario", "mls-match"): "did you mean `msl-match`?",
    ("old.py", "new.py", "--scenario", "defender"): "is no match: `soccersim run defender`",
    ("old.py", "new.py", "--set", "duration=x"): "duration: must be a number",
    ("old.py", "new.py", "--results", "."): "is a folder: --results names a file",
    ("old.py", "new.py", "--results", "no/x.db"): "the folder for it is not there",
    ("old.py", "new.py", "--report", "new.py"): "must end in .html or .htm",
    ("old.py", "new.py", "--results", "old.py"): "is no store of results",
    ("old.py", "new.py", "--jobs", "2", "--scheduler", "tcp://a:1"): "--jobs is of this machine",
}


@pytest.mark.parametrize("words", MISTAKES, ids=" ".join)
def test_a_mistake_gets_one_clear_line(verb, strategies, words):
    strategies(new="GOOD", weak="")
    ended = verb("regress", *words)
    assert (ended.code, ended.out) == (2, "")
    assert len(ended.lines) == 1
    assert MISTAKES[words] in ended.err
    assert make_believe.Pool.opened == 0


def test_a_results_file_in_use_is_refused(verb, strategies):
    strategies(new="")
    with Store(Path("old-new.db")):
        ended = verb("regress", "old.py", "new.py")
    assert ended.code == 2
    assert ended.lines == [
        "old-new.db: another run is using it: wait for that, or name another file"
    ]
    with sqlite3.connect("other.db") as base:
        base.execute("CREATE TABLE mine (x)")
    assert (
        "is a database of something else"
        in verb("regress", "old.py", "new.py", "--results", "other.db").err
    )
