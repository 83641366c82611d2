"""Laws of a base on wheels: inverse and forward, slip, steering, trust, change of frame."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.kinematics import OmniBase

CONDITION = 100.0  # layouts nearer to singular than this say more about rounding than about the law

twists = st.tuples(*3 * [st.floats(-5, 5)])
patient = settings(deadline=None)


def random_base(rng, n=None, **more):
    """Any layout at all; contact points 10 to 40 cm from the centre."""
    n = n or int(rng.integers(3, 7))
    return OmniBase.general(
        rng.uniform(0, 360, n),
        rng.uniform(0.1, 0.4, n),
        rng.uniform(0.02, 0.1, n),
        directions_deg=rng.uniform(0, 360, n),
        roller_angles_deg=rng.choice((0, 45, -45), n),
        **more,
    )


def well_conditioned(rng, **more):
    """A random layout whose matrix, with lengths in units of its reach, is far from singular."""
    while True:
        base = random_base(rng, **more)
        if np.linalg.cond(base.jacobian / (1, 1, base.reach)) <= CONDITION:
            return base


def standing_at(contact, wheel_radius, **more):
    """A base with its wheels at (n, 2) points of the body frame."""
    azimuths = np.degrees(np.arctan2(contact[:, 1], contact[:, 0]))
    return OmniBase.general(azimuths, np.hypot(*contact.T), wheel_radius, **more)


def turned(angle):
    return np.array(((np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle))))


def quarter(vectors):
    return np.c_[-vectors[:, 1], vectors[:, 0]]


@pytest.fixture
def rng():
    return np.random.default_rng(20150)


@pytest.fixture
def four_wheels():
    return OmniBase.tangential((45, 135, 225, 315), distance=0.2, wheel_radius=0.05)


def test_forward_undoes_inverse_for_200_random_layouts(rng):
    """None is skipped: chance does not draw the singular, which the constructor refuses."""
    for _ in range(200):
        base, twist = random_base(rng), rng.uniform(-1, 1, 3)
        assert base.twist(base.wheel_speeds(twist)) == pytest.approx(twist, abs=1e-12)
        assert base.inverse_jacobian @ base.jacobian == pytest.approx(np.eye(3), abs=1e-12)


@patient
@given(n=st.integers(3, 12), first=st.floats(0, 360), distance=st.floats(0.05, 1))
def test_evenly_spread_omni_wheels_have_a_diagonal_normal_matrix(n, first, distance):
    base = OmniBase.tangential(first + 360 / n * np.arange(n), distance)
    normal = np.diag((n / 2, n / 2, n * distance**2))
    assert base.jacobian.T @ base.jacobian == pytest.approx(normal, abs=1e-12 * n)
    forward = base.jacobian.T * np.array([[2 / n], [2 / n], [1 / (n * distance**2)]])
    assert base.inverse_jacobian == pytest.approx(forward, abs=1e-11)


def test_utamas_drive_wheels_at_10_20_30_rad_per_s():
    base = OmniBase.tangential((30, 150, 270), distance=0.19, wheel_radius=0.05)
    assert base.twist((10, 20, 30)) == pytest.approx((0.5, -0.2886751, 5.2631579), abs=1e-6)


def test_four_wheels_that_disagree_show_it_in_the_residual(four_wheels):
    speeds = (10, 20, 30, 40)
    assert four_wheels.twist(speeds) == pytest.approx((0.7071068, 0, 6.25), abs=1e-6)
    residual = four_wheels.slip_residual(speeds)
    assert residual == pytest.approx((-0.25, 0.25, -0.25, 0.25), abs=1e-6)


def test_a_wheel_that_spins_its_tyre_has_the_sign_of_its_slip(four_wheels):
    speeds = four_wheels.wheel_speeds((1, 0, 0))
    speeds[2] += 4.0  # rad/s too fast: 0.2 m/s, of which one in four shows
    assert four_wheels.slip_residual(speeds) == pytest.approx((0.05, -0.05, 0.05, -0.05))


def test_steered_legs_turn_their_wheels_as_finite_differences_say(rng):
    """Follow the hubs over the floor while base and legs turn; project their speed on the push."""
    pivot, spoke, twist = rng.uniform(-0.2, 0.2, (3, 2)), (0.03, -0.05), rng.uniform(-2, 2, 3)
    straight, gamma, rates = rng.uniform(0, 360, 3), np.array((0, 45, -45)), (4, -3, 2)
    base = standing_at(
        pivot + spoke, 0.05, directions_deg=straight, roller_angles_deg=gamma, pivots=pivot
    )

    def hubs(t):
        """Field positions at time t; the frames coincide at t = 0."""
        spokes = [turned(rate * t) @ spoke for rate in rates]
        return twist[:2] * t + (pivot + spokes) @ turned(twist[2] * t).T

    h = 1e-5
    velocity = (hubs(h) - hubs(-h)) / (2 * h)
    angle = np.radians(straight + gamma)
    along = velocity[:, 0] * np.cos(angle) + velocity[:, 1] * np.sin(angle)
    speeds = base.wheel_speeds(twist, rates)
    assert speeds == pytest.approx(along / (0.05 * np.cos(np.radians(gamma))), abs=1e-6)
    assert base.twist(speeds, steering_rates=rates) == pytest.approx(twist)


def test_wheel_and_roller_together_hold_the_contact_on_the_floor(rng):
    """Rim plus roller surface undo the hub's velocity: not only its part along the push."""
    n, twist, rates = 5, (0.7, -1.1, 2.3), np.array((1.0, -2.0, 0.5, 3.0, 0.0))
    base = random_base(rng, n, roller_radius=0.01, pivots=rng.uniform(-0.1, 0.1, (n, 2)))
    spoke = base.contact - base.pivot
    hub = np.add(twist[:2], twist[2] * quarter(base.contact)) + rates[:, None] * quarter(spoke)
    drive = np.c_[np.cos(base.direction), np.sin(base.direction)]
    push = base.jacobian[:, :2]
    rim = (base.wheel_radius * base.wheel_speeds(twist, rates))[:, None] * drive
    roller = (base.roller_radius * base.roller_speeds(twist, rates))[:, None] * quarter(push)
    assert rim + roller == pytest.approx(hub)


