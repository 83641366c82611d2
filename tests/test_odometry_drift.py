"""How far odometry drifts from the truth, and why: slip, tolerances, gyro (model.md, section 5)."""

from functools import cache
from math import cos, degrees, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest
from factory import EXACT, NO_SLIP, merged, player, robot, simulate

SEEDS = range(40)
WAY = 4.5  # m
VARIANTS = [("drive", "wheels"), ("drive", "gyro"), ("dead", "wheels"), ("dead", "gyro")]
# check 21: 20 kg kiwi, mu .5, h .15, radius and distance off by .4 %, a real gyro
BUILT = {"radius_sd": 0.004, "distance_sd": 0.004}
ENCODER = {"perfect": False, "pulses_per_turn": 360, "decoding": 4}
KIWI = {
    "mass": 20.0,
    "mass_height": 0.15,
    "drive": {"build": BUILT, "encoder": ENCODER},
    "dead": {
        "azimuth_deg": [180, 300, 60],
        "distance": 0.08,
        "radius": 0.025,
        "build": BUILT,
        "encoder": ENCODER,
    },
    "gyro": {"perfect": False},
    "control": {"profile": "trapezoid"},
}


def kiwi(wheels, heading, acceleration=1.0):
    limits = {"speed": 2.775, "acceleration": acceleration, "turn_acceleration": 6.0}
    used = {"wheels": wheels, "heading": heading}
    return robot(merged(EXACT, KIWI), odometry=used, control={"limits": limits})


@cache
def drifts(wheels, heading, acceleration, towards_deg=0.0):
    """Truth less odometry at the end of 4.5 m, a row a seed: x, y (m) and heading."""
    c, s = cos(radians(towards_deg)), sin(radians(towards_deg))
    way = player(kiwi(wheels, heading, acceleration), (WAY * c, WAY * s, 0))
    ends = []
    for seed in SEEDS:
        leg = simulate(way, seed=seed).legs[0][0]
        ends.append(np.subtract(leg["truth"], leg["odometry"]))
    return np.array(ends)


def rms(*variant):
    """Root mean square of the end error, as a share of the way."""
    ends = drifts(*variant)
    return sqrt((ends[:, :2] ** 2).sum(axis=1).mean()) / WAY


@pytest.mark.parametrize("towards_deg", [0.0, 90.0])
def test_drift_of_a_gentle_straight_way(towards_deg):
    """Check 21, at 1 m/s2: encoders alone 1.5-4 % of the way, with a gyro at most .8 %."""
    encoders, gyro, dead, dead_gyro = (rms(*v, 1.0, towards_deg) for v in VARIANTS)
    assert 0.015 <= encoders <= 0.04
    assert gyro <= 0.008
    assert dead > gyro  # a short lever tells the turn badly ...
    assert dead_gyro <= 0.008  # ... but needs not, beside a gyro
    assert dead_gyro < gyro


@pytest.mark.parametrize("towards_deg", [0.0, 90.0])
def test_drift_grows_with_the_acceleration_but_for_dead_wheels(towards_deg):
    """Check 21, at 2 m/s2, near the limit of the grip: driven wheels slip, dead ones do not."""
    for variant in VARIANTS[:2]:
        assert rms(*variant, 2.0, towards_deg) > 2 * rms(*variant, 1.0, towards_deg)
    for variant in VARIANTS[2:]:
        assert rms(*variant, 2.0, towards_deg) < 1.5 * rms(*variant, 1.0, towards_deg)
    best = rms("dead", "gyro", 2.0, towards_deg)
    assert best <= 0.008
    assert all(best < rms(*variant, 2.0, towards_deg) for variant in VARIANTS[:3])


def test_wheels_of_unlike_size_turn_the_odometry_by_what_they_must():
    """A way d turns a kiwi's belief by d / (3 l) sqrt(3 / 2) times the spread of its radii."""
    expected = WAY / (3 * 0.19) * sqrt(1.5) * 0.004
    turned = drifts("drive", "wheels", 1.0)[:, 2]
    assert turned.std() == pytest.approx(expected, rel=0.3)
    assert drifts("drive", "gyro", 1.0)[:, 2].std() < 0.1 * expected


