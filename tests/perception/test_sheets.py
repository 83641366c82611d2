"""What a team is told: of now, in its own frame, with the age of the news."""

from math import pi

import numpy as np
import pytest
from watched import SHARP, Watched, realistic, sharp

from soccersim.geometry import wrap_angle

US = ((-2, 1, 30), (-6, -2, 90))
THEM = ((3, 1, 170), (5, -3, -60))


def moving(senses=SHARP, seed=1, **more):
    """Two against two, everything in motion."""
    game = Watched(*US, away=THEM, ball=(0, 2), senses=senses, seed=seed, **more)
    rng = np.random.default_rng(7)
    game.truth.body[:4, 3:] = rng.uniform(-1, 1, (4, 3))
    game.ball[3:5] = (1.5, -0.5)
    return game


def test_perfect_senses_tell_what_is_so():
    game = moving()
    game.readings.contact[1] = 1
    game.go(20)
    told = game.sheet()
    assert told.robots[:, :3].tolist() == [[1, 1, 1], [1, 2, 0]]
    assert told.robots[:, 3:5] == pytest.approx(game.truth.body[:2, :2], abs=1e-6)
    assert told.robots[:, 5] == pytest.approx([wrap_angle(h) for h in game.truth.body[:2, 2]])
    assert told.robots[:, 6:9] == pytest.approx(game.estimate.twist[:2], abs=1e-9)
    assert told.robots[:, 9].tolist() == [0, 1]
    assert (told.robots[:, 10] == 0).all()
    assert told.ball[:2] == pytest.approx(game.ball[:2], abs=0.01)
    assert told.ball[2:4] == pytest.approx(game.ball[3:5], abs=0.1)
    assert told.met[:, :2] == pytest.approx(game.truth.body[2:4, :2], abs=0.01)


def test_both_teams_see_their_own_goal_at_minus_x():
    game = moving().go(20)
    home, away = game.sheet(0), game.sheet(1)
    assert away.ball[:4] == pytest.approx(-home.ball[:4], abs=1e-2)
    assert away.robots[:, 3:5] == pytest.approx(-game.truth.body[2:4, :2], abs=1e-6)
    facing = game.truth.body[2:4, 2] + pi
    assert np.cos(away.robots[:, 5] - facing) == pytest.approx([1, 1])
    game.direction[:] = (-1, 1)  # the referee has changed ends: at once, no frame in between
    assert game.sheet(0).ball[:4] == pytest.approx(away.ball[:4], abs=1e-2)
    assert game.sheet(1).robots[:, 3:5] == pytest.approx(game.truth.body[2:4, :2], abs=1e-6)


def test_a_team_in_perception_of_the_truth_is_told_the_truth_at_once():
    game = moving(realistic(), perception="truth")
    game.estimate.pose[0, 0] += 0.5
    believed = game.estimate.pose.copy()
    game.look()
    assert (game.estimate.pose == believed).all()
    for slot, way in enumerate((1, -1)):
        told, mine, others = game.sheet(slot), [0, 1], [2, 3]
        if slot == 1:
            mine, others = others, mine
        body = game.truth.body
        assert told.ball.tolist() == [*(way * game.ball[:2]), *(way * game.ball[3:5]), 0.0]
        assert (told.robots[:, 3:5] == way * body[mine, :2]).all()
        assert (told.opponents[:, :2] == way * body[others, :2]).all()
        assert (told.opponents[:, 2:4] == way * body[others, 3:5]).all()
        assert (told.robots[:, 10] == 0).all()
        c, s = np.cos(body[mine, 2]), np.sin(body[mine, 2])
        forward = c * body[mine, 3] + s * body[mine, 4]
        assert told.robots[:, 6] == pytest.approx(forward)
    game.in_play[2] = 0
    game.look()
    assert len(game.sheet(0).opponents) == 1
    assert game.sheet(1).robots[:, 0].tolist() == [0, 1]


@pytest.mark.parametrize(
    ("camera", "radio", "frames"), [(0.0, 0.0, 0), (0.03, 0.0, 1), (0.045, 0.015, 2), (0.1, 0.1, 5)]
)
def test_delay_is_told_as_age(camera, radio, frames):
    """Frames come every 40 ms: news of 60 ms ago is 80 ms old when the next frame is taken."""
    game = moving(sharp(delay=camera, radio={"delay": radio}))
    told = game.go(40).sheet()
    ages = [told.ball[4], *told.robots[:, 10], *told.opponents[:, 4]]
    assert ages == pytest.approx([frames * 0.04] * 5)
    later = game.sheet(later=7)
    assert later.ball[4] == pytest.approx(frames * 0.04 + 7 / 500)
    assert later.robots[:, 10] == pytest.approx([frames * 0.04 + 7 / 500] * 2)


