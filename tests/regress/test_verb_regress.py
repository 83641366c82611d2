"""`soccersim regress`: a verdict, its evidence, an exit code; and it goes on where it stopped."""

import json
import shlex
from pathlib import Path

import make_believe
import pytest

from soccersim.cli import regress as module
from soccersim.problems import MachineError
from soccersim.regress.store import Store

FRIENDLY = ("--scenario", "friendly-match", "--duration", "5")
KEYS = {
    *("verdict", "pairs", "diverged", "llr", "bounds", "elo", "elo_ci", "goal_difference"),
    *("pentanomial", "faults", "results"),
}
OPTIONS = {
    *("--scenario", "--seed", "--duration", "--set", "--pairs", "--sprt", "--alpha", "--beta"),
    *("--max-pairs", "--against", "--jobs", "--scheduler", "--keep", "--results", "--report"),
    *("--junit", "--strict", "--json"),
}


@pytest.fixture
def regress(verb, strategies):
    """Runs `soccersim regress` over a second's matches; teams are old.py and these."""
    strategies(new="GOOD", same="", weak="", bad="FAULTY", moody="MOODY", other=" ")
    return lambda *words: verb("regress", *words, *FRIENDLY)


def told(ended):
    """The document of --json; without what depends on how often it was stopped."""
    document = json.loads(ended.out)
    document.pop("matches")
    return document


def test_it_has_the_contracted_options():
    options = {o for p in module.command.params for o in p.opts}
    assert options == OPTIONS | {"base", "candidate"}


@pytest.mark.parametrize(
    ("base", "candidate", "verdict", "code"),
    [
        ("old", "new", "PASS", 0),
        ("new", "old", "FAIL", 1),
        ("old", "same", "IDENTICAL", 0),
        ("old", "old", "IDENTICAL", 0),
        ("old", "bad", "INVALID", 4),
        ("old", "moody", "INVALID", 4),
    ],
)
def test_the_verdict_comes_first_and_is_the_exit_code(regress, base, candidate, verdict, code):
    words = (f"{base}.py", f"{candidate}.py", "--seed", "7")
    ended = regress(*words)
    assert ended.code == code
    assert ended.out.startswith(f"{verdict}  ")
    for name in ("pairs", "diverged", "normalized Elo", "goals a match", "faults", "results"):
        assert f"\n{name} " in ended.out
    again = f"again: {shlex.join(['soccersim', 'regress', *words, *FRIENDLY])}"
    assert " ".join(ended.out.split()).endswith(again)
    document = told(regress(*words, "--json"))
    assert set(document) >= KEYS
    assert document["verdict"] == verdict
    assert document["results"] == f"{base}-{candidate}.db"


def test_stopped_as_soon_as_it_is_clear(regress):
    ended = regress("old.py", "new.py", "--json")
    document = json.loads(ended.out)
    assert document["pairs"] < 100
    assert document["matches"]["played"] <= 2 * document["pairs"] + 10
    assert 0.0 < document["elo_ci"][0] < document["elo"] < document["elo_ci"][1]


def test_copies_are_told_after_one_look_whatever_their_names(regress):
    assert told(regress("old.py", "same.py", "--json"))["pairs"] == 8
    document = told(regress("old.py", "other.py", "--json", "--max-pairs", "20"))
    assert (document["verdict"], document["pairs"]) == ("INCONCLUSIVE", 20)


def test_json_is_all_that_standard_output_has(regress):
    ended = regress("old.py", "bad.py", "--json", "--pairs", "9")
    document = json.loads(ended.out)
    assert ended.out.count("\n") == 1
    assert len(document["faults"]) == 18
    assert document["fault_counts"] == {"candidate": 18, "base": 0}
    first = document["faults"][0]
    assert (first["team"], first["as"], first["pair"], first["kind"]) == (
        *("bad.py", "candidate", 0),
        "exception",
    )
    assert ended.lines[0].startswith("playing friendly-match, ")


def test_the_table_names_the_exception_of_a_fault(regress):
    assert "exception: ValueError: no" in regress("old.py", "bad.py").out


