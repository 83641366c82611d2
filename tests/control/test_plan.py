"""Legs: when one begins and ends, which way it turns, and what follows."""

from itertools import pairwise
from math import degrees, radians

import numpy as np
import pytest
from factory import NO_SLIP, Obedient, far, player, robot, scenario, simulate
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.simulation import Simulation

ARRIVAL = {"distance": 0.02, "angle_deg": 2.0, "dwell": 0.2, "timeout": 3.0}
HERE = (0, 0, 0)
angles = st.integers(-720, 720)


def arriving(**arrival):
    return robot(control={"arrival": {**ARRIVAL, **arrival}})


def ended_at(obedient, pose, seconds=1.0):
    """Steps until the first leg ends while the robot is kept at this pose, or None."""
    for step in range(round(seconds / (obedient.dt * obedient.plan.every[0]))):
        obedient.pose[:] = pose
        obedient.step(hold=(0, 0, 0))
        if obedient.progress.ended[0]:
            return step
    return None


@pytest.mark.parametrize(
    ("pose", "arrives"),
    [
        ((1, 0, 0), True),
        ((1.019, 0, 0), True),
        ((1.0, -0.021, 0), False),
        ((1.015, 0.015, 0), False),
        ((1, 0, radians(1.9)), True),
        ((1, 0, radians(-2.1)), False),
        ((1.019, 0, radians(1.9)), True),
        ((1.021, 0, radians(1.9)), False),
    ],
)
def test_arrival_needs_the_distance_and_the_angle(pose, arrives):
    obedient = Obedient(arriving(), (1, 0, 0))
    assert (ended_at(obedient, pose) is not None) == arrives


@pytest.mark.parametrize("dwell", [0.0, 0.05, 0.2])
def test_arrival_needs_the_dwell(dwell):
    obedient = Obedient(arriving(dwell=dwell), (1, 0, 0))
    ended = ended_at(obedient, (1, 0, 0))
    assert ended == max(1, 1 + round(dwell * 100))
    assert obedient.progress.ended_reached[0] == 1


def test_a_step_outside_starts_the_dwell_anew():
    obedient = Obedient(arriving(dwell=0.2), (1, 0, 0))
    assert ended_at(obedient, (1, 0, 0), seconds=0.15) is None
    assert ended_at(obedient, (1.1, 0, 0), seconds=0.01) is None
    assert ended_at(obedient, (1, 0, 0), seconds=0.20) is None
    assert ended_at(obedient, (1, 0, 0), seconds=0.02) is not None


def test_a_leg_out_of_time_is_not_reached_and_the_next_begins():
    """A time-out of half a second is too short for a metre, not for the way back."""
    path = ({"to": (1, 0, 0), "timeout": 0.5}, {"to": (0, 0.2, 0), "timeout": 10.0})
    legs = simulate(player(arriving(), *path)).legs[0]
    assert [leg["reached"] for leg in legs] == [False, True]
    assert legs[0]["end_tick"] == legs[1]["start_tick"] == 250
    assert far(legs[1]["odometry"], (0, 0.2)) < 0.02


def test_a_leg_without_a_time_out_of_its_own_takes_the_robot_s():
    held = robot(control={"limits": {"speed": 0.01}, "arrival": {**ARRIVAL, "timeout": 1.5}})
    leg = simulate(player(held, (1, 0, 0))).legs[0][0]
    assert (leg["reached"], leg["end_tick"]) == (False, 750)


@given(angles, angles, angles)
@settings(max_examples=40)
def test_as_written_turns_as_far_as_the_numbers_say(start, first, second):
    path = [{"to": (0, 0, heading), "turn": "as_written"} for heading in (first, second)]
    obedient = Obedient(arriving(), *path, start=(0, 0, start))
    obedient.step()
    assert degrees(obedient.progress.goal[0, 2]) == pytest.approx(first)
    ended_at(obedient, obedient.progress.goal[0].copy())
    assert degrees(obedient.progress.goal[0, 2]) == pytest.approx(second)


@given(angles, angles)
@settings(max_examples=40)
def test_the_shortest_turn_is_at_most_half_a_turn(start, to):
    obedient = Obedient(arriving(), (0, 0, to), start=(0, 0, start))
    obedient.step()
    turn = degrees(obedient.progress.goal[0, 2]) - start
    assert abs(turn) <= 180 + 1e-9
    assert (turn - (to - start)) / 360 == pytest.approx(round((turn - (to - start)) / 360))


