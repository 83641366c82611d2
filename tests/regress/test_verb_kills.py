"""The command line under kills, a full disk and a second run: what was played stays, once."""

import json
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

pytestmark = [
    pytest.mark.slow,  # test_kills.py has a few kills for every day
    pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc"),
]
SECONDS = 900  # that a command may take, also on a machine that does much else


@pytest.fixture
def soccersim(tmp_path):
    """Starts a command line in an empty folder; and the mark of all processes that it starts."""
    mark = uuid.uuid4().hex
    (tmp_path / "tmp").mkdir()
    env = {**os.environ, "TMPDIR": str(tmp_path / "tmp"), "CAMPAIGN": mark}

    def start(*words, limit=None):
        return subprocess.Popen(
            [sys.executable, "-m", "soccersim", *map(str, words)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            cwd=tmp_path,
            env=env,
            preexec_fn=limit,
        )

    start.mark = mark
    yield start
    pids = marked(mark)
    for pid in pids:
        os.kill(pid, signal.SIGKILL)
    assert pids == []
    assert list((tmp_path / "tmp").iterdir()) == []


def words(seed, pairs, results, keep="all"):
    """A regression of real matches, a fraction of a second each."""
    return (
        *("regress", "chaser", "roles", "--scenario", "friendly-match", "--duration", "4"),
        *("--seed", seed, "--pairs", pairs, "--keep", keep, "--results", results, "--json"),
    )


def told(process):
    """The document of a command that has come to its end, without what tells how it came there."""
    out, err = process.communicate(timeout=SECONDS)
    assert process.returncode == 0, err
    document = json.loads(out)
    del document["matches"], document["results"]
    return document


def disturbed(soccersim, chance, kills, asked):
    """Run the same command until so many kills are through, or it ends by itself before that.

    Returns the kills that are left, and what the last one told. Whose processes are killed again
    and again before they have loaded gives up, as a machine that fails: exit code 3.
    """
    process = soccersim(*asked)
    while kills:
        try:
            process.wait(1.0 + 3.0 * chance.random())
        except subprocess.TimeoutExpired:
            kills -= 1
            if not killed(chance, process, soccersim.mark):
                continue
        if process.poll() == 0:
            break
        _, err = process.communicate()
        assert process.returncode in (-signal.SIGKILL, 3), err
        assert has_ended_soon(*marked(soccersim.mark))
        process = soccersim(*asked)
    return kills, told(process)


def test_killed_fifty_times_it_tells_what_an_undisturbed_run_tells(soccersim, tmp_path):
    kills, pairs, seed = 50, 40, 0
    chance = random.Random(kills)
    while kills:
        calm = told(soccersim(*words(seed, pairs, "calm.db")))
        kills, document = disturbed(soccersim, chance, kills, words(seed, pairs, "killed.db"))
        assert document == calm
        seed += pairs
    stores = []
    for name in ("calm.db", "killed.db"):
        with Store(tmp_path / name) as store:
            rows = list(store.rows())
        assert len(rows) == 2 * seed
        assert all((tmp_path / f"{name}.recordings" / row.recording).is_file() for row in rows)
        stores.append([(row.result, row.recording) for row in rows])
    assert stores[0] == stores[1]


def test_a_full_disk_is_exit_code_three_and_it_goes_on_when_there_is_room(soccersim, tmp_path):
    import resource

    asked = words(0, 20, "results.db", "none")
    calm = told(soccersim(*words(0, 20, "calm.db", "none")))
    told(soccersim(*words(0, 2, "results.db", "none")))
    room = (tmp_path / "results.db").stat().st_size + 8192

    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

    full = soccersim(*asked, limit=limit)
    out, err = full.communicate(timeout=SECONDS)
    assert (full.returncode, out) == (3, "")
    assert len(err.splitlines()) == 2
    assert "results.db: cannot be written" in err
    with Store(tmp_path / "results.db") as store:
        before = [row.result for row in store.rows()]
    assert 4 < len(before) < 40
    assert told(soccersim(*asked)) == calm
    with Store(tmp_path / "results.db") as store:
        after = [row.result for row in store.rows()]
    assert len(after) == 40
    assert all(result in after for result in before)


def test_a_second_run_refuses_and_ctrl_c_says_how_to_go_on(soccersim, tmp_path):
    asked = words(0, 400, "results.db")
    first = soccersim(*asked)
    recordings = Path(tmp_path / "results.db.recordings")
    end = time.monotonic() + SECONDS
    while not recordings.exists() and time.monotonic() < end:
        time.sleep(0.05)
    second = soccersim(*asked)
    out, err = second.communicate(timeout=SECONDS)
    assert (second.returncode, out) == (2, "")
    assert err == "results.db: another run is using it: wait for that, or name another file\n"
    for pid in marked(soccersim.mark):  # as a terminal does
        try:
            os.kill(pid, signal.SIGINT)
        except ProcessLookupError:
            continue
    out, err = first.communicate(timeout=SECONDS)
    assert (first.returncode, out) == (130, "")
    assert err.splitlines()[-1].startswith("stopped after ")
    assert err.splitlines()[-1].endswith("matches: the same command goes on from there")
    with Store(tmp_path / "results.db") as store:
        assert 0 < store.count() < 800