@pytest.mark.parametrize("words", [(), ("--pairs", "30"), ("--against", "weak.py", "moody.py")])
def test_one_job_and_many_come_to_the_same(regress, words):
    if "moody.py" in words:  # another opponent: it would be INVALID
        words = ("--against", "weak.py", "new.py", "--pairs", "12")
    each = [
        regress("old.py", "new.py", *words, "--jobs", jobs, "--results", f"{jobs}.db", "--json")
        for jobs in (1, 16)
    ]
    documents = [{**told(ended), "results": ""} for ended in each]
    assert documents[0] == documents[1]


def test_the_same_command_goes_on_and_plays_nothing_that_is_there(regress, monkeypatch):
    whole = told(regress("old.py", "new.py", "--json", "--results", "whole.db"))
    play = make_believe.play
    calls = iter(range(11))

    def full(leg):
        if next(calls, None) is None:
            raise MachineError("a disk: No space left on device")
        return play(leg)

    monkeypatch.setattr(make_believe, "play", full)
    monkeypatch.setattr("soccersim.regress.runner.PAUSE", 0.0)
    ended = regress("old.py", "new.py")
    assert (ended.code, ended.out) == (3, "")
    assert ended.lines[1:] == ["a disk: No space left on device"]
    monkeypatch.setattr(make_believe, "play", play)
    with Store(Path("old-new.db")) as store:
        there = store.count()
    assert 0 < there <= 11
    again = json.loads(regress("old.py", "new.py", "--json").out)
    assert again.pop("matches")["found"] >= there
    assert {**again, "results": ""} == {**whole, "results": ""}
    opened = make_believe.Pool.opened
    last = regress("old.py", "new.py", "--json")
    assert make_believe.Pool.opened == opened  # nothing to play: no processes
    assert told(last) == again
    assert last.err == ""


@pytest.mark.parametrize("name", ["regress", "worker", "tournament"])
def test_what_the_machine_failed_to_play_is_played_by_the_next_run(verb, strategies, name):
    strategies(new="GOOD")
    more = {"worker": ("--shard", "1/1", "--out", "x.db"), "regress": ("--results", "x.db")}
    words = ("old.py", "new.py", *FRIENDLY, "--pairs", "3", *more.get(name, ("--results", "x.db")))
    first = verb(name, *words)
    with Store(Path("x.db")) as store:
        rows = list(store.rows())
        store.all("UPDATE legs SET void = 'a worker was lost' WHERE pair = 1 AND leg = 0")
    assert verb(name, *words).code == first.code
    with Store(Path("x.db")) as store:
        assert [row.result for row in store.rows()] == [row.result for row in rows]


def test_matches_are_told_as_the_candidate_saw_them(regress):
    words = ("old.py", "new.py", "--pairs", "20")
    with_base, against = regress(*words), regress(*words, "--against", "weak.py")
    with Store(Path("old-new.db")) as store:
        bundles = {bundle.name: sha for sha, bundle in store.bundles().items()}
        rows = [row for row in store.rows() if bundles["old.py"] in (row.home, row.away)]
    mine = [row for row in rows if bundles["new.py"] in (row.home, row.away)]
    scores = [row.score if row.home == bundles["new.py"] else row.score[::-1] for row in mine]
    won, lost = sum(us > them for us, them in scores), sum(us < them for us, them in scores)
    goals = [sum(score[k] for score in scores) for k in (0, 1)]
    told = f"{won} won, {40 - won - lost} drawn, {lost} lost, goals {goals[0]}:{goals[1]}"
    assert told in " ".join(with_base.out.split())
    assert won > lost
    assert "matches new.py " in " ".join(against.out.split())
    assert "; old.py " in " ".join(against.out.split())


def test_changed_code_is_played_anew(regress, tmp_path):
    first = told(regress("old.py", "new.py", "--json"))
    (tmp_path / "new.py").write_text((tmp_path / "old.py").read_text() + "# GOOD and FAULTY\n")
    second = told(regress("old.py", "new.py", "--json"))
    assert (first["verdict"], second["verdict"]) == ("PASS", "INVALID")


