"""A run plays what is missing, in order, and never blames a team for what a machine did."""

import time
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace

import pytest

from soccersim.problems import InputError, MachineError, Problem
from soccersim.regress import runner
from soccersim.regress.job import Lost, Played
from soccersim.regress.row import Row
from soccersim.regress.runner import TRIES, run
from soccersim.regress.store import Store


@pytest.fixture(autouse=True)
def _hasty(monkeypatch):
    monkeypatch.setattr(runner, "PAUSE", 0.0)


@pytest.fixture
def store(tmp_path):
    with Store(tmp_path / "results.db") as opened:
        yield opened


def row(leg, **changes):
    """What a leg comes to where nothing goes wrong."""
    teams = leg.home.sha, leg.away.sha
    told = Row(leg.key, leg.pair, leg.leg, leg.seed, *teams, (1, 0), f"d{leg.pair}", 60.0, (), ())
    return replace(told, **changes)


def fine(leg, alone):
    return Played(row(leg))


def fault(kind, detail="", side="home"):
    return ({"side": side, "kind": kind, "tick": 20, "detail": detail},)


def places(rows):
    return [(leg.pair, leg.leg) for leg, _ in rows]


def test_all_legs_are_played_once_in_their_order(legs, store, told):
    pool = told(fine)
    rows = list(run(legs(3), store, pool))
    assert sorted(places(rows)) == [(pair, leg) for pair in range(3) for leg in (0, 1)]
    assert pool.begun == [(pair, leg, False) for pair in range(3) for leg in (0, 1)]
    assert [row for _, row in sorted(rows, key=lambda pair: pair[0].key)] == sorted(
        store.rows(), key=lambda row: row.key
    )


def test_the_same_call_goes_on_where_it_stopped(legs, store, told):
    first = run(legs(3), store, told(fine))
    seen = [next(first)[1] for _ in range(3)]
    first.close()
    pool = told(fine)
    rows = [row for _, row in run(legs(3), store, pool)]
    assert {row.key for row in seen} <= {row.key for row in rows}
    assert len(rows) == 6
    assert len(pool.begun) == 3
    assert list(run(legs(3), store, pool))
    assert len(pool.begun) == 3


def test_changed_code_never_mixes_with_old_rows(legs, store, told, team):
    list(run(legs(2), store, told(fine)))
    pool = told(fine)
    rows = list(run(legs(2, team("return fine  # changed")), store, pool))
    assert len(pool.begun) == len(rows) == 4
    assert store.count() == 8


def test_a_match_that_is_asked_for_twice_is_played_once(legs, store, told):
    pool = told(fine)
    twice = legs(2) + [replace(leg, pair=leg.pair + 7) for leg in legs(2)]
    assert sorted(places(run(twice, store, pool))) == sorted((leg.pair, leg.leg) for leg in twice)
    assert len(pool.begun) == store.count() == 4


class Slow:
    """A pool whose first leg is over when it is let go."""

    width, quiet = 2, True

    def __init__(self):
        self.first, self.legs = Future(), []

    def submit(self, leg, alone):
        self.legs.append(leg)
        if len(self.legs) == 1:
            return self.first
        future = Future()
        future.set_result(fine(leg, alone))
        return future


def test_nobody_plays_far_ahead_of_a_leg_that_is_missing(legs, store):
    pool = Slow()
    rows = run(legs(20), store, pool, ahead=6)
    assert len([next(rows) for _ in range(5)]) == len(pool.legs) - 1 == 5
    pool.first.set_result(fine(pool.legs[0], False))
    assert len(list(rows)) == 35
    assert len(pool.legs) == 40


def test_legs_without_end_are_begun_as_they_are_needed(legs, store, told):
    def endless():
        number = 0
        while True:
            yield from (replace(leg, seed=number, pair=number) for leg in legs(1))
            number += 1

    rows = run(endless(), store, told(fine))
    assert len([next(rows) for _ in range(50)]) == 50
    rows.close()


