"""`soccersim new`."""

import keyword
import re
import sys
from pathlib import Path

import click

from soccersim.problems import InputError, Problem, one_line

START = Path(__file__).parents[1] / "strategy" / "newcomer.py"
TAKEN = {"soccersim", "pytest", "numpy", *sys.stdlib_module_names}  # modules that tests import
IMPORTED = {"Any", "Ball", "Command", "Path", "Phase", "Player", "Strategy", "View"}  # by the files
TEST = '''\
"""{Class} answers, and plays: run it with `pytest {test}`."""

from pathlib import Path

import numpy as np
from soccersim import play_match
from soccersim.strategy import Ball, Player, View

from {module} import {Class}

FILE = Path(__file__).parent / "{module}.py"


def test_a_robot_with_the_ball_before_an_open_goal_kicks():
    keeper = Player(number=1, x=-10.5, y=0.0, role="keeper")
    striker = Player(number=2, x=8.0, y=0.0, has_ball=True)
    view = View(robots=(keeper, striker), ball=Ball(8.35, 0.0))
    _, command = {Class}(np.random.default_rng(1)).decide(view)
    assert command.kick > 0


def test_it_plays_ten_seconds_without_a_fault():
    outcome = play_match(FILE, "still", duration=10, seed=1)
    assert outcome.faults == []
    assert outcome.duration == 10
'''


@click.command("new", short_help="A strategy to start from, with its test.")
@click.argument("name")
@click.option("--force", is_flag=True, help="Overwrite files that are there.")
def command(name: str, force: bool) -> None:
    """Write NAME.py, a strategy that plays at once, and test_NAME.py, which shows that it does.

    \b
    soccersim new my_team
    soccersim match ./my_team.py chaser      see how it does
    pytest test_my_team.py

    NAME may stand in a folder: teams/my_team.
    """
    module = Path(name).name.removesuffix(".py")
    check(module)
    path = Path(name).with_name(f"{module}.py")
    if not path.parent.is_dir():
        raise InputError(Problem("there is no such folder: make it first", str(path.parent)))
    test = path.with_name(f"test_{module}.py")
    for each in (path, test):
        if not force and (each.exists() or each.is_symlink()):
            raise InputError(Problem("is there already: --force overwrites it", str(each)))
    words = {"module": module, "Class": class_name(module), "test": test.name}
    start = START.read_text(encoding="utf-8")
    path.write_text(start.replace("Newcomer", words["Class"]), encoding="utf-8")
    test.write_text(TEST.format(**words), encoding="utf-8")
    click.echo(f"{path}: the strategy; {test}: its test. Next:")
    click.echo(f"  soccersim match {shown(path)} chaser")


def check(module: str) -> None:
    """InputError where a strategy's module cannot be called so."""
    wrong = ""
    if not re.fullmatch(r"[A-Za-z]\w*", module, re.ASCII) or keyword.iskeyword(module):
        wrong = "cannot be a module's name: letters, digits and _, a letter first"
    elif module in TAKEN or module.startswith("test_"):
        wrong = "is taken, its test could not import it: choose another, such as my_team"
    if wrong:
        raise InputError(Problem(f"`{one_line(module)}` {wrong}"))


def class_name(module: str) -> str:
    """MyTeam for my_team; ViewTeam for view, which the file has already."""
    name = "".join(part[:1].upper() + part[1:] for part in module.split("_"))
    unfit = not name.isidentifier() or keyword.iskeyword(name) or name in IMPORTED
    return f"{name}Team" if unfit and f"{name}Team".isidentifier() else name


def shown(path: Path) -> str:
    """The path as a strategy is named on the command line: with a folder."""
    return str(path) if len(path.parts) > 1 else f"./{path}"
