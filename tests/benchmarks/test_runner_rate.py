"""What a run costs besides its matches, and what a second processor brings."""

import os
import time

import pytest

from soccersim import load_scenario
from soccersim.regress.bundle import bundle
from soccersim.regress.ground import Ground
from soccersim.regress.leg import pair_of
from soccersim.regress.pool import LocalPool
from soccersim.regress.runner import run
from soccersim.regress.store import Store
from soccersim.regress.warm import CAN_FORK

pytestmark = [
    pytest.mark.benchmark,
    pytest.mark.skipif(not CAN_FORK, reason="processes that fork"),
]
TURNS = 4  # of one job, then two; the best of each counts: whoever else is here takes from both
PAIRS = 6


@pytest.fixture(scope="module")
def turns(tmp_path_factory):
    """Matches of 60 s: for each turn and number of jobs seconds a match, and the rows."""
    folder = tmp_path_factory.mktemp("stores")
    spec = load_scenario("friendly-match", settings=["duration=60"])
    teams = bundle("roles"), bundle("chaser")
    legs = [leg for number in range(PAIRS) for leg in pair_of(spec, teams, number, number)]
    found = {1: [], 2: []}
    for turn in range(TURNS):
        for jobs, taken in found.items():
            path = folder / f"{turn}-{jobs}.db"
            with Store(path) as store, LocalPool(jobs, Ground(legs[0].scenario)) as pool:
                start = time.perf_counter()
                rows = [row for _, row in run(legs, store, pool)]
                taken.append(((time.perf_counter() - start) / len(rows), rows))
    return found


def test_process_and_store_cost_less_than_0_35_seconds_a_match(turns):
    rows = [row for taken in turns.values() for _, rows in taken for row in rows]
    best = min(
        sum(row.overhead for row in rows) / len(rows)
        for taken in turns.values()
        for _, rows in taken
    )
    print(
        f"overhead a match: {sum(row.overhead for row in rows) / len(rows):.3f} s, best {best:.3f}"
    )
    assert best < 0.35


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="two processors")
def test_two_jobs_play_1_8_times_the_matches_of_one(turns):
    one, two = (min(seconds for seconds, _ in turns[jobs]) for jobs in (1, 2))
    print(
        f"matches an hour: {3600 / one:.0f}, with two jobs {3600 / two:.0f}: {one / two:.2f} times"
    )
    assert one / two >= 1.8
