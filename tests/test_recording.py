"""Recordings: saved and read back whole, only what was asked for, and never a crash."""

import json
import os
import random
import re

import numpy as np
import pytest

from soccersim import Recording, Simulation, load_scenario
from soccersim.problems import InputError
from soccersim.record.recording import GROUPS


def simulate(*settings):
    return Simulation(load_scenario("one-of-everything", settings=settings)).run()


@pytest.fixture(scope="module")
def recording():
    return simulate("duration=1")


def test_what_is_saved_is_read_back_whole(recording, tmp_path):
    recording.save(tmp_path / "r.npz")
    again = Recording.load(tmp_path / "r.npz")
    assert again.meta == recording.meta == json.loads(json.dumps(recording.meta))
    assert again.scenario == recording.scenario
    assert again.arrays.keys() == recording.arrays.keys()
    for key, array in recording.arrays.items():
        assert array.dtype == again.arrays[key].dtype
        np.testing.assert_array_equal(array, again.arrays[key])


def test_the_shapes_are_those_of_records_bodies_robots_and_wheels(recording):
    records, robots, wheels = 50, 3, 6
    shapes = {
        "tick": (),
        "chain": (4,),
        "body": (robots + 1 + 2 * 3, 6),  # the ball and two arms of three links
        "joint": (2, 3),
        "estimate": (robots, 3),
        "reference": (robots, 3),
        "leg": (robots,),
        "gyro": (robots,),
        "command": (robots, 3),
    }
    for key, array in recording.arrays.items():
        assert array.shape == (records, *shapes.get(key, (robots, wheels)))
    assert recording.time[0] == 0
    assert recording.time[-1] == pytest.approx(0.98)
    assert recording.duration == 1.0
    assert recording.reference[0, 1, :2] == pytest.approx(recording.body[0, 1, :2])
    assert np.isnan(recording.reference[:, 2]).all()  # open loop


def test_only_what_the_scenario_asks_for_is_kept_and_the_digest_is_the_same(recording, tmp_path):
    for kept in ([], ["wheels"], ["sensors", "control"]):
        less = simulate("duration=1", f"record={json.dumps(kept)}")
        expected = {key for group in ("poses", *kept) for key in GROUPS[group]}
        assert less.arrays.keys() == expected
        assert less.digest == recording.digest
        less.save(tmp_path / "less.npz")
        assert Recording.load(tmp_path / "less.npz").arrays.keys() == expected


def test_a_file_is_the_same_bytes_each_time(recording, tmp_path):
    recording.save(tmp_path / "a.npz")
    recording.save(tmp_path / "b.npz")
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()


def refusal(path):
    with pytest.raises(InputError) as caught:
        Recording.load(path)
    return str(caught.value)


def test_what_is_no_recording_is_refused_in_one_line(tmp_path):
    os.mkfifo(tmp_path / "fifo.npz")
    (tmp_path / "text.npz").write_text("version: 1\n")
    (tmp_path / "empty.npz").write_bytes(b"")
    np.savez(tmp_path / "other.npz", x=np.arange(3))
    np.savez(tmp_path / "list.npz", meta=np.frombuffer(b"[1]", np.uint8))
    for name, wrong in {
        "nobody.npz": "cannot be read: is not a file",
        "fifo.npz": "cannot be read: is not a file",
        "text.npz": "is not a soccersim recording, or damaged",
        "empty.npz": "is not a soccersim recording, or damaged",
        "other.npz": "is not a soccersim recording, or damaged",
        "list.npz": "is not a soccersim recording, or damaged",
    }.items():
        assert refusal(tmp_path / name) == f"{tmp_path / name}: {wrong}"


def test_no_damage_does_worse_than_a_refusal(recording, tmp_path):
    recording.save(tmp_path / "r.npz")
    whole, path = (tmp_path / "r.npz").read_bytes(), tmp_path / "d.npz"
    dice = random.Random(1)
    refused = 0
    for _ in range(100):
        data = bytearray(whole)
        at = dice.randrange(len(data))
        if dice.random() < 0.3:
            del data[at:]
        elif dice.random() < 0.3:
            del data[at : at + dice.randrange(50)]
        else:
            data[at] ^= 1 << dice.randrange(8)
        path.write_bytes(data)
        try:
            Recording.load(path)
        except InputError:
            refused += 1
    assert refused > 80  # the rest hit what nobody reads, such as times of files


def test_recordings_of_another_soccersim_say_so(recording, tmp_path):
    meta = recording.meta
    newer = Recording(meta | {"format": 3}, recording.arrays)
    newer.save(tmp_path / "r.npz")
    assert refusal(tmp_path / "r.npz").endswith("has format 3; this soccersim reads format 2")
    odd = {**meta["scenario"], "gravity": 3}
    with pytest.raises(InputError, match=re.escape("a recording of soccersim 0.1.0, whose")):
        _ = Recording(meta | {"scenario": odd}, recording.arrays).scenario


def test_a_recording_may_be_taken_at_any_time():
    simulation = Simulation(load_scenario("one-of-everything", settings=["duration=1"]))
    start = simulation.recording()
    assert (start.duration, len(start.tick), start.legs) == (0.0, 0, [[], [], []])
    simulation.advance(101)
    early = simulation.recording()
    assert early.duration == pytest.approx(0.202)
    assert list(early.tick) == list(range(0, 101, 10))
