"""PASS, FAIL, INCONCLUSIVE, IDENTICAL, INVALID: what leads to each, and what is told with it."""

import json
from dataclasses import replace
from math import isfinite

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic_matches import leg

from soccersim.regress.rules import Fixed, Sprt
from soccersim.regress.samples import Pair, between, compared, void
from soccersim.regress.standing import Statistic, Verdict, exit_code
from soccersim.regress.verdict import decide

GOALS, RESULTS = Statistic


def run(*pairs, **settings):
    """Samples of pairs (home, away): the candidate's goal differences; a pair of None is void."""
    return {
        n: void(n)
        if pair is None
        else between(n, Pair(leg(pair[0], f"{n}"), leg(pair[1], f"{n}'")))
        for n, pair in enumerate(pairs)
    }


def copies(count):
    """Samples of a copy against its original."""
    return {n: between(n, Pair(leg(n % 3, f"{n}"), leg(-(n % 3), f"{n}"))) for n in range(count)}


@pytest.mark.parametrize("statistic", Statistic)
def test_better_passes_and_worse_fails(statistic):
    better, worse = run(*[(2, 0)] * 100), run(*[(0, -2)] * 100)
    assert decide(better, Sprt(), statistic=statistic).verdict is Verdict.PASS
    assert decide(worse, Sprt(), statistic=statistic).verdict is Verdict.FAIL
    assert decide(better, Fixed(100), statistic=statistic).verdict is Verdict.PASS
    assert decide(worse, Fixed(100), statistic=statistic).verdict is Verdict.FAIL


@pytest.mark.parametrize("rule", [Sprt(), Fixed(400)])
def test_even_is_inconclusive_when_the_pairs_are_used_up_and_open_before(rule):
    even = run(*[(1, 0), (0, -1)] * 200)
    assert decide(even, rule).verdict is Verdict.INCONCLUSIVE
    del even[399]
    assert decide(even, rule).verdict is None


def test_nothing_played_is_open_and_every_number_told_is_finite():
    for rule in (Sprt(), Fixed(10)):
        for statistic in Statistic:
            assert decide({}, rule, statistic=statistic).verdict is None
            assert finite(decide({}, rule, statistic=statistic).document())


def test_only_numbers_without_a_gap_count():
    better = run(*[(2, 0)] * 100)
    ahead = {n: sample for n, sample in better.items() if n >= 1}
    assert decide(ahead, Sprt()).verdict is None
    assert decide(ahead, Sprt()).pairs == 0
    assert decide({n: better[n] for n in range(45) if n != 30}, Sprt()).pairs == 30


def test_pairs_beyond_the_deciding_mark_change_nothing():
    better = run(*[(2, 0)] * 40, *[(-3, -3)] * 60)
    few = decide({n: better[n] for n in range(32)}, Sprt())
    assert few.verdict is Verdict.PASS
    assert decide(better, Sprt()) == few
    assert few.numbers == few.path[-1][0] == 32


@settings(max_examples=8)
@given(st.randoms(use_true_random=False), st.sampled_from([Sprt(most=64), Fixed(50)]))
def test_the_verdict_does_not_hang_on_the_order_in_which_pairs_end(random, rule):
    samples = run(*[(random.randint(-2, 3), random.randint(-2, 2)) for _ in range(64)])
    in_order = decide(samples, rule)
    came, order, first = {}, list(samples), None
    random.shuffle(order)
    for number in order:
        came[number] = samples[number]
        first = decide(came, rule)
        if first.verdict:
            break
    assert first == in_order


def test_a_copy_is_identical_at_the_first_mark():
    found = decide(copies(8), Sprt(), same_code=True)
    assert found.verdict is Verdict.IDENTICAL
    assert (found.pairs, found.diverged, found.llr, found.elo) == (8, 0, 0, (0, 0, 0))
    assert found.divergence == "0 of 8 pairs diverged"
    assert decide(copies(7), Sprt(), same_code=True).verdict is None
    assert decide(copies(400), Sprt(), same_code=True) == found


