"""Laws of the planar arm: forward and every inverse solution, limits, motion, workspace."""

from math import cos, hypot, pi, radians, remainder, sin

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from soccersim.kinematics import PlanarArm

ARM = PlanarArm((8.0, 5.0, 3.0))  # the paper's first, in cm
EQUAL = PlanarArm((2.0, 2.0, 1.0))

patient = settings(deadline=None)
lengths = st.floats(0.05, 30)
arms = st.tuples(lengths, lengths, lengths).map(PlanarArm)
three_angles = st.tuples(*3 * [st.floats(-pi, pi)])
poses = st.tuples(st.floats(-100, 100), st.floats(-100, 100), st.floats(-20, 20))


def apart(q, other):
    """The greatest angle between two sets of angles, mod 2 pi."""
    return max(abs(remainder(a - b, 2 * pi)) for a, b in zip(q, other, strict=True))


def brings_tip_to(arm, q, pose, near=1e-11):
    """Whether the forward kinematics gives the pose, phi mod 2 pi."""
    x, y, phi = arm.forward(q)
    off = hypot(x - pose[0], y - pose[1]) / sum(arm.lengths)
    return off <= near and apart([phi], [pose[2]]) <= near


# Forward and inverse


@patient
@given(arm=arms, pose=poses)
def test_every_solution_brings_the_tip_to_the_pose(arm, pose):
    for q in arm.inverse(pose):
        assert brings_tip_to(arm, q, pose)
        assert all(-pi < angle <= pi for angle in q)


@patient
@given(arm=arms, q=three_angles)
def test_the_joints_a_pose_came_from_are_among_its_solutions(arm, q):
    pose = arm.forward(q)
    solutions = arm.inverse(pose)
    assert all(brings_tip_to(arm, solution, pose) for solution in solutions)
    assume(abs(sin(q[1])) > 1e-2)  # nearer to straight or folded the angles are lost in rounding
    assert min(apart(solution, q) for solution in solutions) < 1e-7


@patient
@given(arm=arms, q=three_angles)
def test_there_are_two_solutions_unless_they_meet(arm, q):
    assume(abs(sin(q[1])) > 1e-2)
    up, down = arm.inverse(arm.forward(q))
    assert up[1] > 0 > down[1]
    assert up[1] == -down[1]


@patient
@given(arm=arms, q1=st.floats(-pi, pi), q3=st.floats(-pi, pi), q2=st.sampled_from([0.0, pi]))
def test_a_straight_or_folded_elbow_is_one_solution(arm, q1, q2, q3):
    assume(abs(arm.lengths[0] - arm.lengths[1]) > 1e-3)
    (solution,) = arm.inverse(arm.forward((q1, q2, q3)))
    assert apart(solution, (q1, q2, q3)) < 1e-9
    assert arm.singular(solution)


@patient
@given(arm=arms, bearing=st.floats(-pi, pi), phi=st.floats(-pi, pi), beyond=st.floats(1e-6, 10))
def test_a_pose_out_of_reach_has_no_solution_and_says_by_how_much(arm, bearing, phi, beyond):
    first, second, third = arm.lengths
    for distance, why in ((first + second + beyond, "far"), (abs(first - second) - beyond, "near")):
        if distance < 0:
            continue
        x = distance * cos(bearing) + third * cos(phi)
        y = distance * sin(bearing) + third * sin(phi)
        assert arm.inverse((x, y, phi)) == []
        assert arm.reach_problem((x, y, phi)).startswith(f"too {why} by ")


def test_how_far_out_of_reach_is_told_in_the_arms_own_unit():
    assert ARM.reach_problem((17.25, 0, 0)) == "too far by 1.25: the wrist reaches 13 from the base"
    assert ARM.reach_problem((4, 0, 0)) == "too near by 2: the wrist keeps 3 from the base"
    assert ARM.reach_problem((16, 0, 0)) is None


def test_half_a_turn_is_pi_and_not_minus_pi():
    assert ARM.inverse((-16, 0, pi)) == [(pi, 0, 0)]


