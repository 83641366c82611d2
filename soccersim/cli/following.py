"""How matches come along: lines that stay in place on a terminal, else a line now and then."""

import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from rich.live import Live

    from soccersim.regress.campaign import Campaign
    from soccersim.regress.standing import Standing

PATIENCE = 1.0  # s before anything is shown
CALM = (10.0, 60.0)  # s from line to line where nobody watches a terminal: at first, and later
GAUGE = 31  # characters from bound to bound
CLEAR = 0.3  # LLR from which on it tells how long it may take to a bound
FEW = 8  # pairs


class Following(ExitStack[None]):
    """Shows on standard error what is told. Used as a context."""

    def __init__(self) -> None:
        super().__init__()
        self.start = self._said = time.monotonic()
        self._pause = CALM[0]
        self._first: tuple[float, int] | None = None  # when matches began to come, and how many
        self._live: Live | None = None

    def show(self, played: int, lines: Callable[[bool], list[str]]) -> None:
        """Tell what these lines say, if it is time to; played: matches in this run.

        lines: asked with whether there is a terminal.
        """
        now = time.monotonic()
        if self._first is None and played:
            self._first = now, played
        if sys.stderr.isatty():
            if self._live is None and now - self.start > PATIENCE:
                self._live = self.enter_context(live())
            if self._live:
                self._live.update("\n".join(lines(True)))
        elif now - self._said > self._pause and played:
            click.echo(", ".join(lines(False)), err=True)
            self._said, self._pause = now, min(2 * self._pause, CALM[1])

    def left(self, played: int, more: float) -> list[str]:
        """How long so many more matches may take, after those of this run; nothing at first."""
        if not self._first or played <= self._first[1]:
            return []
        began, then = self._first
        each = (time.monotonic() - began) / (played - then)
        return [f"{shown_time(each * more)} left"]

    def campaign(self, campaign: "Campaign") -> None:
        """Show how a regression comes along."""
        self.show(campaign.played, lambda terminal: self._lines(campaign, terminal))

    def _lines(self, campaign: "Campaign", terminal: bool) -> list[str]:
        standing, most = campaign.standing, campaign.plan.rule.most
        more = pairs_left(campaign) * len(campaign.plan.meetings)
        fixed = not hasattr(campaign.plan.rule, "low")
        of = "of" if fixed else "of at most"
        first = [f"{campaign.whole} {of} {most} pairs", *self.left(campaign.played, more)]
        low, high = standing.bounds
        llr = f"LLR {standing.llr:.2f} in {low:.2f} .. {high:.2f}"
        if terminal:
            llr = f"LLR {low:.2f} {drawn(standing.llr, low, high)} {high:.2f}"
        return [", ".join(first), *([] if fixed else [llr]), score(standing)]

    def matches(self, played: int, done: int, total: int) -> None:
        """Show how so many matches come along."""
        left = self.left(played, total - done)
        self.show(played, lambda _: [", ".join([f"{done} of {total} matches", *left])])


def live() -> "Live":
    """Lines that stay in place and go away at the end."""
    from rich.console import Console
    from rich.live import Live

    return Live("", console=Console(stderr=True, highlight=False), transient=True)


def pairs_left(campaign: "Campaign") -> float:
    """Pairs to be played yet: as the LLR has gone so far it may reach a bound before the end."""
    standing, rule = campaign.standing, campaign.plan.rule
    left = float(rule.most - campaign.whole)
    llr, pairs = standing.llr, standing.numbers
    if hasattr(rule, "low") and abs(llr) > CLEAR and pairs >= FEW:
        bound = standing.bounds[llr > 0]
        left = min(left, max(pairs * (bound / llr - 1.0), float(FEW)))
    return left


def score(standing: "Standing") -> str:
    """Pairs that the candidate won, lost and did neither, its goals, and who was at fault."""
    counts = standing.counts
    told = [
        f"{sum(counts[3:])} pairs won, {counts[2]} even, {sum(counts[:2])} lost",
        f"{standing.goal_difference.value:+.2f} goals a match",
        f"faults {standing.faults}:{standing.base_faults}",
    ]
    return ", ".join(told)


def drawn(value: float, low: float, high: float) -> str:
    """A value between two bounds: |-----0--*----|."""
    cells = ["-"] * GAUGE
    for at, mark in ((0.0, "0"), (min(max(value, low), high), "*")):
        cells[round((at - low) / (high - low) * (GAUGE - 1))] = mark
    return f"|{''.join(cells)}|"


def shown_time(seconds: float) -> str:
    """Roughly: 40 s, 12 min, 3.5 h."""
    if seconds < 90:
        return f"{max(seconds, 1):.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
