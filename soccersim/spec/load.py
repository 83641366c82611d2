"""From a name or a file to a Scenario: read, expand, set, validate."""

from collections.abc import Iterable
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from soccersim import bundled
from soccersim.problems import InputError, Problem
from soccersim.spec import MAX_ROBOTS
from soccersim.spec.yaml12 import MAX_NODES, Tree, parse_setting, read
from soccersim.spec.yaml12 import Path as TreePath

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario


def load_scenario(
    source: str | PathLike[str], *, seed: int | None = None, settings: Iterable[str] = ()
) -> "Scenario":
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
    # pydantic and numpy take half a second: what cannot be read is refused before
    from soccersim.spec.scenario import Scenario
    from soccersim.spec.validate import validate

    return validate(Scenario, tree)


def expand(tree: Tree, beside: Path) -> None:
    """Put robots, fields, rules and senses that are named in their files' contents.

    A path in a file counts from `beside`, one on the command line from the working folder.
    """
    root: Any = tree.value
    if not isinstance(root, dict):
        return
    graft(tree, ("field",), root.get("field"), "field", beside, {})
    graft(tree, ("senses",), root.get("senses"), "senses", beside, {})
    match = root.get("match")
    if isinstance(match, dict):
        graft(tree, ("match", "rules"), match.get("rules"), "rules", beside, {})
    robots = root.get("robots")
    if isinstance(robots, list):
        files: dict[Path, Tree] = {}
        for i, robot in enumerate(robots[: MAX_ROBOTS + 1]):
            if isinstance(robot, dict):
                graft(tree, ("robots", i, "model"), robot.get("model"), "robot", beside, files)


def graft(
    tree: Tree, at: TreePath, source: object, kind: str, beside: Path, files: dict[Path, Tree]
) -> None:
    """Put the file that a text names in the text's place; leave everything else alone."""
    if not isinstance(source, str):
        return
    place, dotted = tree.place(at), ".".join(map(str, at))
    try:
        path = bundled.find(kind, source, beside if place.line else Path())
        if path not in files:
            files[path] = read(path)
    except InputError as error:
        problem = error.problems[0]
        if problem.line:
            raise
        message = ": ".join(part for part in (problem.file, problem.message) if part)
        raise InputError(Problem(message, *place, dotted)) from None
    tree.graft(at, files[path])
    if len(tree.marks) + len(tree.keys) > MAX_NODES:  # robots written out may be as many
        wrong = f"with this {kind} the scenario has more than {MAX_NODES} keys and values: use less"
        raise InputError(Problem(wrong, *place, dotted))
