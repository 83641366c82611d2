"""A strategy is taken with all that belongs to it, and with nothing else."""

import io
import json
from importlib.metadata import version
from zipfile import ZipFile

import pytest

from soccersim.problems import InputError
from soccersim.regress import reach
from soccersim.regress.bundle import Bundle, bundle, same_program, unpack
from soccersim.strategy.load import load_team

TEAM = """\
class Team:
    def decide(self, view):
        return []
"""


@pytest.fixture
def folder(tmp_path):
    """Writes files of a team's folder; the bundle of its mine.py."""

    def write(**files):
        for name, text in files.items():
            path = tmp_path / "team" / (name.replace("__", "/").replace("_dot_", ".") + ".py")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return tmp_path / "team"

    return write


def of(folder, name="mine.py"):
    return bundle(str(folder / name))


def names(taken):
    return ZipFile(io.BytesIO(taken.data)).namelist()


def test_what_a_strategy_imports_from_its_folder_is_taken_and_nothing_else(folder):
    here = folder(
        mine=f"import json, numpy\nimport one\n{TEAM}",
        one="def later():\n    from two import x\n    from . import three",
        two="x = 1",
        three="",
        four="",
    )
    assert names(of(here)) == ["mine.py", "one.py", "three.py", "two.py"]


def test_a_package_is_taken_whole_with_its_data(folder):
    here = folder(mine=f"from tactics.corner import x\n{TEAM}", up="")
    inside = here / "tactics" / "deep"
    inside.mkdir(parents=True)
    (here / "tactics" / "corner.py").write_text("from .. import up\nx = 1")
    (here / "tactics" / "__init__.py").touch()
    (inside / "weights.bin").write_bytes(bytes(9))
    (here / "tactics" / ".hidden").touch()
    (here / "tactics" / "__pycache__").mkdir()
    (here / "tactics" / "__pycache__" / "corner.pyc").touch()
    tactics = ["tactics/__init__.py", "tactics/corner.py", "tactics/deep/weights.bin"]
    assert names(of(here)) == ["mine.py", *tactics, "up.py"]


def test_files_that_the_code_names_are_taken(folder):
    code = (
        'import importlib\nhere / "net.npz"\nimportlib.import_module("helper")\nopen("../secret")\n'
    )
    here = folder(mine=code + TEAM, helper="")
    for name in ("net.npz", "other.npz", "../secret"):
        (here / name).touch()
    assert names(of(here)) == ["helper.py", "mine.py", "net.npz"]


def test_a_module_of_a_package_brings_its_package(tmp_path, monkeypatch):
    package = tmp_path / "club"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / "first.py").write_text("from club import second\nimport beside\n" + TEAM)
    (package / "second.py").touch()
    (tmp_path / "beside.py").write_text("x = 1")
    monkeypatch.syspath_prepend(tmp_path)
    taken = bundle("club.first:Team")
    assert names(taken) == ["beside.py", "club/__init__.py", "club/first.py", "club/second.py"]
    assert json.loads(ZipFile(io.BytesIO(taken.data)).comment)["cls"] == "Team"
    monkeypatch.undo()
    assert load_team(unpack(taken, tmp_path / "elsewhere")).__name__ == "Team"


def test_the_same_files_are_the_same_bundle_and_others_are_not(folder):
    here = folder(mine=f"import one\n{TEAM}", one="x = 1", aside="")
    before = of(here)
    (here / "aside.py").write_text("y = 2")
    (here / "results.db").write_bytes(bytes(99))
    assert of(here) == before
    assert of(here).sha == before.sha
    assert bundle(f"{here}/mine.py:Team").sha != before.sha
    (here / "one.py").write_text("x = 2")
    assert of(here).sha != before.sha


def test_another_version_of_a_library_is_another_bundle(folder, monkeypatch):
    here = folder(mine=f"import yaml\n{TEAM}")
    before = of(here)
    needs = json.loads(ZipFile(io.BytesIO(before.data)).comment)["needs"]
    assert needs == {"PyYAML": version("PyYAML")}
    monkeypatch.setattr("soccersim.regress.bundle.version", lambda name: "99")
    assert of(here).sha != before.sha


def test_a_later_edit_does_not_leak_in(folder, tmp_path):
    here = folder(mine=f"import one\n{TEAM}    speed = one.speed", one="speed = 1")
    taken = of(here)
    (here / "one.py").write_text("speed = 2")
    assert load_team(unpack(taken, tmp_path / "first")).speed == 1
    (tmp_path / "first" / "one.py").write_text("speed = 3")  # as a team itself might
    assert load_team(unpack(taken, tmp_path / "second")).speed == 1


def test_bundled_strategies_are_bundled_too(tmp_path):
    taken = bundle("still")
    assert names(taken) == ["still.py"]
    assert unpack(taken, tmp_path / "x").source == "still"


def test_code_that_is_none_is_taken_as_it_is(folder):
    assert names(of(folder(mine="import one\nthis is no code", one=""))) == ["mine.py"]


def test_a_folder_of_everything_is_refused(folder, monkeypatch):
    here = folder(mine=f"import one\n{TEAM}", one="x = 1")
    monkeypatch.setattr(reach, "MOST_FILES", 1)
    with pytest.raises(
        InputError, match=r"mine\.py: with all that it imports it is more than 16 Mi"
    ):
        of(here)
    monkeypatch.setattr(reach, "MOST_FILES", 9)
    monkeypatch.setattr(reach, "MOST_BYTES", 70)
    with pytest.raises(InputError, match=r"it stopped at .*one\.py"):
        of(here)


@pytest.mark.parametrize("name", ["../out.py", "/tmp/out.py", "a/../../out.py", "c:\\out.py"])
def test_no_bundle_writes_outside_its_folder(tmp_path, name):
    file = io.BytesIO()
    with ZipFile(file, "w") as archive:
        archive.writestr(name, "")
        archive.comment = b'{"module": "out", "cls": "", "needs": {}}'
    with pytest.raises(InputError, match="evil: is a damaged bundle"):
        unpack(Bundle("evil", file.getvalue()), tmp_path / "in")
    assert not list(tmp_path.rglob("*.py"))


def test_what_is_no_bundle_is_refused(tmp_path):
    for data in (b"", b"PK", bundle("still").data[:-3]):
        with pytest.raises(InputError, match="is a damaged bundle"):
            unpack(Bundle("x", data), tmp_path / "x")


def test_a_copy_under_another_name_is_the_same_program(folder):
    here = folder(one=TEAM, two=TEAM, three=TEAM + "# changed\n")
    one, two, three = (of(here, f"{name}.py") for name in ("one", "two", "three"))
    assert one.sha != two.sha
    assert same_program(one, one)
    assert same_program(one, two)
    assert not same_program(one, three)
    assert not same_program(one, of(here, "two.py:Team"))


def test_a_copy_that_imports_other_code_is_another_program(folder):
    text = "import help\n" + TEAM
    one = of(folder(one=text, help="x = 1"), "one.py")
    assert same_program(one, of(folder(two=text), "two.py"))
    assert not same_program(one, of(folder(two=text, help="x = 2"), "two.py"))
