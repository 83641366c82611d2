"""From matches to samples: what a pair says, and what a seed says against the same opponents."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from synthetic_matches import leg

from soccersim.regress.samples import Pair, between, compared, contradictions, void

legs = st.builds(leg, st.integers(-9, 9), st.sampled_from("ab"))
pairs = st.builds(Pair, legs, legs)


def test_a_pair_sums_both_legs_and_its_goal_difference_is_clipped():
    sample = between(7, Pair(leg(5, "a"), leg(-1, "b")), parted=120)
    assert (sample.number, sample.void, sample.diverged, sample.parted) == (7, False, True, 120)
    assert sample.outcome == 3  # 4, clipped
    assert sample.difference == 2  # a match, not clipped
    assert sample.result == 0  # one won, one lost
    assert sample.counts == (0, 0, 1, 0, 0)
    assert between(7, Pair(leg(5), leg(-1)), clip=10).outcome == 4


@pytest.mark.parametrize(
    ("home", "away", "column", "result"),
    [
        (-1, -2, 0, -0.5),
        (0, -1, 1, -0.25),
        (1, -1, 2, 0),
        (0, 0, 2, 0),
        (0, 3, 3, 0.25),
        (1, 1, 4, 0.5),
    ],
)
def test_the_five_kinds_of_pair(home, away, column, result):
    sample = between(0, Pair(leg(home), leg(away)))
    assert sample.counts[column] == sum(sample.counts) == 1
    assert sample.result == result


def test_a_copy_plays_the_same_match_from_either_side():
    # HOME won 2:0 in both legs; the candidate was HOME in the first only
    sample = between(0, Pair(leg(2, "same"), leg(-2, "same")))
    assert not sample.diverged
    assert sample.outcome == sample.result == sample.difference == 0


def test_a_forfeit_by_rule_counts_as_its_score_and_as_a_fault():
    sample = between(0, Pair(leg(-3, "a", faults=1), leg(-3, "b", faults=1, faults_against=2)))
    assert (sample.faults, sample.base_faults) == (2, 2)
    assert sample.outcome == -3


def test_against_opponents_the_sample_is_candidate_less_base_on_the_same_seed():
    mine = [Pair(leg(2, "a"), leg(1, "b")), Pair(leg(0, "c"), leg(0, "d"))]
    its = [Pair(leg(1, "a"), leg(1, "x")), Pair(leg(-1, "c"), leg(0, "d"))]
    sample = compared(4, mine, its, parted=9)
    assert sample.outcome == pytest.approx(((3 - 2) + (0 - -1)) / 2)
    assert sample.result == pytest.approx(((4 - 4) + (2 - 1)) / 8)
    assert sample.difference == pytest.approx(0.5)
    assert sample.diverged
    assert sample.counts == (0, 0, 1, 0, 1)
    assert sample.base_counts == (0, 1, 0, 0, 1)


def test_each_pair_is_clipped_before_it_is_compared():
    won, lost = Pair(leg(6), leg(6)), Pair(leg(-1), leg(0))
    assert compared(0, [won], [lost]).outcome == 4
    assert compared(0, [won], [lost]).difference == 6.5


def test_only_its_own_faults_count_against_a_team_in_a_comparison():
    mine = [Pair(leg(0, faults=1, faults_against=5), leg(0))]
    its = [Pair(leg(0, faults=2), leg(0, faults_against=7))]
    sample = compared(0, mine, its)
    assert (sample.faults, sample.base_faults) == (1, 2)


def test_a_comparison_needs_the_same_opponents_for_both():
    pair = Pair(leg(0), leg(0))
    with pytest.raises(ValueError, match="shorter"):
        compared(0, [pair, pair], [pair])
    with pytest.raises(ValueError, match="needs an opponent"):
        compared(0, [], [])


@given(pairs, pairs)
def test_teams_exchanged_is_the_sign_exchanged(mine, its):
    there, back = compared(0, [mine], [its]), compared(0, [its], [mine])
    assert (there.outcome, there.result) == (-back.outcome, -back.result)
    assert there.diverged == back.diverged
    turned = Pair(*(match._replace(goals=match.against, against=match.goals) for match in mine))
    assert between(0, turned).outcome == -between(0, mine).outcome
    assert between(0, turned).counts == between(0, mine).counts[::-1]


def test_a_void_pair_says_nothing():
    sample = void(3)
    assert (sample.number, sample.void, sample.outcome, sample.counts) == (3, True, 0, (0,) * 5)


def test_matches_that_came_out_differently_are_named_once():
    played = [((0, "home"), "a"), ((0, "away"), "b"), ((0, "home"), "a"), ((1, "home"), "c")]
    assert contradictions(played) == []
    assert contradictions([*played, ((0, "away"), "x"), ((0, "away"), "y")]) == [(0, "away")]
