"""Every sensor of every robot has chance of its own, however a run is cut."""

import numpy as np
import pytest
from factory import merged, player, robot, scenario, simulate

from soccersim.sensing.noise import BLOCK, NoiseSource
from soccersim.simulation import Simulation
from soccersim.streams import stream

REAL = {
    "drive": {"encoder": {"perfect": False, "pulses_per_turn": 360, "missed": 0.02}},
    "gyro": {"perfect": False},
    "odometry": {"heading": "wheels"},
}
MOVE = (1.0, 0.5, 90)


def real(**changes):
    return robot(merged(REAL, changes))


def blind():
    """The real robot without its gyro, which it does not use."""
    model = real().model_dump(exclude_unset=True)
    return robot_of({key: value for key, value in model.items() if key != "gyro"})


def robot_of(written):
    return type(robot()).model_validate(written)


def test_a_gyro_more_leaves_the_encoders_missed_edges_as_they_were():
    with_gyro, without = simulate(player(real(), MOVE)), simulate(player(blind(), MOVE))
    assert (with_gyro.arrays["counts"] == without.arrays["counts"]).all()
    assert with_gyro.arrays["gyro"].any()
    assert not without.arrays["gyro"].any()
    assert with_gyro.digest == without.digest


def test_missed_edges_leave_the_gyro_s_noise_as_it_was():
    models = [real(), real(drive={"encoder": {"missed": 0.0}})]
    noises = [NoiseSource([model], 3, 500, 4) for model in models]
    for noise in noises:
        noise.prepare(0, 1)
    assert (noises[0].noise.gyro_white == noises[1].noise.gyro_white).all()
    assert noises[0].noise.missed.any()
    assert not noises[1].noise.missed.any()


def test_dead_wheels_leave_the_driven_wheels_edges_as_they_were():
    dead = {"azimuth_deg": [180, 300, 60], "distance": 0.08, "radius": 0.025}
    dead["encoder"] = {"missed": 0.1}
    alone, both = NoiseSource([real()], 6, 500, 0), NoiseSource([real(dead=dead)], 6, 500, 0)
    for source in (alone, both):
        source.prepare(0, 1)
    assert (alone.noise.missed[:, :, :3] == both.noise.missed[:, :, :3]).all()
    assert both.noise.missed[:, :, 3:].all()


def test_another_robot_leaves_the_first_as_it_was():
    first = player(real(), MOVE, name="first")
    other = player(real(), MOVE, name="other", start=(0, 4, 0))
    alone, together = simulate(first), simulate(first, other)
    records = len(alone.tick)
    assert (together.body[:records, 0] == alone.body[:, 0]).all()
    assert (together.arrays["counts"][:records, 0] == alone.arrays["counts"][:, 0]).all()


def test_equal_robots_do_not_err_alike():
    players = [player(real(), MOVE, start=(0, 4.0 * i, 0)) for i in (-1, 0, 1)]
    legs = simulate(*players).legs
    drifts = [np.subtract(leg[0]["truth"], leg[0]["odometry"]) for leg in legs]
    assert len({round(drift[0], 6) for drift in drifts}) == 3
    gyro = NoiseSource([real()] * 2, 3, 500, 0)
    gyro.prepare(0, 1)
    noise = gyro.noise.gyro_white
    assert abs(np.corrcoef(noise[:, 0], noise[:, 1])[0, 1]) < 4 / BLOCK**0.5


def test_a_gyro_s_walk_knows_nothing_of_its_white_noise():
    source = NoiseSource([real()], 3, 500, 0)
    source.prepare(0, 1)
    noise = source.noise
    assert abs(np.corrcoef(noise.gyro_white[:, 0], noise.gyro_walk[:, 0])[0, 1]) < 4 / BLOCK**0.5


def test_another_seed_is_another_run():
    digests = {simulate(player(real(), MOVE), seed=seed).digest for seed in (1, 2, 3)}
    assert len(digests) == 3
    assert simulate(player(real(), MOVE), seed=2).digest in digests


@pytest.mark.parametrize("ticks", [1, 7, 1000])
def test_however_a_run_is_cut_it_is_the_same_run(ticks):
    """Long enough for several blocks of noise, of sensors with different rates."""
    slow = real(drive={"encoder": {"rate_hz": 50}}, gyro={"rate_hz": 500})
    square = [(1, 0, 0), (1, 1, 90), (0, 1, 180), (0, 0, 0)]
    written = scenario(player(slow, *square, repeat=True), duration=7.3)
    whole = Simulation(written).run()
    cut = Simulation(written)
    while not cut.done:
        cut.advance(ticks)
    again = cut.recording()
    assert len(whole.tick) == 365
    assert again.digest == whole.digest
    assert all((again.arrays[key] == whole.arrays[key]).all() for key in ("gyro", "counts"))


def test_a_block_of_noise_is_used_once():
    source = NoiseSource([real()], 3, 500, 0)
    seen = []
    tick = 0
    while len(seen) < 4:
        tick = source.prepare(tick, 10**6)
        seen.append(source.noise.gyro_white[:, 0].copy())
    assert tick == 4 * BLOCK * 5  # samples at 100 Hz, ticks at 500
    assert len(np.unique(np.concatenate(seen))) == 4 * BLOCK


# --- kicks: counted, not clocked

KICKER = {"kicker": {"recharge": 0.1}}


def test_every_kick_has_a_row_of_its_own_however_many_there_are():
    """Kick n finds row n of its robot's stream, whenever blocks are filled up."""
    kicks = np.zeros(2, np.int64)
    source = NoiseSource([robot(), robot(**KICKER)], 3, 500, 4, kicks)
    rng, found = np.random.default_rng(0), []
    while len(found) < 3 * BLOCK:
        end = source.prepare(0, 10**9)
        assert end == BLOCK * 50  # ticks: as many kicks as there are rows
        for _ in range(rng.integers(0, BLOCK + 1)):
            found.append(source.noise.kick[kicks[1] % BLOCK, 1].copy())
            kicks[1] += 1
    expected = stream(4, 1, "kick").standard_normal((len(found), 2))
    np.testing.assert_array_equal(found, expected)
    assert not source.noise.kick[:, 0].any()


def test_a_kicker_more_leaves_all_else_as_it_was():
    plain, kicking = (NoiseSource([model], 3, 500, 4) for model in (real(), real(**KICKER)))
    for source in (plain, kicking):
        source.prepare(0, 1)
    for name in ("gyro_white", "gyro_walk", "missed"):
        assert (getattr(plain.noise, name) == getattr(kicking.noise, name)).all()


def test_equal_robots_do_not_kick_alike():
    source = NoiseSource([real(**KICKER)] * 2, 3, 500, 0)
    source.prepare(0, 1)
    first, second = source.noise.kick[:, 0], source.noise.kick[:, 1]
    assert abs(np.corrcoef(first[:, 0], second[:, 0])[0, 1]) < 4 / BLOCK**0.5
    assert abs(np.corrcoef(first[:, 0], first[:, 1])[0, 1]) < 4 / BLOCK**0.5
