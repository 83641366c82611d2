"""run --video and match --video: alone as ever, or before the name of a film, and a part of it."""

import sys

import pytest
from PIL import Image

from soccersim.cli import match, run
from soccersim.cli.film import ENDINGS
from soccersim.render.cut import KINDS

LINE = ("run", "linear", "--no-plot", "--set", "duration=0.4", "--out", "r")


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path, monkeypatch, compiled):
    monkeypatch.chdir(tmp_path)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.parametrize(
    ("command", "words", "video", "rest"),
    [
        (run, ["--video", "defender"], "video.mp4", {"scenario": "defender"}),
        (run, ["defender", "--video"], "video.mp4", {"scenario": "defender"}),
        (run, ["--video", "./my.yaml"], "video.mp4", {"scenario": "./my.yaml"}),
        (run, ["--video", "goal.gif", "defender"], "goal.gif", {"scenario": "defender"}),
        (run, ["defender", "--video=GOAL.GIF"], "GOAL.GIF", {"scenario": "defender"}),
        (run, ["--video", "--frames", "defender"], "video.mp4", {"frames": True}),
        (run, ["defender"], None, {"frames": False}),
        (match, ["--video", "roles", "chaser"], "video.mp4", {"home": "roles", "away": "chaser"}),
        (match, ["--video", "./a.py", "teams.one:Mine"], "video.mp4", {"away": "teams.one:Mine"}),
        (match, ["roles", "--video", "k.webp", "chaser"], "k.webp", {"away": "chaser"}),
    ],
)
def test_video_takes_the_next_word_only_where_that_is_a_film(command, words, video, rest):
    told = command.command.make_context("verb", list(words)).params
    assert told["video"] == video
    assert told | rest == told


def test_all_kinds_of_films_are_known_as_such():
    assert set(KINDS) < ENDINGS


def test_video_alone_is_an_mp4_of_the_whole(soccersim, tmp_path):
    assert soccersim(*LINE, "--video").code == 0
    assert names(tmp_path / "r") == ["recording.npz", "report.json", "video.mp4"]


def test_a_named_film_lies_beside_the_recording_and_shows_the_part(soccersim, tmp_path):
    part = ("--from", 0.1, "--to", 0.3, "--speed", 0.5, "--size", "160x128")
    assert soccersim(*LINE, "--frames", "--video", "slow.gif", *part).code == 0
    assert names(tmp_path / "r") == ["frames", "recording.npz", "report.json", "slow.gif"]
    with Image.open(tmp_path / "r" / "slow.gif") as film:
        assert (film.format, film.size, film.n_frames) == ("GIF", (160, 128), 11)
    assert len(names(tmp_path / "r" / "frames")) == 11  # 0.2 s at half speed, 25 a second


def test_a_named_film_is_not_written_over_without_force(soccersim, tmp_path):
    (tmp_path / "r").mkdir()
    (tmp_path / "r" / "mine.gif").write_text("mine")
    ended = soccersim(*LINE, "--video", "mine.gif")
    told = "r: holds mine.gif already: choose another folder, or add --force"
    assert (ended.code, ended.lines) == (2, [told])
    assert (tmp_path / "r" / "mine.gif").read_text() == "mine"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--video", "a.avi"), "a.avi: a film's name ends in .mp4, .gif or .webp"),
        (("--video=",), "a film's name ends in .mp4, .gif or .webp"),
        (("--video", "../a.gif"), "--video takes a name without a folder: it lies in --out"),
        (("--from", 0.1), "--from, --to, --speed and --size are of --video and --frames"),
        (("--video", "--from", 2), "--from 2: from 0 to 0.4 s are recorded"),
        (("--video", "--from", 0.2, "--to", 0.1), "--to 0.1 s must be later than --from 0.2 s"),
        (("--video", "--speed", 0), "--speed 0: it can be from 0.01 to 100"),
        (("--frames", "--size", "9x9"), "--size 9x9: H.264 needs even numbers"),
    ],
)
def test_a_film_that_cannot_be_is_told_before_the_run_begins(soccersim, tmp_path, words, told):
    ended = soccersim(*LINE, *words)
    assert (ended.code, ended.out, len(ended.lines)) == (2, "", 1)
    assert told in ended.lines[0]
    assert names(tmp_path) == []


def test_a_run_that_was_over_before_its_film_began_is_kept(soccersim, tmp_path):
    ended = soccersim("run", "defender", "--no-plot", "--out", "r", "--video", "--from", 50)
    assert ended.code == 0
    assert "nothing to show: it was over at 7.58 s, before --from 50" in ended.lines
    assert names(tmp_path / "r") == ["recording.npz", "report.json"]


def test_without_pyav_nothing_is_simulated_for_a_film(soccersim, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "av", None)
    ended = soccersim(*LINE, "--video")
    assert (ended.code, len(ended.lines)) == (2, 1)
    assert "pip install 'soccersim[video]'" in ended.lines[0]
    assert names(tmp_path) == []
