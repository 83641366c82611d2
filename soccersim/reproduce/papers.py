"""The papers that can be reproduced: their titles, and the modules that do it."""

from collections.abc import Callable, Iterator
from importlib import import_module

from soccersim.reproduce.lab import Lab
from soccersim.reproduce.section import Section

PAPERS = {  # name: title; its module has sections(lab) -> Iterator[Section]
    "idris": "Idris, Prasetyowati, Subroto: Forward and Inverse Kinematic on Wheeled Soccer Robot",
    "utama": "Utama et al.: Positioning and Maneuver of an Omnidirectional Robot Soccer",
    "dasmahapatra": "Dasmahapatra: Inverse and Forward Kinematics of 3R Planner Serial Robot",
    "four-wheel": "A note on four omni wheels (in Indonesian)",
    "garcia": "García-Sillas et al.: Kinematics modeling and simulation of an autonomous "
    "omni-directional mobile robot",
}


def sections(paper: str, lab: Lab) -> Iterator[Section]:
    """Every table, figure and set of equations of one paper, in its order."""
    module = import_module(f"soccersim.reproduce.{paper.replace('-', '_')}")
    reproduce: Callable[[Lab], Iterator[Section]] = module.sections
    return reproduce(lab)
