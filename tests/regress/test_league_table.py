"""The table of a tournament: points, goals, who beat whom, and the order."""

import json

import pytest
from synthetic_matches import leg

from soccersim.regress.samples import Leg, Pair
from soccersim.regress.table import Meeting, table

TEAMS = ["ants", "bees", "crabs"]
MEETINGS = [
    Meeting(0, 1, Pair(Leg(2, 1, ""), Leg(1, 1, ""))),
    Meeting(0, 2, Pair(Leg(0, 3, ""), Leg(4, 0, ""))),
    Meeting(2, 1, Pair(Leg(2, 0, "", faults_against=1), Leg(0, 0, "", faults=2))),
]


@pytest.fixture
def after():
    return table(TEAMS, MEETINGS)


def test_points_goals_and_faults(after):
    lines = {row.team: row for row in after.rows}
    assert lines["ants"][1:8] == (4, 2, 1, 1, 7, 5, 7)
    assert lines["bees"][1:8] == (4, 0, 2, 2, 2, 5, 2)
    assert lines["crabs"][1:8] == (4, 2, 1, 1, 5, 4, 7)
    assert [lines[team].faults for team in TEAMS] == [0, 1, 2]


def test_teams_level_on_points_are_parted_by_goals(after):
    assert [row.team for row in after.rows] == ["ants", "crabs", "bees"]


def test_the_cross_table_is_in_the_tables_order(after):
    assert after.cross[0, 2].tolist() == [1, 1, 0]  # ants against bees
    assert after.cross[2, 0].tolist() == [0, 1, 1]
    assert after.cross[1, 2].tolist() == [1, 1, 0]  # crabs against bees
    assert after.cross[0, 0].tolist() == [0, 0, 0]


def test_ratings_stand_beside_the_teams_they_belong_to(after):
    assert after.rows[2].elo == after.ratings.elo[1] < 0
    assert after.rows[0].elo == pytest.approx(after.rows[1].elo)


def test_while_it_runs_points_a_match_count():
    meetings = [Meeting(0, 1, Pair(leg(1), leg(0)))] * 3 + [Meeting(2, 1, Pair(leg(1), leg(1)))]
    assert [row.team for row in table(TEAMS, meetings).rows] == ["crabs", "ants", "bees"]


def test_the_document_is_json_and_counts_pairs(after):
    document = after.document()
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["pairs"] == 3
    assert table(TEAMS, []).document()["pairs"] == 0
