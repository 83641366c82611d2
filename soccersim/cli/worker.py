"""`soccersim worker`."""

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.campaigns import (
    Typed,
    check_file,
    check_scheduler,
    file_option,
    match_options,
    place,
    planned,
    play_options,
    processors,
    typed,
)
from soccersim.problems import Stopped

if TYPE_CHECKING:
    from soccersim.cli.campaigns import Place
    from soccersim.regress.leg import Leg
    from soccersim.regress.store import Store


@click.command("worker", cls=Typed, short_help="Play one shard of a regression.")
@click.argument("base")
@click.argument("candidate")
@match_options
@click.option(
    "--pairs", type=click.IntRange(min=1), required=True, metavar="N", help="Of all shards."
)
@click.option("--against", multiple=True, metavar="TEAM...", help="Both play these instead.")
@play_options
@click.option("--shard", required=True, metavar="I/N", help="Which shard of how many: 1/4 to 4/4.")
@file_option("--out", "Where its matches are kept.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
@click.pass_context
def command(
    ctx: click.Context,
    base: str,
    candidate: str,
    scenario: str,
    seed: int | None,
    duration: float | None,
    settings: tuple[str, ...],
    pairs: int,
    against: tuple[str, ...],
    jobs: int | None,
    scheduler: str | None,
    keep: str,
    shard: str,
    out: Path | None,
    as_json: bool,
) -> None:
    """Play one shard of a regression of --pairs N, for batch systems and many machines.

    \b
    soccersim worker roles ./my_team.py --pairs 1000 --shard 1/4 --out shard-1.db
    soccersim merge shard-*.db

    Every shard is given the same words but for --shard and --out. The same command goes on where it
    was stopped. `soccersim merge` puts the shards together and gives the verdict that one
    `soccersim regress` would have given.
    """
    if out is None:
        raise click.UsageError("--out FILE: where this shard's matches are kept")
    which, shards = shard_of(shard)
    check_scheduler(scheduler, jobs)
    check_file(out, "--out")
    from soccersim.regress.rules import Fixed
    from soccersim.regress.shards import keep_plan
    from soccersim.regress.store import Store

    plan = planned(
        base,
        candidate,
        against,
        Fixed(pairs),
        scenario=scenario,
        seed=seed,
        duration=duration,
        settings=settings,
        keep=keep,
    )
    where = place(plan, out, jobs or processors(), scheduler)
    with Store(out) as store:
        store.forget_void()
        keep_plan(store, plan, typed(ctx))
        legs = list(plan.legs(shard=which - 1, shards=shards))
        document = played(legs, store, where)
    document = {"shard": [which, shards], "pairs": pairs, **document, "results": str(out)}
    if as_json:
        click.echo(json.dumps(document))
    else:
        told = (
            f"{document['matches']} matches, {document['faults']} faults, {document['void']} void"
        )
        click.echo(f"shard {which} of {shards}: {told}, in {out}")
        click.echo("when all are there: soccersim merge FILE...")


def shard_of(text: str) -> tuple[int, int]:
    """I/N, I from 1 to N."""
    found = re.fullmatch(r"(\d{1,9})/(\d{1,9})", text)
    if not found or not 1 <= int(found[1]) <= int(found[2]):
        raise click.UsageError("--shard I/N: I from 1 to N, as 1/4 for the first of four")
    return int(found[1]), int(found[2])


def played(legs: "list[Leg]", store: "Store", where: "Place") -> dict[str, Any]:
    """Play what is missing, and count. Ctrl-C keeps what is through."""
    from soccersim.cli.following import Following
    from soccersim.regress.campaign import gathered

    matches = faults = void = 0
    try:
        with Following() as following:
            for _, row in gathered(legs, store, where):
                matches += 1
                faults += len(row.faults)
                void += bool(row.void)
                following.matches(store.added, matches, len(legs))
    except KeyboardInterrupt:
        raise Stopped(
            f"stopped after {matches} of {len(legs)} matches; {store.path} keeps them: the same "
            "command goes on from there"
        ) from None
    return {"matches": matches, "faults": faults, "void": void, "played": store.added}
