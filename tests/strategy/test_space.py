"""Two teams never meet in a module, whatever their files are called."""

import sys

import pytest

from soccersim.strategy.load import load_team, locate, make_team

TEAM = """
import utils
import utils as u
import pkg.sub
import pkg.sub as s
from pkg import other
from pkg.sub import NAME
from . import utils as beside


class Team:
    def __init__(self, rng):
        pass

    def decide(self, view):
        import late
        import pkg.lazy
        from pkg import lazy

        def inner():
            from pkg.deep import NAME
            return NAME

        return [
            utils.NAME, u.NAME, pkg.sub.NAME, s.NAME, other.NAME, NAME, beside.NAME,
            late.NAME, pkg.lazy.NAME, lazy.NAME, inner(),
        ]
"""
SUB = "from . import deep\nfrom .deep import NAME\nfrom pkg import deep as d\nassert d is deep\n"


@pytest.fixture
def team(tmp_path):
    """Writes a folder with strategy.py, utils.py and a package, each knowing whose it is."""

    def write(name, strategy=TEAM):
        folder = tmp_path / name
        (folder / "pkg").mkdir(parents=True)
        (folder / "strategy.py").write_text(strategy)
        for module in ("utils", "late", "pkg/deep"):
            (folder / f"{module}.py").write_text(f"NAME = {name!r}\n")
        for module in ("sub", "other", "lazy"):
            (folder / "pkg" / f"{module}.py").write_text(SUB)
        (folder / "pkg" / "__init__.py").write_text("")
        return folder / "strategy.py"

    return write


def load(source, beside=None):
    return load_team(locate(str(source), beside))


def decide(source):
    return load(source)().decide(None)


SIMPLE = "class Team:\n    def decide(self, view):\n        return 'it'\n"


def test_two_teams_with_the_same_names_of_files_each_have_their_own(team):
    red, blue = load(team("red")), load(team("blue"))
    for _ in range(2):
        assert red(None).decide(None) == ["red"] * 11
        assert blue(None).decide(None) == ["blue"] * 11
    assert "utils" not in sys.modules
    assert "pkg" not in sys.modules


def test_a_team_against_itself_shares_no_state(file):
    path = file(
        "GOALS = []\n\n\nclass Team:\n    def decide(self, view):\n"
        "        GOALS.append(1)\n        return len(GOALS)\n"
    )
    home, away = load(path)(), load(path)()
    assert [home.decide(0), home.decide(0), away.decide(0), home.decide(0)] == [1, 2, 1, 3]
    assert type(home) is not type(away)


def test_modules_that_import_each_other_meet(file):
    file("import team\n\n\ndef back():\n    return team.NAME\n", "utils.py")
    path = file(
        "import utils\n\nNAME = 'x'\n\n\nclass Team:\n    def decide(self, view):\n"
        "        return utils.back()\n"
    )
    assert decide(path) == "x"


def test_everybodys_command_is_the_same(file):
    path = file(
        "from soccersim.strategy import Command\nimport soccersim.strategy as st\n\n\n"
        "class Team:\n    def decide(self, view):\n        return Command, st.Command\n"
    )
    from soccersim.strategy import Command

    assert decide(path) == (Command, Command)


def test_a_copy_of_soccersim_beside_a_team_does_not_count(file):
    file("X = 1\n", "soccersim/__init__.py")
    assert decide(file("import soccersim.strategy as s\n" + SIMPLE)) == "it"


def test_own_modules_come_before_the_librarys_and_folders_of_data_do_not(file):
    file("NAME = 'own'\n", "statistics.py")
    file("NAME = 'own'\n", "sys.py")
    file("x: 1\n", "yaml/strategy.yaml")
    path = file(
        "import sys, statistics, yaml\n\n\nclass Team:\n    def decide(self, view):\n"
        "        return statistics.NAME, yaml.safe_load('3'), sys.maxsize\n"
    )
    assert decide(path) == ("own", 3, sys.maxsize)
    import statistics

    assert statistics.mean([1, 3]) == 2


def test_a_folder_without_init_is_a_package_too(file):
    file("NAME = 'deep'\n", "tactics/press/high.py")
    path = file(
        "from tactics.press import high\n\n\nclass Team:\n    def decide(self, view):\n"
        "        return high.NAME\n"
    )
    assert decide(path) == "deep"


def test_an_edit_within_the_same_second_is_seen_and_nothing_is_left_behind(
    file, tmp_path, monkeypatch
):
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    assert decide(file(SIMPLE)) == "it"
    assert decide(file(SIMPLE.replace("it", "up"))) == "up"
    assert [path.name for path in tmp_path.iterdir()] == ["team.py"]


def test_dataclasses_enums_and_annotations_find_their_module(file):
    path = file(
        "from __future__ import annotations\nfrom dataclasses import dataclass\n"
        "from enum import Enum\nfrom typing import get_type_hints\n\n\n"
        "class Role(Enum):\n    LEFT = 1\n\n\n@dataclass(slots=True)\nclass Plan:\n    role: Role\n"
        "\n\n@dataclass\nclass Team:\n    rng: object\n    press: bool = True\n\n"
        "    def decide(self, view):\n        return get_type_hints(Plan)['role'] is Role\n"
    )
    assert make_team(load(path), None, {"press": False}).decide(None) is True


def test_a_missing_module_is_named_as_the_team_wrote_it(file):
    file("", "pkg/__init__.py")
    with pytest.raises(ModuleNotFoundError, match=r"^No module named 'pkg\.nothing'$"):
        load(file("import pkg.nothing\n"))