def test_ctrl_c_keeps_what_is_through_and_says_how_to_go_on(regress, monkeypatch):
    from soccersim.regress.campaign import Campaign

    take, calls = Campaign.take, iter(range(7))

    def stopped(self, leg, row):
        if next(calls, None) is None:
            raise KeyboardInterrupt
        return take(self, leg, row)

    monkeypatch.setattr(Campaign, "take", stopped)
    ended = regress("old.py", "new.py", "--jobs", "1")
    assert (ended.code, ended.out) == (130, "")
    assert ended.lines[-1] == (
        "stopped after 3 of 400 pairs; old-new.db keeps 8 matches: the same command goes on from "
        "there"
    )


def test_against_others_both_meet_the_same_teams(regress):
    words = ("old.py", "new.py", "--against", "weak.py", "other.py", "--pairs", "10", "--json")
    document = told(regress(*words))
    assert document["against"] == ["weak.py", "other.py"]
    assert sum(document["pentanomial"]) == sum(document["base_pentanomial"]) == 20
    assert document["verdict"] in ("PASS", "INCONCLUSIVE")
    with Store(Path("old-new.db")) as store:
        assert store.count() == 10 * 2 * 2 * 2
    assert "of the base " in regress(*words[:-1]).out
    same = told(regress("old.py", "old.py", *words[2:]))
    assert same["verdict"] == "IDENTICAL"


def test_opponents_at_fault_do_not_make_it_invalid(regress):
    document = told(regress("old.py", "new.py", "--against", "bad.py", "--pairs", "8", "--json"))
    assert document["verdict"] != "INVALID"
    assert {fault["as"] for fault in document["faults"]} == {"opponent"}


def test_options_are_the_teams_own_and_make_other_matches(regress):
    words = ("roles", "roles", "--pairs", "8", "--json")
    assert told(regress(*words))["verdict"] == "IDENTICAL"
    with Store(Path("roles-roles.db")) as store:
        assert store.count() == 16
    regress(*words, "--set", 'match.away.options={"speed": 0.9}')
    with Store(Path("roles-roles.db")) as store:
        assert store.count() == 32


def test_strict_lets_nothing_unclear_pass(regress):
    words = ("old.py", "other.py", "--max-pairs", "8")
    assert regress(*words).code == 0
    assert regress(*words, "--strict").code == 1


def test_report_and_junit_are_written_and_written_again(regress, tmp_path):
    words = ("old.py", "new.py", "--junit", "out.xml", "--report", "out.html")
    for _ in range(2):
        ended = regress(*words)
        assert ended.code == 0
        assert ended.lines[-2:] == ["wrote out.html", "wrote out.xml"]
        assert "PASS" in (tmp_path / "out.html").read_text()
        assert (tmp_path / "out.xml").read_text().startswith("<?xml")


def test_the_pairs_that_differ_most_are_filmed_for_the_report(regress, tmp_path):
    words = ("old.py", "new.py", "--report", "out.html", "--pairs", "20")
    assert regress(*words, "--keep", "none").lines[1:] == ["wrote out.html"]
    plain = regress(*words[:2], *words[4:], "--json")
    ended = regress(*words, "--json")
    assert ended.lines[0] == "playing 12 matches again, for their replays"
    assert told(ended) == told(plain)
    with Store(tmp_path / "old-new.db") as store:
        filmed = [row for row in store.rows() if row.recording]
        assert store.contradictions() == []
    assert len(filmed) == 12
    assert {row.pair for row in filmed} == {
        row.pair for row in filmed if row.score[0] != row.score[1]
    }
    assert len(list((tmp_path / "old-new.db.recordings").iterdir())) == 12
    assert "playing" not in regress(*words).err


def test_a_match_that_is_another_when_it_is_filmed_makes_it_invalid(regress, strategies):
    strategies(shy="GOOD SHY")
    words = ("old.py", "shy.py", "--pairs", "20")
    assert regress(*words).code == 0
    ended = regress(*words, "--report", "out.html")
    assert ended.code == 4
    assert "was played twice and came out differently" in ended.out
