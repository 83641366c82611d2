"""The faults of a run: who did what, when, and the last lines of the traceback."""

from collections.abc import Sequence

from soccersim.regress.account import Account
from soccersim.regress.report.markup import Html, join, tag
from soccersim.regress.report.meetings import Fault, faults, role
from soccersim.regress.report.words import number, several

PLACES = 12  # where it happened, of one fault
MOST = 30  # faults told apart


def alike(account: Account) -> list[list[Fault]]:
    """The faults, those of one team that say the same together, in the order of their first."""
    groups: dict[tuple[str, str, str], list[Fault]] = {}
    for fault in faults(account.matches):
        groups.setdefault((fault.team, fault.kind, fault.detail), []).append(fault)
    return list(groups.values())


def wrongs(account: Account) -> Html:
    """Each fault once, with all the places where it happened."""
    groups = alike(account)
    if not groups:
        return tag("p", "None. No team's code failed.")
    told = [_group(group) for group in groups[:MOST]]
    more = len(groups) - MOST
    if more > 0:
        told.append(tag("p", f"And {several(more, 'more kind', 'more kinds')}: see the table."))
    return join(*told)


def _group(group: Sequence[Fault]) -> Html:
    first = group[0]
    title = f"{first.team} ({role(first)}): {first.kind}, {several(len(group), 'time')}"
    where = "; ".join(place(fault) for fault in group[:PLACES])
    more = f"; and {number(len(group) - PLACES)} more" if len(group) > PLACES else ""
    return tag(
        "section",
        tag("h3", title),
        tag("p", f"{where}{more}", class_="faint"),
        tag("pre", first.detail) if first.detail else "",
    )


def place(fault: Fault) -> str:
    """Where a fault happened."""
    row = fault.match.row
    return f"pair {row.pair} (seed {row.seed}), {fault.side}, tick {number(fault.tick)}"
