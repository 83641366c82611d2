"""docs/strategy.md tells every field of the messages and every skill."""

from dataclasses import fields
from inspect import signature

import pytest
from pages import ROOT, rows

from soccersim.strategy import (
    Ball,
    Body,
    Command,
    Opponent,
    Phase,
    Pitch,
    Player,
    Rules,
    View,
    skills,
)

PAGE = ROOT / "docs" / "strategy.md"


@pytest.mark.parametrize(
    "message", [View, Player, Body, Ball, Opponent, Pitch, Rules, Command], ids=lambda m: m.__name__
)
def test_every_field_is_told_in_order(message):
    assert list(rows(PAGE, message.__name__)) == [field.name for field in fields(message)]


def test_every_phase_is_told():
    told = rows(PAGE, "View")["phase"][0]
    assert [f"`{phase}`" in told for phase in Phase] == [True] * len(Phase)


def test_every_skill_is_told_as_it_is_called():
    told = [call.partition("(") for call in rows(PAGE, "Skills")]
    assert sorted(name for name, _, _ in told) == sorted(skills.__all__)
    for name, _, arguments in told:
        known = signature(getattr(skills, name)).parameters
        for argument in arguments.rstrip(")").split(", "):
            word, _, default = argument.partition("=")
            assert word in known, name
            assert str(known[word].default) == default or not default, name
