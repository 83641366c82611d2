"""`soccersim merge`."""

from pathlib import Path

import click

from soccersim.cli.campaigns import Typed, results_file, typed
from soccersim.cli.verdicts import check_outputs, exit_code_of, report_options, tell
from soccersim.problems import InputError, Problem

SHOWN = 5  # numbers of missing pairs


@click.command("merge", cls=Typed, short_help="Put the shards of a regression together.")
@click.argument(
    "files", nargs=-1, required=True, type=click.Path(path_type=Path), metavar="FILE..."
)
@click.option(
    "--results",
    "--out",
    "results",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Where all matches go. [merged.db]",
)
@report_options
@click.pass_context
def command(
    ctx: click.Context,
    files: tuple[Path, ...],
    results: Path | None,
    report: Path | None,
    junit: Path | None,
    strict: bool,
    as_json: bool,
) -> None:
    """Put what `soccersim worker` has written together, and give the verdict.

    \b
    soccersim merge shard-*.db
    soccersim merge shard-*.db --out all.db --report report.html

    Verdict, table and exit code are those that one `soccersim regress` of all pairs would have
    given. Shards of different code, settings or platforms are refused. A match that is in two
    shards and came out differently makes the regression INVALID.
    """
    path = results_file(results, ("merged",))
    check_outputs(report, junit)
    from soccersim.regress.campaign import Campaign
    from soccersim.regress.shards import merge, missing, plan_in
    from soccersim.regress.store import Store

    if path.exists() and any(file.exists() and path.samefile(file) for file in files):
        wrong = "is one of the shards: name another file for all of them with --out"
        raise InputError(Problem(wrong, str(path)))
    plan = plan_in(files)
    with Store(path) as store:
        merge(plan, files, store)
        campaign = Campaign(plan, store)
        campaign.recall()
        if lacking := missing(plan, store):
            some = ", ".join(map(str, lacking[:SHOWN])) + (", ..." if lacking[SHOWN:] else "")
            wrong = f"{len(lacking)} of {plan.most} pairs are missing ({some})"
            raise InputError(Problem(f"{wrong}: name the files of all shards"))
        account = campaign.account(typed(ctx), 1, 1.0)
        tell(account, report, junit, strict, as_json)
    ctx.exit(exit_code_of(account, strict))
