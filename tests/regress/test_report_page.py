"""The report of a regression: whole, honest, and safe from what teams call themselves."""

import re
from collections import Counter
from dataclasses import replace

import pytest
from accounts import ACCOUNTS, FAULT, Season
from hypothesis import given, settings
from hypothesis import strategies as st
from reading import Page

from soccersim.regress.report import html
from soccersim.regress.report.axes import HEIGHT, WIDTH, ticks
from soccersim.regress.report.markup import shown
from soccersim.regress.report.style import STYLE
from soccersim.regress.report.words import number, signed, span
from soccersim.regress.rules import Fixed, Sprt
from soccersim.regress.samples import Leg, Pair, between
from soccersim.regress.standing import Statistic

JUDGED = {Statistic.GOALS: "goal difference", Statistic.RESULTS: "results"}
EVIL = "<script>alert('1')</script>&\"x\"\x1b[31m\udcff\u202e"


@pytest.fixture(scope="module")
def accounts():
    return {name: make() for name, make in ACCOUNTS.items()}


@pytest.fixture(scope="module")
def pages(accounts):
    return {name: Page(html(account)) for name, account in accounts.items()}


@pytest.mark.parametrize("name", ACCOUNTS)
def test_the_verdict_comes_first_with_its_reason(name, accounts, pages):
    account, page = accounts[name], pages[name]
    told = account.standing.verdict.value if account.standing.verdict else "STOPPED"
    assert name in (told, "comparison")
    body = next(e for e in page.elements if e["tag"] == "body")
    assert body["text"].lstrip()[1:].lstrip().startswith(told)  # after its sign
    (why,) = page.all("p", class_="why")
    for reason in account.standing.reasons:
        assert reason.replace("-", "\N{MINUS SIGN}")[1:] in why["text"].replace(
            "-", "\N{MINUS SIGN}"
        )
    assert len(page.all("li")) >= len(account.standing.warnings)
    for warning in account.standing.warnings:
        assert warning[1:] in body["text"]


@pytest.mark.parametrize("name", ACCOUNTS)
def test_every_pair_is_in_the_table_with_its_scores(name, accounts, pages):
    account = accounts[name]
    firsts = [row for row in pages[name].rows("All pairs")[1:] if row[0].isdigit()]
    assert [int(row[0]) for row in firsts] == [sample.number for sample in account.samples]
    for row, sample in zip(firsts, account.samples, strict=True):
        assert int(row[1]) == sample.number + 1  # its seed
        if sample.void:
            assert "a worker was lost" in row[2]
            continue
        places = 2 if account.against else 0
        assert row[-3] == signed(2.0 * sample.difference, places)
        assert row[-2] == ("no" if not sample.diverged else f"tick {number(sample.parted)}")
    scores = [
        c for row in pages[name].rows("All pairs") for c in row if re.fullmatch(r"\d+ : \d+", c)
    ]
    played = [m.row.score for m in account.matches if not m.row.void]
    assert scores == [f"{home} : {away}" for home, away in played]


@pytest.mark.parametrize("name", ACCOUNTS)
def test_the_numbers_are_the_standings(name, accounts, pages):
    standing, page = accounts[name].standing, pages[name]
    elo, band = page.box(f"normalized Elo by {JUDGED[standing.statistic]}")
    assert elo == f"{signed(standing.elo.value, 1)} nElo"
    assert band == f"95 %: {span(standing.elo, 1)} nElo"
    goals, band = page.box("goal difference a match")
    assert goals == f"{signed(standing.goal_difference.value, 2)} goals"
    assert band == f"95 %: {span(standing.goal_difference, 2)} goals"
    assert page.box("pairs")[0] == number(standing.pairs)
    assert page.box("diverged")[0] == f"{standing.diverged} of {standing.pairs}"
    assert page.box("log-likelihood ratio")[0] == signed(standing.llr, 2)
    assert page.box("faults")[0] == f"{standing.faults} : {standing.base_faults}"
    los = page.box("likelihood of superiority (LOS), by results")[0]
    shown_los = f"{number(100 * standing.superiority, 1)} %"
    assert los == ("> 99.9 %" if standing.superiority > 0.999 else shown_los)
    results = [row[1].split()[0] for row in page.rows("Results of the pairs")[1:6]]
    assert tuple(map(int, results)) == standing.counts


