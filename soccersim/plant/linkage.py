"""The links of arms as pymunk bodies on pivots."""

from collections.abc import Sequence
from math import radians

import pymunk

from soccersim.geometry import rotate
from soccersim.plant.arm import link_masses, link_poses
from soccersim.spec.arm import Arm
from soccersim.spec.scenario import Scenario
from soccersim.state import Truth

PIVOT_LEFT = 1e-100  # share of a pivot's error left after a second: a third goes each tick
FIRST_GROUP = 1  # of shapes that never touch each other: an arm and its carrier


def add_arms(
    space: pymunk.Space, scenario: Scenario, robots: Sequence[pymunk.Body], truth: Truth
) -> None:
    """Add all arms' links to the space, in order, and their start to truth.body."""
    row = len(scenario.robots) + (scenario.ball is not None)
    names = [player.name for player in scenario.robots]
    for group, arm in enumerate(scenario.arms, FIRST_GROUP):
        before = robots[names.index(arm.on)] if arm.on else space.static_body
        shape_filter = pymunk.ShapeFilter(group=group)
        if arm.on:
            for shape in before.shapes:
                shape.filter = shape_filter
        base = base_on_field(scenario, arm, before)
        pivot = base[:2]
        for link, pose in enumerate(link_poses(arm, base, tuple(map(radians, arm.start_deg)))):
            body = _link(arm, link, pose)
            half = arm.lengths[link] / 2
            shape = pymunk.Segment(body, (-half, 0), (half, 0), arm.thickness / 2)
            shape.elasticity, shape.friction, shape.filter = arm.elasticity, 0.0, shape_filter
            joint = pymunk.PivotJoint(before, body, pivot)
            joint.collide_bodies, joint.error_bias = False, PIVOT_LEFT
            space.add(body, shape, joint)
            truth.body[row, :3] = pose
            pivot = body.local_to_world((half, 0))
            before, row = body, row + 1


def base_on_field(scenario: Scenario, arm: Arm, carrier: pymunk.Body) -> tuple[float, float, float]:
    """Where the first joint and its zero are on the field."""
    x, y, heading = arm.base_pose(scenario.coordinates)
    if not arm.on:
        return x, y, heading
    dx, dy = rotate(x, y, carrier.angle)  # body to field
    return carrier.position.x + dx, carrier.position.y + dy, heading + carrier.angle


def _link(arm: Arm, link: int, pose: tuple[float, float, float]) -> pymunk.Body:
    """A slender rod at its place."""
    mass, length = link_masses(arm)[link], arm.lengths[link]
    body = pymunk.Body(mass, mass * length**2 / 12)
    body.position, body.angle = pose[:2], pose[2]
    return body