def test_other_code_that_plays_the_same_is_identical_only_at_the_end():
    assert decide(copies(399), Sprt()).verdict is None
    assert decide(copies(400), Sprt()).verdict is Verdict.IDENTICAL
    assert decide(copies(20), Fixed(20)).verdict is Verdict.IDENTICAL
    almost = {**copies(400), 300: between(300, Pair(leg(0, "a"), leg(0, "b")), parted=77)}
    found = decide(almost, Sprt())
    assert found.verdict is Verdict.INCONCLUSIVE
    assert found.divergence == "1 of 400 pairs diverged, first at tick 77"
    assert found.reasons == ("only 0 of 400 pairs are not exactly 0; 8 needed",)


@pytest.mark.parametrize("statistic", Statistic)
def test_pairs_that_are_all_zero_are_no_evidence_either_way(statistic):
    found = decide(run(*[(0, 0), (1, -1)] * 200), Sprt(0, 50), statistic=statistic)
    assert found.verdict is Verdict.INCONCLUSIVE
    assert {llr for _, llr in found.path} == {0}


def test_void_pairs_alone_are_not_identical():
    assert decide(run(*[None] * 8), Sprt(), same_code=True).verdict is None
    late = run(*[None] * 8) | {n: copies(16)[n] for n in range(8, 16)}
    assert decide(late, Sprt(), same_code=True).verdict is Verdict.IDENTICAL
    assert decide(run(*[None] * 20), Fixed(20)).verdict is Verdict.INCONCLUSIVE


def test_a_copy_whose_legs_differ_makes_the_run_invalid():
    found = decide(copies(8) | run((1, 0)), Sprt(), same_code=True)
    assert found.verdict is Verdict.INVALID
    assert found.reasons == ("the same code on both sides, and the legs of pair 0 differ",)


def test_a_match_that_cannot_be_repeated_makes_the_run_invalid_at_once():
    found = decide(run((1, 0)), Sprt(), contradictions=[(3, "home")])
    assert found.verdict is Verdict.INVALID
    assert found.reasons == ("(3, 'home') was played twice and came out differently",)


@pytest.mark.parametrize("score", [(2, 1), (-3, -3), (0, 0)])
def test_more_faults_than_the_base_are_invalid_whatever_the_score(score):
    samples = run(*[score] * 400)
    samples[3] = replace(samples[3], faults=1)
    for rule in (Sprt(), Fixed(400)):
        found = decide(samples, rule)
        assert found.verdict is Verdict.INVALID
        assert found.reasons == ("faults: 1 of the candidate, 0 of the base",)
        assert decide({n: samples[n] for n in range(6)}, rule).verdict is None  # the base may too


def test_no_more_faults_than_the_base_is_no_bar_but_is_remarked_on():
    samples = run(*[(2, 1)] * 40)
    samples[3] = replace(samples[3], faults=1)
    samples[5] = replace(samples[5], base_faults=1)
    found = decide(samples, Sprt())
    assert found.verdict is Verdict.PASS
    assert (found.faults, found.base_faults) == (1, 1)
    assert "the base was at fault 1 times" in found.warnings[0]


def test_faults_beyond_the_deciding_mark_do_not_count():
    samples = run(*[(2, 1)] * 100)
    samples[90] = replace(samples[90], faults=1)
    assert decide(samples, Sprt()).verdict is Verdict.PASS
    assert decide(samples, Fixed(100)).verdict is Verdict.INVALID


def test_the_last_look_decides_by_bounds_of_its_own_and_says_so():
    close = run(*[(1, 0), (-1, 0)] * 195, *[(1, 0)] * 10)
    found = decide(close, Sprt())
    assert found.verdict is Verdict.PASS
    assert found.bounds[0] < found.llr < found.bounds[1]
    assert found.llr > found.closing_bounds[1]
    assert found.reasons[0].endswith("2.01 is not between the closing bounds -1.41 and 1.41")
    assert decide(close, Sprt(closing=False)).verdict is Verdict.INCONCLUSIVE
    assert decide(run(*[(2, 0)] * 40), Sprt()).reasons == (
        "after 32 pairs the log-likelihood ratio 3.25 is not between -2.94 and 2.94",
    )


