"""A hand pushes a robot from mark to mark: it follows, and its idle wheels turn along."""

from math import hypot, pi

import numpy as np
import pytest
from factory import player, robot, scenario

from soccersim.simulation import Simulation

COASTING = robot(mass_height=0.15, drive={"motor": {"at_zero": "coast"}})
HAND = {"speed": 0.3, "acceleration": 0.5, "turn_rate": 1.0}


def test_a_pushed_robot_follows_the_hand_to_its_mark():
    """Within a centimetre on the way, where the mark speeds up, and a millimetre at the end."""
    written = scenario(
        player(COASTING, (1.0, 0.5, 90), (1.0, -0.5, 90), pushed_by=HAND), duration=30.0
    )
    recording = Simulation(written).run()
    legs = recording.meta["legs"][0]
    assert [leg["reached"] for leg in legs] == [True, True]
    for leg, mark in zip(legs, [(1.0, 0.5), (1.0, -0.5)], strict=True):
        assert hypot(*(np.array(leg["truth"][:2]) - mark)) < 0.01
        assert leg["truth"][2] == pytest.approx(pi / 2, abs=0.02)
    lag = recording.body[1:-1, 0, :2] - recording.reference[1:-1, 0, :2]
    assert np.hypot(*lag.T).max() < 0.01
    assert (recording.arrays["pwm"] == 0).all()


def test_the_wheels_of_a_pushed_robot_roll_with_the_floor():
    """They have only their bearings to turn: the rims cover the way, within the creep."""
    written = scenario(player(COASTING, (2.0, 0.0, 0), pushed_by=HAND), duration=30.0)
    recording = Simulation(written).run()
    way = recording.body[-1, 0, 0]
    rolled = recording.arrays["wheel_angle"][-1, 0] * 0.05
    assert rolled == pytest.approx(way * np.array([-0.5, -0.5, 1.0]), abs=0.01)
