"""Two matches have one key exactly where they must come out the same."""

from dataclasses import replace

import pytest

from soccersim import load_scenario
from soccersim.regress import engine as engines
from soccersim.regress.bundle import Bundle
from soccersim.regress.leg import pair_of


@pytest.fixture
def teams(team):
    return team("return fine", "one.py"), team("return fine  # two", "two.py")


@pytest.fixture
def leg(friendly, teams):
    return pair_of(friendly, teams, 4, 7)[0]


def test_home_and_away_are_exchanged(friendly, teams):
    options = {"speed": 1}, {"speed": 2}
    one, two = pair_of(friendly, teams, 4, 7, options=options, watched=0)
    assert (one.home, one.away) == (two.away, two.home) == teams
    assert (one.seed, one.pair, one.leg, one.watched) == (7, 4, 0, 0)
    assert (two.seed, two.pair, two.leg, two.watched) == (7, 4, 1, 1)
    for each, speeds in ((one, [1, 2]), (two, [2, 1])):
        match = load_match(each)
        assert [match.home.strategy, match.away.strategy] == [each.home.name, each.away.name]
        assert [match.home.options["speed"], match.away.options["speed"]] == speeds


def load_match(leg):
    from soccersim.spec.scenario import Scenario

    return Scenario.model_validate_json(leg.scenario).match


def test_names_numbers_and_what_is_kept_are_not_in_the_key(friendly, leg):
    renamed = replace(leg, home=Bundle("another name", leg.home.data))
    assert renamed.key == leg.key
    assert replace(leg, pair=0, keep="all", watched=1).key == leg.key
    spec = friendly.model_copy(update={"name": "x", "about": "y", "seed": 99})
    named = Bundle("as I call it", leg.home.data)
    assert pair_of(spec, (named, leg.away), 0, 7)[0].key == leg.key


def test_all_else_is(friendly, teams, leg, monkeypatch):
    one, two = teams
    longer = load_scenario("friendly-match", settings=["duration=0.6"])
    others = [
        pair_of(longer, teams, 4, 7)[0],
        pair_of(friendly, teams, 4, 8)[0],
        pair_of(friendly, teams, 4, 7)[1],
        pair_of(friendly, (two, one), 4, 7)[0],
        pair_of(friendly, (one, one), 4, 7)[0],
        pair_of(friendly, (one, one), 4, 7)[1],
        pair_of(friendly, teams, 4, 7, options=({"speed": 1}, {}))[0],
        replace(leg, engine="another"),
    ]
    assert len({leg.key, *(other.key for other in others)}) == 1 + len(others)


@pytest.fixture
def engine(monkeypatch):
    """The digest of what plays, computed anew."""
    return engines.engine.__wrapped__


def test_an_edit_of_what_plays_matches_is_another_engine(engine, monkeypatch, tmp_path):
    for name in ("match/game.py", "cli/match.py", "regress/runner.py"):
        path = tmp_path / name
        path.parent.mkdir()
        path.write_text("x = 1")
    monkeypatch.setattr(engines, "PACKAGE", tmp_path)
    before = engine()
    (tmp_path / "cli/match.py").write_text("x = 2")
    (tmp_path / "regress/runner.py").write_text("x = 2")
    assert engine() == before
    (tmp_path / "match/game.py").write_text("x = 2")
    assert engine() != before


def test_so_are_other_versions_and_platforms(engine, monkeypatch):
    before = engine()
    monkeypatch.setattr(engines, "__version__", "99")
    newer = engine()
    monkeypatch.setattr(engines, "fingerprint", lambda: {"os": "another"})
    assert len({before, newer, engine()}) == 3
