"""How fast the simulator is on this machine: ratios within one run, and the issue's own limits."""

import json
import os
import subprocess
import sys

import pytest

from soccersim.bench import measure

pytestmark = pytest.mark.benchmark


@pytest.fixture(scope="module")
def bench():
    return measure(60.0, lambda share: None)


def test_a_tick_costs_little_more_than_bare_pymunk(bench):
    assert bench["tick_over_floor"] <= 2.5


def test_ten_robots_run_at_150_times_real_time(bench):
    assert bench["robots"] == 10
    assert bench["realtime_factor"] >= 150


def test_the_race_is_run_with_about_one_contact_a_tick(bench):
    assert 0.5 < bench["contacts"] < 3


def test_time_grows_no_faster_than_the_number_of_robots(bench):
    assert bench["growth_10_to_22"] <= 2.5


def test_frames_are_drawn_at_400_a_second(bench):
    assert bench["frames_per_second"] >= 400


WATCH = """
import json, os, subprocess, sys
words = [sys.executable, "-m", "soccersim", *sys.argv[1:]]
child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
_, code, used = os.wait4(child.pid, 0)
child.returncode = 0
print(json.dumps([used.ru_utime + used.ru_stime, used.ru_maxrss / 1000]))
"""


def spent(*words, times=3, **more):
    """Seconds of CPU time and the most MB that a command takes: the best of a few.

    A small process starts it, since a child's memory counts from that of its parent on.
    """
    watch = [sys.executable, "-c", WATCH, *map(str, words)]
    runs = (subprocess.run(watch, capture_output=True, check=True, **more) for _ in range(times))
    return min(tuple(json.loads(run.stdout)) for run in runs)


def test_kickabout_holds_less_than_250_mb():
    assert spent("run", "kickabout", "--json")[1] < 250


def test_bench_itself_holds_less_than_250_mb(tmp_path):
    ended = subprocess.run(
        [sys.executable, "-m", "soccersim", "bench", "--seconds", "20", "--json"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert json.loads(ended.stdout)["memory_mb"] < 250


def test_help_takes_less_than_0_3_seconds():
    assert spent("--help")[0] < 0.3


def test_defender_takes_less_than_5_seconds_with_its_files(tmp_path):
    assert spent("run", "defender", "--out", tmp_path, "--force")[0] < 5


def test_a_first_run_compiles_in_less_than_25_seconds(tmp_path):
    cold = {**os.environ, "SOCCERSIM_CACHE": str(tmp_path)}
    assert spent("run", "defender", times=1, env=cold)[0] < 25


BAD = {
    "brackets": "[" * 50_000,
    "many legs": "robots: [" + "{to: [1, 2, 3]}, " * 1400 + "]",
    "many keys": "".join(f"k{i}: {i}\n" for i in range(5900)),
    "many words": "x: [" + "a, " * 11_000 + "]",
    "one long text": "x: " + "a" * 90_000,
}


@pytest.mark.parametrize("name", BAD)
def test_the_worst_file_is_refused_within_a_second(tmp_path, name):
    (tmp_path / "bad.yaml").write_text(BAD[name])
    seconds, megabytes = spent("run", "./bad.yaml", cwd=tmp_path)
    assert seconds < 1
    assert megabytes < 200


def test_a_sparse_file_of_200_mb_is_refused_within_a_second(tmp_path):
    with open(tmp_path / "large.yaml", "wb") as file:
        file.truncate(200_000_000)
    assert spent("run", "./large.yaml", cwd=tmp_path)[0] < 1