@pytest.mark.parametrize("kind", ["deadline", "memory", "crash"])
def test_a_doubtful_match_is_repeated_when_alone(legs, store, told, kind):
    def doubtful(leg, alone):
        if leg.pair == 1 and not alone:
            return Played(row(leg, score=(0, 3), faults=fault(kind)), f"home: {kind}")
        return fine(leg, alone)

    pool = told(doubtful)
    rows = {(leg.pair, leg.leg): row for leg, row in run(legs(4), store, pool)}
    assert all(not row.faults and row.score == (1, 0) for row in rows.values())
    assert {at for at, row in rows.items() if row.again == f"home: {kind}"} == {(1, 0), (1, 1)}
    assert [at for at in pool.begun if at[2]] == [(1, 0, True), (1, 1, True)]


class Crowded:
    """A pool of three threads that writes down who plays at the same time."""

    width, quiet = 3, True

    def __init__(self, what):
        self.what, self.threads = what, ThreadPoolExecutor(3)
        self.now, self.met = [], []

    def submit(self, leg, alone):
        return self.threads.submit(self.play, leg, alone)

    def play(self, leg, alone):
        self.now.append(alone)
        self.met.append(list(self.now))
        time.sleep(0.02)
        self.met.append(list(self.now))
        self.now.remove(alone)
        return self.what(leg, alone)


def test_it_is_alone_indeed(legs, store):
    def doubtful(leg, alone):
        return Played(row(leg), "" if alone or leg.pair % 2 else "home: deadline")

    pool = Crowded(doubtful)
    with pool.threads:
        rows = list(run(legs(6), store, pool))
    assert len(rows) == 12
    assert sum(bool(row.again) for _, row in rows) == 6
    assert max(map(len, pool.met)) == 3
    assert [each for each in pool.met if True in each] == [[True]] * 12


def test_what_happens_again_when_alone_is_the_teams_fault(legs, store, told):
    def slow(leg, alone):
        return Played(row(leg, score=(0, 3), faults=fault("deadline")), "home: deadline")

    pool = told(slow)
    for _, row_ in run(legs(1), store, pool):
        assert (row_.score, row_.faults, row_.void) == ((0, 3), fault("deadline"), "")
    assert len(pool.begun) == 4


def test_a_fault_without_doubt_counts_at_once(legs, store, told):
    pool = told(lambda leg, alone: Played(row(leg, faults=fault("exception"))))
    assert all(row.faults and not row.again for _, row in run(legs(2), store, pool))
    assert len(pool.begun) == 4


def lost(times, how):
    """A machine that loses each leg so many times."""
    seen = {}

    def play(leg, alone):
        seen[leg.key] = seen.get(leg.key, 0) + 1
        if seen[leg.key] > times:
            return fine(leg, alone)
        if how == "lost":
            raise Lost("its machine is gone")
        if how == "disk":
            raise MachineError("/tmp: No space left on device")
        return Played(None, "its process was killed by SIGKILL, in nobody's turn")

    return play


@pytest.mark.parametrize("how", ["lost", "killed", "disk"])
@pytest.mark.parametrize("times", [1, TRIES - 1])
def test_what_the_machine_fails_to_play_is_tried_again(legs, store, told, how, times):
    rows = [row for _, row in run(legs(2), store, told(lost(times, how)))]
    assert len(rows) == 4
    assert all(row.score == (1, 0) and row.again and not row.void for row in rows)


@pytest.mark.parametrize("how", ["lost", "killed"])
def test_what_it_fails_to_play_each_time_is_void_and_nobodys_loss(legs, store, told, how):
    rows = [row for _, row in run(legs(1), store, told(lost(TRIES, how)))]
    assert len(rows) == 2
    for each in rows:
        assert (each.score, each.digest, each.faults) == ((0, 0), "", ())
        assert each.void in ("its machine is gone", lost(1, "killed")(legs(1)[0], False).doubt)
    assert list(store.rows()) == sorted(rows, key=lambda row: row.leg)


