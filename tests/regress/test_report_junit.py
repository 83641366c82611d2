"""JUnit XML of a regression: what CI reads must agree with the exit code."""

from dataclasses import replace
from xml.etree import ElementTree

import pytest
from accounts import ACCOUNTS, FAULT, Season

from soccersim.regress.report import junit
from soccersim.regress.rules import Fixed
from soccersim.regress.standing import Verdict, exit_code

# junit-10.xsd: what each element may hold, and which attributes it may have; name is required
SCHEMA = {
    "testsuites": ({"testsuite"}, {"name", "tests", "failures", "errors", "time"}),
    "testsuite": (
        {"properties", "testcase", "system-out", "system-err"},
        {"name", "tests", "failures", "errors", "skipped", "time", "timestamp", "hostname"},
    ),
    "properties": ({"property"}, set()),
    "property": (set(), {"name", "value"}),
    "testcase": (
        {"skipped", "error", "failure", "system-out", "system-err"},
        {"classname", "name", "time"},
    ),
    "failure": (set(), {"type", "message"}),
    "error": (set(), {"type", "message"}),
    "system-out": (set(), set()),
}
NAMED = {"testsuite", "testcase", "property"}


def read(account, strict=False):
    """The cases by the first word of their names, after a look at the form of it all."""
    root = ElementTree.fromstring(junit(account, strict).encode())
    assert root.tag == "testsuites"
    for element in root.iter():
        inside, attributes = SCHEMA[element.tag]
        assert {child.tag for child in element} <= inside
        assert set(element.attrib) <= attributes
        assert (element.tag in NAMED) <= ("name" in element.attrib)
    (suite,) = root
    cases = suite.findall("testcase")
    assert int(suite.get("tests")) == len(cases)
    for kind, key in (("failure", "failures"), ("error", "errors")):
        assert int(suite.get(key)) == sum(case.find(kind) is not None for case in cases)
    return {case.get("name").split(":")[0]: case for case in cases}, suite


def outcome(case):
    return next((child.tag for child in case if child.tag in ("failure", "error")), "passed")


@pytest.mark.parametrize("name", ACCOUNTS)
@pytest.mark.parametrize("strict", [False, True])
def test_something_is_red_exactly_where_the_exit_code_is_not_0(name, strict):
    account = ACCOUNTS[name]()
    cases, _ = read(account, strict)
    verdict = account.standing.verdict
    red = any(outcome(case) != "passed" for case in cases.values())
    assert red == (verdict is None or exit_code(verdict, strict) != 0)


@pytest.mark.parametrize(
    ("name", "strict", "wanted"),
    [
        ("PASS", True, "passed"),
        ("IDENTICAL", True, "passed"),
        ("FAIL", False, "failure"),
        ("INCONCLUSIVE", False, "passed"),
        ("INCONCLUSIVE", True, "failure"),
        ("INVALID", False, "error"),
        ("STOPPED", False, "error"),
    ],
)
def test_the_case_of_the_verdict(name, strict, wanted):
    account = ACCOUNTS[name]()
    cases, suite = read(account, strict)
    case = cases["verdict"]
    assert outcome(case) == wanted
    out = case.find("system-out").text
    assert out.startswith(name)
    for warning in account.standing.warnings:
        assert warning in out
    if wanted != "passed":
        assert case.find(wanted).get("type") == name
    assert float(case.get("time")) == account.seconds
    told = {p.get("name"): p.get("value") for p in suite.find("properties")}
    assert float(told["elo"]) == account.standing.elo.value
    assert float(told["llr"]) == account.standing.llr
    assert int(told["pairs"]) == account.standing.pairs
    assert told["python"] == "3.11.2"


def test_too_many_faults_are_an_error_of_the_case_of_faults_with_their_tracebacks():
    cases, _ = read(ACCOUNTS["INVALID"]())
    assert outcome(cases["faults"]) == "error"
    assert outcome(cases["determinism"]) == "passed"
    assert FAULT["detail"] in cases["faults"].find("system-out").text


def test_matches_that_cannot_be_repeated_are_an_error_of_determinism():
    account = Season().play(8).account(contradictions=("leg 0 of pair 3",))
    assert account.standing.verdict is Verdict.INVALID
    cases, _ = read(account)
    assert outcome(cases["determinism"]) == "error"
    assert outcome(cases["faults"]) == "passed"
    assert "pair 3" in cases["determinism"].find("error").text


def test_who_does_both_has_both():
    season = Season().play(8, faults={1: (FAULT,)})
    cases, _ = read(season.account(Fixed(8), contradictions=("leg 0 of pair 3",)))
    assert outcome(cases["determinism"]) == "error"
    assert outcome(cases["faults"]) == "error"


def test_what_xml_cannot_hold_is_made_visible():
    evil = "<a>&\x00\x1b[1m\udcff\ufffe]]>"
    fault = {**FAULT, "detail": evil}
    account = Season(evil, f"{evil}2").play(8, faults={1: (fault,)}).account(Fixed(8), command=evil)
    standing = replace(account.standing, reasons=(evil,), warnings=(evil,))
    cases, _ = read(replace(account, standing=standing, environment={evil: evil}))
    assert r"<a>&\x00\x1b[1m\udcff\ufffe]]>" in cases["faults"].find("system-out").text
