"""Where each robot's camera put the ball, as recordings keep it."""

import numpy as np
import pytest
from watched import NOTHING, Watched, rms, sharp

BLIND = {"distance_sd": 0.0, "heading_sd_deg": 0.0, "dropout": 1.0}  # poses stay as believed
PLACES = ((1, 0, 20), (-3, 0, 70), (0, 4.5, -120), (6, 0, 170))


def sightings(game, frames):
    """(frames, R, 2): all that the robots saw."""
    seen = [game.go().perception.sighted() for _ in range(frames)]
    return np.array(seen)


def test_errors_are_as_wide_along_and_across_the_line_of_sight_as_the_camera_says():
    ball = {"range": 9.0, "radial": (0.04, -0.01, 0.01), "tangential": (0.01, 0.02, 0.0)}
    game = Watched(*PLACES, senses=sharp(ball={**ball, "dropout": 0.0}, lines=BLIND), ball=(0, 0))
    seen = sightings(game, 2000)
    for robot, (x, y, _) in enumerate(PLACES):
        distance = np.hypot(x, y)
        sight = -np.array((x, y)) / distance
        along, across = seen[:, robot] @ sight, seen[:, robot] @ (-sight[1], sight[0])
        wide = 0.04 - 0.01 * distance + 0.01 * distance**2, 0.01 + 0.02 * distance
        assert (rms(along), rms(across)) == pytest.approx(wide, rel=0.06)
        assert abs(along.mean()) < 4 * wide[0] / np.sqrt(len(seen))
        assert abs(across.mean()) < 4 * wide[1] / np.sqrt(len(seen))


def test_a_camera_misses_the_ball_as_often_as_it_is_said_to_and_beyond_its_range_always():
    ball = {"range": 4.0, "radial": NOTHING, "tangential": NOTHING, "dropout": 0.2}
    game = Watched(*PLACES, senses=sharp(ball=ball, lines=BLIND), ball=(0, 0))
    game.in_play[1] = 0
    missed = np.isnan(sightings(game, 2000)).mean(axis=(0, 2))
    assert missed[0] == pytest.approx(0.2, abs=0.03)
    assert missed[1:].tolist() == [1, 1, 1]  # out of play, too far, too far


def test_a_sighting_is_laid_on_from_where_the_robot_believed_it_was_at_the_picture():
    game = Watched((-2, 0, 0), (-3, 0, 90), senses=sharp(delay=0.06, lines=BLIND), ball=(0, 0))
    game.estimate.pose[0, :2] += (0.5, -0.3)
    game.estimate.pose[1, 2] -= np.pi / 2  # what is to its right it takes to be ahead of -y
    game.truth.body[-1, 3:5] = (2.0, 1.0)
    seen = sightings(game, 20)[-1]
    late = 2 * game.span  # a picture is worked on with the first step after the delay
    x, y = game.ball[:2] - late * game.ball[3:5]
    assert seen[0] == pytest.approx((x + 0.5, y - 0.3))
    assert seen[1] == pytest.approx((-3 + y, -(x + 3)))


def test_nothing_is_sighted_twice_nor_by_a_robot_that_was_carried_since():
    game = Watched((-2, 0, 0), (-2, 1, 0), senses=sharp(delay=0.06, lines=BLIND), ball=(0, 0))
    game.go(10)
    assert np.isfinite(game.perception.sighted()).all()
    assert np.isnan(game.perception.sighted()).all()
    game.go()
    game.perception.place(1, (3.0, 3.0, 0.0))
    assert np.isfinite(game.perception.sighted()).tolist() == [[True] * 2, [False] * 2]


def test_with_perfect_senses_there_are_no_cameras():
    game = Watched((-2, 0, 0), senses=sharp(), perception="truth")
    assert np.isnan(sightings(game, 5)).all()