def test_a_turn_of_phi_changes_nothing():
    pose = ARM.forward((0.3, 1.1, -0.7))
    turned = ARM.inverse((*pose[:2], pose[2] + 4 * pi))
    assert np.array(turned) == pytest.approx(np.array(ARM.inverse(pose)), abs=1e-12)


def test_with_the_wrist_on_the_base_one_solution_stands_for_infinitely_many():
    pose = (cos(0.4), sin(0.4), 0.4)
    assert EQUAL.wrist_on_base(pose)
    (solution,) = EQUAL.inverse(pose)
    assert solution == pytest.approx((0, pi, 0.4 - pi))
    for q1 in np.linspace(-3, 3, 7):
        assert brings_tip_to(EQUAL, (q1, pi, 0.4 - q1 - pi), pose)
    assert EQUAL.singular(solution)
    assert not ARM.wrist_on_base((3, 0, 0))


# Joint limits


def test_limits_leave_out_the_elbow_that_they_forbid():
    bent = PlanarArm((8, 5, 3), ((-pi, pi), (0, 2.5), (-pi, pi)))
    pose = ARM.forward((0.3, -1.0, 0.2))
    up, _ = ARM.inverse(pose)
    assert bent.inverse(pose) == [up]


def test_a_joint_that_turns_past_180_degrees_is_found_there():
    turning = PlanarArm((8, 5, 3), ((0, radians(330)), (0, pi), (0, radians(330))))
    q = (radians(280), radians(40), radians(200))
    (found,) = turning.inverse(turning.forward(q))
    assert found == pytest.approx(q)


def test_a_joint_on_its_limit_is_within_it():
    q = (0.5, 1.2, -0.3)
    exact = PlanarArm((8, 5, 3), tuple((angle, angle) for angle in q))
    assert exact.inverse(exact.forward(q)) == [q]


def test_limits_that_forbid_both_elbows_are_told_joint_by_joint():
    stiff = PlanarArm((8, 5, 3), ((-pi, pi), (-1.0, 1.0), (-pi, pi)))
    pose = stiff.forward((0, radians(90), 0))
    assert stiff.inverse(pose) == []
    assert stiff.reach_problem(pose) == (
        "joint limits: joint 2 at 90.0 deg, which has -57.3 to 57.3, "
        "or joint 2 at -90.0 deg, which has -57.3 to 57.3"
    )


@pytest.mark.parametrize("phi", np.linspace(-3, 3, 13))
@pytest.mark.parametrize(
    ("q1", "q3"), [((0.5, 1.0), (-1.0, 0.75)), ((0.5, 2.5), (-0.2, 0.1)), ((-1, 1), (-1, 1))]
)
def test_with_the_wrist_on_the_base_limits_are_kept_where_any_angle_of_joint_1_keeps_them(
    phi, q1, q3
):
    arm = PlanarArm((2, 2, 1), (q1, (2, 4), q3))
    angles = np.linspace(*q1, 2001)
    possible = any(q3[0] <= remainder(phi - pi - angle, 2 * pi) <= q3[1] for angle in angles)
    pose = (cos(phi), sin(phi), phi)
    assert len(arm.inverse(pose)) == possible
    if possible:
        assert brings_tip_to(arm, arm.inverse(pose)[0], pose)
    else:
        assert "no angle of joint 1 helps" in arm.reach_problem(pose)


@patient
@given(q=three_angles, limits=st.tuples(*3 * [st.tuples(*2 * [st.floats(-7, 7)]).map(sorted)]))
def test_solutions_are_those_without_limits_that_can_stand_within_them(q, limits):
    limited = PlanarArm(ARM.lengths, limits)
    pose = ARM.forward(q)
    found = limited.inverse(pose)
    for solution in found:
        assert all(a <= angle <= b for angle, (a, b) in zip(solution, limits, strict=True))
        assert brings_tip_to(ARM, solution, pose, near=4e-9)  # three joints put on their limits
    allowed = [
        solution
        for solution in ARM.inverse(pose)
        if all(
            any(a <= angle + turn * 2 * pi <= b for turn in range(-2, 3))
            for angle, (a, b) in zip(solution, limits, strict=True)
        )
    ]
    assert all(min(apart(one, other) for other in found) < 1e-8 for one in allowed)
    assert (limited.reach_problem(pose) is None) == bool(found)


