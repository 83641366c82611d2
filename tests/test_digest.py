"""The digest: one run, one chain of SHA-256, however and wherever it is run."""

import hashlib
import json
import os
import subprocess
import sys

import numpy as np
import pytest

from soccersim import Simulation, load_scenario
from soccersim.record.digest import Digest, fingerprint
from soccersim.render.frames import save_frames

# robots that push each other and the ball from the first second on
CROWD = ("duration=1.2", "ball={at: [0, 0.35], velocity: [0, -1]}")
STARTS = [
    f"robots.{i}.start=[{x}, {y}, 0]"
    for i, (x, y) in enumerate([(-0.3, 0), (0.3, 0), (-0.3, 0.6), (0.3, 0.6)])
]
RUNS = {
    "defender": ("duration=2",),
    "kickabout": (*CROWD, *STARTS),
    "one-of-everything": ("duration=1",),
}


def digest(name):
    return Simulation(load_scenario(name, settings=RUNS[name])).run().digest


@pytest.fixture(scope="module")
def digests():
    return {name: digest(name) for name in RUNS}


def touching(recording):
    """How many records show two bodies in touch."""
    scenario = recording.scenario
    radii = np.array([r.model.radius for r in scenario.robots] + [scenario.ball.radius])
    place = recording.body[:, :, 0] + 1j * recording.body[:, :, 1]
    apart = np.abs(place[:, :, None] - place[:, None, :]) + 9 * np.eye(len(radii))
    return int((apart < np.add.outer(radii, radii) + 0.001).any(axis=(1, 2)).sum())


def test_the_crowd_does_collide():
    recording = Simulation(load_scenario("kickabout", settings=RUNS["kickabout"])).run()
    assert touching(recording) > 20


@pytest.mark.parametrize("name", RUNS)
def test_the_same_run_has_the_same_digest_also_after_others(digests, name):
    digest("one-of-everything")
    assert digest(name) == digests[name]


@pytest.mark.parametrize("name", RUNS)
def test_each_seed_has_its_own_digest(digests, name):
    words = [*RUNS[name], "seed=77"]
    assert Simulation(load_scenario(name, settings=words)).run().digest != digests[name]


def test_every_number_of_every_record_counts():
    rng = np.random.default_rng(1)
    arrays = [rng.normal(size=(5, 3, 6)), rng.normal(size=(5, 2))]

    def chain(*pieces):
        link = Digest()
        for start, stop in pieces:
            link.add([a[start:stop] for a in arrays])
        return link.hex

    whole = chain((0, 5))
    assert chain((0, 2), (2, 5)) == whole  # however it is cut
    for array in arrays:
        for index in ((0, 0), (4, 1)):
            array[index] = np.nextafter(array[index], 9)
            assert chain((0, 5)) != whole
            array[index] = np.nextafter(array[index], -9)
    assert chain((0, 5)) == whole
    assert chain((0, 4)) != whole


def test_the_chain_is_what_the_page_says():
    body, wheel = np.arange(12.0).reshape(2, 1, 6), np.arange(2.0).reshape(2, 1, 1)
    link = hashlib.sha256(b"soccersim 1").digest()
    for row in range(2):
        numbers = np.concatenate([body[row].ravel(), wheel[row].ravel()]).astype("<f8")
        link = hashlib.sha256(link + numbers.tobytes()).digest()
    chain = Digest()
    chain.add([body, wheel])
    assert chain.hex == link.hex()


@pytest.mark.parametrize("name", RUNS)
def test_a_digest_can_be_recomputed_from_the_recording(digests, name):
    arrays = Simulation(load_scenario(name, settings=RUNS[name])).run().arrays
    chain = Digest()
    chain.add([arrays[key] for key in ("body", "wheel_angle", "wheel_speed", "estimate")])
    assert chain.hex == digests[name]


@pytest.mark.parametrize("name", RUNS)
def test_a_run_may_be_cut_into_steps_of_any_size(digests, name):
    simulation = Simulation(load_scenario(name, settings=RUNS[name]))
    sizes = np.random.default_rng(3).choice([1, 1, 2, 3, 7, 64, 250], 10_000)
    for size in map(int, sizes):
        if simulation.done:
            break
        simulation.advance(size)
    assert simulation.done
    assert simulation.recording().digest == digests[name]


def test_looking_at_a_run_changes_nothing(digests, tmp_path):
    simulation = Simulation(load_scenario("kickabout", settings=RUNS["kickabout"]))
    while not simulation.done:
        simulation.advance(400)
        save_frames(simulation.recording(), tmp_path / "frames")
        json.dumps(simulation.recording().meta)
    assert simulation.recording().digest == digests["kickabout"]


def test_two_runs_side_by_side_do_not_feel_each_other(digests):
    pair = [Simulation(load_scenario(name, settings=RUNS[name])) for name in RUNS]
    while not all(each.done for each in pair):
        for each in pair:
            each.advance(33)
    assert [each.recording().digest for each in pair] == list(digests.values())


CHILD = """
import json, sys
from soccersim import Simulation, load_scenario
runs = json.loads(sys.argv[1])
digest = lambda name: Simulation(load_scenario(name, settings=runs[name])).run().digest
print(json.dumps({name: digest(name) for name in runs}))
"""
ELSEWHERE = {
    "hash seed 0": {"PYTHONHASHSEED": "0"},
    "hash seed 1": {"PYTHONHASHSEED": "1"},
    "hash seed random": {"PYTHONHASHSEED": "random"},
    "plain Python": {"NUMBA_DISABLE_JIT": "1"},
}


def test_other_processes_hash_seeds_and_plain_python_give_the_same_digests(digests):
    children = {
        how: subprocess.Popen(
            [sys.executable, "-c", CHILD, json.dumps(RUNS)],
            env={**os.environ, **environment},
            stdout=subprocess.PIPE,
            text=True,
        )
        for how, environment in ELSEWHERE.items()
    }
    told = {how: json.loads(child.communicate()[0]) for how, child in children.items()}
    assert told == dict.fromkeys(ELSEWHERE, digests)


def test_a_recording_says_for_which_platform_its_digest_holds(digests):
    recording = Simulation(load_scenario("linear", settings=["duration=0.1"])).run()
    assert recording.meta["platform"] == fingerprint()
    needed = {"os", "machine", "libc", "cpu", "python", "numpy", "pymunk", "numba"}
    assert set(fingerprint()) == needed
    assert all(fingerprint().values())
