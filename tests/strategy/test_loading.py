"""Strategies are found by name, and two teams never meet in a module."""

import json
import subprocess
import sys

import pytest

from soccersim.problems import InputError
from soccersim.strategy import Strategy
from soccersim.strategy.load import Origin, load_team, locate, make_team


def load(source, beside=None):
    return load_team(locate(str(source), beside))


def decide(source):
    return load(source)().decide(None)


SIMPLE = "class Team:\n    def decide(self, view):\n        return 'it'\n"


@pytest.fixture
def package(file):
    """A package whose parent would tell if it were imported."""
    file("from .names import NAME\n", "club/__init__.py")
    file("NAME = 'club'\n", "club/names.py")
    file(
        "import club\nfrom club import names\n\n\nclass First:\n    def decide(self, view):\n"
        "        import club.names as late\n        return club.NAME, names.NAME, late.NAME\n\n\n"
        "class Second(First):\n    pass\n",
        "club/teams.py",
    )


def test_a_module_is_found_beside_the_caller_and_each_team_has_its_own(package, tmp_path):
    one, two = (load("club.teams:First", tmp_path) for _ in range(2))
    assert one().decide(0) == ("club",) * 3
    assert one is not two
    assert sys.modules[one.__module__] is not sys.modules[two.__module__]


def test_a_module_is_found_on_the_path(package, tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(tmp_path))
    assert load("club.teams:Second")().decide(0) == ("club",) * 3


def test_locating_runs_nothing_and_its_answer_crosses_to_another_process(file, tmp_path):
    file("raise SystemExit(9)\n", "club/__init__.py")
    file("raise SystemExit(9)\n", "club/teams.py")
    origin = locate("club.teams:First", tmp_path)
    assert Origin(**json.loads(json.dumps(vars(origin)))) == origin
    path = file("raise SystemExit(9)\n")
    assert locate(str(path)).module == "team"


def test_bundled_strategies_are_found_by_name():
    assert locate("still").module == "still"
    assert issubclass(load("still"), Strategy)
    assert locate("still:Still").cls == "Still"