def test_push_and_transverse_rows_hold_the_whole_motion_of_the_contact(rng):
    base, twist = random_base(rng), np.array((0.3, -0.8, 2.0))
    contact = twist[:2] + twist[2] * quarter(base.contact)
    push = base.jacobian[:, :2]
    seen = (base.jacobian @ twist)[:, None] * push
    seen += (base.transverse @ twist)[:, None] * quarter(push)
    assert seen == pytest.approx(contact)


@patient
@given(seed=st.integers(0, 10**6), twist=twists)
def test_wheels_that_agree_have_no_residual(seed, twist):
    base = well_conditioned(np.random.default_rng(seed))
    speeds = base.wheel_speeds(twist)
    assert base.slip_residual(speeds) == pytest.approx(0, abs=1e-11)
    assert base.slip_residual(speeds, gyro=twist[2]) == pytest.approx(0, abs=1e-11)


@patient
@given(seed=st.integers(0, 10**6), n=st.integers(4, 6))
def test_residual_pushes_the_base_nowhere(seed, n):
    """It lies in the null space of G': as forces along the wheels it has no sum and no torque."""
    rng = np.random.default_rng(seed)
    base = well_conditioned(rng, n=n)
    residual = base.slip_residual(rng.uniform(-50, 50, n))
    assert base.jacobian.T @ residual == pytest.approx(0, abs=1e-11)


@patient
@given(seed=st.integers(0, 10**6), n=st.integers(4, 6), twist=twists)
def test_what_pushes_the_base_nowhere_is_all_residual(seed, n, twist):
    base = well_conditioned(np.random.default_rng(seed), n=n)
    fight = 0.3 * np.linalg.svd(base.jacobian)[0][:, 3]  # m/s, wheel against wheel
    speeds = base.wheel_speeds(twist) + fight / base.rolling_radius
    assert base.slip_residual(speeds) == pytest.approx(fight, abs=1e-11)
    assert base.twist(speeds) == pytest.approx(twist, abs=1e-10)


def test_three_wheels_never_disagree_but_the_gyro_does():
    base = OmniBase.tangential()
    residual = base.slip_residual((10, 20, 30), gyro=5.0)
    assert residual[:3] == pytest.approx(0, abs=1e-12)
    assert residual[3] == pytest.approx(5.2631579 - 5.0)