def test_a_disk_that_stays_full_ends_the_run_and_the_rest_is_played_later(legs, store, told):
    def full(leg, alone):
        if leg.pair == 1:
            raise MachineError("/tmp: No space left on device")
        return fine(leg, alone)

    with pytest.raises(MachineError, match="No space left"):
        list(run(legs(3), store, told(full)))
    before = list(store.rows())
    assert {row.pair for row in before} >= {0}
    rows = [row for _, row in run(legs(3), store, told(fine))]
    assert len(rows) == 6
    assert not any(row.void for row in rows)
    assert {row.key for row in before} <= {row.key for row in rows}


def test_a_store_on_a_full_disk_ends_the_run_and_keeps_what_it_has(legs, store, told):
    rows = run(legs(3), store, told(fine))
    kept = [next(rows)[1]]
    store.all(f"PRAGMA max_page_count = {store.all('PRAGMA page_count')[0][0]}")
    large = tuple({"kind": "x" * 999, "at": at**9} for at in range(999))
    with pytest.raises(MachineError, match="cannot be written"):
        list(run(legs(3), store, told(lambda leg, alone: Played(row(leg, events=large)))))
    assert list(store.rows()) == kept
    store.all("PRAGMA max_page_count = 1000000")
    assert len(list(run(legs(3), store, told(fine)))) == 6


def test_who_is_killed_from_outside_has_more_than_one_chance(legs, store, told):
    """SIGKILL may be a system whose memory is full; a team that kills itself does so each time."""
    killed = fault("crash", "its process was killed by SIGKILL")
    seen = []

    def kill(leg, alone):
        seen.append(leg.key)
        if leg.leg == 0 and seen.count(leg.key) > 2:
            return fine(leg, alone)
        return Played(row(leg, score=(0, 3), faults=killed), "home: crash")

    innocent, guilty = sorted(
        (row for _, row in run(legs(1), store, told(kill))), key=lambda r: r.leg
    )
    assert (innocent.faults, innocent.score) == ((), (1, 0))
    assert (guilty.faults, guilty.score, guilty.void) == (killed, (0, 3), "")


def test_a_strategy_that_is_not_there_ends_the_run(legs, store, told):
    def nothing(leg, alone):
        raise InputError(Problem("defines no class", "mine.py"))

    with pytest.raises(InputError, match="defines no class"):
        list(run(legs(1), store, told(nothing)))
    assert store.count() == 0


def test_legs_played_twice_show_who_does_not_play_the_same_match_twice(legs, store, told):
    seen = []

    def moody(leg, alone):
        seen.append(leg.key)
        return Played(row(leg, digest=f"{leg.key} {seen.count(leg.key) if leg.pair == 2 else 0}"))

    pool = told(moody)
    rows = list(run(legs(4), store, pool, twice=2))
    assert len(rows) == store.count() == 8
    assert len(pool.begun) == 12
    (found,) = store.contradictions()
    assert (found.pair, found.leg, found.first[-1], found.digest[-1]) == (2, 0, "1", "2")


def test_recordings_are_kept_beside_the_store_whole_and_before_their_rows(
    legs, store, told, monkeypatch
):
    def recorded(leg, alone):
        return Played(row(leg), "", b"recording of it" if leg.leg else b"")

    folder = store.path.with_name("results.db.recordings")
    for leg, each in run(legs(2), store, told(recorded)):
        assert bool(each.recording) == bool(leg.leg)
        if leg.leg:
            assert (folder / each.recording).read_bytes() == b"recording of it"
    assert len(list(folder.iterdir())) == 2

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    more = legs(3)[4:]
    with pytest.raises(MachineError, match=r"pair-000002-leg-1-.*\.npz: No space left"):
        list(run(more, store, told(recorded)))
    assert len(list(folder.iterdir())) == 2
    assert store.count() == 5


def test_the_time_of_the_store_is_in_the_overhead(legs, store, told):
    store.seconds = 5.0
    rows = run(legs(1), store, told(lambda leg, alone: Played(row(leg, overhead=0.25))))
    assert next(rows)[1].overhead == 5.25
    assert 0.25 < next(rows)[1].overhead < 5.25
