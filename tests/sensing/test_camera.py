"""Cameras err as much as asked, each in its own way, and see no farther than they can."""

import numpy as np
import pytest
from watched import NOTHING, SHARP, Watched, realistic, sharp

from soccersim.sensing.camera import DrawSource
from soccersim.sensing.noise import BLOCK

FRAMES = 3000
FACING = 50.0  # degrees
SURE = 4 / (2 * FRAMES) ** 0.5  # four standard deviations of a standard deviation, relative


def frames(game, *names, count=FRAMES):
    """What the cameras' ring holds under these names, frame by frame."""
    ring = game.perception._eyes.frames
    seen = {name: [] for name in names}
    for _ in range(count):
        game.go()
        slot = game.tick // game.perception.beat % len(ring.number)
        for name in names:
            seen[name].append(getattr(ring, name)[slot].copy())
    return [np.array(seen[name]) for name in names]


def along_and_across(places, seen):
    """Sightings (T, 2) in the body frame, less what is so, along and across the line of sight."""
    d = np.hypot(*places)
    ux, uy = np.array(places) / d
    return seen @ (ux, uy) - d, seen @ (-uy, ux)


def test_poses_from_lines_err_as_much_as_asked():
    lines = {"distance_sd": 0.07, "heading_sd_deg": 3.0}
    game = Watched((1, 2, FACING), senses=sharp(lines=lines))
    (fix,) = frames(game, "fix")
    off = fix[:, 0] - (1, 2, np.radians(FACING))
    assert off.std(axis=0) == pytest.approx([0.07, 0.07, np.radians(3)], rel=SURE)
    assert abs(off.mean(axis=0)) == pytest.approx(0, abs=4 * 0.07 / FRAMES**0.5)
    assert abs(np.corrcoef(off.T)[np.triu_indices(3, 1)]).max() < 4 / FRAMES**0.5


@pytest.mark.parametrize("distance", [0.5, 2.0, 6.0])
def test_a_ball_is_seen_with_the_spread_that_teams_published(distance):
    """CAMBADA: .01 d2 - .01 d + .039 along the line of sight; Falcons: .02 d + .01 across."""
    game = Watched((0, 0, FACING), ball=(distance, 0), senses=realistic(scale_sd=0.0))
    seen, at = frames(game, "ball_seen", "ball")
    a = np.radians(FACING)
    places = distance * np.array([np.cos(a), -np.sin(a)])  # body frame
    along, across = along_and_across(places, at[seen[:, 0] == 1, 0])
    assert along.std() == pytest.approx(0.01 * distance**2 - 0.01 * distance + 0.039, rel=SURE)
    assert across.std() == pytest.approx(0.02 * distance + 0.01, rel=SURE)
    assert abs(along.mean()) < 4 * along.std() / len(along) ** 0.5
    assert abs(np.corrcoef(along, across)[0, 1]) < 4 / len(along) ** 0.5


def test_opponents_are_seen_with_a_spread_of_their_own():
    sight = {"radial": [0.1, 0, 0], "tangential": [0.02, 0, 0]}
    game = Watched((0, 0, 0), away=((0, 3, 0),), senses=sharp(opponents=sight))
    (other,) = frames(game, "other")
    along, across = along_and_across((0, 3), other[:, 0, 1])
    assert along.std() == pytest.approx(0.1, rel=SURE)
    assert across.std() == pytest.approx(0.02, rel=SURE)


def test_frames_balls_robots_and_poses_are_missed_as_often_as_asked():
    once = {"ball": {"dropout": 0.2}, "opponents": {"dropout": 0.3}, "lines": {"dropout": 0.4}}
    game = Watched((0, 0, 0), away=((3, 0, 0),), senses=sharp(dropout=0.1, **once))
    ball, other, fixed = frames(game, "ball_seen", "seen", "fixed")
    seen = [ball[:, 0].mean(), other[:, 0, 1].mean(), fixed[:, 0].mean()]
    assert seen == pytest.approx([0.9 * 0.8, 0.9 * 0.7, 0.9 * 0.6], abs=4 * 0.5 / FRAMES**0.5)


def test_nothing_is_seen_beyond_its_range():
    sights = {"ball": {"range": 5.0}, "opponents": {"range": 3.0}}
    game = Watched(
        (0, 0, 0), away=((2.9, 0, 0), (0, 3.1, 0)), ball=(4.9, 0), senses=sharp(**sights)
    )
    ball, other = frames(game, "ball_seen", "seen", count=3)
    assert ball[:, 0].all()
    assert other[:, 0, 1].all()
    assert not other[:, 0, 2].any()
    game.ball[0] = 5.1
    assert not frames(game, "ball_seen", count=1)[0][0, 0]


