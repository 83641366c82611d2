"""`soccersim new`: a strategy that plays at once, and a test that shows it."""

import subprocess
import sys

import pytest

from soccersim.strategy import Strategy
from soccersim.strategy.load import load_team, locate


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty working folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_two_files_are_written_and_the_next_step_is_told(soccersim, here):
    ended = soccersim("new", "my_team")
    assert (ended.code, ended.err) == (0, "")
    assert sorted(path.name for path in here.iterdir()) == ["my_team.py", "test_my_team.py"]
    assert "soccersim match ./my_team.py" in ended.out
    made = load_team(locate("./my_team.py"))
    assert made.__name__ == "MyTeam"
    assert issubclass(made, Strategy)
    assert "Newcomer" not in (here / "my_team.py").read_text()


def test_the_new_test_passes(soccersim, here, compiled):
    soccersim("new", "my_team")
    words = [sys.executable, "-m", "pytest", "-q", "test_my_team.py"]
    ended = subprocess.run(words, cwd=here, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stdout
    assert "2 passed" in ended.stdout


def test_both_files_please_a_linter(soccersim, here):
    soccersim("new", "my_team")
    check = ["check", "--line-length", "100", "--select", "E,F,I,UP,B"]
    for words in (check, ["format", "--check"]):
        ended = subprocess.run(
            [sys.executable, "-m", "ruff", words[0], "--isolated", *words[1:], "."],
            cwd=here,
            capture_output=True,
            text=True,
        )
        assert ended.returncode == 0, ended.stdout


def test_a_folder_may_stand_before_the_name_and_py_after_it(soccersim, here):
    (here / "teams").mkdir()
    ended = soccersim("new", "teams/reds.py")
    assert "soccersim match teams/reds.py" in ended.out
    assert (here / "teams" / "test_reds.py").is_file()
    missing = soccersim("new", "nowhere/reds")
    assert (missing.code, len(missing.lines)) == (2, 1)
    assert "nowhere: there is no such folder" in missing.err


def test_nothing_is_overwritten_unless_it_is_asked_for(soccersim, here):
    (here / "test_reds.py").write_text("mine")
    ended = soccersim("new", "reds")
    assert ended.code == 2
    assert ended.lines == ["test_reds.py: is there already: --force overwrites it"]
    assert not (here / "reds.py").exists()
    assert (here / "test_reds.py").read_text() == "mine"
    assert soccersim("new", "reds", "--force").code == 0
    assert "Reds" in (here / "test_reds.py").read_text()


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("my-team", "`my-team` cannot be a module's name"),
        ("1team", "`1team` cannot be a module's name"),
        ("class", "`class` cannot be a module's name"),
        ("", "`` cannot be a module's name"),
        ("_hidden", "`_hidden` cannot be a module's name"),
        ("équipe", "`équipe` cannot be a module's name"),
        ("random", "`random` is taken, its test could not import it"),
        ("soccersim", "`soccersim` is taken"),
        ("test_it", "`test_it` is taken"),
    ],
)
def test_a_name_that_python_could_not_import_is_refused(soccersim, here, name, told):
    ended = soccersim("new", name)
    assert (ended.code, len(ended.lines)) == (2, 1)
    assert told in ended.err
    assert list(here.iterdir()) == []


@pytest.mark.parametrize(
    ("name", "made"), [("view", "ViewTeam"), ("none", "NoneTeam"), ("a__b_2", "AB2")]
)
def test_classes_never_take_a_name_that_the_file_needs(soccersim, here, name, made):
    soccersim("new", name)
    assert load_team(locate(f"./{name}.py")).__name__ == made
