"""--out: whole files or none, nothing overwritten unasked, and what the machine refuses."""

import json
import os
import resource
import subprocess
import sys

import pytest

from soccersim import Recording, Simulation, load_scenario
from soccersim.problems import MachineError

FILES = {"report.json", "recording.npz", "trajectory.png"}


@pytest.fixture
def run(soccersim, scenario):
    """Run two.yaml with more words."""
    scenario()
    return lambda *words: soccersim("run", "./two.yaml", "--json", *words)


def names(folder):
    return {path.name for path in folder.iterdir()}


def test_out_makes_its_folder_and_the_files_of_a_run(run, tmp_path):
    assert run("--out", "a/b/c").code == 0
    assert names(tmp_path / "a" / "b" / "c") == FILES
    assert run("--out", "d", "--no-plot").code == 0
    assert names(tmp_path / "d") == FILES - {"trajectory.png"}


def test_nothing_is_overwritten_without_force(run, tmp_path):
    run("--out", "r", "--no-plot")
    (tmp_path / "r" / "notes.txt").write_text("mine")
    before = (tmp_path / "r" / "report.json").read_bytes()
    again = run("--out", "r", "--seed", 9)
    assert (again.code, again.out) == (2, "")
    assert again.lines == [
        "r: holds report.json, recording.npz already: choose another folder, or add --force"
    ]
    assert (tmp_path / "r" / "report.json").read_bytes() == before
    assert names(tmp_path / "r") == FILES - {"trajectory.png"} | {"notes.txt"}


def test_force_replaces_an_earlier_run_as_a_whole_and_leaves_other_files(run, tmp_path):
    run("--out", "r", "--frames", "--video")
    (tmp_path / "r" / "notes.txt").write_text("mine")
    assert run("--out", "r", "--force", "--seed", 9, "--no-plot").code == 0
    assert names(tmp_path / "r") == {"report.json", "recording.npz", "notes.txt"}
    assert json.loads((tmp_path / "r" / "report.json").read_text())["seed"] == 9
    assert Recording.load(tmp_path / "r" / "recording.npz").meta["seed"] == 9


def test_force_leaves_no_frame_of_a_longer_run(run, tmp_path):
    run("--out", "r", "--frames", "--set", "duration=0.4")
    assert len(names(tmp_path / "r" / "frames")) == 10
    run("--out", "r", "--frames", "--force")
    assert len(names(tmp_path / "r" / "frames")) == 3


def test_a_folder_named_frames_with_other_files_is_nobodys_to_replace(run, tmp_path):
    (tmp_path / "r" / "frames").mkdir(parents=True)
    (tmp_path / "r" / "frames" / "holiday.png").write_bytes(b"sea")
    ended = run("--out", "r", "--frames", "--force")
    wrong = "r/frames: holds more than frames: move it away, or choose another folder"
    assert (ended.code, ended.lines) == (2, [wrong])
    assert names(tmp_path / "r" / "frames") == {"holiday.png"}


def test_a_folder_that_cannot_be_made_is_named_with_exit_code_3(run, tmp_path):
    before = names(tmp_path)
    for out, wrong in (
        ("two.yaml/x", "two.yaml/x: Not a directory"),
        ("two.yaml", "two.yaml: is a file, and a folder is needed"),
        ("/proc/nobody/here", "/proc/nobody/here: No such file or directory"),
        ("a" * 300, f"{'a' * 300}: File name too long"),
    ):
        ended = run("--out", out)
        assert (ended.code, ended.out, ended.lines) == (3, "", [wrong])
    assert names(tmp_path) == before


def test_a_full_disk_is_told_with_the_file_and_leaves_no_half_of_it(run, tmp_path, monkeypatch):
    def fill(path, data, *_, **__):
        with open("/dev/full", "wb", buffering=0) as disk:
            disk.write(b"x")

    monkeypatch.setattr("pathlib.Path.write_bytes", fill)  # as trajectory.png is written
    ended = run("--out", "r")
    assert (ended.code, ended.out) == (3, "")
    assert ended.lines == ["r/trajectory.png: No space left on device"]
    assert names(tmp_path / "r") == {"report.json", "recording.npz"}


def test_a_file_that_may_not_grow_is_told_and_taken_away(scenario, tmp_path):
    scenario()
    words = [sys.executable, "-m", "soccersim", "run", "./two.yaml", "--out", "r"]
    size = 2000  # bytes: the report fits, the recording does not
    ended = subprocess.run(
        words,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)),
    )
    assert (ended.returncode, ended.stdout) == (3, "")
    assert ended.stderr == "r/recording.npz: File too large\n"
    assert names(tmp_path / "r") == {"report.json"}


def test_a_recording_on_a_full_disk_raises_one_line():
    recording = Simulation(load_scenario("linear", settings=["duration=0.1"])).run()
    with pytest.raises(MachineError, match=r"^/dev/full: No space left on device$"):
        recording.save("/dev/full")


def test_a_full_standard_output_is_the_machines_fault():
    words = [sys.executable, "-m", "soccersim", "schema"]
    with open("/dev/full", "w") as disk:
        ended = subprocess.run(words, stdout=disk, stderr=subprocess.PIPE, text=True)
    wrong = "the output cannot be used: No space left on device\n"
    assert (ended.returncode, ended.stderr) == (3, wrong)


@pytest.mark.parametrize("verb", ["schema", "list"])  # by click, by rich
def test_a_reader_who_leaves_early_hears_no_complaint(verb):
    read, write = os.pipe()
    os.close(read)
    words = [sys.executable, "-m", "soccersim", verb]
    ended = subprocess.run(words, stdout=write, stderr=subprocess.PIPE, text=True)
    os.close(write)
    assert (ended.returncode, ended.stderr) == (0, "")
