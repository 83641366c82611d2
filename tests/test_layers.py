"""Who may know whom: dependencies run one way, and a robot's own code cannot see the truth."""

import ast
from functools import cache
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "soccersim"
FOUNDATION = {"problems", "kernel", "geometry", "streams", "kinematics", "spec", "state"}
PARTS = {"plant", "sensing", "estimation", "control"}
ARMS = {"limbs", "arm_report"}
TOLD = {"sheet", "touches", "shots", "match_report"}  # of a match, from its recording
MATCH = {"strategy", "referee", "perception", "match", "verify"} | TOLD
LOOP = {"limbs", "machine", "simulation", "record"}
ALL = FOUNDATION | PARTS | ARMS | LOOP | {"bundled", "report", "workers", "processes", "repeat"}
MAY_IMPORT = {  # part: what it may import besides itself and the name and version on top
    "problems": set(),
    "processes": set(),
    "workers": {"problems", "processes"},
    "streams": set(),
    "kernel": set(),
    "state": set(),
    "sheet": set(),
    "geometry": {"kernel"},
    "kinematics": {"geometry", "kernel"},
    "bundled": {"problems"},
    "spec": {"problems", "kinematics", "bundled"},
    **dict.fromkeys(PARTS, FOUNDATION),  # never each other
    "record": {"problems", "kernel", "spec", "state"},
    # recordings are its world; of state it takes the names of types
    "render": {"problems", "kernel", "kinematics", "spec", "record", "bundled", "state"}
    | {"arm_report"}
    | TOLD,
    "export": {"problems", "spec", "record", "render"} | TOLD,
    "arm_report": {"record", "spec"},
    "report": {"record", "spec", "arm_report"},
    "limbs": FOUNDATION | PARTS,
    "strategy": {"sheet", "problems", "bundled"},  # small: it runs in processes of its own
    "referee": {"geometry", "kernel", "spec", "state", "problems"},
    "perception": FOUNDATION | {"sensing", "estimation", "control", "sheet"},
    "machine": FOUNDATION | PARTS | {"record", "limbs", "referee"},
    "simulation": FOUNDATION | PARTS | {"record", "limbs", "machine", "referee"},
    "match": ALL | MATCH - {"verify"},
    "touches": {"record", "sheet"},
    "shots": {"sheet", "spec", "touches"},
    "match_report": {"record", "sheet", "touches", "shots"},
    "verify": {"problems", "record", "simulation", "match"},
    "repeat": {"record", "report", "simulation", "spec", "workers"},
    "regress": {"problems", "processes", "spec", "record", "strategy", "match", "render"},
    "bench": ALL | {"render"},
    "live": ALL | MATCH - {"verify"} | {"render"},
    "reproduce": ALL | {"render"},
    "tune": ALL | {"render"},
    "cli": ALL | MATCH | {"regress", "render", "export", "bench", "reproduce", "tune", "live"},
    "__main__": {"cli"},
}
FILES = sorted(PACKAGE.rglob("*.py"))
SOURCES = [path for path in FILES if path != PACKAGE / "__init__.py"]  # the front door


@cache
def tree(path):
    return ast.parse(path.read_text(encoding="utf-8"))


def name(path):
    return str(path.relative_to(PACKAGE))


def part(path):
    """geometry for soccersim/geometry.py, plant for all of soccersim/plant/."""
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imports(path):
    """Every module that is imported, wherever it stands: also for types, also by import_module."""
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Call) and "import_module" in ast.dump(node.func):
            first = node.args[0]
            yield first.value if isinstance(first, ast.Constant) else ast.unparse(first)


def names(path):
    """Every name that is used."""
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Name):
            yield node.id
        elif isinstance(node, ast.Attribute):
            yield node.attr
        elif isinstance(node, ast.alias):
            yield node.name


def users(library):
    return {name(p) for p in FILES for module in imports(p) if module.split(".")[0] == library}


@pytest.mark.parametrize("path", SOURCES, ids=map(name, SOURCES))
def test_every_part_imports_only_what_it_may_know(path):
    ours = {module.split(".")[1] for module in imports(path) if module.startswith("soccersim.")}
    assert ours - {part(path), "__version__"} <= MAY_IMPORT[part(path)]


def test_a_robots_own_code_never_names_the_truth():
    sources = [path for path in SOURCES if part(path) in ("estimation", "control", "strategy")]
    assert len(sources) > 5
    assert [name(path) for path in sources if {"Truth", "truth"} & set(names(path))] == []


def test_the_physics_engine_the_compiler_and_the_screen_have_one_door_each():
    assert users("numba") == {"kernel.py"}
    assert all(user.startswith("plant/") for user in users("pymunk"))
    assert all(user.startswith("render/") for user in users("pygame") | users("av"))
    assert all(user.startswith("cli/") for user in users("click") | users("rich"))
    assert users("pymunk")
    assert users("pygame")


def test_nothing_is_checked_with_assert():
    asserts = [
        f"{name(path)}:{node.lineno}"
        for path in FILES
        for node in ast.walk(tree(path))
        if isinstance(node, ast.Assert)
    ]
    assert asserts == []


def test_no_file_outgrows_a_reader():
    assert [name(path) for path in FILES if len(path.read_text().splitlines()) > 300] == []