def test_residual_is_blind_to_wheels_that_slip_alike(four_wheels):
    speeds = 1.2 * four_wheels.wheel_speeds((2, 0, 0))  # a straight start, all wheels spinning
    assert four_wheels.slip_residual(speeds) == pytest.approx(0, abs=1e-12)
    assert four_wheels.twist(speeds)[0] == pytest.approx(2.4)


def test_least_squares_is_unbiased_and_as_sharp_as_it_promises(rng):
    base, twist, sigma, runs = random_base(rng, 5), (1.0, -2.0, 3.0), 0.01, 20_000
    trust = rng.uniform(0.5, 2, 5)
    noise = rng.normal(0, sigma, (runs, 5)) / base.rolling_radius
    speeds = base.wheel_speeds(twist)
    covariance = sigma**2 * np.linalg.inv(base.jacobian.T @ base.jacobian)
    plain = np.array([base.twist(speeds + row) for row in noise])
    error = np.sqrt(np.diag(covariance) / runs)
    assert (np.abs(plain.mean(axis=0) - twist) < 4 * error).all()
    assert np.cov(plain.T) == pytest.approx(covariance, abs=0.05 * np.diag(covariance).min())
    weighted = np.array([base.twist(speeds + row, trust) for row in noise[:2000]])
    assert (np.abs(weighted.mean(axis=0) - twist) < 4 * weighted.std(axis=0) / 2000**0.5).all()


def test_trust_by_one_over_variance_beats_equal_trust(rng):
    """Gauss-Markov: no other linear estimate has a smaller variance in any direction."""
    base, sigma = random_base(rng, 6), np.array((0.01, 0.01, 0.02, 0.05, 0.05, 0.1))
    units = np.diag(1 / base.rolling_radius)  # each wheel 1 m/s in turn

    def variance(weights):
        gain = np.array([base.twist(unit, weights) for unit in units]).T
        return np.einsum("ij,j,kj->ik", gain, sigma**2, gain)

    best = np.linalg.inv(base.jacobian.T / sigma**2 @ base.jacobian)
    assert variance(sigma**-2) == pytest.approx(best)
    gained = variance(np.ones(6)) - best
    assert np.linalg.eigvalsh(gained).min() > -1e-12
    assert np.trace(gained) > 0


def test_a_wheel_of_no_weight_is_not_heard(four_wheels):
    speeds = four_wheels.wheel_speeds((1, 2, 3))
    speeds[3] = 1e6
    assert four_wheels.twist(speeds, weights=(1, 1, 1, 0)) == pytest.approx((1, 2, 3))


@patient
@given(seed=st.integers(0, 10**6), turn=st.floats(-180, 180), twist=twists)
def test_a_base_described_in_a_turned_frame_turns_its_jacobian(seed, turn, twist):
    base = well_conditioned(np.random.default_rng(seed))
    other = OmniBase.general(
        np.degrees(base.azimuth) + turn,
        base.distance,
        base.wheel_radius,
        directions_deg=np.degrees(base.direction) + turn,
        roller_angles_deg=np.degrees(base.roller_angle),
    )
    rotation = np.eye(3)
    rotation[:2, :2] = turned(np.radians(turn))
    assert other.jacobian == pytest.approx(base.jacobian @ rotation.T, abs=1e-13)
    assert other.transverse == pytest.approx(base.transverse @ rotation.T, abs=1e-13)
    speeds = base.wheel_speeds(twist)
    assert other.wheel_speeds(rotation @ twist) == pytest.approx(speeds, abs=1e-9)


@patient
@given(seed=st.integers(0, 10**6), x=st.floats(-0.5, 0.5), y=st.floats(-0.5, 0.5), twist=twists)
def test_wheels_do_not_care_which_point_of_the_base_is_its_centre(seed, x, y, twist):
    base = well_conditioned(np.random.default_rng(seed))
    other = standing_at(
        base.contact - (x, y),
        base.wheel_radius,
        directions_deg=np.degrees(base.direction),
        roller_angles_deg=np.degrees(base.roller_angle),
    )
    vx, vy, omega = twist
    there = (vx - omega * y, vy + omega * x, omega)  # of the point (x, y) of the same body
    assert other.wheel_speeds(there) == pytest.approx(base.wheel_speeds(twist), abs=1e-9)