@pytest.mark.parametrize(("turn", "degrees_turned"), [("as_written", 270), ("shortest", -90)])
def test_a_turn_to_270_degrees(turn, degrees_turned):
    model = robot(drive={"grip": NO_SLIP})
    leg = simulate(player(model, {"to": (0, 0, 270), "turn": turn})).legs[0][0]
    assert leg["reached"]
    assert degrees(leg["truth"][2]) == pytest.approx(degrees_turned, abs=2)


def test_headings_wind_up_over_the_legs():
    """Four shortest quarter turns are a whole turn; 350 as written goes on from 360, by -10."""
    quarters = [(0, 0, 90), (0, 0, 180), (0, 0, 270), (0, 0, 0)]
    path = [*quarters, {"to": (0, 0, -10), "turn": "as_written"}]
    model = robot(drive={"grip": NO_SLIP})
    legs = simulate(player(model, *path, start=(0, 0, 1))).legs[0]
    turned = [degrees(leg["odometry"][2]) for leg in legs]
    assert turned == pytest.approx([90, 180, 270, 360, 350], abs=2)


def test_a_path_repeats_until_the_time_is_up():
    path = [(0.3, 0, 0), (0, 0, 0)]
    run = simulate(player(arriving(dwell=0.0), *path, repeat=True), duration=12.0)
    starts = np.flatnonzero(np.diff(run.leg[:, 0]) == -1)
    assert run.duration == 12.0
    assert len(starts) >= 3
    assert set(run.leg[:, 0]) == {0, 1}
    laps = np.diff(run.time[starts])
    assert laps == pytest.approx(np.full(len(laps), laps[0]), rel=0.1)


def test_open_loop_legs_last_as_long_as_they_say():
    phases = [
        {"seconds": 0.5, "twist": (0.5, 0, 0)},
        {"seconds": 0.24, "wheel_speeds": (5, 5, 5)},
        {"seconds": 1.0, "pwm": (60, 0, -60)},
    ]
    run = simulate(player(robot(), open_loop=phases))
    ends = [leg["end_tick"] for leg in run.legs[0]]
    assert ends == [250, 370, 870]
    assert [leg["reached"] for leg in run.legs[0]] == [True] * 3
    assert all(leg["target"] is None for leg in run.legs[0])
    assert run.duration == pytest.approx(1.74)


def test_an_open_loop_twist_is_the_robot_s_own():
    """(0.5, 0, 0) goes ahead, which is to the field's left for a robot that faces left."""
    run = simulate(
        player(
            robot(drive={"grip": NO_SLIP}),
            open_loop=[{"seconds": 2.0, "twist": (0.5, 0, 0)}],
            start=(0, 0, 90),
        )
    )
    assert run.body[-1, 0, :2] == pytest.approx((0, 1.0), abs=0.12)
    assert run.body[-1, 0, 4] == pytest.approx(0.5, abs=0.01)


def test_after_open_loop_the_robot_stands():
    driver = player(robot(), open_loop=[{"seconds": 0.5, "twist": (0.5, 0, 1)}])
    other = player(robot(), open_loop=[{"seconds": 6.0, "twist": (0, 0, 0)}], start=(0, 5, 0))
    run = simulate(driver, other)
    assert (run.arrays["wheel_setpoint"][run.time > 0.5, 0] == 0).all()
    assert abs(run.body[run.time > 5, 0, 3:]).max() < 1e-3


def test_pushed_robots_follow_the_hand_with_their_motors_idle():
    path = [(0.4, 0, 0), (0.4, 0.3, 90), (0, 0, 270)]
    coasting = robot(drive={"motor": {"at_zero": "coast"}})
    run = simulate(player(coasting, *path, pushed_by={}))
    assert (run.arrays["pwm"] == 0).all()
    assert [leg["reached"] for leg in run.legs[0]] == [True] * 3
    behind = run.body[:, 0, :3] - run.reference[:, 0]
    assert np.hypot(*behind[:, :2].T).max() < 10e-3  # while it speeds up
    assert np.degrees(abs(behind[:, 2])).max() < 5
    for leg, (x, y, heading) in zip(run.legs[0], path, strict=True):
        assert far(leg["truth"], (x, y)) < 2e-3
        turned = (degrees(leg["truth"][2]) - heading + 180) % 360 - 180
        assert abs(turned) < 1


