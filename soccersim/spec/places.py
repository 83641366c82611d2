"""Where bodies may stand at the start: on the floor, clear of each other, of posts and of nets."""

from collections.abc import Iterator
from itertools import combinations
from math import hypot
from typing import TYPE_CHECKING, NamedTuple

from soccersim.spec.field import NET_RADIUS, Field
from soccersim.spec.validate import Fault

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario


class Disc(NamedTuple):
    """A body at its start, on the field."""

    at: tuple[str | int, ...]  # where the scenario says so
    name: str
    x: float
    y: float
    radius: float


def discs(scenario: "Scenario") -> list[Disc]:
    """The robots, then the ball."""
    field_pose = scenario.coordinates.field_pose
    bodies = [
        Disc(("robots", i, "start"), robot.name, *field_pose(robot.start)[:2], robot.model.radius)
        for i, robot in enumerate(scenario.robots)
    ]
    if ball := scenario.ball:
        at = field_pose((*ball.at, 0.0))[:2]
        bodies.append(Disc(("ball", "at"), "the ball", *at, ball.radius))
    return bodies


def shots(scenario: "Scenario") -> Iterator[Disc]:
    """The ball where shots put it: by then the robots may be anywhere."""
    if ball := scenario.ball:
        for i, shot in enumerate(ball.shots):
            at = scenario.coordinates.field_pose((*shot.at, 0.0))[:2]
            yield Disc(("ball", "shots", i, "at"), "the ball", *at, ball.radius)


def misplaced(scenario: "Scenario") -> Iterator[Fault]:
    """Everybody who stands where nobody can."""
    bodies = discs(scenario)
    for body in (*bodies, *shots(scenario)):
        yield from in_board(body, scenario.field)
        yield from in_goal(body, scenario.field)
    for first, body in combinations(bodies, 2):
        apart = first.radius + body.radius
        if hypot(first.x - body.x, first.y - body.y) < apart:
            yield Fault(
                f"{body.name} and {first.name} are in one place: "
                f"keep {apart:.2f} m between their centres",
                at=body.at,
            )


def in_board(body: Disc, field: Field) -> Iterator[Fault]:
    """Whether the body reaches beyond the border."""
    x = field.half_length + field.border - body.radius
    y = field.half_width + field.border - body.radius
    if abs(body.x) > x or abs(body.y) > y:
        yield Fault(
            f"{body.name} is off the floor: at ({body.x:.2f}, {body.y:.2f}) m on the field, "
            f"inside is |x| < {x:.2f}, |y| < {y:.2f}",
            at=body.at,
        )


def in_goal(body: Disc, field: Field) -> Iterator[Fault]:
    """Whether the body is inside a post or reaches through a net."""
    goal = field.goal
    line, back = field.half_length, field.half_length + goal.depth
    x, y = abs(body.x), abs(body.y)
    if hypot(x - line, y - goal.post_centre) < body.radius + goal.post_radius:
        away = f"keep {body.radius + goal.post_radius:.2f} m from"
        post = f"({line:.2f}, {goal.post_centre:.2f})"
        yield Fault(f"{body.name} stands in a goal post: {away} |x|, |y| = {post} m", at=body.at)
        return
    # the nearest points of a side net and of the back net
    side = hypot(x - min(max(x, line), back), y - goal.post_centre)
    rear = hypot(x - back, y - min(y, goal.post_centre))
    if min(side, rear) < body.radius + NET_RADIUS:
        away = f"{body.radius + NET_RADIUS:.2f} m"
        yield Fault(f"{body.name} stands in a goal's net: keep {away} from it", at=body.at)
