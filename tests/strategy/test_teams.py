"""The contract, run over every team that comes with the program."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_api import views

from soccersim.bundled import names
from soccersim.strategy.check import answer_of
from soccersim.strategy.load import load_team, locate, make_team

TEAMS = names("strategy")
KINDS = {name: load_team(locate(name)) for name in TEAMS}


def test_the_four_reference_teams_are_there():
    assert {"still", "chaser", "positioning", "roles"} <= set(TEAMS)


@pytest.mark.parametrize("name", TEAMS)
@settings(max_examples=60)
@given(seen=st.lists(views, min_size=1, max_size=4))
def test_a_team_answers_whatever_it_sees_with_one_good_command_a_robot(name, seen):
    """Also a ball never seen, one robot, nobody in play, one view after any other."""
    team = make_team(KINDS[name], np.random.default_rng(1), {})
    for view in seen:
        answer = answer_of(team.decide(view), len(view.robots))
        assert len(answer.orders) == len(view.robots)
