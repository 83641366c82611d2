"""What a team file imports: Strategy, View, Command, and the library of skills.

>>> from soccersim.strategy import Command, Strategy, View, skills

Nothing here needs numpy or any other library: a team may run in a small process of its own.
"""

from soccersim.strategy.api import (
    Area,
    Ball,
    Body,
    Circle,
    Command,
    Line,
    Opponent,
    Phase,
    Pitch,
    Player,
    Rules,
    Strategy,
    Text,
    View,
)

__all__ = [
    "Area",
    "Ball",
    "Body",
    "Circle",
    "Command",
    "Line",
    "Opponent",
    "Phase",
    "Pitch",
    "Player",
    "Rules",
    "Strategy",
    "Text",
    "View",
]
