"""A run that is killed, at any moment and in any part, goes on as if nothing had been."""

import os
import random
import signal
import subprocess
import sys
import time
import uuid
from pathlib import Path

import pytest
from living import has_ended_soon, killed, marked

from soccersim.regress.store import Store

CAMPAIGN = str(Path(__file__).parent / "campaign.py")
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")
SLOW = "time.sleep(0.01)\nself.asked -= 1\nreturn fine"  # a quarter of a second a match


@pytest.fixture
def campaign(tmp_path, team):
    """Starts the program; and the mark of all processes that it starts."""
    mark = uuid.uuid4().hex
    team(SLOW, "one.py")
    team(SLOW.replace("return fine", "return fine[::-1]"), "two.py")
    (tmp_path / "tmp").mkdir()
    env = {**os.environ, "TMPDIR": str(tmp_path / "tmp"), "CAMPAIGN": mark}

    def start(name="results.db", pairs=20, child="quick", **more):
        words = [sys.executable, CAMPAIGN, str(tmp_path / name), str(tmp_path), str(pairs), child]
        return subprocess.Popen(
            words,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**env, **more},
        )

    start.mark = mark
    yield start
    pids = marked(mark)
    for pid in pids:
        os.kill(pid, signal.SIGKILL)
    assert pids == []


def whole(process):
    """Its lines, where it has come to its end."""
    out, err = process.communicate(timeout=500)
    assert (process.returncode, err) == (0, "")
    return out.splitlines()


def table(path):
    """What must come out the same; and nothing void."""
    with Store(path) as store:
        rows = sorted(store.rows(), key=lambda row: (row.pair, row.leg))
        assert store.contradictions() == []
    assert not any(row.void for row in rows)
    for row in rows:
        kept = path.with_name(f"{path.name}.recordings") / (row.recording or "none")
        assert kept.exists() == bool(row.recording)
    return [row.result for row in rows]


def disturbed(campaign, chance, kills, **more):
    """Run the same command until so many kills are through and it ends by itself."""
    process = campaign(**more)
    while kills:
        line = process.stdout.readline()  # something is won between two kills
        if not line:  # it has come to its end before
            break
        time.sleep(chance.random() * 0.8)
        kills -= 1
        if killed(chance, process, campaign.mark):
            process.communicate()
            assert has_ended_soon(*marked(campaign.mark))
            process = campaign(**more)
    whole(process)
    return kills


@pytest.mark.parametrize(
    ("kills", "pairs", "child"),
    [
        (4, 8, "quick"),
        pytest.param(50, 75, "quick", marks=pytest.mark.slow),
        pytest.param(50, 60, "real", marks=pytest.mark.slow),
    ],
)
def test_killed_at_random_it_comes_out_as_undisturbed(campaign, tmp_path, kills, pairs, child):
    calm = whole(campaign("calm.db", pairs, child))
    assert len(calm) == 2 * pairs
    chance = random.Random(kills + pairs)
    left = disturbed(campaign, chance, kills, pairs=pairs, child=child)
    assert left == 0
    assert table(tmp_path / "results.db") == table(tmp_path / "calm.db")
    assert (
        len(whole(campaign(pairs=pairs, child=child))) == 2 * pairs
    )  # all there: nothing is played
    assert list((tmp_path / "tmp").iterdir()) == []


@pytest.mark.slow
def test_a_full_disk_ends_it_with_three_and_it_goes_on_when_there_is_room(campaign, tmp_path):
    full = campaign(GROWTH=str(8192))
    out, err = full.communicate(timeout=200)
    assert full.returncode == 3
    assert "results.db: cannot be written" in err
    assert err.count("\n") == 1
    with Store(tmp_path / "results.db") as store:
        before = [row.result for row in store.rows()]
    assert 0 < len(out.splitlines()) == len(before) < 40
    assert len(whole(campaign())) == 40
    whole(campaign("calm.db"))
    after = table(tmp_path / "results.db")
    assert after == table(tmp_path / "calm.db")
    assert all(result in after for result in before)


def test_a_second_run_refuses_and_doubles_nothing(campaign, tmp_path):
    first = campaign(pairs=6)
    first.stdout.readline()
    second = campaign(pairs=6)
    out, err = second.communicate(timeout=100)
    assert (second.returncode, out) == (2, "")
    assert err.endswith("another run is using it: wait for that, or name another file\n")
    assert err.count("\n") == 1
    assert len(whole(first)) == 11
    assert len(table(tmp_path / "results.db")) == 12
