"""`soccersim tournament`: everybody against everybody, on the same seeds."""

import json
from pathlib import Path

import make_believe
import pytest

from soccersim.regress.store import Store

MORE = ("--scenario", "friendly-match", "--duration", "5")


@pytest.fixture
def tournament(verb, strategies):
    strategies(new="GOOD", bad="FAULTY", moody="MOODY")
    return lambda *words: verb("tournament", *words, *MORE)


def test_table_cross_table_and_ratings(tournament):
    ended = tournament("old.py", "new.py", "bad.py", "--pairs", "6")
    assert ended.code == 4
    assert ended.lines[-1] == "matches forfeited: bad.py 24"
    lines = ended.out.splitlines()
    assert lines[0] == "3 teams, 18 pairs of friendly-match"
    order = [line.split()[1] for line in lines[1:] if line.strip()[:2] in ("1 ", "2 ", "3 ")]
    assert order == ["new.py", "old.py", "bad.py"] * 2
    assert "the first of 24 faults" in ended.out
    document = json.loads(tournament("old.py", "new.py", "bad.py", "--pairs", "6", "--json").out)
    assert [team["team"] for team in document["teams"]] == order[:3]
    assert [team["played"] for team in document["teams"]] == [24, 24, 24]
    assert [team["faults"] for team in document["teams"]] == [0, 0, 24]
    assert document["cross"][2][0] == [0, 0, 12]
    assert document["pairs"] == 18
    assert sum(team["elo"] for team in document["teams"]) == pytest.approx(0.0, abs=1e-6)
    assert all(team["error"] > 0.0 for team in document["teams"])
    assert {fault["team"] for fault in document["faults"]} == {"bad.py"}
    assert document["matches"] == {"played": 0, "found": 36}
    assert tournament("old.py", "new.py", "--pairs", "6").code == 0


def test_one_job_and_many_and_one_that_was_stopped_come_to_the_same(tournament, monkeypatch):
    words = ("old.py", "new.py", "bad.py", "--pairs", "4", "--json")
    documents = [
        json.loads(tournament(*words, "--jobs", jobs, "--results", f"{jobs}.db").out)
        for jobs in (1, 16)
    ]
    play, calls = make_believe.play, iter(range(9))

    def stopped(leg):
        if next(calls, None) is None:
            raise KeyboardInterrupt
        return play(leg)

    monkeypatch.setattr(make_believe, "play", stopped)
    ended = tournament(*words, "--jobs", "1")
    assert (ended.code, ended.out) == (130, "")
    assert ended.lines[-1].startswith("stopped after ")
    assert ended.lines[-1].endswith("tournament.db keeps them: the same command goes on from there")
    monkeypatch.setattr(make_believe, "play", play)
    with Store(Path("tournament.db")) as store:
        assert 0 < store.count() < 24
    documents.append(json.loads(tournament(*words).out))
    assert documents[2]["matches"]["found"] > 0
    for document in documents:
        del document["matches"], document["results"]
    assert documents[0] == documents[1] == documents[2]


def test_who_does_not_play_the_same_match_twice_makes_it_invalid(tournament):
    ended = tournament("old.py", "moody.py", "--pairs", "3")
    assert ended.code == 4
    assert ended.lines[-1] == "played twice, and came out differently: old.py - moody.py, seed 1"


MISTAKES = {
    ("old.py",): "a tournament needs two teams at least",
    ("old.py", "new.py", "old.py"): "old.py: is named twice",
    ("old.py", "rols"): "did you mean `roles`?",
    ("old.py", "new.py", "--pairs", "0"): "0 is not in the range",
    ("old.py", "new.py", "--scenario", "defender"): "is no match",
    ("old.py", "new.py", "--set", "match.home.options.x=1"): "the teams of a tournament take turns",
    (): "Missing argument",
}


@pytest.mark.parametrize("words", MISTAKES, ids=" ".join)
def test_a_mistake_gets_one_clear_line(verb, strategies, words):
    strategies(new="GOOD")
    ended = verb("tournament", *words)
    assert (ended.code, ended.out) == (2, "")
    assert len(ended.lines) == 1
    assert MISTAKES[words] in ended.err
