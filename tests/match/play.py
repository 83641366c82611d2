"""Matches in this process, for tests."""

from pathlib import Path

from soccersim import load_scenario
from soccersim.match.game import Game
from soccersim.match.pitch import pitch_of
from soccersim.match.seats import LocalSeat
from soccersim.match.turn import Turn
from soccersim.strategy.load import locate

TEAMS = Path(__file__).parent / "teams"
RUSH = str(TEAMS / "rush.py")


def game(home=RUSH, away=RUSH, *settings, scenario="friendly-match", seed=1, options=({}, {})):
    """A match about to begin, and its seats."""
    spec = load_scenario(scenario, seed=seed, settings=settings)
    turn = Turn()
    seats = [
        LocalSeat(slot, locate(str(team)), options[slot], pitch_of(spec, slot), spec.seed, turn)
        for slot, team in enumerate((home, away))
    ]
    return Game(spec, turn), seats


def play(*arguments, **keywords):
    """Its result."""
    match, seats = game(*arguments, **keywords)
    return match.play(seats)
