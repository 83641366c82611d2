"""How a regression comes along: two lines on a terminal, else a line now and then."""

import sys
import time
from types import TracebackType
from typing import TYPE_CHECKING, Self

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


class Following:
    """Shows a campaign on standard error. Used as a context."""

    def __init__(self) -> None:
        self.start = time.monotonic()
        self.first: tuple[float, int] | None = None  # when legs began to come, and how many by then
        self._live: Live | None = None
        self._said, self._pause = self.start, CALM[0]

    def __call__(self, campaign: "Campaign") -> None:
        """A leg is over."""
        now = time.monotonic()
        if self.first is None and campaign.played:
            self.first = now, campaign.played
        if sys.stderr.isatty():
            if self._live is None and now - self.start > PATIENCE:
                self._live = live()
                self._live.start()
            if self._live:
                self._live.update("\n".join(self.lines(campaign)))
        elif now - self._said > self._pause and campaign.played:
            click.echo(", ".join(self.lines(campaign, gauge=False)), err=True)
            self._said, self._pause = now, min(2 * self._pause, CALM[1])

    def lines(self, campaign: "Campaign", gauge: bool = True) -> list[str]:
        """What is shown."""
        standing, most = campaign.standing, campaign.plan.rule.most
        fixed = not hasattr(campaign.plan.rule, "low")
        of = "of" if fixed else "of at most"
        first = [f"{campaign.whole} {of} {most} pairs"]
        if left := self.left(campaign):
            first.append(left)
        low, high = standing.bounds
        llr = f"LLR {standing.llr:.2f} in {low:.2f} .. {high:.2f}"
        if gauge:
            llr = f"LLR {low:.2f} {drawn(standing.llr, low, high)} {high:.2f}"
        second = [] if fixed and gauge else [llr]
        return [", ".join(first), ", ".join([*second, score(standing)])]

    def left(self, campaign: "Campaign") -> str:
        """How long it may take, from what the legs of this run took."""
        if not self.first or campaign.played <= self.first[1]:
            return ""
        began, then = self.first
        each = (time.monotonic() - began) / (campaign.played - then)
        pairs = pairs_left(campaign)
        return f"{shown_time(each * pairs * len(campaign.plan.meetings))} left"

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._live:
            self._live.stop()


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
