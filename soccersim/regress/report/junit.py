"""JUnit XML: what CI systems read. A regression is a suite of three cases.

Written to the schema that Jenkins reads (junit-10.xsd) and other systems after it.
"""

from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from soccersim.regress.account import Account
from soccersim.regress.report import words
from soccersim.regress.report.markup import shown
from soccersim.regress.report.wrongs import alike, place
from soccersim.regress.standing import Verdict, exit_code

CLASS = "soccersim.regress"


def junit(account: Account, strict: bool = False) -> str:
    """The document. It has a failure or an error exactly where the exit code is not 0.

    strict: what is not clear does not pass.
    """
    standing = account.standing
    name = f"{account.candidate} against {account.base}"
    suite = Element("testsuite", name=shown(f"soccersim regress: {name} on {account.scenario}"))
    properties = SubElement(suite, "properties")
    for key, value in {**_numbers(account), **account.environment}.items():
        SubElement(properties, "property", name=shown(str(key)), value=shown(str(value)))

    verdict = _case(suite, f"verdict: {name}", account.seconds)
    told = f"{words.outcome(account)} {words.reason(account)}"
    if standing.verdict is None or standing.verdict is Verdict.INVALID:
        _wrong(verdict, "error", words.word(account), told)
    elif exit_code(standing.verdict, strict):
        _wrong(verdict, "failure", words.word(account), told)
    _out(verdict, "\n".join([f"{words.word(account)}: {told}", *standing.warnings]))

    faults = _case(suite, "faults")
    found = f"faults: {standing.faults} of the candidate, {standing.base_faults} of the base"
    too_many = standing.faults > standing.base_faults
    if too_many and standing.verdict is Verdict.INVALID:
        _wrong(faults, "error", "faults", found)
    _out(faults, "\n\n".join([found, *_faults(account)]))

    same = _case(suite, "determinism")
    broken = standing.verdict is Verdict.INVALID and not (too_many and standing.reasons == (found,))
    if broken:
        _wrong(same, "error", "determinism", "; ".join(standing.reasons))
    _out(same, standing.divergence)

    cases = suite.findall("testcase")
    for kind, key in (("failure", "failures"), ("error", "errors")):
        suite.set(key, str(sum(case.find(kind) is not None for case in cases)))
    suite.set("tests", str(len(cases)))
    suite.set("skipped", "0")
    suite.set("time", f"{account.seconds:.3f}")
    root = Element("testsuites")
    root.append(suite)
    ElementTree.indent(root)
    document = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{document}\n'


def _numbers(account: Account) -> dict[str, object]:
    """What is worth a look, flat."""
    standing = account.standing
    return {
        "verdict": words.word(account),
        "pairs": standing.pairs,
        "diverged": standing.diverged,
        "llr": standing.llr,
        "elo": standing.elo.value,
        "elo_low": standing.elo.low,
        "elo_high": standing.elo.high,
        "goal_difference": standing.goal_difference.value,
        "los": standing.superiority,
        "pentanomial": " ".join(map(str, standing.counts)),
        "candidate": account.candidate,
        "candidate_sha": account.candidate_sha,
        "base": account.base,
        "base_sha": account.base_sha,
        "command": account.command,
    }


def _case(suite: Element, name: str, seconds: float = 0.0) -> Element:
    told = {"classname": CLASS, "name": shown(name), "time": f"{seconds:.3f}"}
    return SubElement(suite, "testcase", told)


def _wrong(case: Element, kind: str, type_: str, said: str) -> None:
    """A failure or an error."""
    SubElement(case, kind, type=type_, message=shown(said)).text = shown(said)


def _out(case: Element, said: str) -> None:
    SubElement(case, "system-out").text = shown(said)


def _faults(account: Account) -> list[str]:
    """Each fault once, with its traceback's last lines."""
    return [
        f"{g[0].team}: {g[0].kind}, {words.several(len(g), 'time')}, first in {place(g[0])}\n"
        f"{g[0].detail}"
        for g in alike(account)
    ]
