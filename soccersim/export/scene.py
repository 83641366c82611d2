"""What a log shows in 3D: field, robots, ball and arms in the colours of our own pictures.

Each is told once and moves with its frame.
"""

from math import pi

from soccersim.export.frames import MAP
from soccersim.export.primitives import (
    THIN,
    Entity,
    Place,
    arc,
    ball,
    cylinder,
    entity,
    line,
    lying,
    rgba,
    slab,
    words,
)
from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.pitch import floor
from soccersim.spec.field import Field

TALL = 1.0  # height of a robot beside its radius: low, so that its name is seen from above
POST = 0.8  # m, height of a goal


def field_entities(field: Field) -> list[Entity]:
    """Floor, grass, lines and goals."""
    length, width = floor(field)
    parts = [
        slab((0, 0), (length, width), -2 * THIN, look.VERGE),
        slab((0, 0), (field.length, field.width), -THIN, look.GRASS[0]),
    ]
    goals = []
    for side, team in ((-1, "home"), (1, "away")):
        goal, x = field.goal, side * (field.half_length + field.goal.depth / 2)
        parts.append(slab((x, 0), (goal.depth, goal.width), THIN, look.TEAMS[team]))
        for y in (-goal.width / 2, goal.width / 2):
            size = {"x": 2 * goal.post_radius, "y": 2 * goal.post_radius, "z": POST}
            pose = lying((side * field.half_length, y), POST / 2)
            goals.append(cylinder(pose, size, look.POST))
    lines = [line(way, field.line_width) for way in _ways(field)]
    return [entity("field", MAP, cubes=parts, cylinders=goals, lines=lines)]


def robot_entities(recording: Recording, names: list[str]) -> list[Entity]:
    """A disc in its team's colour with a white nose and its name, for each robot."""
    entities = []
    for player, name in zip(recording.scenario.robots, names, strict=True):
        radius = player.model.radius
        height = TALL * radius
        size = {"x": 2 * radius, "y": 2 * radius, "z": height}
        body = cylinder(lying((0, 0), height / 2), size, look.TEAMS[player.team])
        nose = {
            "pose": lying((0.7 * radius, 0), height),
            "size": {"x": 0.5 * radius, "y": 0.3 * radius, "z": 0.1 * radius},
            "color": rgba(look.NOSE),
        }
        label = words(player.name, lying((0, 0), 1.6 * height), radius)
        frame = f"{name}/base_link"
        entities.append(entity(name, frame, cylinders=[body], cubes=[nose], texts=[label]))
    return entities


def other_entities(recording: Recording, arms: list[str]) -> list[Entity]:
    """The ball, and the links of arms."""
    scenario, entities = recording.scenario, []
    if scenario.ball:
        round_ = ball((0, 0), 0.0, 2 * scenario.ball.radius, look.BALL)
        entities.append(entity("ball", "ball", spheres=[round_]))
    for arm, name in zip(scenario.arms, arms, strict=True):
        for number, length in enumerate(arm.lengths, 1):
            size = {"x": length, "y": arm.thickness, "z": arm.thickness}
            link = {"pose": lying((0, 0), 0.1), "size": size, "color": rgba(look.DEAD_ROLLER)}
            entities.append(entity(f"{name}_{number}", f"{name}/link_{number}", cubes=[link]))
    return entities


def _ways(field: Field) -> list[list[Place]]:
    """The lines of a field, through their middles, each closed unless it is an arc."""
    inset = field.line_width / 2
    x, y = field.half_length - inset, field.half_width - inset
    ways = [_box(-x, -y, x, y), [(0.0, -y), (0.0, y)]]
    if field.centre_circle:
        ways.append(arc((0, 0), field.centre_circle - inset, 0, 2 * pi))
    for side in (-1, 1):
        for area in (field.penalty_area, field.goal_area):
            if area:
                front = side * (field.half_length - area.depth + inset)
                ways.append(_box(side * x, -area.width / 2, front, area.width / 2))
        for other in (-1, 1):
            if field.corner_arc:
                start = {(-1, -1): 0, (1, -1): 1, (1, 1): 2, (-1, 1): 3}[side, other] * pi / 2
                corner = (side * field.half_length, other * field.half_width)
                ways.append(arc(corner, field.corner_arc - inset, start, start + pi / 2))
    return ways


def _box(x1: float, y1: float, x2: float, y2: float) -> list[Place]:
    return [(x1, y1), (x2, y1), (x2, y2), (x1, y2), (x1, y1)]
