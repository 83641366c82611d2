"""The error models give again what they were fitted to, and nothing drifts between the two."""

import numpy as np
import pytest

from soccersim.reproduce import error_models as models
from soccersim.reproduce.tables import table
from soccersim.reproduce.utama_points import RUNS, points

SEEDS = range(200)


def marks():
    paper = table("idris-table6")
    real = np.column_stack([paper.numbers(key) for key in ("x", "y", "theta")])
    measured = [paper.numbers(f"measured_{key}", corrected=True) for key in ("x", "y", "theta")]
    return real, np.column_stack(measured)


# Idris, Table 1: acceptance check 17


def test_the_gyro_model_is_the_fit_to_table_1_without_its_outlier():
    paper = table("idris-table1")
    error = paper.numbers("gyro") - paper.numbers("real")
    kept = np.delete(error, 18)
    assert kept.mean() == pytest.approx(models.GYRO_MEAN, abs=0.005)
    assert kept.std(ddof=1) == pytest.approx(models.GYRO_SD, abs=0.005)
    assert error[18] == pytest.approx(models.OUTLIER_MEAN, abs=0.15)


def test_the_gyro_model_has_table_1s_mean_and_spread():
    real = np.linspace(10, 360, 19)
    error = models.gyro_angles(real, SEEDS, outlier_share=0.0) - real
    assert error.mean() == pytest.approx(0.96, abs=0.2)
    assert error.std() == pytest.approx(0.76, abs=0.15)


def test_one_reading_in_twenty_of_the_gyro_model_is_nine_degrees_off():
    real = np.linspace(10, 360, 19)
    error = models.gyro_angles(real, SEEDS) - real
    assert np.mean(error > 5) == pytest.approx(0.05, abs=0.01)
    assert np.median(error[error > 5]) == pytest.approx(9.0, abs=0.3)


def test_the_gyro_model_starts_from_zero_as_the_paper_does():
    assert (models.gyro_angles(np.array([0.0, 10.0]), SEEDS)[:, 0] == 0).all()


# Idris, Table 6: acceptance check 19


def test_the_hand_model_is_the_fit_to_the_legs_of_table_6():
    real, measured = marks()
    gained = np.diff(measured - real, axis=0, prepend=0.0)[:, :2]
    moved = np.diff(real[:, :2], axis=0, prepend=np.zeros((1, 2))) > 0
    along, cross = gained[moved], gained[~moved]
    assert along.mean() == pytest.approx(models.ALONG_MEAN, abs=0.01)
    assert along.std(ddof=1) == pytest.approx(models.ALONG_SD, abs=0.03)
    assert cross.mean() == pytest.approx(models.CROSS_MEAN, abs=0.01)
    assert cross.std(ddof=1) == pytest.approx(models.CROSS_SD, abs=0.03)
    turned = (measured - real)[:, 2]
    assert turned.mean() == pytest.approx(models.HEADING_MEAN, abs=0.01)
    assert turned.std(ddof=1) == pytest.approx(models.HEADING_SD, abs=0.03)


def test_the_hand_model_scatters_most_along_the_leg_that_is_pushed():
    real, _ = marks()
    gained = np.diff(models.pushed_poses(real, SEEDS) - real, axis=1, prepend=0.0)[..., :2]
    moved = np.diff(real[:, :2], axis=0, prepend=np.zeros((1, 2))) > 0
    assert gained[:, moved].std() == pytest.approx(models.ALONG_SD, rel=0.05)
    assert gained[:, ~moved].std() == pytest.approx(models.CROSS_SD, rel=0.05)
    assert gained[:, ~moved].mean() == pytest.approx(models.CROSS_MEAN, rel=0.1)


def test_the_hand_model_holds_the_papers_sums_of_table_6_in_its_band():
    real, _ = marks()
    error = models.pushed_poses(real, SEEDS) - real
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(real[:, :2] > 0, np.abs(error[..., :2]) / real[:, :2], 0.0)
    percent = 100 * share.mean(axis=1)  # (S, 2), the paper's rule
    final = np.hypot(*error[:, -1, :2].T)
    for paper, ours in ((5.37, percent[:, 0]), (5.46, percent[:, 1]), (6.67, final)):
        low, high = np.percentile(ours, (5, 95))
        assert low < paper < high
    assert 4 < np.median(final) < 11
    assert 0.5 < np.sqrt((error[..., 2] ** 2).mean()) < 1.5


# Utama: acceptance check 20


@pytest.mark.parametrize("run", RUNS)
def test_replaying_the_scale_and_rotation_of_each_leg_gives_the_measured_points(run):
    sensor, measured = points(run, "sensor"), points(run, "measured")
    scale, rotation = models.leg_errors(sensor, measured)
    assert models.replay(sensor, scale, rotation) == pytest.approx(measured, abs=1e-9)


def test_the_scales_and_rotations_of_the_legs_as_shown_give_the_measured_points_within_1_mm():
    for run in RUNS:
        sensor, measured = points(run, "sensor"), points(run, "measured")
        scale, rotation = models.leg_errors(sensor, measured)
        again = models.replay(sensor, scale.round(4), rotation.round(4))
        assert np.hypot(*(again - measured).T).max() < 1


def test_the_leg_model_is_the_fit_to_the_five_legs_of_section_3():
    legs = [models.leg_errors(points(run, "sensor"), points(run, "measured")) for run in RUNS]
    scale, rotation = (np.concatenate(column) for column in zip(*legs, strict=True))
    assert len(scale) == 5
    assert scale.mean() == pytest.approx(models.SCALE_MEAN, abs=0.0005)
    assert scale.std(ddof=1) == pytest.approx(models.SCALE_SD, abs=0.0005)
    assert rotation.std(ddof=1) == pytest.approx(models.ROTATION_SD, abs=0.1)


@pytest.mark.parametrize(
    ("run", "median"), [("defender", 220), ("midfielder", 300), ("striker", 510)]
)
def test_the_leg_model_gives_gaps_like_the_papers(run, median):
    """Over 2000 seeds: at 200 the median itself scatters by 6 %."""
    sensor, measured = points(run, "sensor"), points(run, "measured")
    ends = models.slipped_ends(sensor, range(2000))[:, -1]
    gaps = np.hypot(*(ends - sensor[-1]).T)
    assert np.median(gaps) == pytest.approx(median, rel=0.15)
    paper = np.hypot(*(measured - sensor)[-1])
    low, high = np.percentile(gaps, (5, 95))
    assert low < paper < high
