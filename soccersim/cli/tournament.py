"""`soccersim tournament`."""

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.campaigns import (
    Typed,
    check_scheduler,
    file_option,
    match_options,
    own_options,
    place,
    play_options,
    processors,
    results_file,
)
from soccersim.cli.main import INVALID
from soccersim.problems import InputError, Problem, Stopped, one_line

if TYPE_CHECKING:
    from soccersim.cli.campaigns import Place
    from soccersim.regress.row import Row
    from soccersim.regress.store import Store
    from soccersim.regress.tournament import Tournament

PAIRS = 10
SHOWN = 5  # matches that did not come out the same


@click.command("tournament", cls=Typed, short_help="Every team against every other.")
@click.argument("teams", nargs=-1, required=True, metavar="TEAM TEAM...")
@match_options
@click.option(
    "--pairs",
    type=click.IntRange(min=1),
    default=PAIRS,
    show_default=True,
    metavar="N",
    help="Of matches between every two teams.",
)
@play_options
@file_option("--results", "Where every match is kept. [tournament.db]")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
@click.pass_context
def command(
    ctx: click.Context,
    teams: tuple[str, ...],
    scenario: str,
    seed: int | None,
    duration: float | None,
    settings: tuple[str, ...],
    pairs: int,
    jobs: int | None,
    scheduler: str | None,
    keep: str,
    results: Path | None,
    as_json: bool,
) -> None:
    """Let every two TEAMs play pairs of matches, one seed with the sides exchanged, and rate them.

    \b
    soccersim tournament roles chaser positioning
    soccersim tournament roles chaser ./my_team.py --pairs 50 --scenario friendly-match

    A win is 3 points, a draw 1. The rating is Elo about the mean of the field, with its 95 %
    interval. Each match is kept in --results as it ends, and the same command goes on where it was
    stopped. A team that fails forfeits that match: the table is whole, and tells how often, but the
    exit code is 4, for its numbers say less of how teams play.
    """
    check_scheduler(scheduler, jobs)
    path = results_file(results, ("tournament",))
    asked = drawn_up(teams, pairs, scenario, seed, duration, settings, keep)
    where = place(asked, path, jobs or processors(), scheduler)
    from soccersim.cli.league_tables import show
    from soccersim.regress.store import Store

    with Store(path) as store:
        rows = played(asked, store, where)
        broken = moody(asked, store)
        document = told(asked, rows, str(path), store.added, len(broken))
        table = asked.table(rows)
    if as_json:
        click.echo(json.dumps(document, allow_nan=False))
    else:
        show(table, document)
    if forfeits := Counter(fault["team"] for fault in document["faults"]):
        each = ", ".join(f"{team} {count}" for team, count in forfeits.most_common())
        click.echo(f"matches forfeited: {each}", err=True)
    if broken:
        click.echo(f"played twice, and came out differently: {'; '.join(broken[:SHOWN])}", err=True)
    if forfeits or broken:
        ctx.exit(INVALID)


def drawn_up(
    teams: Sequence[str],
    pairs: int,
    scenario: str,
    seed: int | None,
    duration: float | None,
    settings: Sequence[str],
    keep: Any,
) -> "Tournament":
    """The tournament, with all code as it is now; InputError with what is wrong."""
    from soccersim.cli.run import check_seeds
    from soccersim.match.request import match_request
    from soccersim.regress.bundle import bundle
    from soccersim.regress.plan import Team
    from soccersim.regress.tournament import Tournament

    if len(teams) < 2:
        raise click.UsageError("a tournament needs two teams at least")
    if twice := [name for name in dict.fromkeys(teams) if teams.count(name) > 1]:
        raise InputError(Problem("is named twice", one_line(twice[0], 200)))
    for setting in settings:
        if setting.startswith(("match.home.", "match.away.")):
            wrong = "the teams of a tournament take turns: set options in a class of your own"
            raise InputError(Problem(f"--set {one_line(setting)}: {wrong}"))
    asked = match_request(
        teams[0], teams[1], scenario, seed=seed, duration=duration, settings=settings
    )
    check_seeds(asked.scenario.seed, pairs)
    given = own_options(scenario)
    entered = tuple(Team(bundle(name), given.get(name, {})) for name in teams)
    return Tournament(asked.scenario, entered, pairs, asked.scenario.seed, keep)


def played(asked: "Tournament", store: "Store", where: "Place") -> "dict[str, Row]":
    """The rows of all legs, by their keys. Ctrl-C keeps what is through."""
    from soccersim.cli.following import Following
    from soccersim.regress.campaign import gathered

    store.forget_void()
    store.keep_bundles(team.bundle for team in asked.teams)
    rows: dict[str, Row] = {}
    legs = list(asked.legs())
    try:
        with Following() as following:
            for leg, row in gathered(legs, store, where):
                rows[leg.key] = row
                following.matches(store.added, len(rows), len(legs))
    except KeyboardInterrupt:
        raise Stopped(
            f"stopped after {len(rows)} of {len(legs)} matches; {store.path} keeps them: the same "
            "command goes on from there"
        ) from None
    return rows


def moody(asked: "Tournament", store: "Store") -> list[str]:
    """The matches that came out differently when they were played again."""
    keys = {found.key for found in store.contradictions()}
    return [
        f"{leg.home.name} - {leg.away.name}, seed {leg.seed}"
        for leg in (asked.legs() if keys else ())
        if leg.key in keys
    ]


def told(
    asked: "Tournament", rows: "dict[str, Row]", results: str, added: int, broken: int
) -> dict[str, Any]:
    """The document of --json."""
    names = [(leg, leg.home.name, leg.away.name) for leg in asked.legs()]
    faults = [
        {
            "team": home if fault["side"] == "home" else away,
            "pair": leg.pair,
            "leg": leg.leg,
            "seed": leg.seed,
            **fault,
        }
        for leg, home, away in names
        for fault in rows[leg.key].faults
    ]
    return {
        **asked.table(rows).document(),
        "scenario": asked.scenario.name,
        "seed": asked.seed,
        "faults": faults,
        "void": sum(bool(rows[leg.key].void) for leg, _, _ in names),
        "contradictions": broken,
        "matches": {"played": added, "found": len(names) - added},
        "results": results,
    }
