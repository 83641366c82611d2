"""Numbers and verdicts in words for people."""

import re
from collections.abc import Sequence

from soccersim.regress.account import Account
from soccersim.regress.rules import Sprt
from soccersim.regress.standing import Statistic, Verdict
from soccersim.regress.statistics import Estimate

MINUS = "\N{MINUS SIGN}"
STOPPED = "STOPPED"  # in the place of a verdict that is not there yet
SIGNS = {  # a verdict is told by a sign too, not by its colour alone
    "PASS": "\N{CHECK MARK}",
    "FAIL": "\N{MULTIPLICATION X}",
    "INCONCLUSIVE": "?",
    "IDENTICAL": "=",
    "INVALID": "!",
    STOPPED: "\N{HORIZONTAL ELLIPSIS}",
}


def number(value: float, places: int = 0) -> str:
    """1234.5 as 1 234.5, with a true minus sign, and no -0."""
    rounded = round(value, places) + 0.0
    return f"{rounded:,.{places}f}".replace(",", " ").replace("-", MINUS)


def signed(value: float, places: int = 0) -> str:
    """The same, with + where it is above 0."""
    told = number(value, places)
    return f"+{told}" if round(value, places) > 0.0 else told


def span(estimate: Estimate, places: int) -> str:
    """The 95 % interval."""
    return f"{signed(estimate.low, places)} to {signed(estimate.high, places)}"


def several(count: int, one: str, more: str = "") -> str:
    """1 pair, 2 pairs."""
    return f"{number(count)} {one if count == 1 else more or one + 's'}"


def duration(seconds: float) -> str:
    """1 h 5 min, 3 min 20 s, 12.3 s."""
    if seconds < 60.0:
        return f"{number(seconds, 1)} s"
    minutes, rest = divmod(round(seconds), 60)
    if minutes < 60:
        return f"{minutes} min {rest} s"
    return f"{number(minutes // 60)} h {minutes % 60} min"


def word(account: Account) -> str:
    """The verdict, or that there is none yet."""
    verdict = account.standing.verdict
    return STOPPED if verdict is None else verdict.value


def outcome(account: Account) -> str:
    """What the verdict says of the two teams."""
    candidate, base, rule = account.candidate, account.base, account.rule
    better = f"{candidate} plays better than {base}."
    worse = f"{candidate} plays worse than {base}."
    if isinstance(rule, Sprt):  # what was asked may not have been which is better
        low, high = signed(rule.low, 1), signed(rule.high, 1)
        if rule.high <= 0.0:
            better = f"{candidate} holds up against {base}: {high} nElo is likelier than {low}."
        if rule.low >= 0.0:
            worse = f"{candidate} is no better than {base}: {low} nElo is likelier than {high}."
    said = {
        Verdict.PASS: better,
        Verdict.FAIL: worse,
        Verdict.INCONCLUSIVE: f"It is not clear which of {candidate} and {base} plays better.",
        Verdict.IDENTICAL: f"{candidate} played just as {base} does.",
        Verdict.INVALID: f"These matches do not tell which of {candidate} and {base} is better.",
    }
    verdict = account.standing.verdict
    return said[verdict] if verdict else "Stopped before a verdict; the same command goes on."


def reason(account: Account) -> str:
    """Why, in one sentence."""
    reasons = account.standing.reasons
    if not reasons:
        return f"{several(account.standing.pairs, 'pair')} played so far."
    return sentence("; ".join(reasons))


def sentence(told: str) -> str:
    """What has been found, as a sentence, with true minus signs."""
    minus = re.sub(r"(?<![\w-])-(?=\d)", MINUS, told.rstrip("."))
    return f"{minus[:1].upper()}{minus[1:]}."


def rule_of(account: Account) -> str:
    """How it was decided when to stop, and what with."""
    rule = account.rule
    judged = "goal difference" if account.standing.statistic is Statistic.GOALS else "results"
    if isinstance(rule, Sprt):
        return (
            f"sequential test by {judged}: {number(rule.low, 1)} against {number(rule.high, 1)} "
            f"nElo, alpha {rule.alpha:g}, beta {rule.beta:g}, looked at every "
            f"{several(rule.every, 'pair')}, at most {several(rule.most, 'pair')}"
        )
    return f"{several(rule.most, 'pair')}, settled beforehand, judged by {judged}"


def titles(names: Sequence[str]) -> str:
    """a, b and c."""
    return " and ".join(filter(None, (", ".join(names[:-1]), *names[-1:])))