def test_wheels_of_half_the_lever_turn_it_more():
    ratio = drifts("dead", "wheels", 1.0)[:, 2].std() / drifts("drive", "wheels", 1.0)[:, 2].std()
    assert ratio == pytest.approx(0.19 / 0.08, rel=0.3)


@pytest.mark.parametrize(("pulses", "millimetres"), [(270, 8.0), (27_000, 1.0)])
@pytest.mark.parametrize("heading", ["wheels", "gyro"])
@pytest.mark.parametrize("to", [(2, 0, 0), (0, 2, 0), (1.6, -1.2, 0)])
def test_without_slip_only_the_pulses_are_left(to, pulses, millimetres, heading):
    """Check 7: mu 5, v0 1e-4, kappa 0, 2 m at .2 m/s2."""
    limits = {"speed": 1.5, "acceleration": 0.2, "turn_acceleration": 1.0}
    model = robot(
        drive={
            "grip": merged(NO_SLIP, {"roller": 0.03}),
            "encoder": {"perfect": False, "pulses_per_turn": pulses, "decoding": 1},
        },
        odometry={"heading": heading},
        control={"profile": "trapezoid", "limits": limits},
    )
    for seed in range(5):
        leg = simulate(player(model, to), seed=seed).legs[0][0]
        x, y, turn = np.subtract(leg["truth"], leg["odometry"])
        assert leg["reached"]
        assert hypot(x, y) < millimetres / 1000
        assert abs(degrees(turn)) < 0.25


@pytest.mark.parametrize("bias", [-0.03, 0.02])
def test_wheels_smaller_than_drawn_fall_short(bias):
    """The robot believes its drawing: it stops where 2 m of pulses are counted."""
    model = robot(drive={"grip": NO_SLIP, "build": {"radius_bias": bias}})
    leg = simulate(player(model, (2, 0, 0))).legs[0][0]
    assert leg["odometry"][0] == pytest.approx(2.0, abs=0.02)
    assert leg["truth"][0] == pytest.approx(leg["odometry"][0] * (1 + bias), abs=2e-3)


def test_missed_edges_make_a_way_look_shorter_than_it_was():
    encoder = {"perfect": False, "pulses_per_turn": 1000, "missed": 0.05}
    model = robot(drive={"grip": NO_SLIP, "encoder": encoder})
    leg = simulate(player(model, (2, 0, 0))).legs[0][0]
    assert leg["odometry"][0] / leg["truth"][0] == pytest.approx(0.95, abs=0.005)


def test_wheels_that_spin_on_the_spot_fool_driven_encoders_alone():
    """Full voltage on a slippery floor: the odometry of the driven wheels runs ahead."""
    phase = {"seconds": 0.6, "wheel_speeds": (-48.0, 48.0, 0.0)}
    ahead = {}
    for wheels, heading in (("drive", "gyro"), ("dead", "gyro")):
        way = player(kiwi(wheels, heading), open_loop=[phase], start=(0, 0, 0))
        leg = simulate(way, field={"grip": 0.3}).legs[0][0]
        ahead[wheels] = np.hypot(*np.subtract(leg["odometry"], leg["truth"])[:2])
    assert ahead["drive"] > 0.2
    assert ahead["dead"] < 0.02


def test_a_gyro_s_scale_error_shows_after_a_turn():
    model = robot(drive={"grip": NO_SLIP}, gyro={"perfect": False, "scale_sd": 0.05})
    leg = simulate(player(model, {"to": (0, 0, 360), "turn": "as_written"}), seed=4).legs[0][0]
    error = degrees(leg["odometry"][2] - leg["truth"][2])
    assert leg["odometry"][2] == pytest.approx(2 * pi, abs=radians(2))
    assert 3.0 < abs(error) < 54.0  # 360 deg of 5 %, times up to three
