"""The numbers that a verdict rests on, in boxes, and how fast the matches were played."""

from soccersim.regress.account import Account
from soccersim.regress.report.markup import Html, join, tag
from soccersim.regress.report.words import duration, number, several, signed, span
from soccersim.regress.standing import Statistic
from soccersim.regress.statistics import Estimate

HOUR = 3600.0


def numbers(account: Account) -> Html:
    """One box a number: what it is, itself, what else there is to say."""
    standing = account.standing
    lower, upper = (signed(bound, 2) for bound in standing.bounds)
    void = f", {several(standing.void, 'is', 'are')} void" if standing.void else ""
    by_goals = standing.statistic is Statistic.GOALS
    judged = "goal difference" if by_goals else "results"
    boxes = [
        _estimate(f"normalized Elo by {judged}", standing.elo, 1, "nElo"),
        _estimate("goal difference a match", standing.goal_difference, 2, "goals"),
        _estimate("normalized Elo by results", standing.results_elo, 1, "nElo") if by_goals else "",
        _box(
            "likelihood of superiority (LOS), by results",
            _share(standing.superiority),
            "that the candidate is the better team",
        ),
        _box(
            "pairs",
            number(standing.pairs),
            f"of {number(account.rule.most)} at most{void}; two matches each",
        ),
        _box(
            "diverged", f"{number(standing.diverged)} of {number(standing.pairs)}", _parted(account)
        ),
        _box("log-likelihood ratio", signed(standing.llr, 2), f"bounds {lower} and {upper}"),
        _box(
            "faults",
            f"{number(standing.faults)} : {number(standing.base_faults)}",
            "of the candidate : of the base",
        ),
    ]
    return tag("dl", *boxes, class_="numbers")


def speed(account: Account) -> dict[str, str]:
    """Jobs, time, matches an hour, and what a match costs besides playing."""
    rows = {match.row.key: match.row for match in account.matches if not match.row.void}
    told = {
        "matches": f"{number(account.played)} played in this run, "
        f"{number(account.found)} were in the store already",
        "jobs": number(account.jobs),
        "time of this run": duration(account.seconds),
    }
    if account.played and account.seconds > 0.0:
        told["matches an hour"] = number(account.played / account.seconds * HOUR)
    if rows:
        seconds, overhead = (
            sum(getattr(row, name) for row in rows.values()) / len(rows)
            for name in ("seconds", "overhead")
        )
        told["time of a match"] = f"{number(seconds, 2)} s playing, on average"
        told["overhead of a match"] = (
            f"{number(overhead, 3)} s besides (process, loading, store), on average"
        )
    return told


def _estimate(name: str, estimate: Estimate, places: int, unit: str) -> Html:
    value = join(signed(estimate.value, places), tag("small", f" {unit}"))
    return _box(name, value, f"95 %: {span(estimate, places)} {unit}")


def _share(share: float) -> str:
    """In %; what is all but certain is not told as certain."""
    if share > 0.999:
        return "> 99.9 %"
    return "< 0.1 %" if share < 0.001 else f"{number(100.0 * share, 1)} %"


def _parted(account: Account) -> str:
    parted = account.standing.parted
    if parted is None:
        return "pairs whose two matches were not the same"
    return f"pairs; the first parted at tick {number(parted)}"


def _box(name: str, value: str, more: str) -> Html:
    return tag("div", tag("dt", name), tag("dd", value, class_="large"), tag("dd", more))
