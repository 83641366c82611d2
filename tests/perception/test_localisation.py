"""A robot that slips knows where it is, because it sees the lines; without them it drifts."""

from math import pi, radians

import numpy as np
import pytest
from factory import bundled, merged, player, scenario
from watched import SHARP, Watched, realistic, rms, sharp

from soccersim.geometry import wrap_angle
from soccersim.perception import Perception
from soccersim.simulation import Simulation

LAPS = [(8, 3, 90), (-7, 4, 180), (-8, -5, 0), (6, -4, -90), (0, 0, 180)]  # with hard turns
BLIND = {"lines": {"dropout": 1.0}}


def laps(senses, seconds=120.0, seed=1):
    """Errors (T, 3) of what a Middle Size robot believes while it drives laps and slips."""
    model = player(bundled("msl"), *LAPS, start=(-3, -1, 0), repeat=True)
    written = scenario(model, senses=senses, ball={"at": (0, 9)}, duration=seconds, seed=seed)
    simulation, perception = Simulation(written), Perception(written)
    m, errors = simulation.machine, []
    while not simulation.done:
        perception.step(m.truth, m.readings, m.estimate, simulation.tick, [1], [1, -1])
        error = m.estimate.pose[0] - m.truth.body[0, :3]
        errors.append([*error[:2], wrap_angle(error[2])])
        simulation.advance(perception.beat)
    return np.array(errors)


def test_a_slipping_robot_stays_within_a_few_centimetres_for_minutes():
    off = laps(realistic())
    far = np.hypot(off[:, 0], off[:, 1])
    assert rms(far) < 0.05
    assert far.max() < 0.2
    assert np.degrees(rms(off[:, 2])) < 1.2
    fix = realistic()["camera"]["lines"]["distance_sd"]
    assert rms(far) < 0.5 * fix * 2**0.5  # less than half of a single frame's error


def test_odometry_alone_drifts_metres_in_the_same_time():
    off = laps(realistic(**BLIND))
    assert np.hypot(off[:, 0], off[:, 1]).max() > 1.5


def test_with_perfect_lines_a_robot_knows_its_place_exactly():
    off = laps(SHARP, seconds=10.0)
    assert abs(off).max() < 1e-3


def test_lines_correct_a_robot_that_believes_itself_elsewhere():
    game = Watched((1, 2, 30), senses=realistic())
    game.estimate.pose[0] += (3.0, -2.0, radians(40))
    game.go(25)
    assert np.hypot(*game.off[0, :2]) < 0.15
    assert abs(np.degrees(game.off[0, 2])) < 4


def test_a_frame_that_comes_late_corrects_where_the_robot_is_now():
    """At 2 m/s a frame of 0.12 s ago shows a place 24 cm back."""
    game = Watched((-5, 0, 0), senses=sharp(delay=0.12))
    game.truth.body[0, 3:5] = (2.0, 1.0)
    game.estimate.pose[0, :2] += (0.5, -0.3)
    game.go(25)
    assert abs(game.off).max() < 1e-6


def test_a_wrong_heading_is_set_right_with_all_that_was_reckoned_since():
    game = Watched((-5, 0, 0), senses=sharp(delay=0.12))
    game.truth.body[0, 3:6] = (2.0, 0.0, 1.0)
    game.estimate.pose[0, 2] += radians(20)
    game.go(3)
    assert abs(game.off[0, 2]) == pytest.approx(radians(20))  # no frame has been worked on yet
    assert np.hypot(*game.off[0, :2]) > 0.05
    game.go(1)  # the first one sets all right
    assert abs(game.off).max() < 2e-3


def test_a_heading_may_have_gone_round_many_times():
    game = Watched((0, 0, 0), senses=realistic())
    game.estimate.pose[0, 2] += 20 * pi
    game.go(25)
    assert game.off[0, 2] == pytest.approx(20 * pi, abs=radians(4))


def test_without_lines_nothing_changes_what_a_robot_reckons():
    game = Watched((0, 0, 0), senses=realistic(**BLIND))
    game.truth.body[0, 3:6] = (1.0, 0.5, 0.2)
    game.estimate.pose[0] += (0.2, 0.1, 0.05)
    before = game.estimate.pose[0, 2] - game.truth.body[0, 2]
    game.go(50)
    assert game.off[0, 2] == pytest.approx(before, abs=1e-12)


def test_a_robot_carried_back_into_play_is_not_pulled_to_where_it_was_seen_before():
    game = Watched((0, 0, 0), senses=sharp(delay=0.2))
    game.go(10)
    game.truth.body[0, :3] = game.estimate.pose[0] = (5.0, 1.0, 1.0)
    game.perception.place(0, (5.0, 1.0, 1.0))
    for _ in range(10):
        game.go()
        assert abs(game.off).max() < 1e-9
        assert game.sheet().robots[0, 3:6] == pytest.approx([5.0, 1.0, 1.0])


def test_the_surer_a_single_frame_the_surer_the_robot():
    spread = []
    for sd in (0.02, 0.06, 0.2):
        game = Watched((0, 0, 0), senses=realistic(lines={"distance_sd": sd}))
        off = []
        for _ in range(500):
            game.go()
            off.append(game.off[0, :2].copy())
        spread.append(rms(off[50:]))
        assert spread[-1] < sd
    assert spread == sorted(spread)


def test_a_filter_that_trusts_its_odometry_more_is_calmer_and_slower():
    calm = merged(realistic(), {"localisation": {"wander": 0.02, "slip": 0.0}})
    quick = merged(realistic(), {"localisation": {"wander": 0.5}})
    noise = []
    for senses in (calm, quick):
        game, off = Watched((0, 0, 0), senses=senses), []
        for _ in range(500):
            game.go()
            off.append(game.off[0, :2].copy())
        noise.append(rms(off[100:]))
    assert noise[0] < 0.6 * noise[1]
