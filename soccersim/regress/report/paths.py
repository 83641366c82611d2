"""How the evidence came in, pair by pair: the log-likelihood ratio, and the Elo so far."""

from collections.abc import Sequence

import numpy as np

from soccersim.regress.account import Account
from soccersim.regress.effect import after_fixed, as_elo
from soccersim.regress.evidence import tally_of
from soccersim.regress.report.axes import (
    BOTTOM,
    HEIGHT,
    LEFT,
    RIGHT,
    TOP,
    WIDTH,
    Axes,
    around,
    chart,
)
from soccersim.regress.report.markup import Html, join, tag
from soccersim.regress.report.words import several, signed, span
from soccersim.regress.rules import Marks, Sprt, Tally, llr_of
from soccersim.regress.samples import Sample
from soccersim.regress.standing import Statistic
from soccersim.regress.statistics import Estimate

FINEST = 400  # points of a line: more are not seen
LOOKS = 120  # marks on it: more would be a line again


def llr_chart(account: Account) -> Html:
    """The log-likelihood ratio between the bounds that end the run."""
    standing, rule = account.standing, account.rule
    sums = _sums(account.samples, standing.statistic)
    llr = llr_of(sums, rule.nelo)
    path = [(0.0, 0.0)] + [(float(n), float(y)) for n, y in zip(sums.numbers, llr, strict=True)]
    lower, upper = standing.bounds
    last = max(len(account.samples), 1)
    axes = Axes((0.0, float(last)), around([lower, upper, *(y for _, y in path)]))
    sequential = isinstance(rule, Sprt)
    ends = ("PASS", "FAIL") if sequential else ("for better", "for worse")
    parts: list[object] = [
        axes.box(0, last, upper, axes.y[1], "for"),
        axes.box(0, last, lower, axes.y[0], "against"),
        axes.frame("pairs", "log-likelihood ratio"),
        axes.level(0.0, "zero"),
        axes.level(upper, "bound"),
        axes.level(lower, "bound"),
        axes.words(0, upper, f"{ends[0]} at {signed(upper, 2)}", "note"),
        axes.words(0, lower, f"{ends[1]} at {signed(lower, 2)}", "note", 14.0),
    ]
    closing = sequential and last == rule.most and standing.closing_bounds != standing.bounds
    if closing:
        for y in standing.closing_bounds:
            parts.append(axes.line(((0.94 * last, y), (last, y)), "closing"))
            parts.append(axes.words(0.92 * last, y, signed(y, 2), "note", 4.0, "end"))
    parts.append(axes.line(path, "path"))
    if len(standing.path) <= LOOKS:
        parts += [
            axes.dot(n, y, "look", f"after {several(n, 'pair')}: {signed(y, 2)}")
            for n, y in standing.path
        ]
    between = f"{signed(lower, 2)} and {signed(upper, 2)}"
    said = f"{signed(standing.llr, 2)} after {several(standing.pairs, 'pair')}, bounds {between}."
    if sequential:
        low, high = (signed(nelo, 1) for nelo in rule.nelo)
        said += f" Up: the outcomes are likelier at {high} nElo than at {low}; down: less likely."
        said += " Dots: where it was looked at."
    else:
        said += " Told for comparison: the number of pairs was settled beforehand."
    if closing:
        near = " and ".join(signed(bound, 2) for bound in standing.closing_bounds)
        said += f" Short marks: {near}, the bounds after the last pair."
    return chart("Evidence as it came in", said, *parts)


def elo_chart(account: Account) -> Html:
    """Normalized Elo after each pair with its 95 % band: a fixed number is judged by it."""
    sums = _sums(account.samples, account.standing.statistic)
    by_counts = sums.counts is not None
    each = [
        as_elo(after_fixed(float(t), int(pairs)), by_counts)
        for t, pairs in zip(sums.effect, sums.pairs, strict=True)
    ]
    so_far = list(zip((float(n) for n in sums.numbers), each, strict=True))
    last = max(len(account.samples), 1)
    end = each[-1] if each else Estimate(0.0, -1.0, 1.0)
    most = 2.2 * max(abs(end.low), abs(end.high), 1.0)  # of early pairs the band is cut
    axes = Axes((0.0, float(last)), (-most, most))
    band = [(n, e.high) for n, e in so_far] + [(n, e.low) for n, e in reversed(so_far)]
    within = tag(
        "clipPath",
        tag("rect", x=LEFT, y=TOP, width=WIDTH - LEFT - RIGHT, height=HEIGHT - TOP - BOTTOM),
        id="within",
    )
    drawn = join(axes.band(band, "band"), axes.line([(n, e.value) for n, e in so_far], "path"))
    said = (
        f"{signed(end.value, 1)} nElo after {several(account.standing.pairs, 'pair')}, 95 % "
        f"interval {span(end, 1)}. Only its end counts; where the band was before decides nothing."
    )
    return chart(
        "Normalized Elo so far",
        said,
        axes.frame("pairs", "normalized Elo (nElo)"),
        axes.level(0.0, "zero"),
        within,
        tag("g", drawn, clip_path="url(#within)"),
    )


def _sums(samples: Sequence[Sample], statistic: Statistic) -> Tally:
    """Sums after each pair, or where there are very many after each few."""
    return tally_of(samples, _marks(len(samples)), statistic)


def _marks(count: int) -> Marks:
    if count <= FINEST:
        return np.arange(1, count + 1, dtype=np.int64)
    return np.unique(np.linspace(1, count, FINEST).round().astype(np.int64))
