"""`soccersim reproduce`: the papers' tables, the same wherever they are simulated; its files."""

import json

import pytest

from soccersim.reproduce import dasmahapatra_figure

PAPER = ("reproduce", "dasmahapatra")  # nothing of it is simulated
FILES = {"reproduce.json", "reproduce.html", "dasmahapatra-table-2.png"}


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def names(folder):
    return {path.name for path in folder.iterdir()}


@pytest.mark.parametrize(
    ("papers", "jobs"),
    [
        (("four-wheel",), (1, 2)),
        pytest.param((), (1, 2, 3), marks=pytest.mark.slow),
    ],
)
def test_papers_come_out_the_same_on_any_number_of_processes(soccersim, compiled, papers, jobs):
    words = ("reproduce", *papers, "--seeds", 4, "--json", "--jobs")
    documents = [soccersim(*words, count).out for count in jobs]
    assert json.loads(documents[0])["papers"]
    assert set(documents) == {documents[0]}


def test_page_and_json_hold_the_pictures_that_stand_beside_them(soccersim, here):
    assert soccersim(*PAPER, "--out", "a/r").code == 0
    assert names(here / "a" / "r") == FILES
    document = json.loads((here / "a" / "r" / "reproduce.json").read_text(encoding="utf-8"))
    figures = [section.get("figure") for section in document["papers"]["dasmahapatra"]]
    assert set(filter(None, figures)) == {"dasmahapatra-table-2.png"}
    assert "data:image/png;base64," in (here / "a" / "r" / "reproduce.html").read_text("utf-8")


def test_nothing_is_overwritten_unasked(soccersim, here):
    soccersim(*PAPER, "--out", "r")
    before = (here / "r" / "reproduce.html").read_bytes()
    ended = soccersim("reproduce", "garcia", "--out", "r")
    assert ended.code == 2
    assert ended.lines == [
        "r: holds reproduce.json, reproduce.html already: choose another folder, or add --force"
    ]
    assert (here / "r" / "reproduce.html").read_bytes() == before
    assert soccersim(*PAPER, "--out", "r", "--force").code == 0
    assert (here / "r" / "reproduce.html").read_bytes() == before


def test_a_ctrl_c_while_a_picture_is_drawn_leaves_no_folder(soccersim, here, monkeypatch):
    def stopped(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(dasmahapatra_figure, "_draw_arms", stopped)
    ended = soccersim(*PAPER, "--out", "r")
    assert (ended.code, ended.lines) == (130, ["stopped; nothing was kept: run it again"])
    assert not (here / "r").exists()
