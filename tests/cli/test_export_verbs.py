"""replay --video, --mcap, --csv and plot as a user meets them."""

import resource
import subprocess
import sys

import pytest

from soccersim import Simulation, load_scenario


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """A short recording, in a file."""
    path = tmp_path_factory.mktemp("kept") / "run.npz"
    Simulation(load_scenario("linear", settings=["duration=0.4"])).run().save(path)
    return path


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_all_kinds_are_written_at_once_and_named(soccersim, kept, tmp_path):
    files = ("--video", "a.gif", "--frames", "f", "--mcap", "a.mcap", "--csv", "a.csv")
    ended = soccersim("replay", kept, *files, "--to", 0.2, "--size", "160x128")
    assert (ended.code, ended.out) == (0, "")
    assert sorted(ended.lines) == ["wrote a.csv", "wrote a.gif", "wrote a.mcap", "wrote f"]
    assert names(tmp_path) == ["a.csv", "a.gif", "a.mcap", "f"]
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 1 + 11
    assert len(names(tmp_path / "f")) == 6


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--video", "a.avi"), "a.avi: a film's name ends in .mp4, .gif or .webp"),
        (("--video", "a.mp4", "--size", "161x128"), "--size 161x128: H.264 needs even numbers"),
        (
            ("--video", "a.mp4", "--from", 3, "--to", 2),
            "--from 3: from 0 to 0.4 s are recorded",
        ),
        (("--csv", "a.csv", "--to", -1), "--to -1 s must be later than --from 0 s"),
        (("--csv", "a", "--mcap", "./a"), "a: --mcap would take the place of --csv"),
        (("--csv", "."), ".: is no name of a file"),
        (("--frames", ".", "--force"), ".: is no name of a file"),
        (("--csv", "a.csv", "--from", 0.001, "--to", 0.002), "no record lies between"),
        (
            ("--csv", "a.csv", "--speed", 2),
            "soccersim replay: --speed and --size are of --video and --frames; "
            "see soccersim replay --help",
        ),
        (
            ("--html", "a.html", "--to", 2),
            "soccersim replay: --from and --to are of --video, --frames, --mcap and --csv; "
            "see soccersim replay --help",
        ),
    ],
)
def test_what_cannot_be_is_told_in_one_line_before_anything_is_written(
    soccersim, kept, tmp_path, words, told
):
    ended = soccersim("replay", kept, *words)
    assert (ended.code, len(ended.lines)) == (2, 1)
    assert ended.lines[0].startswith(told)
    assert names(tmp_path) == []


def test_a_recording_is_not_written_over_by_what_is_made_of_it(soccersim, kept):
    before = kept.read_bytes()
    ended = soccersim("replay", kept, "--csv", kept, "--force")
    told = f"{kept}: --csv would take the place of the recording"
    assert (ended.code, ended.lines) == (2, [told])
    assert kept.read_bytes() == before


@pytest.mark.parametrize(("module", "extra"), [("av", "video"), ("mcap.writer", "log")])
def test_what_is_not_installed_is_told_before_anything_is_written(
    soccersim, kept, tmp_path, monkeypatch, module, extra
):
    monkeypatch.setitem(sys.modules, module, None)
    words = ("--video", "a.gif") if extra == "video" else ("--mcap", "a.mcap")
    ended = soccersim("replay", kept, "--html", "a.html", *words)
    assert (ended.code, len(ended.lines)) == (2, 1)
    assert f"pip install 'soccersim[{extra}]'" in ended.lines[0]
    assert names(tmp_path) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("option", "name"),
    [("--video", "a.webp"), ("--mcap", "a.mcap"), ("--csv", "a.csv"), ("--frames", "f")],
)
def test_a_full_disk_is_told_in_one_line_and_leaves_nothing(kept, tmp_path, option, name):
    words = [sys.executable, "-m", "soccersim", "replay", str(kept), option, name]
    ended = subprocess.run(
        words,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000)),
    )
    assert (ended.returncode, ended.stdout) == (3, "")
    assert ended.stderr.startswith(name)
    assert ended.stderr.endswith(": File too large\n")
    assert names(tmp_path) == []


@pytest.mark.parametrize(
    ("option", "name"), [("--video", "a.mp4"), ("--mcap", "a.mcap"), ("--csv", "a.csv")]
)
def test_nothing_is_written_over_without_force(soccersim, kept, tmp_path, option, name):
    (tmp_path / name).write_text("mine")
    ended = soccersim("replay", kept, option, name)
    assert (ended.code, len(ended.lines)) == (2, 1)
    assert (tmp_path / name).read_text() == "mine"
    assert soccersim("replay", kept, option, name, "--force").code == 0
    assert (tmp_path / name).read_bytes() != b"mine"


def test_plot_writes_a_picture_and_not_over_another(soccersim, kept, tmp_path):
    ended = soccersim("plot", kept, "--out", "a.png")
    assert (ended.code, ended.out, ended.lines) == (0, "", ["wrote a.png"])
    again = soccersim("plot", kept, "--out", "a.png")
    assert again.lines == [
        ".: holds a.png already: choose another folder, or add --force",
    ]
    assert (again.code, names(tmp_path)) == (2, ["a.png"])


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--out", "a.jpg"), "a.jpg: a plot's name ends in .png, .svg or .pdf"),
        (("--out", "a.png", "--robot", "x"), "has no robot x: there are"),
    ],
)
def test_plots_that_cannot_be_are_told_in_one_line(soccersim, kept, tmp_path, words, told):
    ended = soccersim("plot", kept, *words)
    assert (ended.code, len(ended.lines)) == (2, 1)
    assert told in ended.lines[0]
    assert names(tmp_path) == []


def test_a_file_that_is_no_recording_cannot_be_plotted(soccersim, tmp_path):
    (tmp_path / "a.npz").write_text("nothing")
    ended = soccersim("plot", "a.npz", "--out", "a.png")
    assert (ended.code, ended.lines) == (2, ["a.npz: is not a soccersim recording, or damaged"])


def test_arms_without_robots_are_plotted_and_logged(soccersim, tmp_path):
    bench = Simulation(load_scenario("arm-table2", settings=["duration=0.2"])).run()
    bench.save("arms.npz")
    assert soccersim("plot", "arms.npz", "--out", "a.png").code == 0
    assert soccersim("replay", "arms.npz", "--mcap", "a.mcap", "--csv", "a.csv").code == 0
    ended = soccersim("plot", "arms.npz", "--robot", "x", "--out", "b.png")
    told = "arms.npz: has no robots: arms alone are plotted by themselves"
    assert (ended.code, ended.lines) == (2, [told])
    assert names(tmp_path) == ["a.csv", "a.mcap", "a.png", "arms.npz"]
