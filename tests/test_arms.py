"""Arms in the plant: they hold what inverse kinematics asks, and keep the league's rule."""

from itertools import pairwise

import numpy as np
import pytest

from soccersim.plant.arm import carried, link_masses
from soccersim.problems import InputError
from soccersim.record import Recording
from soccersim.report import report
from soccersim.simulation import Simulation
from soccersim.spec.arm import Arm
from soccersim.spec.load import load_scenario
from soccersim.spec.scenario import Scenario

IDLE = {"kp": 0.0, "ki": 0.0, "kd": 0.0, "friction": 0.0}
FIELD = {"length": 9.0, "width": 6.0, "goal": {"width": 2.0}}


def bench(arm: dict, **changes) -> Scenario:
    """A scenario of one arm on the floor."""
    given = {"version": 1, "name": "bench", "field": FIELD, "duration": 2.0, "arms": [arm]}
    return Scenario.model_validate({**given, **changes})


def energy(arm: Arm, links: np.ndarray) -> np.ndarray:
    """Kinetic energy of the links (T, 3, 6) at each record, J."""
    mass = np.array(link_masses(arm))
    spin = mass * np.array(arm.lengths) ** 2 / 12
    square = links[..., 3] ** 2 + links[..., 4] ** 2
    return (0.5 * mass * square + 0.5 * spin * links[..., 5] ** 2).sum(axis=1)


@pytest.fixture(scope="module")
def table2() -> Recording:
    return Simulation(load_scenario("arm-table2")).run()


@pytest.fixture(scope="module")
def shots() -> Recording:
    return Simulation(load_scenario("keeper-arm")).run()


def test_every_target_of_table_2_is_held_within_a_millimetre_and_half_a_degree(table2):
    goals = [goal for arm in report(table2)["arms"] for goal in arm["goals"]]
    assert len(goals) == 50
    assert max(goal["position_error"] for goal in goals) < 1e-3
    assert max(goal["angle_error"] for goal in goals) < np.radians(0.5)


def test_the_joints_stand_where_table_2_prints_them(table2):
    told = report(table2)["arms"]
    first, last = told[0]["goals"][0], told[-1]["goals"][-1]
    assert np.degrees(first["joints"]) == pytest.approx([5, 4, 3], abs=0.05)
    assert np.degrees(last["joints"]) % 360 == pytest.approx([325, 260, 195], abs=0.1)


def test_links_stay_on_their_pivots(table2):
    scenario, links = table2.scenario, table2.links
    for i, arm in enumerate(scenario.arms):
        base = np.array(scenario.coordinates.field_pose(arm.base)[:2])
        for k, length in enumerate(arm.lengths):
            along = np.stack([np.cos(links[:, i, k, 2]), np.sin(links[:, i, k, 2])], axis=1)
            start = links[:, i, k, :2] - along * length / 2
            assert np.abs(start - base).max() < 5e-4
            base = links[:, i, k, :2] + along * length / 2


def test_an_arm_left_to_itself_never_gains_energy():
    arm = {"name": "a", "lengths": [0.3, 0.2, 0.15], "start_deg": [10, 60, -40], "joint": IDLE}
    simulation = Simulation(bench(arm, duration=10.0))
    body = simulation.machine.truth.body
    for shape in simulation.world.space.shapes:
        link = shape.body
        if link.body_type == link.DYNAMIC:  # the whole arm turns about its base like one body
            link.angular_velocity = 3.0
            link.velocity = -3.0 * link.position.y, 3.0 * link.position.x
    body[:, 3], body[:, 4], body[:, 5] = -3.0 * body[:, 1], 3.0 * body[:, 0], 3.0
    recording = simulation.run()
    left = energy(recording.scenario.arms[0], recording.links[:, 0])
    assert left[0] > 0.01
    assert left.max() <= left[0] * (1 + 1e-3)  # the integrator's ripple
    assert left[-1] <= left[0]


