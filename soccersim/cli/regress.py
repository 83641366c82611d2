"""`soccersim regress`."""

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.campaigns import (
    Typed,
    check_scheduler,
    file_option,
    match_options,
    place,
    planned,
    play_options,
    processors,
    results_file,
    typed,
)
from soccersim.cli.verdicts import check_outputs, exit_code_of, report_options, tell
from soccersim.problems import Stopped

if TYPE_CHECKING:
    from soccersim.regress.account import Account
    from soccersim.regress.plan import Plan
    from soccersim.regress.rules import Rule
    from soccersim.regress.store import Store


@click.command("regress", cls=Typed, short_help="Is the candidate better than the base?")
@click.argument("base")
@click.argument("candidate")
@match_options
@click.option("--pairs", type=click.IntRange(min=1), metavar="N", help="Play so many, then decide.")
@click.option("--sprt", metavar="LOW,HIGH", help="Normalized Elo to decide between. [-25,25]")
@click.option("--alpha", type=float, help="Chance to pass where LOW is true. [0.05]")
@click.option("--beta", type=float, help="Chance to fail where HIGH is true. [0.05]")
@click.option("--max-pairs", type=click.IntRange(min=1), metavar="N", help="At most. [400]")
@click.option("--against", multiple=True, metavar="TEAM...", help="Both play these instead.")
@play_options
@file_option("--results", "Where every match is kept. [BASE-CANDIDATE.db]")
@report_options
@click.pass_context
def command(
    ctx: click.Context,
    base: str,
    candidate: str,
    scenario: str,
    seed: int | None,
    duration: float | None,
    settings: tuple[str, ...],
    pairs: int | None,
    sprt: str | None,
    alpha: float | None,
    beta: float | None,
    max_pairs: int | None,
    against: tuple[str, ...],
    jobs: int | None,
    scheduler: str | None,
    keep: str,
    results: Path | None,
    report: Path | None,
    junit: Path | None,
    strict: bool,
    as_json: bool,
) -> None:
    """Play CANDIDATE against BASE, until it is clear whether it is better.

    A pair of matches is one seed with the sides exchanged.

    \b
    soccersim regress roles ./my_team.py
    soccersim regress roles ./my_team.py --scenario friendly-match --duration 60
    soccersim regress old.py new.py --against roles chaser --pairs 100 --report report.html

    PASS: better. FAIL: worse (exit code 1). INCONCLUSIVE: not clear. IDENTICAL: not one match
    differed. INVALID: more faults than the base, or matches that cannot be repeated (exit code 4).

    Each match is kept in --results as it ends. The same command goes on where it was stopped; code
    that has changed since is played anew. In --set, match.home is BASE and match.away CANDIDATE.
    """
    rule = rule_of(pairs, sprt, alpha, beta, max_pairs)
    check_scheduler(scheduler, jobs)
    path = results_file(results, (base, candidate))
    check_outputs(report, junit)
    plan = planned(
        base,
        candidate,
        against,
        rule,
        scenario=scenario,
        seed=seed,
        duration=duration,
        settings=settings,
        keep=keep,
    )
    from soccersim.regress.store import Store

    with Store(path) as store:
        filmed = report is not None and keep != "none"
        account = played(plan, store, typed(ctx), jobs or processors(), scheduler, filmed)
        tell(account, report, junit, strict, as_json)
    ctx.exit(exit_code_of(account, strict))


def played(
    plan: "Plan", store: "Store", command: str, jobs: int, scheduler: str | None, filmed: bool
) -> "Account":
    """Play it to its verdict. Ctrl-C keeps what is through.

    filmed: play the pairs that differ most once more, where they have no recordings.
    """
    import time

    from soccersim.cli.following import Following
    from soccersim.regress.campaign import Campaign
    from soccersim.regress.filming import film, unfilmed
    from soccersim.regress.shards import keep_plan

    store.forget_void()
    keep_plan(store, plan, command)
    campaign = Campaign(plan, store)
    where = place(plan, store.path, jobs, scheduler)
    start = time.monotonic()
    try:
        with Following() as following:
            campaign.play(where, following.campaign)
        seconds = time.monotonic() - start
        if filmed and (legs := unfilmed(campaign)):
            click.echo(f"playing {len(legs)} matches again, for their replays", err=True)
            with suppress(KeyboardInterrupt):  # the verdict is there: the report has fewer of them
                film(campaign, legs, where)
    except KeyboardInterrupt:
        raise Stopped(
            f"stopped after {campaign.whole} of {plan.rule.most} pairs; {store.path} keeps "
            f"{store.count()} matches: the same command goes on from there"
        ) from None
    return campaign.account(command, jobs, seconds)


def rule_of(
    pairs: int | None,
    sprt: str | None,
    alpha: float | None,
    beta: float | None,
    max_pairs: int | None,
) -> "Rule":
    """The rule to stop by; UsageError where the options contradict each other."""
    from soccersim.regress.rules import Fixed, Sprt

    given = {"sprt": sprt, "alpha": alpha, "beta": beta, "max-pairs": max_pairs}
    named = [f"--{name}" for name, value in given.items() if value is not None]
    if pairs is not None:
        if named:
            raise click.UsageError(f"--pairs plays a fixed number: leave {', '.join(named)} out")
        return Fixed(pairs)
    options: dict[str, Any] = {"alpha": alpha, "beta": beta, "most": max_pairs}
    if sprt is not None:
        options["low"], options["high"] = hypotheses(sprt)
    try:
        return Sprt(**{name: value for name, value in options.items() if value is not None})
    except ValueError as error:
        raise click.UsageError(f"{' '.join(named)}: {error}") from None


def hypotheses(text: str) -> tuple[float, float]:
    """LOW,HIGH."""
    try:
        low, high = (float(part) for part in text.split(","))
    except ValueError:
        raise click.UsageError("--sprt LOW,HIGH: two numbers with a comma, as -25,25") from None
    return low, high
