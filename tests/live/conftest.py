"""A play to steer, and a match of teams that stand still."""

import pytest

from soccersim import load_scenario
from soccersim.live.catalogue import play_of


@pytest.fixture
def play():
    play = play_of(load_scenario("training"))
    yield play
    play.close()


@pytest.fixture
def match():
    settings = ["match.home.strategy=still", "match.away.strategy=still"]
    match = play_of(load_scenario("msl-match", settings=settings))
    yield match
    match.close()