def test_friction_in_the_joints_brings_an_arm_to_rest():
    joint = {**IDLE, "friction": 5.0}
    arm = {"name": "a", "lengths": [0.3, 0.2, 0.15], "joint": joint}
    simulation = Simulation(bench(arm, duration=4.0))
    simulation.machine.truth.body[2, 5] = 1.0
    list(simulation.world.space.bodies)[2].angular_velocity = 5.0
    left = energy(simulation.scenario.arms[0], simulation.run().links[:, 0])
    assert left.max() > 1e-6
    assert left[-1] < 1e-4 * left.max()


def test_a_joint_turns_what_hangs_on_it_as_slender_rods_do():
    arm = Arm(name="a", lengths=(0.4, 0.3, 0.2), mass_per_length=2.0)
    whole = 2.0 * 0.9 * 0.9**2 / 3  # one rod of the whole length about its end
    assert carried(arm)[0] == pytest.approx(whole)
    assert carried(arm)[2] == pytest.approx(2.0 * 0.2 * 0.2**2 / 3)


def test_a_moving_arm_turns_its_robot_the_other_way(shots):
    keeper = shots.scenario.robots[0]
    assert keeper.name == "keeper"
    during = (shots.time > 0.2) & (shots.time < 0.5)
    assert np.abs(shots.body[during, 0, 5]).max() > 1e-3


def test_the_keepers_arm_blocks_shots_that_pass_it_and_rests_in_between(shots):
    told = report(shots)["shots"]
    assert [shot["goal"] for shot in told] == [None, None, None, None, "home", None]


def test_without_the_arm_the_same_shots_are_goals():
    scenario = load_scenario("keeper-arm")
    bare = scenario.model_copy(update={"arms": ()})
    told = report(Simulation(bare).run())["shots"]
    assert [shot["goal"] for shot in told][:2] == ["home", "home"]


def test_the_keeper_is_never_wider_than_the_league_allows_nor_for_longer(shots):
    keeper, arm = shots.scenario.robots[0].model, shots.scenario.arms[0]
    last = shots.links[:, 0, 2]
    tip = last[:, 1] + arm.lengths[2] / 2 * np.sin(last[:, 2])
    side = np.abs(tip - shots.body[:, 0, 1]) + arm.thickness / 2
    assert (keeper.radius + side).max() <= 0.6 + 1e-3
    wide = side > 0.26  # 0.52 m is the ordinary width
    spells = np.split(shots.time[wide], np.flatnonzero(np.diff(shots.time[wide]) > 0.3) + 1)
    assert len(spells) == 4
    assert max(spell[-1] - spell[0] for spell in spells) <= 1.0
    assert min(b[0] - a[-1] for a, b in pairwise(spells)) >= 4.0


def test_a_pose_out_of_reach_is_told_with_its_place(tmp_path):
    text = (
        "version: 1\nname: far\nfield: krsbi\narms:\n  - name: a\n    lengths: [0.3, 0.2, 0.1]\n"
        "    reaches:\n      - to: [0.7, 0, 0]\n"
    )
    path = tmp_path / "far.yaml"
    path.write_text(text)
    with pytest.raises(InputError, match=r"far.yaml:8:13: arms.0.reaches.0.to: too far by 0.1"):
        load_scenario(path)


@pytest.mark.parametrize(
    ("arm", "wrong"),
    [
        ({"on": "nobody"}, "no robot `nobody`"),
        ({"guard": {}}, "needs a robot"),
        ({"guard": {}, "reaches": [{"to": [0.3, 0, 0]}]}, "keep one"),
    ],
)
def test_arms_that_cannot_be_are_refused(arm, wrong):
    with pytest.raises(ValueError, match=wrong):
        bench({"name": "a", "lengths": [0.3, 0.2, 0.1], **arm})


def test_arms_give_the_same_digest_twice_and_cut_into_pieces(shots):
    simulation = Simulation(load_scenario("keeper-arm"))
    while not simulation.done:
        simulation.advance(777)
    assert simulation.recording().digest == shots.digest
