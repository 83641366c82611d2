"""`soccersim replay --html`: one file, written whole or not at all."""

import pytest

from soccersim import Simulation, load_scenario


@pytest.fixture
def recording(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Simulation(load_scenario("linear", settings=["duration=0.1"])).run().save("run.npz")
    return tmp_path / "run.npz"


def test_page_is_written_and_told(soccersim, recording, tmp_path):
    ended = soccersim("replay", recording, "--html", tmp_path / "pages" / "run.html")
    assert (ended.code, ended.out) == (0, "")
    assert ended.lines[-1].endswith("run.html")
    text = (tmp_path / "pages" / "run.html").read_text(encoding="utf-8")
    assert text.startswith("<!doctype html>")
    assert "<title>linear</title>" in text


def test_page_that_is_there_is_kept_unless_forced(soccersim, recording, tmp_path):
    page = tmp_path / "run.html"
    page.write_text("mine")
    ended = soccersim("replay", recording, "--html", page)
    assert ended.code == 2
    assert len(ended.lines) == 1
    assert "--force" in ended.lines[0]
    assert page.read_text() == "mine"
    assert soccersim("replay", recording, "--html", page, "--force").code == 0
    assert page.read_text(encoding="utf-8") != "mine"


def test_place_that_cannot_be_written_is_the_machines_failure(soccersim, recording):
    ended = soccersim("replay", recording, "--html", "/proc/run.html")
    assert ended.code == 3
    assert len(ended.lines) == 1
    assert "/proc" in ended.lines[0]