# Motion and workspace


@patient
@given(q=st.lists(st.floats(-pi, pi), min_size=1, max_size=6), data=st.data())
def test_the_jacobian_is_the_derivative_of_forward(q, data):
    arm = PlanarArm(tuple(data.draw(st.lists(lengths, min_size=len(q), max_size=len(q)))))
    step = 1e-6
    ahead = np.array([arm.forward(np.add(q, step * unit)) for unit in np.eye(len(q))])
    back = np.array([arm.forward(np.subtract(q, step * unit)) for unit in np.eye(len(q))])
    assert arm.jacobian(q) == pytest.approx(((ahead - back) / (2 * step)).T, abs=1e-6)


@patient
@given(arm=arms, q=three_angles)
def test_manipulability_is_the_area_the_first_two_links_span(arm, q):
    expected = arm.lengths[0] * arm.lengths[1] * abs(sin(q[1]))
    assert arm.manipulability(q) == pytest.approx(expected, rel=1e-6, abs=1e-9)


def test_an_arm_is_singular_when_straight_or_folded_and_with_fewer_than_three_links():
    assert ARM.singular((0.4, 0, 1))
    assert ARM.singular((0.4, pi, 1))
    assert not ARM.singular((0.4, 0.01, 1))
    two = PlanarArm((1, 1))
    assert two.singular((0, 1))
    assert two.manipulability((0, 1)) == 0


@patient
@given(arm=arms, q=three_angles)
def test_the_tip_stays_in_the_workspace(arm, q):
    x, y, _ = arm.forward(q)
    least, most = arm.workspace()
    assert least - 1e-9 <= hypot(x, y) <= most + 1e-9
    assert arm.inside(x, y)


@pytest.mark.parametrize(
    ("links", "least"),
    [((8, 5, 3), 0), ((3, 5, 8), 0), ((10, 3, 2), 5), ((2, 10, 3), 5), ((4,), 4)],
)
def test_the_workspace_has_a_hole_where_one_link_outreaches_the_others(links, least):
    arm = PlanarArm(links)
    assert arm.workspace() == (least, sum(links))
    assert arm.inside(sum(links), 0)
    assert not arm.inside(sum(links) + 1e-6, 0)
    assert arm.inside(0, least)
    assert least == 0 or not arm.inside(0, least - 1e-6)


@patient
@given(q=st.lists(st.floats(-pi, pi), min_size=4, max_size=4))
def test_the_joints_are_the_lengths_apart_and_end_in_the_tip(q):
    arm = PlanarArm((4, 3, 2, 1))
    points = arm.joints(q)
    assert points.shape == (5, 2)
    assert points[0].tolist() == [0, 0]
    assert np.hypot(*np.diff(points, axis=0).T) == pytest.approx(arm.lengths)
    assert points[-1] == pytest.approx(arm.forward(q)[:2], abs=1e-12)


# What is refused


@pytest.mark.parametrize("links", [(), (1, 0, 1), (1, -2), (1, float("nan")), (float("inf"),)])
def test_links_have_positive_lengths(links):
    with pytest.raises(ValueError, match="links of positive length"):
        PlanarArm(links)


@pytest.mark.parametrize("limits", [((0, 1),), ((1, 0), (0, 1), (0, 1)), 3 * ((0, float("nan")),)])
def test_limits_are_lower_and_upper_for_each_joint(limits):
    with pytest.raises(ValueError, match=r"one \(lower, upper\) for each joint"):
        PlanarArm((1, 1, 1), limits)


@pytest.mark.parametrize("pose", [(1, 2), (1, 2, 3, 4), (float("nan"), 0, 0)])
def test_a_pose_is_three_finite_numbers(pose):
    with pytest.raises(ValueError, match="pose must be 3 finite numbers"):
        ARM.inverse(pose)


def test_the_inverse_is_of_three_links():
    with pytest.raises(ValueError, match="this arm has 4"):
        PlanarArm((1, 1, 1, 1)).inverse((1, 1, 0))