def test_old_news_are_brought_forward_to_now():
    game = moving(sharp(delay=0.1, radio={"delay": 0.02}))
    told = game.go(40).sheet()
    assert told.robots[0, 10] == pytest.approx(0.12)
    assert told.robots[:, 3:5] == pytest.approx(game.truth.body[:2, :2], abs=0.01)
    assert told.ball[:2] == pytest.approx(game.ball[:2], abs=0.01)
    assert told.met[:, :2] == pytest.approx(game.truth.body[2:4, :2], abs=0.02)


def test_reports_that_are_lost_let_the_last_one_grow_old():
    game = moving(sharp(radio={"report_loss": 0.5}))
    ages = np.array([game.go().sheet().robots[:, 10] for _ in range(2000)]) / 0.04
    assert ages.min() == 0
    runs = [np.mean(np.isclose(ages, k)) for k in range(4)]
    assert runs == pytest.approx([0.5, 0.25, 0.125, 0.0625], abs=0.03)
    assert abs(np.corrcoef(ages.T)[0, 1]) < 0.1  # each robot's own
    game = moving(sharp(radio={"report_loss": 1.0}))
    assert game.go(50).sheet().robots[:, 10] == pytest.approx([2.0, 2.0])


def test_a_robot_out_of_play_is_told_as_such_where_it_was_last():
    game = moving().go(10)
    game.in_play[1] = 0
    before = game.sheet().robots[1]
    after = game.go(10).sheet().robots[1]
    assert after[0] == 0
    assert after[3:5] == pytest.approx(before[3:5], abs=0.1)
    assert after[10] == pytest.approx(0.4)


def test_the_same_seed_tells_the_same_and_another_something_else():
    def numbers(seed):
        game = moving(realistic(), seed=seed)
        return np.array([game.go().sheet(slot).numbers for _ in range(60) for slot in (0, 1)])

    again, other = numbers(1), numbers(2)
    assert np.array_equal(numbers(1), again, equal_nan=True)
    assert not np.array_equal(again, other, equal_nan=True)


@pytest.mark.parametrize("senses", [SHARP, realistic()])
def test_the_game_turned_round_is_told_just_the_same(senses):
    """Each slot at the other end: with its own noise too, for a robot errs in its own frame."""
    game, turned = moving(senses), moving(senses)
    turned.truth.body[:, :2] *= -1
    turned.truth.body[:, 3:5] *= -1
    turned.truth.body[:4, 2] += pi
    turned.estimate.pose[:] = turned.truth.body[:4, :3]
    turned.direction[:] = (-1, 1)
    for i, pose in enumerate(turned.estimate.pose):
        turned.perception.place(i, pose)
    turned.perception.place_ball(*turned.ball[:2])
    game.perception.place_ball(*game.ball[:2])
    for i, pose in enumerate(game.estimate.pose):
        game.perception.place(i, pose)
    for _ in range(100):
        for slot in (0, 1):
            one, other = game.go().sheet(slot), turned.go().sheet(slot)
            apart = one.numbers - other.numbers
            headings = one.robots[:, 5] - other.robots[:, 5]
            assert np.cos(headings) == pytest.approx([1, 1], abs=1e-12)
            apart = np.delete(apart, [15 + 5, 15 + 11 + 5])
            assert np.nanmax(np.abs(apart)) < 1e-9


def test_cameras_leave_the_noise_of_encoders_and_gyros_as_it_was():
    from factory import bundled, player, scenario

    from soccersim.perception import Perception
    from soccersim.simulation import Simulation

    readings = []
    for watched in (False, True):
        drive = {"open_loop": [{"seconds": 5, "twist": [0.5, 0.2, 1.0]}]}
        robot = player(bundled("msl"), **drive)
        written = scenario(robot, senses=realistic(), ball={"at": (0, 5)}, duration=3)
        simulation, perception = Simulation(written), Perception(written)
        m = simulation.machine
        while not simulation.done:
            if watched:
                tick = simulation.tick
                perception.step(m.truth, m.readings, m.estimate, tick, [1], [1, -1])
            simulation.advance(perception.beat)
        recording = simulation.recording()
        readings.append([recording.arrays[key] for key in ("counts", "gyro")])
        readings[-1].append(recording.arrays["estimate"])
    assert all((a == b).all() for a, b in zip(readings[0][:2], readings[1][:2], strict=True))
    assert (readings[0][2] != readings[1][2]).any()  # what it believes of its pose is corrected


def test_every_number_told_is_a_number():
    game = moving(realistic(dropout=0.3, radio={"report_loss": 0.5}))
    for _ in range(300):
        told = game.go().sheet()
        assert np.isfinite(told.ball).all()
        assert np.isfinite(told.robots).all()
        assert np.isfinite(told.opponents).all()
