"""From a name or a file to a Scenario: read, expand, set, validate."""

from collections.abc import Iterable
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from soccersim import bundled
from soccersim.problems import InputError, Problem
from soccersim.spec.scenario import MAX_ROBOTS, Scenario
from soccersim.spec.validate import validate
from soccersim.spec.yaml12 import Path as TreePath
from soccersim.spec.yaml12 import Tree, parse_setting, read


def load_scenario(
    source: str | PathLike[str], *, seed: int | None = None, settings: Iterable[str] = ()
) -> Scenario:
    """The scenario of a bundled name or a file, with `key.path=value` settings put in.

    Names of robots and fields are expanded first, so that a setting can change any value within.
    InputError with all that is wrong, each at its place.
    """
    path = bundled.find("scenario", fspath(source))
    tree = read(path)
    expand(tree, path.parent)
    for setting in settings:
        tree.set(*parse_setting(setting))
    if seed is not None and isinstance(tree.value, dict):
        tree.set("seed", str(seed), file="--seed")
    expand(tree, path.parent)  # a setting may have named another robot or field
    return validate(Scenario, tree)


def expand(tree: Tree, beside: Path) -> None:
    """Put robots and fields that are named in their files' contents; paths count from `beside`."""
    root: Any = tree.value
    if not isinstance(root, dict):
        return
    _graft(tree, ("field",), root.get("field"), "field", beside)
    robots = root.get("robots")
    if isinstance(robots, list):
        read_files: dict[str, Tree] = {}
        for i, robot in enumerate(robots[: MAX_ROBOTS + 1]):
            if isinstance(robot, dict):
                at = ("robots", i, "model")
                _graft(tree, at, robot.get("model"), "robot", beside, read_files)


def _graft(
    tree: Tree,
    at: TreePath,
    source: object,
    kind: str,
    beside: Path,
    read_files: dict[str, Tree] | None = None,
) -> None:
    """Put the file that a text names in the text's place; leave everything else alone."""
    if not isinstance(source, str):
        return
    files = {} if read_files is None else read_files
    if source not in files:
        try:
            files[source] = read(bundled.find(kind, source, beside))
        except InputError as error:
            mark, dotted = tree.place(at), ".".join(map(str, at))
            problem = error.problems[0]
            if problem.line:
                raise
            message = ": ".join(part for part in (problem.file, problem.message) if part)
            raise InputError(Problem(message, mark.file, mark.line, mark.column, dotted)) from None
    tree.graft(at, files[source])
