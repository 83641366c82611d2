"""The report's files: whole or not at all, with replays that its links lead to."""

import re
from pathlib import Path
from urllib.parse import unquote

import pytest
from accounts import Season, failing

from soccersim.problems import InputError, MachineError, Problem
from soccersim.regress.report import files, write_report
from soccersim.regress.report.meetings import most_different, played


@pytest.fixture
def account(tmp_path):
    """A run whose recordings are there, but for one that is damaged and one that is gone."""
    account = Season(seed=2).play(400, 0.6).account(folder=tmp_path)
    account.recordings.mkdir()
    for match in account.matches:
        (account.recordings / match.row.recording).write_text("a recording")
    return account


@pytest.fixture(autouse=True)
def drawn(monkeypatch):
    """Instead of real recordings and pages: their names, and the titles asked for."""
    asked = []

    class Recording:
        tick = (0,)

        @staticmethod
        def load(path):
            if not path.is_file() or path.read_text() == "damaged":
                raise InputError(Problem("is not a soccersim recording, or damaged", str(path)))
            return Recording()

    def page(recording, title=""):
        asked.append(title)
        return f"<!doctype html><title>{title}</title>"

    monkeypatch.setattr("soccersim.record.Recording", Recording)
    monkeypatch.setattr("soccersim.render.page.page", page)
    return asked


def links(page):
    return [unquote(link) for link in re.findall(r'href="([^"]*)"', page.read_text())]


def test_the_most_different_pairs_are_linked_to_their_replays(account, tmp_path, drawn):
    page, *replays = write_report(account, tmp_path / "my report.html")
    assert page == tmp_path / "my report.html"
    assert len(replays) == 12
    assert {tmp_path / link for link in links(page)} == set(replays)
    assert all(replay.parent.name == "my report-replays" for replay in replays)
    wide = {f"{2 * abs(pair.sample.difference):g}" for pair in most_different(played(account), 6)}
    least = min(map(float, wide))
    others = [2 * abs(sample.difference) for sample in account.samples]
    assert sorted(others)[-6] == least
    match = most_different(played(account), 1)[0].legs[0]
    home, away = match.row.score
    assert drawn[0] == f"{match.home} {home} : {away} {match.away}, seed {match.row.seed}"


def test_a_recording_that_is_damaged_or_gone_has_no_link(account, tmp_path):
    one, two = (leg.row.recording for leg in most_different(played(account), 1)[0].legs)
    (account.recordings / one).write_text("damaged")
    (account.recordings / two).unlink()
    page, *replays = write_report(account, tmp_path / "report.html", replays=2)
    assert len(replays) == 2
    assert {tmp_path / link for link in links(page)} == set(replays)


def test_without_recordings_there_is_one_file_and_no_folder(tmp_path):
    account = failing()
    assert write_report(account, tmp_path / "report.html") == [tmp_path / "report.html"]
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]
    assert "--keep lost" in (tmp_path / "report.html").read_text()


def test_replays_of_an_earlier_report_go_and_other_files_stay(account, tmp_path):
    folder = tmp_path / "report-replays"
    folder.mkdir()
    (folder / "pair-000999-leg-0-0123456789ab.html").touch()
    (folder / "mine.html").touch()
    _, *replays = write_report(account, tmp_path / "report.html")
    assert set(folder.iterdir()) == {*replays, folder / "mine.html"}


def test_a_report_that_cannot_be_written_leaves_the_old_one(account, tmp_path, monkeypatch):
    page, *_ = write_report(account, tmp_path / "report.html")
    old = page.read_bytes()

    def full(self, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(MachineError, match=r"replays/pair-\S+: No space left on device"):
        write_report(account, page)
    assert page.read_bytes() == old
    assert not list(tmp_path.rglob("*.part"))


@pytest.mark.parametrize("name", ["file/report.html", "folder", "a\0b"])
def test_a_place_that_cannot_be_is_the_machines_error(tmp_path, name):
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    with pytest.raises(MachineError):
        write_report(failing(), tmp_path / name)
    assert not list(tmp_path.rglob("*.part"))


def test_missing_folders_are_made(tmp_path):
    assert write_report(failing(), tmp_path / "a" / "b.html")[0].is_file()


def test_a_name_that_may_not_be_text_is_written_all_the_same(tmp_path):
    account = Season(candidate="\udcff\ud800.py").play(2).account()
    page, *_ = write_report(account, tmp_path / "report.html")
    assert r"\udcff\ud800.py" in page.read_text(encoding="utf-8")


def test_a_text_is_written_whole_with_the_same_line_ends_everywhere(tmp_path):
    files.write_whole(tmp_path / "a.html", "one\ntwo\n")
    assert (tmp_path / "a.html").read_bytes() == b"one\ntwo\n"


@pytest.mark.slow
def test_a_real_run_has_real_replays(tmp_path, monkeypatch):
    from click.testing import CliRunner

    from soccersim.cli.main import soccersim

    monkeypatch.undo()
    monkeypatch.chdir(tmp_path)
    words = "regress still chaser --scenario friendly-match --duration 1 --jobs 1 --pairs 1"
    files = "--keep all --report report.html --junit junit.xml"
    done = CliRunner().invoke(soccersim, f"{words} {files}".split())
    assert done.exit_code == 0, done.output
    linked = sorted({tmp_path / link for link in links(tmp_path / "report.html")})
    assert linked == sorted((tmp_path / "report-replays").iterdir())
    assert len(linked) == 2
    for replay in linked:
        assert replay.read_text(encoding="utf-8").lstrip().lower().startswith("<!doctype html>")
        assert len(replay.read_bytes()) > 20_000
