"""A trajectory to the micrometre, which nobody changes unawares.

Who changes the model, the control or Utama's robot on purpose puts the new numbers here, and the
reason into the commit. Digests, which hold every bit, are not kept: they belong to one platform.
"""

import pytest

from soccersim import Simulation, load_scenario
from soccersim.report import report

DEFENDER = {  # seed 1: truth and belief at the end of each leg, m and rad in Utama's frame
    "truth 1": [-0.0124053, 1.9209604, -0.0031679],
    "odometry 1": [0.0006851, 1.9862150, 0.0022956],
    "truth 2": [-2.4318790, 1.9798931, -0.0258248],
    "odometry 2": [-2.4895263, 2.0023642, -0.0146101],
}


def test_defender_ends_where_it_always_did():
    legs = report(Simulation(load_scenario("defender", seed=1)).run())["robots"][0]["legs"]
    ends = {
        f"{pose} {k}": leg[pose] for k, leg in enumerate(legs, 1) for pose in ("truth", "odometry")
    }
    assert ends == {key: pytest.approx(pose, abs=1e-6) for key, pose in DEFENDER.items()}
