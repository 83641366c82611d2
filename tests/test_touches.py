"""Who played the ball, as a recording tells it."""

import numpy as np
import pytest
from tape import tape

from soccersim.touches import BallPlay

REACH = 0.24 + 0.11  # m, from a robot's centre to the ball that it touches
FAR = (9.0, 6.0, 0.0)


def still(records, *poses):
    """Ten robots that stand: these, and the others in a corner."""
    places = [*poses, *[FAR] * (10 - len(poses))]
    return np.tile(np.array(places), (records, 1, 1))


def rolling(start, end, records):
    """The ball from one place to another."""
    return np.linspace(start, end, records)


def test_robot_whose_shell_the_ball_meets_has_it_until_another_gets_it():
    ball = np.concatenate((rolling((REACH, 0), (REACH, 0), 20), rolling((REACH, 0), (3, 0), 40)))
    play = BallPlay(tape(still(60, (0, 0, 0), (3 + REACH, 0, 0)), ball))
    assert [(touch.robot, touch.before) for touch in play.touches] == [(0, -1), (1, 0)]
    assert (play.holder[:50] == 0).all()
    assert play.holder[-1] == 1
    assert 19 <= play.touches[1].left <= 21


def test_ball_that_bounces_off_a_robot_between_two_records_has_been_touched():
    there, back = rolling((0, 0), (2.9, 0), 30), rolling((2.8, 0), (0, 0), 30)
    play = BallPlay(tape(still(60, (3 + REACH, 0, 0)), np.concatenate((there, back))))
    assert np.hypot(*(play.ball[:, :2] - (3 + REACH, 0)).T).min() > REACH + 0.05
    assert [touch.robot for touch in play.touches] == [0]


def test_ball_that_bounces_off_the_board_has_been_touched_by_nobody():
    there, back = rolling((0, 0), (0, 7.9), 30), rolling((0, 7.8), (0, 0), 30)
    play = BallPlay(tape(still(60, (5, 7, 0)), np.concatenate((there, back))))
    assert play.touches == []
    assert (play.holder == -1).all()


def test_robot_that_feels_the_ball_in_its_mouth_has_it_at_any_distance():
    contact = np.zeros((5, 10))
    contact[2:, 4] = 1
    play = BallPlay(tape(still(10), np.full((10, 2), 3.0), contact=contact))
    assert play.holder.tolist() == [-1] * 4 + [4] * 6


def test_of_two_robots_at_the_ball_the_one_who_had_it_keeps_it():
    ways = still(40, (0, 0, 0), (3, 0, 0))
    ways[20:, 1, 0] = 2 * REACH
    play = BallPlay(tape(ways, np.tile((REACH, 0.0), (40, 1))))
    assert (play.holder == 0).all()


def test_nobody_has_the_ball_while_play_is_stopped():
    phase = ["play"] * 5 + ["stop"] * 5 + ["throw_in"] * 5 + ["play"] * 5
    started = [1] * 5 + [0] * 8 + [1] * 7
    play = BallPlay(
        tape(still(40, (0, 0, 0)), np.tile((REACH, 0.0), (40, 1)), phase=phase, started=started)
    )
    assert play.live.tolist() == [True] * 10 + [False] * 16 + [True] * 14
    assert (play.holder == np.where(play.live, 0, -1)).all()
    assert [(touch.record, touch.before) for touch in play.touches] == [(0, -1), (26, -1)]


def test_kick_is_told_with_the_ball_on_its_way():
    ball = np.concatenate((np.tile((REACH, 0.0), (10, 1)), rolling((0.5, 0), (3.5, 0), 16)))
    play = BallPlay(tape(still(26, (0, 0, 0)), ball, kicks=[(10, 0)]))
    (kick,) = play.kicks
    assert (kick.tick, kick.record, kick.robot) == (100, 11, 0)
    assert np.hypot(kick.vx, kick.vy) == pytest.approx(10.0, rel=1e-5)


def test_kick_by_a_robot_takes_the_ball_from_one_that_touches_it_too():
    ways = still(20, (0, 0, 0), (2 * REACH, 0, 0))
    play = BallPlay(tape(ways, np.tile((REACH, 0.0), (20, 1)), kicks=[(9, 1)]))
    assert play.holder.tolist() == [0] * 10 + [1] * 10


def test_match_that_never_began_has_nothing_to_tell():
    play = BallPlay(tape(np.zeros((0, 10, 3)), np.zeros((0, 2))))
    assert (play.kicks, play.touches, len(play.holder), len(play.live)) == ([], [], 0, 0)
