"""Recordings of arms without robots: their plot, and the trajectory.png of their run."""

import numpy as np
import pytest

from soccersim import Simulation, load_scenario
from soccersim.problems import InputError
from soccersim.render.arm_plots import arm_figure, ends
from soccersim.render.curves import curves
from soccersim.render.plots import save_trajectory


@pytest.fixture(scope="module")
def arms():
    """Six arms on the floor; the smallest comes to its first two poses."""
    return Simulation(load_scenario("arm-table2", settings=["duration=2.6"])).run()


def test_the_tip_is_where_the_joints_put_it(arms):
    for row, arm in enumerate(arms.scenario.arms):
        base, tip = ends(arms, row)
        at = arms.scenario.coordinates
        x, y, zero = at.to_field(at.framed(arm.base))
        assert base == pytest.approx(np.tile((x, y), (len(base), 1)), abs=2e-3)
        directions = zero + np.cumsum(arms.arrays["joint"][1:, row], axis=1)
        way = arm.lengths * np.exp(1j * directions)
        reached = way.sum(axis=1)
        expected = np.column_stack((x + reached.real, y + reached.imag))
        assert tip[1:] == pytest.approx(expected, abs=0.01)  # angles are older by a reading


def test_tips_and_joints_of_all_arms_are_drawn_in_metres_and_degrees(arms):
    figure = arm_figure([("", arms)], "six arms")
    tips, *joints = figure.axes
    assert (tips.get_xlabel(), tips.get_ylabel()) == ("x (m)", "y (m)")
    assert [panel.get_ylabel() for panel in joints] == [f"joint {n} (deg)" for n in (1, 2, 3)]
    assert [len(panel.lines) for panel in joints] == [6, 6, 6]
    shown = joints[1].lines[3].get_ydata()
    assert shown == pytest.approx(np.degrees(arms.arrays["joint"][1:, 3, 1]))
    assert figure.legends[0].get_texts()[0].get_text() == "arm-8-5-3"
    assert len({line.get_color() for line in joints[0].lines}) == 6
    held = tips.lines[1].get_xydata()
    assert len(held) == 2
    assert held[0] == pytest.approx(arms.meta["arms"][0][0]["tip_link"][:2], abs=0.02)


def test_a_run_of_arms_alone_has_its_picture(arms, tmp_path):
    save_trajectory(arms, tmp_path / "trajectory.png")
    assert (tmp_path / "trajectory.png").read_bytes().startswith(b"\x89PNG")


def test_arms_alone_are_not_drawn_among_robots(arms):
    with pytest.raises(InputError, match=r"^arms.npz: has no robots"):
        curves([("arms.npz", arms)])


def test_among_robots_arms_are_left_out_and_said():
    keeper = Simulation(load_scenario("keeper-arm", settings=["duration=0.1"])).run()
    drawn, told = curves([("k.npz", keeper)])
    assert [curve.label for curve in drawn] == ["keeper"]
    assert told == ["k.npz: its arms are left out; --csv of replay tells their joints"]