def test_a_robot_s_mirror_stretches_all_distances_alike():
    places = [(3, 0, 0), (0, 0, 90), (-4, 1, 0)]
    game = Watched(*places, ball=(0, 4), senses=sharp(scale_sd=0.05))
    (at,) = frames(game, "ball", count=5)
    far = np.hypot(at[..., 0], at[..., 1]) / [5, 4, 5]
    assert (far[0] == far).all()  # the same in every frame
    assert len(set(far[0].round(6))) == 3  # of every robot another
    assert abs(far[0] - 1).max() < 4 * 0.05
    drawn = [
        Watched((0, 0, 0), seed=seed, senses=sharp(scale_sd=0.05)).perception._eyes.camera.scale[0]
        for seed in range(100)
    ]
    assert np.std(drawn) == pytest.approx(0.05, rel=0.3)


def test_robots_out_of_play_neither_see_nor_are_seen():
    game = Watched((0, 0, 0), (1, 1, 0), away=((3, 0, 0), (4, 0, 0)))
    game.in_play[:] = (1, 0, 1, 0)
    ball, other, fixed = frames(game, "ball_seen", "seen", "fixed", count=2)
    assert ball[-1].tolist() == [1, 0, 1, 0]
    assert fixed[-1].tolist() == [1, 0, 1, 0]
    assert other[-1].tolist() == [[0, 0, 1, 0], [0, 0, 0, 0], [1, 0, 0, 0], [0, 0, 0, 0]]


def test_an_opponent_more_leaves_what_the_others_see_as_it_was():
    one = Watched((0, 0, 0), away=((3, 0, 0),), senses=realistic())
    two = Watched((0, 0, 0), away=((3, 0, 0), (-3, 2, 0)), senses=realistic())
    names = ("fix", "ball", "ball_seen", "sent", "fixed")
    for a, b in zip(frames(one, *names, count=50), frames(two, *names, count=50), strict=True):
        assert (a[:, :2] == b[:, :2]).all()


def test_what_a_camera_misses_leaves_what_it_sees_as_it_was():
    clear, dim = realistic(), realistic(dropout=0.5, ball={"dropout": 0.5}, lines={"dropout": 0.9})
    games = [Watched((0, 0, 0), ball=(2, 1), senses=s) for s in (clear, dim)]
    (fix, ball, seen), (dim_fix, dim_ball, dim_seen) = (
        frames(game, "fix", "ball", "ball_seen", count=200) for game in games
    )
    both = (seen == 1) & (dim_seen == 1)
    assert (fix == dim_fix).all()
    assert (ball[both] == dim_ball[both]).all()
    assert 20 < both.sum() < 100


def test_every_draw_is_used_once():
    source = DrawSource([0, 0, 1], 5)
    source.prepare(0)
    first = source.draws.ball.copy()
    source.prepare(BLOCK - 1)
    assert (source.draws.ball == first).all()
    source.prepare(BLOCK)
    numbers = np.concatenate([first.ravel(), source.draws.ball.ravel(), source.draws.pose.ravel()])
    assert len(np.unique(numbers)) == numbers.size
    source.prepare(3 * BLOCK)  # blocks nobody asked for are passed over
    again = DrawSource([0, 0, 1], 5)
    again.prepare(3 * BLOCK)
    assert (again.draws.other == source.draws.other).all()


def test_equal_robots_side_by_side_err_differently():
    game = Watched((0, 0, 0), (0, 0.6, 0), senses=realistic())
    (fix,) = frames(game, "fix", count=200)
    assert abs(np.corrcoef(fix[:, 0, 0], fix[:, 1, 0])[0, 1]) < 0.3


def test_perfect_senses_see_what_is_so():
    game = Watched((1, 2, FACING), away=((4, -2, 0),), ball=(-1, 3), senses=SHARP)
    fix, ball = frames(game, "fix", "ball", count=1)
    assert fix[0, 0] == pytest.approx([1, 2, np.radians(FACING)])
    a = np.radians(FACING)
    c, s = np.cos(a), np.sin(a)
    assert ball[0, 0] == pytest.approx([-2 * c + s, 2 * s + c])
    assert SHARP["camera"]["ball"]["radial"] == NOTHING
