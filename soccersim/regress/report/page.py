"""The page of a regression: one HTML file that asks the network for nothing and runs no script."""

from collections.abc import Mapping

from soccersim.regress.account import Account
from soccersim.regress.report import words
from soccersim.regress.report.bars import histogram, results
from soccersim.regress.report.markup import Html, join, row, table, tag, text
from soccersim.regress.report.meetings import played
from soccersim.regress.report.numbers import numbers, speed
from soccersim.regress.report.pairs import pairs_table, widest
from soccersim.regress.report.paths import elo_chart, llr_chart
from soccersim.regress.report.style import STYLE
from soccersim.regress.report.wrongs import wrongs
from soccersim.regress.rules import Fixed

POLICY = "default-src 'none'; style-src 'unsafe-inline'"  # the browser sees to it too
NO_REPLAYS: Mapping[str, str] = {}


def html(account: Account, replays: Mapping[str, str] = NO_REPLAYS) -> str:
    """The report. replays: for recordings by their names in the folder, the page to link to."""
    pairs = played(account)
    sections = [
        _verdict(account),
        numbers(account),
        _charts(account),
        _section("Results of the pairs", results(account)),
        _section("The pairs that differ most", widest(account, pairs, replays)),
        _section("All pairs", pairs_table(account, pairs, replays)),
        _section("Faults", wrongs(account)),
        _section("What was played, and where", _environment(account)),
        _section("To repeat it", tag("pre", account.command)),
        _section("How to read this", READING),
    ]
    title = f"{words.word(account)}: {account.candidate} against {account.base}"
    head = join(
        tag("meta", charset="utf-8"),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("title", title),
        tag("style", Html(STYLE)),
    )
    page = tag("html", tag("head", head), tag("body", tag("main", *sections)), lang="en")
    return f"<!doctype html>\n{page}\n"


def _section(title: str, *inside: object) -> Html:
    return tag("section", tag("h2", title), *inside)


def _verdict(account: Account) -> Html:
    """Verdict, reason, warnings: what most readers come for."""
    word = words.word(account)
    sign = tag("span", words.SIGNS[word], class_="sign", aria_hidden="true")
    against = f", both against {words.titles(account.against)}" if account.against else ""
    banner = tag(
        "header",
        tag("h1", sign, word),
        tag("p", words.outcome(account)),
        tag("p", words.reason(account), class_="why"),
        class_=f"verdict {word.lower()}",
    )
    what = tag(
        "p",
        tag("strong", account.candidate),
        f" (candidate) against {account.base} (base){against}, on {account.scenario}",
        class_="faint",
    )
    warnings = [tag("li", words.sentence(told)) for told in account.standing.warnings]
    return join(banner, what, tag("ul", *warnings, class_="warnings") if warnings else "")


def _charts(account: Account) -> Html:
    if not account.samples:
        return tag("p", "No pair is complete yet.")
    charts = [llr_chart(account), histogram(account)]
    if isinstance(account.rule, Fixed):
        charts.insert(0, elo_chart(account))
    return tag("div", *charts, class_="charts")


def _environment(account: Account) -> Html:
    told = {
        "scenario": account.scenario,
        "candidate": f"{account.candidate}, SHA-256 {account.candidate_sha}",
        "base": f"{account.base}, SHA-256 {account.base_sha}",
        **({"against": words.titles(account.against)} if account.against else {}),
        "decided by": words.rule_of(account),
        **speed(account),
        **{str(name): str(value) for name, value in account.environment.items()},
        "store": str(account.store),
        "recordings": str(account.recordings),
    }
    rows = join(*(row(tag("th", name, scope="row"), _left(value)) for name, value in told.items()))
    return table(text(""), rows, class_="facts")


def _left(value: str) -> Html:
    return tag("td", value, class_="left")


READING = tag(
    "ul",
    tag("li", "A pair is one seed played twice, with home and away exchanged."),
    tag(
        "li",
        "Normalized Elo (nElo) is the advantage measured in its own spread: it does not "
        "depend on how many matches are drawn. 0: equally good.",
    ),
    tag(
        "li",
        "The log-likelihood ratio weighs two hypotheses: above 0 the better one is likelier. A "
        "sequential test stops at its bounds, so its interval is freed of what stopping early "
        "adds.",
    ),
    tag("li", "LOS: how likely the candidate is the better team, by matches won and lost alone."),
    tag("li", "A pair has diverged when its two matches were not the same, tick for tick."),
    class_="plain",
)