def test_void_pairs_take_a_number_and_say_nothing():
    samples = run(*([None, (2, 1)] * 60))
    found = decide(samples, Sprt())
    assert found.verdict is Verdict.PASS
    assert found.numbers == 2 * found.pairs == 2 * found.void
    assert found.llr == decide(run(*[(2, 1)] * found.pairs), Fixed(found.pairs)).llr
    assert found.warnings == (f"the machine failed to play {found.void} of {found.numbers} pairs",)
    assert decide(run(None, *[(2, 1)] * 39), Sprt()).warnings == ()


def test_goals_and_results_that_disagree_are_remarked_on():
    samples = run(*[(3, 0), (0, -1), (0, -1)] * 40)  # ahead by goals, behind by results
    found = decide(samples, Fixed(120))
    assert found.warnings == ("goals and results disagree: the candidate is ahead by goals alone",)
    assert found.results_elo.value < 0 < found.elo.value
    behind = run(*[(-3, 0), (0, 1), (0, 1)] * 40)
    assert decide(behind, Fixed(120)).warnings == (
        "goals and results disagree: the candidate is ahead by results alone",
    )


def test_against_opponents_the_difference_a_seed_decides():
    better, worse = Pair(leg(-1, "a"), leg(0, "b")), Pair(leg(-2, "c"), leg(-1, "d"))
    for statistic in Statistic:
        samples = {n: compared(n, [better] * 2, [worse] * 2) for n in range(50)}
        found = decide(samples, Fixed(50), statistic=statistic)
        assert found.verdict is Verdict.PASS  # though both lose
        assert found.counts == (0, 100, 0, 0, 0)
        assert found.base_counts == (100, 0, 0, 0, 0)
        assert found.goal_difference.value == 1
        assert finite(found.document())
    same = {n: compared(n, [better], [better]) for n in range(50)}
    assert decide(same, Fixed(50)).verdict is Verdict.IDENTICAL


def test_the_document_has_what_is_promised():
    document = decide(run(*[(2, 0)] * 40), Sprt()).document()
    assert list(document)[:5] == ["verdict", "pairs", "diverged", "llr", "bounds"]
    assert {"elo", "elo_ci", "goal_difference", "pentanomial", "faults"} <= set(document)
    assert document["verdict"] == "PASS"
    assert document["pairs"] == 32
    assert document["goal_difference"] == 1
    assert document["pentanomial"] == [0, 0, 0, 32, 0]
    assert document["faults"] == {"candidate": 0, "base": 0}
    assert document["elo_ci"][0] < document["elo"] < document["elo_ci"][1]
    assert document["llr"] >= document["bounds"][1] == pytest.approx(2.9444, abs=1e-4)
    assert json.loads(json.dumps(document, allow_nan=False)) == document


@settings(max_examples=30)
@given(
    st.lists(st.none() | st.tuples(st.integers(-9, 9), st.integers(-9, 9)), max_size=40),
    st.sampled_from([Sprt(), Sprt(-200, 200, most=10), Sprt(0, 5), Fixed(8), Fixed(40)]),
    st.sampled_from(Statistic),
)
def test_whatever_is_played_every_number_told_is_finite(pairs, rule, statistic):
    assert finite(decide(run(*pairs), rule, statistic=statistic).document())


def finite(document):
    if isinstance(document, dict):
        return all(map(finite, document.values()))
    if isinstance(document, list):
        return all(map(finite, document))
    return not isinstance(document, float) or isfinite(document)


def test_exit_codes():
    codes = [exit_code(verdict) for verdict in Verdict]
    assert dict(zip([str(verdict) for verdict in Verdict], codes, strict=True)) == {
        "PASS": 0,
        "FAIL": 1,
        "INCONCLUSIVE": 0,
        "IDENTICAL": 0,
        "INVALID": 4,
    }
    assert [exit_code(verdict, strict=True) for verdict in Verdict] == [0, 1, 1, 0, 4]