@pytest.mark.parametrize("name", [name for name in ACCOUNTS if name != "STOPPED"])
def test_the_path_of_the_llr_has_a_dot_at_every_look_and_stays_in_the_picture(
    name, accounts, pages
):
    account, page = accounts[name], pages[name]
    dots = page.all("circle")
    said = [e["text"] for e in page.elements if e["tag"] == "title" and e["in"][-1] == "circle"]
    assert len(dots) == len(account.standing.path)
    for (pairs, llr), text in zip(account.standing.path, said, strict=True):
        assert text == f"after {pairs} pairs: {signed(llr, 2)}"
    path = next(e for e in page.all("polyline", class_="path") if "clippath" not in e["in"])
    places = [tuple(map(float, place.split(","))) for place in path["points"].split()]
    if isinstance(account.rule, Sprt):
        assert len(places) == len(account.samples) + 1
        assert {(float(d["cx"]), float(d["cy"])) for d in dots} <= set(places)
        assert all(0 <= x <= WIDTH and 0 <= y <= HEIGHT for x, y in places)


@pytest.mark.parametrize("name", [name for name in ACCOUNTS if name != "STOPPED"])
def test_the_bars_of_the_histogram_are_all_the_pairs(name, accounts, pages):
    tips = [
        e["text"] for e in pages[name].elements if e["tag"] == "title" and e["in"][-1] == "rect"
    ]
    bars = [tip for tip in tips if "goals: " in tip]
    counted = sum(int(re.search(r"goals: (\d+) pair", bar)[1]) for bar in bars)
    assert counted == accounts[name].standing.pairs
    if not accounts[name].against:  # whole goals, a bar for each
        goals = Counter(2.0 * s.difference for s in accounts[name].samples if not s.void)
        said = {bar.split(" goals: ")[0]: int(bar.split()[2]) for bar in bars}
        assert said == {signed(g): count for g, count in goals.items()}
    same = [tip for tip in tips if tip.startswith("the same match")]
    alike = accounts[name].standing.pairs - accounts[name].standing.diverged
    assert [int(re.search(r": (\d+) pair", tip)[1]) for tip in same] == ([alike] if alike else [])


@pytest.mark.parametrize("name", ACCOUNTS)
def test_the_page_asks_nobody_for_anything(name, accounts):
    text = html(
        accounts[name], {m.row.recording: "r-replays/a%20b.html" for m in accounts[name].matches}
    )
    page = Page(text)
    assert not re.search(r"https?:|//|url\((?!#)|@import|<script|<link|<iframe|\bon\w+=", text)
    assert not any("src" in element for element in page.elements)
    assert {e["href"] for e in page.elements if "href" in e} <= {"r-replays/a%20b.html"}


def test_what_teams_call_themselves_is_never_markup():
    season = Season(EVIL, f"{EVIL}2", against=(f"{EVIL}3",))
    fault = {**FAULT, "kind": EVIL, "detail": EVIL}
    season.play(8, faults={2: (fault,)}).lose_machine()
    account = season.account(
        Fixed(9), command=EVIL, scenario=EVIL, environment={EVIL: EVIL, "python": EVIL}
    )
    reasons, warnings = (EVIL, "b"), (EVIL,)
    account = replace(
        account, standing=replace(account.standing, reasons=reasons, warnings=warnings)
    )
    text = html(account, {m.row.recording: f"{EVIL}.html" for m in account.matches})
    page = Page(text)
    assert page.all("script") == []
    assert "\x1b" not in text
    assert "\u202e" not in text
    text.encode()
    assert shown(EVIL) in page.all("title")[0]["text"]
    assert page.all("pre")[-1]["text"] == shown(EVIL)
    links = {e["href"] for e in page.elements if "href" in e}
    assert links == {shown(f"{EVIL}.html")}


@settings(max_examples=30)
@given(st.text(min_size=1, max_size=40), st.text(max_size=40))
def test_any_name_and_any_traceback_is_shown_as_it_is(name, detail):
    season = Season(candidate=f"a{name}").play(2, faults={1: ({**FAULT, "detail": detail},)})
    page = Page(html(season.account(Fixed(2))))
    assert page.all("strong")[0]["text"] == shown(f"a{name}")
    told = [pre["text"] for pre in page.all("pre")]
    assert told[:-1] == ([shown(detail)] if detail else [])


def test_faults_are_told_once_with_team_kind_tick_and_the_end_of_the_traceback(accounts, pages):
    page = pages["INVALID"]
    (heading,) = [e["text"] for e in page.all("h3") if "exception" in e["text"]]
    assert heading == "./my_roles.py (candidate): exception, 3 times"
    text = next(e["text"] for e in page.elements if e["tag"] == "body")
    for pair in (3, 4, 9):
        assert f"pair {pair} (seed {pair + 1}), home, tick 260" in text
    assert page.all("pre")[0]["text"] == FAULT["detail"]
    cells = [row for row in page.rows("All pairs") if row[0] == "4"]
    assert cells[0][-1] == "./my_roles.py (home): exception at tick 260"


