"""Matches on this machine: what a team does costs its own match alone, and nothing is left over.

The matches are quick ones (quick.py), but for the last.
"""

import os
import time
from dataclasses import replace
from pathlib import Path

import pytest
from living import descendants, has_ended_soon

from soccersim import load_scenario
from soccersim.match import stopwatch
from soccersim.match.play import play_match
from soccersim.problems import InputError
from soccersim.regress.bundle import Bundle, bundle
from soccersim.regress.ground import Ground
from soccersim.regress.leg import pair_of
from soccersim.regress.pool import LocalPool
from soccersim.regress.runner import run
from soccersim.regress.store import Store
from soccersim.regress.warm import CAN_FORK

RUSH = str(Path(__file__).parents[1] / "match" / "teams" / "rush.py")
FORKS = pytest.mark.skipif(not CAN_FORK, reason="forks")
HOWS = pytest.mark.parametrize("fork", [pytest.param(True, marks=FORKS), False])


@pytest.fixture
def store(tmp_path):
    with Store(tmp_path / "results.db") as opened:
        yield opened


def results(rows):
    """All of them that must come out the same."""
    return sorted(row.result for row in rows)


def test_rows_are_the_same_from_one_job_or_three_forked_or_reused(legs, pool, tmp_path):
    tables = []
    for at, (jobs, more) in enumerate(((1, {}), (3, {}), (2, {"fork": False}))):
        with Store(tmp_path / f"{at}.db") as store, pool(jobs, **more) as local:
            rows = [row for _, row in run(legs(4), store, local)]
            assert results(store.rows()) == results(rows)
            tables.append(results(rows))
    assert len(tables[0]) == 8
    assert tables[0] == tables[1] == tables[2]
    assert len({row[6] for row in tables[0]}) == 8  # no two digests are the same
    for row in rows:
        assert 0 < row.seconds < 5
        assert 0 < row.overhead < 60
        assert row.events


POISONS = {
    "raise ValueError('mine')": "exception",
    "return None": "bad_command",
    "os._exit(3)": "exit",
    "ctypes.string_at(0)": "crash",
    "while True: pass": "deadline",
    "os.kill(os.getpid(), 9)": "crash",
}


@pytest.mark.parametrize(
    "fork", [pytest.param(True, marks=FORKS), pytest.param(False, marks=pytest.mark.slow)]
)
def test_a_poisonous_team_among_eighty_good_matches_costs_only_its_own(
    legs, pool, store, team, monkeypatch, fork, tmp_path
):
    monkeypatch.setattr(stopwatch, "DECISION", 0.5)
    good = legs(40)
    evil = [legs(1, team(trick, f"poison{at}.py"))[at % 2] for at, trick in enumerate(POISONS)]
    mixed = [*good[:20], *evil[:3], *good[20:50], *evil[3:], *good[50:]]
    with pool(2, fork=fork) as local:
        rows = {leg.key: row for leg, row in run(mixed, store, local)}
    assert len(rows) == 86
    for leg in good:
        row = rows[leg.key]
        assert (row.faults, row.void, row.again) == ((), "", ""), row
    for at, (leg, kind) in enumerate(zip(evil, POISONS.values(), strict=True)):
        row = rows[leg.key]
        (fault,) = row.faults
        assert (fault["side"], fault["kind"]) == (("home", "away")[at % 2], kind)
        assert row.score == ((0, 3), (3, 0))[at % 2]
        assert str(tmp_path) not in fault["detail"]
    assert "poison0.py" in rows[evil[0].key].faults[0]["detail"]


@pytest.mark.slow
@HOWS
def test_who_eats_the_memory_costs_its_own_too(legs, pool, store, team, fork):
    eater = team("self.hoard = [bytearray(2**26) for _ in range(999)]", "eater.py")
    with pool(2, fork=fork) as local:
        rows = [row for _, row in run([*legs(1, eater), *legs(3)], store, local)]
    bad = [row for row in rows if row.faults]
    assert [(row.pair, len(row.faults)) for row in bad] == [(0, 1), (0, 1)]
    assert {row.faults[0]["kind"] for row in bad} <= {"memory", "deadline"}
    assert {row.faults[0]["side"] for row in bad} == {"home", "away"}
    assert len(rows) == 8


