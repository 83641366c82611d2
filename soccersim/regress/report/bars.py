"""How the pairs came out: goal differences as a histogram, results as a bar and a table."""

from collections import Counter
from math import ceil

from soccersim.regress.account import Account
from soccersim.regress.report.axes import Axes, chart
from soccersim.regress.report.markup import Html, join, row, table, tag
from soccersim.regress.report.words import number, several, signed
from soccersim.regress.samples import CLIP, Counts
from soccersim.regress.standing import Statistic

MOST_BARS = 31
RESULTS = (  # of a pair, worst first: in words, and its class in the style sheet
    ("lost both", "ll"),
    ("lost one, drew one", "ld"),
    ("one each, or two draws", "dd"),
    ("drew one, won one", "dw"),
    ("won both", "ww"),
)


def histogram(account: Account) -> Html:
    """Goal differences of the pairs, both matches together, candidate less base."""
    valid = [sample for sample in account.samples if not sample.void]
    goals = [2.0 * sample.difference for sample in valid]
    furthest = max([1, *(ceil(abs(g)) for g in goals)])
    wide = max(1, ceil((2 * furthest + 1) / MOST_BARS))  # goals a bar

    def bar(difference: float) -> int:
        """Which bar a difference belongs to: the middle one is of those nearest to 0."""
        away = int(abs(difference) / wide + 0.5)
        return away if difference > 0 else -away

    bars = Counter(bar(g) for g in goals)
    same = sum(not sample.diverged for sample in valid)
    reach = max([1, *map(abs, bars)])
    axes = Axes(
        (-(reach + 0.6) * wide, (reach + 0.6) * wide), (0.0, 1.1 * max([1, *bars.values()]))
    )
    parts: list[object] = []
    clipped = account.standing.statistic is Statistic.GOALS and reach * wide > CLIP
    if clipped:
        parts += [
            axes.box(CLIP + 0.5, axes.x[1], 0, axes.y[1], "clipped"),
            axes.box(axes.x[0], -CLIP - 0.5, 0, axes.y[1], "clipped"),
        ]
    parts.append(axes.frame("goal difference of a pair, goals", "pairs", y_whole=True))
    for k, count in sorted(bars.items()):
        left, right = (k - 0.42) * wide, (k + 0.42) * wide
        about = signed(k * wide) if wide == 1 else f"about {signed(k * wide)}"
        tip = tag("title", f"{about} goals: {several(count, 'pair')}")
        side = "plus" if k > 0 else "minus" if k < 0 else "even"
        parts.append(axes.box(left, right, 0, count, side, tip))
        if k == 0 and same:
            also = tag("title", f"the same match on both sides: {several(same, 'pair')}")
            parts.append(axes.box(left, right, 0, same, "same", also))
    mean = 2.0 * account.standing.goal_difference.value
    parts.append(axes.upright(mean, "mean"))
    said = f"Right: {account.candidate} ahead. Dashed: the mean, {signed(mean, 2)} goals a pair."
    if same:
        said += f" Pale: {several(same, 'pair')} in which both sides saw the same match."
    if clipped:
        said += f" Shaded: beyond {number(CLIP)} goals a pair counts no more than {number(CLIP)}."
    return chart("Goal difference", said, *parts)


def results(account: Account) -> Html:
    """The pentanomial: how often each result of a pair came."""
    standing = account.standing
    teams = [(account.candidate, standing.counts)]
    if standing.base_counts is not None:
        teams.append((account.base, standing.base_counts))
    head = row("", *(tag("th", team, class_="team") for team, _ in teams), cell="th")
    rows = [
        row(
            tag("th", tag("span", class_=f"swatch {key}"), words, scope="row"),
            *(_share(counts, k) for _, counts in teams),
        )
        for k, (words, key) in enumerate(RESULTS)
    ]
    totals = row(tag("th", "pairs", scope="row"), *(number(sum(counts)) for _, counts in teams))
    bars = join(*(_bar(team, counts) for team, counts in teams))
    return join(bars, table(head, join(*rows, totals), class_="counts"))


def _share(counts: Counts, k: int) -> Html:
    share = number(100.0 * counts[k] / max(sum(counts), 1))
    return join(number(counts[k]), tag("small", f" ({share} %)"))


def _bar(team: str, counts: Counts) -> Html:
    """A bar of the five shares, worst on the left."""
    total = max(sum(counts), 1)
    parts, at = [], 0.0
    for count, (words, class_) in zip(counts, RESULTS, strict=True):
        share = 100.0 * count / total
        said = tag("title", f"{words}: {number(count)}")
        place = {"x": f"{at:.3f}", "y": 0, "width": f"{share:.3f}", "height": 6}
        parts.append(tag("rect", said, class_=class_, **place))
        at += share
    told = ", ".join(f"{words} {n}" for n, (words, _) in zip(counts, RESULTS, strict=True))
    return tag(
        "svg",
        *parts,
        viewBox="0 0 100 6",
        preserveAspectRatio="none",
        class_="shares",
        role="img",
        aria_label=f"{team}: {told}",
    )