def test_a_hand_goes_from_mark_to_mark_whatever_the_robot_believes():
    """Wheels that are 10 % too small make the odometry err, not the hand."""
    small = robot(drive={"build": {"radius_bias": -0.1}, "motor": {"at_zero": "coast"}})
    run = simulate(player(small, (1, 0, 0), (2, 0, 0), (3, 0, 0), pushed_by={}))
    assert np.hypot(*np.diff(run.reference[:, 0, :2], axis=0).T).max() < 0.2 / 50 * 1.01
    for leg, x in zip(run.legs[0], (1, 2, 3), strict=True):
        assert far(leg["truth"], (x, 0)) < 2e-3
        assert leg["odometry"][0] == pytest.approx(x / 0.9, rel=0.01)


def test_robots_with_different_control_rates_share_a_field():
    rates = (50, 100, 250)
    players = [
        player(robot(control={"rate_hz": rate}), (1, 3 * i, 90), start=(0, 3 * i, 0))
        for i, rate in enumerate(rates)
    ]
    together = simulate(*players)
    for i, alone in enumerate(players):
        leg, single = together.legs[i][0], simulate(alone).legs[0][0]
        assert leg["reached"]
        assert (leg["end_tick"], leg["truth"]) == (single["end_tick"], single["truth"])
        assert leg["end_tick"] % (500 // rates[i]) == 0


def test_a_robot_without_a_path_stands_still():
    mover = player(robot(), (1, 0, 0))
    run = simulate(mover, player(robot(gyro={"perfect": False}), start=(0, 3, 45)))
    assert abs(run.body[:, 1, 3:]).max() < 1e-9
    assert (run.arrays["pwm"][:, 1] == 0).all()


def test_a_run_ends_when_all_that_have_a_path_are_through():
    run = simulate(
        player(robot(), (0.2, 0, 0)),
        player(robot(), (1, 3, 0), start=(0, 3, 0)),
        player(robot(), start=(0, 6, 0)),
    )
    last = max(leg["end_tick"] for legs in run.legs for leg in legs)
    assert run.duration * 500 == last
    assert run.legs[2] == []
    assert simulate(player(robot()), duration=2.0).duration == 2.0


@pytest.mark.parametrize("profile", ["none", "trapezoid"])
def test_one_that_is_through_goes_on_to_its_last_target_and_stays(profile):
    """Its time ran out on the way, at full speed, while another robot still drives."""
    limits = {"speed": 1.0, "acceleration": 1.0, "turn_acceleration": 3.0}
    model = robot(control={"profile": profile, "limits": limits})
    hurried = player(model, {"to": (2, 0, 90), "timeout": 1.0})
    other = player(robot(), open_loop=[{"seconds": 9.0, "twist": (0, 0, 0)}], start=(0, 5, 0))
    run = simulate(hurried, other)
    assert run.legs[0][0]["reached"] is False
    assert run.legs[0][0]["end_tick"] == 500
    late = run.body[run.time > 6, 0]
    assert np.hypot(late[:, 0] - 2, late[:, 1]).max() < 0.02
    assert abs(np.degrees(late[:, 2]) - 90).max() < 2
    assert abs(late[:, 3:]).max() < 0.01


def test_a_profile_starts_where_the_robot_believes_to_be():
    limits = {"speed": 1.0, "acceleration": 1.0, "turn_acceleration": 3.0}
    model = robot(control={"profile": "trapezoid", "limits": limits})
    run = simulate(player(model, {"to": (2, 0, 0), "timeout": 1.0}, (2, 2, 0)))
    second = np.flatnonzero(run.leg[:, 0] == 1)[0]
    there = run.legs[0][0]["odometry"]
    assert far(run.reference[second, 0], there) < 0.02
    jumps = np.hypot(*np.diff(run.reference[second:, 0, :2], axis=0).T)
    assert jumps.max() < 1.0 / 50 * 1.01  # never faster than the limit


def test_legs_are_told_in_order_for_each_robot():
    path = [(0.3, 0, 0), (0.3, 0.3, 0), (0, 0, 0)]
    legs = simulate(player(robot(), *path)).legs[0]
    assert [leg["target"][:2] for leg in legs] == [list(map(float, leg[:2])) for leg in path]
    assert legs[0]["start_tick"] == 0
    for before, after in pairwise(legs):
        assert before["end_tick"] == after["start_tick"]


def test_a_pause_between_pieces_changes_nothing():
    written = scenario(player(robot(), (0.5, 0, 90), (0, 0, 0)))
    simulation = Simulation(written)
    while not simulation.done:
        simulation.advance(3)
    assert simulation.recording().legs == Simulation(written).run().legs
