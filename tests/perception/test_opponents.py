"""A team knows where its opponents are, how fast, and which of them are two, not one."""

import numpy as np
import pytest
from watched import Watched, realistic, rms, sharp

from soccersim import load_scenario
from soccersim.perception import Perception
from soccersim.sheet import HEADER, OPPONENT, OPPONENTS_KNOWN, ROBOT, sheet_size
from soccersim.simulation import Simulation

THEM = ((2, 0, 180), (3, 2, 180), (-1, 4, 0), (4, -4, 90), (6, 1, 0))


def test_in_a_crowd_of_ten_all_five_are_known_and_hardly_ever_one_twice():
    """The kickabout: everybody drives about and bumps, about one contact a tick."""
    simulation = Simulation(load_scenario("kickabout", settings=["duration=20"], seed=3))
    perception, m = Perception(simulation.scenario), simulation.machine
    sheet, known, far, faster, twice = np.zeros(sheet_size(5, 5)), [], [], [], []
    while not simulation.done:
        tick = simulation.tick
        perception.step(m.truth, m.readings, m.estimate, tick, [1] * 10, [1, -1])
        perception.fill(sheet, 0, tick)
        simulation.advance(perception.beat)
        known.append(sheet[OPPONENTS_KNOWN])
        at = HEADER + 5 * ROBOT
        told = sheet[at : at + int(known[-1]) * OPPONENT].reshape(-1, OPPONENT)
        so = m.truth.body[5:10]
        apart = np.hypot(*(told[:, None, k] - so[None, :, k] for k in (0, 1)))
        nearest = apart.argmin(axis=1)
        twice.append(len(set(nearest)) < len(nearest))
        far += apart.min(axis=1).tolist()
        faster += np.hypot(*(told[:, k] - so[nearest, k + 1] for k in (2, 3))).tolist()
    assert np.mean(known) > 4.95
    assert np.mean(twice) < 0.01
    assert rms(far) < 0.2
    assert max(far) < 1.0
    assert rms(faster) < 0.9


def test_where_they_stand_and_how_they_drive():
    game = Watched((0, 0, 0), (-2, 3, 0), away=THEM, senses=realistic())
    game.truth.body[2:7, 3:5] = [(1, 0), (-1, 1), (0, 0), (0.5, -1), (-2, 0)]
    told = game.go(30).sheet().met
    so = game.truth.body[2:7]
    so = so[np.argsort(so[:, 0])]
    assert len(told) == 5
    assert np.abs(told[:, :2] - so[:, :2]).max() < 0.5
    assert rms(told[:, 2:4] - so[:, 3:5]) < 0.6


def test_two_who_stand_shell_to_shell_stay_two():
    game = Watched((0, 0, 0), (0, -3, 90), away=((3, 0.26, 0), (3, -0.26, 0)), senses=realistic())
    for _ in range(300):
        told = game.go().sheet().opponents
        assert len(told) == 2 or game.tick < 20 * 10
    y = np.sort(told[:, 1])
    assert y == pytest.approx([-0.26, 0.26], abs=0.25)


def test_one_who_comes_into_play_beside_another_is_a_second_one():
    game = Watched((0, 0, 0), away=((3, 0.26, 0), (3, -0.26, 0)), senses=realistic())
    game.in_play[2] = 0
    assert len(game.go(40).sheet().opponents) == 1
    game.in_play[2] = 1
    assert len(game.go(6).sheet().opponents) == 2


def test_two_who_cross_are_still_two_afterwards():
    game = Watched((0, 0, 0), away=((3, 1.5, 0), (3.6, -1.5, 0)), senses=realistic())
    game.truth.body[1, 4], game.truth.body[2, 4] = -1.5, 1.5
    met = [len(game.go().sheet().opponents) for _ in range(60)]
    assert met[-30:] == [2] * 30
    so = np.sort(game.truth.body[1:3, 1])
    assert np.sort(game.sheet().opponents[:, 1]) == pytest.approx(so, abs=0.5)


def test_one_nobody_sees_is_forgotten_after_a_second():
    game = Watched((0, 0, 0), away=((4, 0, 0), (-3, 0, 0)), senses=sharp(opponents={"range": 7.0}))
    game.go(5)
    game.truth.body[1, :2] = (9, 5)
    told = game.go(20).sheet().opponents
    assert len(told) == 2
    assert max(told[:, 4]) == pytest.approx(0.8)
    assert len(game.go(10).sheet().opponents) == 1
    game.truth.body[1, :2] = (5, 1)
    assert game.go(2).sheet().met[:, 0] == pytest.approx([-3, 5])


def test_one_taken_off_the_field_is_not_seen_any_more():
    game = Watched((0, 0, 0), away=THEM)
    assert len(game.go(3).sheet().opponents) == 5
    game.in_play[3] = 0
    assert len(game.go(40).sheet().opponents) == 4


def test_a_wild_guess_at_a_far_one_makes_no_second_robot():
    wild = {"range": 12.0, "radial": [0.8, 0, 0], "tangential": [0.3, 0, 0]}
    senses = realistic(opponents=wild)
    game = Watched((0, 0, 0), (0, 3, 0), away=((8, 0, 0), (0, 9, 0)), senses=senses)
    met = [len(game.go().sheet().opponents) for _ in range(500)]
    assert np.mean(np.array(met[5:]) == 2) > 0.99


def test_a_robot_put_elsewhere_by_hand_leaves_no_ghost():
    game = Watched((0, 0, 0), away=((4, 0, 0), (3, 3, 0)), senses=realistic(delay=0.2))
    game.go(20)
    game.truth.body[1, :3] = game.estimate.pose[1] = (-5, -2, 0)
    game.perception.place(1, (-5, -2, 0))
    for _ in range(30):
        told = game.sheet().opponents
        assert all(np.hypot(told[:, 0] - 4, told[:, 1]) > 1)
        game.go()
    assert len(game.sheet().opponents) == 2