def test_matches_a_team_loses_by_its_own_fault_are_blamed_on_the_right_one():
    fault = {**FAULT, "side": "away"}
    page = Page(html(Season().play(8, faults={0: (fault,)}).account()))
    assert "roles (base): exception, 1 time" in [e["text"] for e in page.all("h3")]
    opponents = Season(against=("chaser",)).play(8, faults={0: (fault,)}).account()
    headings = [e["text"] for e in Page(html(opponents)).all("h3")]
    assert "chaser (opponent): exception, 1 time" in headings


def test_speed_and_overhead_stand_in_the_report(accounts, pages):
    account = accounts["PASS"]
    facts = dict(row for row in pages["PASS"].rows("What was played, and where") if len(row) == 2)
    assert facts["matches an hour"] == number(account.played / account.seconds * 3600)
    assert facts["overhead of a match"].startswith("0.210 s")
    assert facts["time of this run"] == "1 min 12 s"
    assert facts["jobs"] == "2"
    assert facts["python"] == "3.11.2"
    assert account.candidate_sha in facts["candidate"]
    assert pages["PASS"].all("pre")[-1]["text"] == account.command


def test_a_fixed_number_of_pairs_is_shown_with_the_interval_it_was_judged_by(pages, accounts):
    said = " ".join(e["text"] for e in pages["INCONCLUSIVE"].all("figcaption"))
    assert f"95 % interval {span(accounts['INCONCLUSIVE'].standing.elo, 1)}" in said
    assert len(pages["PASS"].all("figure")) == 2
    assert len(pages["INCONCLUSIVE"].all("figure")) == 3


@pytest.mark.parametrize("statistic", Statistic)
@pytest.mark.parametrize("rule", [Sprt(most=12), Sprt(every=1), Fixed(20)], ids=str)
@pytest.mark.parametrize("pairs", [1, 7, 8, 20])
@pytest.mark.parametrize("same", [0.0, 1.0])
def test_any_stage_of_any_run_makes_a_page(statistic, rule, pairs, same):
    Page(html(Season().play(pairs, same=same).account(rule, statistic)))


def test_a_run_of_thousands_of_pairs_makes_a_page_of_a_few_megabytes():
    account = Season().play(3000).account(Fixed(3000))
    page = html(account)
    assert len(page) < 3_000_000
    assert len(max(re.findall(r'<polyline points="([^"]*)"', page), key=len).split()) <= 401


def test_ticks_are_round_numbers_within_the_axis():
    assert ticks(0, 40, 7) == [0, 10, 20, 30, 40]
    assert ticks(0, 1.1, 6, whole=True) == [0, 1]
    assert [round(t, 6) for t in ticks(-0.33, 0.31, 6)] == [-0.2, 0, 0.2]


def luminance(colour):
    channels = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
    linear = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels)
    return sum(w * c for w, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


@pytest.mark.parametrize("theme", [0, 1], ids=["light", "dark"])
def test_letters_can_be_read_on_what_they_stand_on(theme):
    """Contrast as WCAG 2.2 asks for it, 1.4.3."""
    blocks = re.findall(r":root \{(.*?)\}", STYLE, re.DOTALL)
    colours = dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6})\b", blocks[theme]))
    pairs = [
        ("#ffffff", colours[v]) for v in ("pass", "fail", "inconclusive", "identical", "invalid")
    ]
    pairs += [
        (colours[i], colours[on]) for i in ("ink", "faint", "link") for on in ("paper", "card")
    ]
    for one, other in pairs:
        bright, dark = sorted((luminance(one), luminance(other)), reverse=True)
        assert (bright + 0.05) / (dark + 0.05) >= 4.5, (one, other)


def test_what_was_not_asked_is_not_answered():
    """Between -50 and 0 a PASS means as good as before, between 0 and 50 a FAIL no better."""
    season = Season().play(400)
    for rule in (Sprt(-50.0, 0.0), Sprt(0.0, 50.0)):
        account = season.account(rule)
        said = Page(html(account)).all("header")[0]["text"]
        wanted = {"PASS": "holds up against", "FAIL": "is no better than"}
        assert wanted[account.standing.verdict.value] in said
        assert "plays" not in said


def test_wide_differences_share_bars_of_several_goals():
    season = Season()
    for k, goals in enumerate((0, 40, -40, 39, 1)):
        score = (max(goals, 0), max(-goals, 0))
        home = season.match(k, 0, season.candidate, season.base, score)
        away = season.match(k, 1, season.base, season.candidate, (0, 0))
        pair = Pair(Leg(*score, home.digest), Leg(0, 0, away.digest))
        season.samples[k] = between(k, pair)
    page = Page(html(season.account(Fixed(5))))
    tips = [e["text"] for e in page.elements if e["tag"] == "title" and e["in"][-1] == "rect"]
    told = [tip for tip in tips if "goals: " in tip]
    minus = "\N{MINUS SIGN}"
    assert told == [
        f"about {minus}39 goals: 1 pair",
        "about 0 goals: 2 pairs",
        "about +39 goals: 2 pairs",
    ]
