"""What `soccersim regress` and `merge` show at the end: the verdict first, then its evidence."""

from collections import Counter
from itertools import pairwise
from typing import Any

from rich.markup import escape
from rich.table import Table

from soccersim.cli.following import shown_time
from soccersim.cli.tables import Screen, new_table
from soccersim.match.turn import SIDES
from soccersim.problems import one_line
from soccersim.regress.account import Account, Match
from soccersim.regress.rules import Sprt
from soccersim.regress.standing import Verdict
from soccersim.regress.statistics import Estimate

SENTENCES = {
    Verdict.PASS: ("green", "{candidate} is better than {base}"),
    Verdict.FAIL: ("red", "{candidate} is worse than {base}"),
    Verdict.INCONCLUSIVE: ("yellow", "{candidate} may be better or worse than {base}"),
    Verdict.IDENTICAL: ("blue", "{candidate} plays exactly as {base} does"),
    Verdict.INVALID: ("magenta", "{candidate} and {base} cannot be compared"),
}
MOST_FAULTS = 5  # shown


def show(account: Account) -> None:
    """Print it on standard output."""
    console = Screen(highlight=False, soft_wrap=True)
    standing = account.standing
    if standing.verdict:
        color, words = SENTENCES[standing.verdict]
        told = words.format(candidate=escape(account.candidate), base=escape(account.base))
        console.print(f"[bold {color}]{standing.verdict}[/]  {told}")
    for reason in standing.reasons:
        console.print(escape(reason))
    for warning in standing.warnings:
        console.print(f"[yellow]warning: {escape(warning)}[/]")
    console.print(evidence(account))
    faults = fault_list(account)
    if faults:
        console.print(faults_table(faults))
    console.print(f"[dim]again: {escape(account.command)}[/]")


def evidence(account: Account) -> Table:
    """A row a figure."""
    standing = account.standing
    table = Table.grid(padding=(0, 2))
    table.add_column(no_wrap=True)
    table.add_column(overflow="fold")
    most = "" if standing.numbers == account.rule.most else f", at most {account.rule.most}"
    void = f", {standing.void} void" if standing.void else ""
    rows = {
        "pairs": f"{standing.pairs} of {account.scenario}{most}{void}",
        "diverged": diverged(account),
        "normalized Elo": span(standing.elo, 0),
        "goals a match": span(standing.goal_difference, 2),
        "matches": tally(account),
        "pairs LL LD DD DW WW": " ".join(map(str, standing.counts)),
    }
    if standing.base_counts:
        rows["of the base"] = " ".join(map(str, standing.base_counts))
    low, high = standing.bounds
    if isinstance(account.rule, Sprt):
        rule = f"{account.rule.low:g} and {account.rule.high:g} nElo"
        rows["log-likelihood ratio"] = f"{standing.llr:.2f}, bounds {low:.2f} {high:.2f}; {rule}"
    rows["faults"] = f"candidate {standing.faults}, base {standing.base_faults}"
    rows |= costs(account)
    rows["results"] = f"{account.store}"
    for name, told in rows.items():
        table.add_row(name, escape(told))
    return table


def diverged(account: Account) -> str:
    """How many pairs differed at all."""
    standing = account.standing
    first = "" if standing.parted is None else f", first at tick {standing.parted}"
    return f"{standing.diverged} of {standing.pairs} pairs{first}"


def costs(account: Account) -> dict[str, str]:
    """What the matches took, and what the runner took besides."""
    rows = [match.row for match in account.matches if not match.row.void]
    if not rows:
        return {}
    playing, besides = (
        sum(getattr(row, key) for row in rows) / len(rows) for key in ("seconds", "overhead")
    )
    told = {"a match took": f"{playing:.2f} s, and {besides:.2f} s for process and store"}
    if account.played:
        rate = 3600 * account.played / account.seconds
        took = f"{account.played} matches in {shown_time(account.seconds)}"
        told["this run"] = f"{took}, {rate:.0f} an hour, {account.jobs} at a time"
    if account.found:
        there = f"{account.found} matches were there already"
        told["this run"] = f"{told['this run']}; {there}" if account.played else there
    return told


def tally(account: Account) -> str:
    """Matches won, drawn and lost, and goals; in a comparison of both."""
    each = [("candidate", account.candidate)]
    if account.against:
        each.append(("base", account.base))
    told = []
    for who, name in each:
        seen = [(match, getattr(match, who)) for match in account.matches]
        goals = [
            (match.row.score[slot], match.row.score[1 - slot])
            for match, slot in seen
            if slot is not None and not match.row.void
        ]
        won = Counter((us > them) - (us < them) for us, them in goals)
        ours, theirs = (sum(score[k] for score in goals) for k in (0, 1))
        words = f"{won[1]} won, {won[0]} drawn, {won[-1]} lost, goals {ours}:{theirs}"
        told.append(f"{name} {words}" if account.against else words)
    return "; ".join(told)


def fault_list(account: Account) -> list[dict[str, Any]]:
    """All faults, with the team that is to blame and the match."""
    return [
        {
            "team": match.home if fault["side"] == SIDES[0] else match.away,
            "as": role(match, SIDES.index(fault["side"])),
            "pair": match.row.pair,
            "leg": match.row.leg,
            "seed": match.row.seed,
            **fault,
        }
        for match in account.matches
        for fault in match.row.faults
    ]


def role(match: Match, slot: int) -> str:
    """What the team in this slot is to the regression."""
    if match.candidate == slot:
        return "candidate"
    return "base" if match.base == slot else "opponent"


def faults_table(faults: list[dict[str, Any]]) -> Table:
    """The first of them."""
    title = "faults" if len(faults) <= MOST_FAULTS else f"the first of {len(faults)} faults"
    table = new_table(title, "team")
    for name in ("pair", "leg", "tick"):
        table.add_column(name, justify="right", no_wrap=True)
    table.add_column("what")
    for fault in faults[:MOST_FAULTS]:
        where = (str(fault[key]) for key in ("pair", "leg", "tick"))
        what = one_line(f"{fault['kind']}: {gist(fault['detail'])}", 200)
        table.add_row(escape(fault["team"]), *where, escape(what))
    return table


def gist(detail: str) -> str:
    """The line of a traceback that names the exception; else the last one."""
    lines = detail.strip().splitlines() or [""]
    named = [two for one, two in pairwise(lines) if one[:1] == " " and two[:1] != " "]
    return (named or lines)[-1]


def span(estimate: Estimate, digits: int) -> str:
    """A number and its 95 % interval."""
    value, low, high = (f"{number:+.{digits}f}" for number in estimate)
    return f"{value} (95 %: {low} to {high})"
