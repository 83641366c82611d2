"""Laws of a match: what it depends on, and what it does not."""

import shutil

import numpy as np
import pytest
from play import RUSH, TEAMS, game, play

from soccersim import Recording
from soccersim.verify import verify

SHORT = "duration=12"


@pytest.fixture(scope="module")
def match():
    return play(RUSH, RUSH, SHORT)


def test_the_same_seed_plays_the_same_match_and_another_seed_another(match):
    assert play(RUSH, RUSH, SHORT).recording.digest == match.recording.digest
    assert play(RUSH, RUSH, SHORT, seed=2).recording.digest != match.recording.digest


def test_a_match_is_played_by_all_and_written_down(match):
    recording = match.recording
    assert recording.duration == pytest.approx(12.0)
    assert len(recording.arrays["decision_tick"]) == 300
    assert np.ptp(recording.body[:, :10, :2], axis=0).max(axis=1).min() > 0.3  # nobody stands
    assert (recording.arrays["kicked"][-1] >= 0).any()
    assert recording.ball is not None
    assert np.ptp(recording.ball[:, 0]) > 1.0
    assert {row[2] for row in recording.match["labels"]} >= {"wait", "kick", ""}


def test_a_match_that_ends_between_two_decisions_is_ended_by_the_referee():
    match = play(RUSH, RUSH, "duration=0.43")
    assert match.recording.duration == pytest.approx(0.43)  # decisions are 0.04 s apart
    end = match.recording.match["events"][-1]
    assert (end["kind"], end["time"]) == ("end", pytest.approx(0.43))
    assert len(match.recording.arrays["decision_tick"]) == 11  # and the teams are not asked again


def test_what_cameras_saw_of_the_ball_is_written_down(match):
    recording = match.recording
    seen, sight = recording.arrays["ball_sighted"], recording.scenario.senses.camera.ball
    assert 0.0 < recording.scenario.senses.camera.delay < 0.04  # so a picture is 40 ms old
    then = np.searchsorted(recording.tick, recording.arrays["decision_tick"][:-1])
    body, seen = recording.body[then].astype(float), seen[1:]
    ball = body[:, 10:, :2]
    away = np.hypot(*(body[:, :10, :2] - ball).transpose(2, 0, 1))
    there, near = np.isfinite(seen[..., 0]), away < sight.range
    assert not there[~near].any()
    assert there[near].mean() == pytest.approx(1 - sight.dropout, abs=0.02)
    radial, tangential = (
        a + b * away + c * away**2 for a, b, c in (sight.radial, sight.tangential)
    )
    off = np.hypot(*(seen - ball).transpose(2, 0, 1)) / np.hypot(radial, tangential)
    assert 1.0 < np.sqrt(np.mean(off[there] ** 2)) < 1.5  # own poses have their errors too


@pytest.mark.parametrize("scenario", ["friendly-match", "msl-match"])
def test_exchanging_a_team_and_its_copy_changes_nothing(tmp_path, scenario):
    """All asymmetry is of the slots: a copy elsewhere, under another name, changes nothing."""
    other = tmp_path / "copy_of_rush.py"
    shutil.copy(TEAMS / "rush.py", other)
    one = play(RUSH, other, SHORT, scenario=scenario)
    two = play(other, RUSH, SHORT, scenario=scenario)
    assert one.recording.digest == two.recording.digest


def states(swap, seed, seconds):
    """The true bodies at every decision, (D, 11, 6), with perfect senses."""
    free = [f"match.rules.{key}" for key in ("opponents=0", "mates=0", "slack=3", "roll=0")]
    settings = ("perception=truth", "duration=40", *free, f"match.swap_ends={swap}")
    eager = {"kick": 0.0, "hurry": True}
    match, seats = game(RUSH, RUSH, *settings, seed=seed, options=(eager, {"hurry": True}))
    truth, hurry, taken = match.simulation.machine.truth, match.simulation.hurry, []

    def hurry_and_look(ticks):
        hurry(ticks)
        taken.append(truth.body.copy())

    match.simulation.hurry = hurry_and_look
    match.play(seats, until=round(seconds / match.scenario.dt))
    return np.array(taken)


@pytest.mark.parametrize("seed", range(3))
def test_a_match_with_ends_swapped_is_the_turned_match(seed):
    """Both run for one ball, squeeze and kick it: rounding of heading + pi is all that may differ.

    Chaos makes more of it; five seconds after the ball first moved it is still nothing.
    """
    one, two = (states(swap, seed, 10) for swap in ("false", "true"))
    begun = np.flatnonzero(np.abs(one[:, 10, 3:5]).max(axis=1) > 0.1)[0]
    five_seconds = slice(0, begun + 125)
    moves = [0, 1, 3, 4]  # x, y, vx, vy
    apart = np.abs(one[five_seconds][..., moves] + two[five_seconds][..., moves])
    assert apart.max() < 1e-6
    assert np.abs(one[five_seconds, 10, 3:5]).max() > 1.0  # the ball was kicked
    gaps = np.hypot(*np.moveaxis(one[:, :10, :2] - one[:, 10:, :2], 2, 0))
    assert (np.sort(gaps[five_seconds], axis=1)[:, 1] < 0.36).any()  # two had it between them


def test_a_recording_is_verified_and_read_back(tmp_path, match):
    path = tmp_path / "match.npz"
    match.recording.save(path)
    again = Recording.load(path)
    for key, array in match.recording.arrays.items():
        np.testing.assert_array_equal(again.arrays[key], array, err_msg=key)
    assert again.meta == match.recording.meta
    verdict = verify(again)
    assert verdict.same
    assert verdict.elsewhere == []


def test_an_order_changed_in_a_recording_is_found_at_its_tick(tmp_path, match):
    path = tmp_path / "match.npz"
    match.recording.save(path)
    changed = Recording.load(path)
    moving = np.abs(changed.arrays["orders"][:, :, 0]) > 0.5
    decision, robot = np.argwhere(moving & (np.arange(len(moving)) > 200)[:, None])[0]
    changed.arrays["orders"][decision, robot, 0] += 0.5
    tick = changed.arrays["decision_tick"][decision]
    verdict = verify(changed)
    assert not verdict.same
    assert tick < verdict.tick < tick + 50