def test_an_entry_point_names_a_team(monkeypatch, package, tmp_path):
    from importlib import metadata

    point = metadata.EntryPoint("champions", "club.teams:First", "soccersim.strategies")
    monkeypatch.setattr(
        metadata, "entry_points", lambda group, name: [point] * (name == point.name)
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    assert locate("champions").module == "club.teams"
    assert load("champions").__name__ == "First"
    assert load("champions:Second").__name__ == "Second"


def test_an_installed_package_is_found_by_its_entry_point(package, tmp_path):
    info = tmp_path / "club-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: club\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text("[soccersim.strategies]\nchamps = club.teams : Second\n")
    code = "from soccersim.strategy.load import *; print(load_team(locate('champs'))().decide(0))"
    ended = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.path.insert(0, {str(tmp_path)!r}); {code}"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert ended.stdout == "('club', 'club', 'club')\n"


BAD = [
    ("stil", "no strategy `stil` is bundled: did you mean `still`?"),
    ("nobody", "no strategy `nobody` is bundled: there are"),
    ("", "no strategy `` is bundled: there are"),
    ("./tean.py", "tean.py: there is no such file; did you mean `team.py`?"),
    ("./tean.py:Team", "tean.py: there is no such file; did you mean `team.py`?"),
    ("nowhere/team.py", "nowhere/team.py: there is no such file"),
    (".", "no module `` for `.`: a file's name ends in .py"),
    ("./", "is a folder: name the file in it"),
    ("./notes.txt", "notes.txt: a strategy is a Python file: its name ends in .py"),
    ("./my-team.py", "my-team.py: its name cannot be a module's: letters, digits and _ only"),
    ("team", "no strategy `team` is bundled: for the file here write `./team.py`"),
    ("club.nothing:Team", "no module `club.nothing` for `club.nothing:Team`"),
    ("nothing.teams", "no module `nothing` for `nothing.teams`"),
    ("club.teams.more:Team", "no module `club.teams.more` for `club.teams.more:Team`"),
    ("sys:Team", "no module `sys` for `sys:Team`"),
    ("a b.c:Team", "no module `a b` for `a b.c:Team`"),
    ("\0.py", "there is no such file"),
]


@pytest.mark.parametrize(("source", "message"), BAD, ids=[repr(source) for source, _ in BAD])
def test_a_name_that_leads_nowhere_is_told_in_one_line(file, package, tmp_path, source, message):
    for name in ("team.py", "my-team.py", "notes.txt"):
        file(SIMPLE, name)
    with pytest.raises(InputError) as error:
        locate(source, tmp_path)
    assert message in str(error.value)
    assert "\n" not in str(error.value)
    assert str(error.value).isprintable()


NO_CLASS = [
    ("", "", "defines no class with a method decide(self, view)"),
    (SIMPLE + SIMPLE.replace("Team", "Other"), "", "several classes have decide(): `Team`, `Oth"),
    (SIMPLE, ":Tean", "`Tean` is not there; there is `Team`"),
    (SIMPLE, ":Other", "`Other` is not there; there is `Team`"),
    (SIMPLE + "\nOther = 5\n", ":Other", "`Other` is not a class with decide(); there is `Team`"),
    ("from strategy_of import Team\n", "", "defines no class with a method decide"),
    ("class Team:\n    decide = 5\n", "", "defines no class with a method decide"),
    ("def decide(view):\n    return []\n", "", "defines no class with a method decide"),
    (
        "from soccersim.strategy import Strategy\n\n\nclass Team(Strategy):\n    pass\n",
        "",
        "defines no class with a method decide",
    ),
]


@pytest.mark.parametrize(("text", "name", "message"), NO_CLASS)
def test_a_file_without_the_one_class_is_told_in_one_line(file, text, name, message):
    file(SIMPLE, "strategy_of.py")
    with pytest.raises(InputError) as error:
        load(f"{file(text)}{name}")
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    "text",
    [
        SIMPLE + "\n\nclass Helper:\n    pass\n",
        SIMPLE + "\n\nAlias = Team\n",
        "from strategy_of import Team as Base\n\n\nclass Team(Base):\n    pass\n",
        "from soccersim.strategy import Strategy\n\n\nclass Base(Strategy):\n    pass\n\n\n"
        "class Team(Base):\n    def decide(self, view):\n        return 'it'\n",
    ],
)
def test_the_one_class_with_decide_is_meant(file, text):
    file(SIMPLE, "strategy_of.py")
    assert load(file(text)).__name__ == "Team"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("1 / 0\n", ZeroDivisionError),
        ("import nothing_of_this_name\n", ModuleNotFoundError),
        ("def\n", SyntaxError),
        ("raise SystemExit(3)\n", SystemExit),
        ("raise KeyboardInterrupt\n", KeyboardInterrupt),
        ("x = '\udcff'\n".encode("utf-8", "surrogateescape"), SyntaxError),
    ],
)
def test_what_a_teams_own_code_raises_comes_out_as_it_is(file, tmp_path, text, kind):
    path = tmp_path / "team.py"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(kind):
        load(path)


class Taking:
    def __init__(self, rng, press=True, line=2.0):
        self.rng, self.press, self.line = rng, press, line


class TakingAll:
    def __init__(self, rng, **options):
        self.options = options


class Needing:
    def __init__(self, rng, *, formation):
        self.formation = formation


class TakingNothing:
    pass


def test_options_reach_the_strategy_by_name():
    team = make_team(Taking, "dice", {"line": 3})
    assert (team.rng, team.press, team.line) == ("dice", True, 3)
    assert make_team(TakingAll, None, {"any": 1}).options == {"any": 1}
    assert make_team(Needing, None, {"formation": "4-4-2"}).formation == "4-4-2"


@pytest.mark.parametrize(
    ("kind", "options", "message"),
    [
        (Taking, {"pres": 1}, "Taking has no option `pres`: did you mean `press`?"),
        (Taking, {"zone": 1, "up": 2}, "Taking has no option `zone`, `up`: it takes press, line"),
        (Taking, {"rng": 1}, "Taking has no option `rng`: it takes press, line"),
        (Needing, {}, "Needing needs the option `formation`"),
        (TakingNothing, {}, "TakingNothing must take rng: def __init__(self, rng)"),
    ],
)
def test_options_that_a_class_does_not_take_are_named(kind, options, message):
    with pytest.raises(TypeError) as error:
        make_team(kind, None, options)
    assert str(error.value) == message