def test_what_teams_start_and_leave_ends_with_their_match(legs, pool, store, team, tmp_path):
    code = f"""\
    for session in (False, True):
        child = subprocess.Popen(["sleep", "99"], start_new_session=session)
        print(child.pid, file=open(r"{tmp_path}/pids", "a"))
    return fine"""
    with pool(2) as local:
        rows = [
            row for _, row in run(legs(2, team(code, "a.py"), team(code, "b.py")), store, local)
        ]
        pids = [int(line) for line in (tmp_path / "pids").read_text().split()]
        assert len(pids) == 16
        assert has_ended_soon(*pids, seconds=1)
    assert not any(row.faults for row in rows)


@HOWS
def test_who_has_seen_enough_ends_what_still_runs_at_once(legs, pool, store, team, fork):
    slow = team("time.sleep(1) if view.time else 0\nself.asked -= 1\nreturn fine", "slow.py")
    asked = [*legs(1), *legs(1, slow)]
    start = time.monotonic()
    with pool(3, fork=fork) as local:
        first = time.monotonic() - start
        rows = run(asked, store, local)
        next(rows)
        mine = descendants(os.getpid())
        assert mine
        rows.close()
        start = time.monotonic()
    assert time.monotonic() - start < 5 + first
    assert has_ended_soon(*mine)
    assert store.count() < 4


def test_recordings_are_kept_as_was_asked(legs, pool, tmp_path, team):
    evil = team("raise ValueError", "evil.py")
    for keep in ("none", "faults", "lost", "all"):
        with Store(tmp_path / f"{keep}.db") as store, pool() as local:
            asked = [*legs(3, keep=keep, watched=0), *legs(1, evil, keep=keep, watched=0)]
            for leg, row in run(asked, store, local):
                mine, its = row.score[leg.leg], row.score[1 - leg.leg]
                wanted = {
                    "faults": bool(row.faults),
                    "lost": mine < its,
                    "all": True,
                    "none": False,
                }
                assert bool(row.recording) == wanted[keep]
                if row.recording:
                    folder = tmp_path / f"{keep}.db.recordings"
                    data = (folder / row.recording).read_text()
                    assert data == f"recording of {row.digest}"


@HOWS
def test_a_strategy_that_is_not_there_is_bad_input(legs, pool, store, tmp_path, fork):
    (tmp_path / "empty.py").write_text("x = 1")
    with (
        pool(fork=fork) as local,
        pytest.raises(InputError, match=r"empty\.py: defines no class with a method decide"),
    ):
        list(run(legs(1, bundle(str(tmp_path / "empty.py"))), store, local))
    assert store.count() == 0


def test_another_soccersim_on_a_machine_of_a_cluster_is_refused(legs, pool, store):
    with pool() as local, pytest.raises(InputError, match="another soccersim, or another platform"):
        list(run([replace(leg, engine="older") for leg in legs(1)], store, local))


def test_a_damaged_bundle_is_refused(legs, pool, store):
    with pool() as local, pytest.raises(InputError, match="broken: is a damaged bundle"):
        list(run([replace(leg, home=Bundle("broken", b"")) for leg in legs(1)], store, local))


def test_folders_of_runs_that_were_killed_are_taken_away_and_no_others(pool, tmp_path):
    with pool() as local:
        ended = local.ground.folder.with_name("soccersim-run-ended")
        (ended / "leg").mkdir(parents=True)
        with pool():
            assert not ended.exists()
            assert local.ground.folder.exists()


def test_a_warm_match_is_the_match_that_any_process_plays(store):
    spec = load_scenario("friendly-match", settings=["duration=4"])
    legs = pair_of(spec, (bundle(RUSH), bundle("still")), 0, 3, keep="all")
    with LocalPool(2, Ground(legs[0].scenario)) as local:
        rows = {leg.leg: row for leg, row in run(legs, store, local)}
    for at, teams in enumerate(((RUSH, "still"), ("still", RUSH))):
        cold = play_match(*teams, "friendly-match", seed=3, duration=4)
        assert (rows[at].digest, rows[at].score) == (cold.digest, cold.score)
        assert list(rows[at].events) == cold.events
        assert rows[at].duration == cold.duration == 4.0
