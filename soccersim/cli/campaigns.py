"""What regress, worker and tournament share: options, teams, and where matches are played."""

import json
import os
import re
import shlex
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.problems import InputError, MachineError, Problem, one_line

if TYPE_CHECKING:
    from soccersim.regress.plan import Plan, Schedule
    from soccersim.regress.pool import Pool
    from soccersim.regress.rules import Rule

Command = Callable[..., Any]
Place = Callable[[], "AbstractContextManager[Pool]"]
LIST = "--against"  # takes all words up to the next option
TYPED = "soccersim.typed"
MOST_JOBS = 256
NAME = 80  # characters of a results file's name that come from the teams' names


class Typed(click.Command):
    """A command that keeps what was typed, and whose --against takes several teams."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the command line."""
        ctx.meta[TYPED] = list(args)
        return super().parse_args(ctx, list(spread(args)))


def spread(args: Sequence[str]) -> list[str]:
    """The words, --against before each team that follows it."""
    out: list[str] = []
    taking = False
    for word in args:
        taking = word == LIST or (taking and not word.startswith("-"))
        if taking and word != LIST and out[-1] != LIST:
            out.append(LIST)
        out.append(word)
    return out


def typed(ctx: click.Context) -> str:
    """The command as it was typed, for a shell."""
    return shlex.join(["soccersim", str(ctx.info_name), *ctx.meta.get(TYPED, ())])


def match_options(function: Command) -> Command:
    """--scenario, --seed, --duration, --set."""
    for option in reversed(
        [
            click.option(
                "--scenario", default="msl-match", show_default=True, help="Bundled name or file."
            ),
            click.option(
                "--seed",
                type=click.IntRange(min=0),
                help="Of the first pair, instead of the scenario's own.",
            ),
            click.option("--duration", type=float, metavar="S", help="Seconds of each match."),
            click.option(
                "--set", "settings", multiple=True, metavar="KEY.PATH=VALUE", help="Change a value."
            ),
        ]
    ):
        function = option(function)
    return function


def play_options(function: Command) -> Command:
    """--jobs, --scheduler, --keep."""
    kept = click.Choice(["all", "faults", "lost", "none"])
    for option in reversed(
        [
            click.option(
                "--jobs", type=click.IntRange(1, MOST_JOBS), help="Matches at a time. [all cores]"
            ),
            click.option("--scheduler", metavar="ADDRESS", help="Play on this Dask cluster."),
            click.option(
                "--keep",
                type=kept,
                default="faults",
                show_default=True,
                help="Of which matches recordings are kept.",
            ),
        ]
    ):
        function = option(function)
    return function


def file_option(name: str, words: str) -> Callable[[Command], Command]:
    """An option that names a file."""
    return click.option(name, type=click.Path(path_type=Path), metavar="FILE", help=words)


def planned(
    base: str,
    candidate: str,
    against: Sequence[str],
    rule: "Rule",
    *,
    scenario: str,
    seed: int | None,
    duration: float | None,
    settings: Sequence[str],
    keep: Any,
) -> "Plan":
    """The plan, with all code as it is now; InputError with what is wrong."""
    from soccersim.cli.run import check_seeds
    from soccersim.match.request import match_request
    from soccersim.regress.bundle import bundle
    from soccersim.regress.plan import Plan, Team

    given = own_options(scenario)
    own = [
        f"match.{side}.options={json.dumps(given.get(name, {}))}"
        for side, name in (("home", base), ("away", candidate))
    ]
    spec = match_request(
        base, candidate, scenario, seed=seed, duration=duration, settings=[*own, *settings]
    ).scenario
    check_seeds(spec.seed, rule.most)
    home, away = (spec.match.home, spec.match.away) if spec.match else (None, None)
    one = Team(bundle(base), home.options if home else {})
    two = Team(bundle(candidate), away.options if away else {})
    opponents = tuple(Team(bundle(name), given.get(name, {})) for name in against)
    return Plan(spec, one, two, opponents, rule, spec.seed, keep)


def own_options(scenario: str) -> dict[str, dict[str, Any]]:
    """What the scenario itself gives to its teams, by their strategies' names."""
    from soccersim.spec.load import load_scenario

    match = load_scenario(scenario).match
    sides = (match.away, match.home) if match else ()
    return {side.strategy: dict(side.options) for side in sides}


def place(schedule: "Schedule", results: Path, jobs: int, scheduler: str | None) -> Place:
    """Where the matches are played; says so when the first one has to be."""
    text, name = schedule.meetings[0].scenario, schedule.scenario.name
    said: list[str] = []

    def say(where: str) -> None:
        goes_on = "Ctrl-C stops it, and the same command goes on"
        if not said:
            said.append(f"playing {name}{where}, into {results}; {goes_on}")
            click.echo(said[0], err=True)

    def here() -> "AbstractContextManager[Pool]":
        from soccersim.cli.run import announce_compiling
        from soccersim.regress.ground import Ground
        from soccersim.regress.pool import LocalPool

        announce_compiling()
        say(f", {jobs} at a time" if jobs > 1 else ", one at a time")
        return LocalPool(jobs, Ground(text))

    def cluster() -> "AbstractContextManager[Pool]":
        from soccersim.regress.cluster import cluster_pool

        say(f" at {scheduler}")
        return cluster_pool(str(scheduler), text)

    return cluster if scheduler else here


def processors() -> int:
    """How many this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return min(len(os.sched_getaffinity(0)), MOST_JOBS)
    return min(os.cpu_count() or 1, MOST_JOBS)


def results_file(given: Path | None, teams: Sequence[str]) -> Path:
    """Where the results are kept: a file named after the teams unless it is told."""
    path = given or Path("-".join(map(short_name, teams))[:NAME].rstrip("-.") + ".db")
    check_file(path, "--results")
    return path


def short_name(team: str) -> str:
    """A team's name as a part of a file's name: my_team for teams/my_team.py."""
    source, _, cls = team.rpartition(":")
    stem = Path(source or cls).name.removesuffix(".py")
    words = [stem, cls] if source else [stem]
    return re.sub(r"[^\w.]+", "_", ".".join(words)) or "team"


def check_file(path: Path | None, option: str, suffixes: Sequence[str] = ()) -> None:
    """InputError where a file of this name could not be written, before hours go into it.

    suffixes: one of which the name must have, as such a file is written over.
    """
    if path is None:
        return
    shown = one_line(str(path), 200)
    if suffixes and path.suffix not in suffixes:
        wrong = f"{option} is written over: its name must end in {' or '.join(suffixes)}"
        raise InputError(Problem(wrong, shown))
    try:
        if path.is_dir():
            raise InputError(Problem(f"is a folder: {option} names a file", shown))
        if not path.parent.is_dir():
            raise InputError(Problem("the folder for it is not there: make it first", shown))
    except (OSError, ValueError) as error:  # a name too long, a NUL in it
        raise MachineError(f"{shown}: {getattr(error, 'strerror', None) or error}") from error


def check_scheduler(scheduler: str | None, jobs: int | None) -> None:
    """UsageError where two tell how many matches are played at a time."""
    if scheduler and jobs:
        raise click.UsageError("--jobs is of this machine: a cluster plays as many as it can")
