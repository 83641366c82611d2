"""Foxglove's well-known messages as JSON Schema, as far as a log of ours fills them.

Foxglove knows a message by its schema's name and reads the fields by theirs. The schemas are
written here from the fields that it documents; fields that it has and we never fill are left out.
Source: https://docs.foxglove.dev/docs/visualization/message-schemas
"""

import json
from typing import Any

Schema = dict[str, Any]

NUMBER: Schema = {"type": "number"}
TEXT: Schema = {"type": "string"}
FLAG: Schema = {"type": "boolean"}


def message(title: str, **fields: Schema) -> Schema:
    """An object with these fields, all of which must be there."""
    named = {"title": title} if title else {}
    return {**named, "type": "object", "properties": fields, "required": list(fields)}


def several(kind: Schema) -> Schema:
    """A list of them."""
    return {"type": "array", "items": kind}


def one_of(title: str, **values: int) -> Schema:
    """A number that stands for a word."""
    return {"title": title, "oneOf": [{"title": k, "const": v} for k, v in values.items()]}


def _span(title: str, least: dict[str, int]) -> Schema:
    nsec = {"type": "integer", "minimum": 0, "maximum": 999_999_999}
    properties = {"sec": {"type": "integer", **least}, "nsec": nsec}
    return {"type": "object", "title": title, "properties": properties}


TIME = _span("time", {"minimum": 0})
DURATION = _span("duration", {})
VECTOR = message("foxglove.Vector3", x=NUMBER, y=NUMBER, z=NUMBER)
POINT = message("foxglove.Point3", x=NUMBER, y=NUMBER, z=NUMBER)
QUATERNION = message("foxglove.Quaternion", x=NUMBER, y=NUMBER, z=NUMBER, w=NUMBER)
POSE = message("foxglove.Pose", position=VECTOR, orientation=QUATERNION)
COLOUR = message("foxglove.Color", r=NUMBER, g=NUMBER, b=NUMBER, a=NUMBER)

TRANSFORM = message(
    "foxglove.FrameTransform",
    timestamp=TIME,
    parent_frame_id=TEXT,
    child_frame_id=TEXT,
    translation=VECTOR,
    rotation=QUATERNION,
)
TRANSFORMS = message("foxglove.FrameTransforms", transforms=several(TRANSFORM))
POSE_IN_FRAME = message("foxglove.PoseInFrame", timestamp=TIME, frame_id=TEXT, pose=POSE)
POSES_IN_FRAME = message(
    "foxglove.PosesInFrame", timestamp=TIME, frame_id=TEXT, poses=several(POSE)
)
JOINT = message("foxglove.JointState", name=TEXT, position=NUMBER)
JOINTS = message("foxglove.JointStates", timestamp=TIME, joints=several(JOINT))
LEVELS = {"UNKNOWN": 0, "DEBUG": 1, "INFO": 2, "WARNING": 3, "ERROR": 4, "FATAL": 5}
LOG = message(
    "foxglove.Log",
    timestamp=TIME,
    level=one_of("foxglove.LogLevel", **LEVELS),
    message=TEXT,
    name=TEXT,
    file=TEXT,
    line={"type": "integer", "minimum": 0},
)

LINE = message(
    "foxglove.LinePrimitive",
    type=one_of("foxglove.LineType", LINE_STRIP=0, LINE_LOOP=1, LINE_LIST=2),
    pose=POSE,
    thickness=NUMBER,
    scale_invariant=FLAG,
    points=several(POINT),
    color=COLOUR,
    colors=several(COLOUR),
    indices=several({"type": "integer", "minimum": 0}),
)
CUBE = message("foxglove.CubePrimitive", pose=POSE, size=VECTOR, color=COLOUR)
SPHERE = message("foxglove.SpherePrimitive", pose=POSE, size=VECTOR, color=COLOUR)
CYLINDER = message(
    "foxglove.CylinderPrimitive",
    pose=POSE,
    size=VECTOR,
    bottom_scale=NUMBER,
    top_scale=NUMBER,
    color=COLOUR,
)
LABEL = message(
    "foxglove.TextPrimitive",
    pose=POSE,
    billboard=FLAG,
    font_size=NUMBER,
    scale_invariant=FLAG,
    color=COLOUR,
    text=TEXT,
)
NEVER_FILLED: Schema = {"type": "array", "maxItems": 0}
PRIMITIVES = {
    "arrows": NEVER_FILLED,
    "cubes": several(CUBE),
    "spheres": several(SPHERE),
    "cylinders": several(CYLINDER),
    "lines": several(LINE),
    "triangles": NEVER_FILLED,
    "texts": several(LABEL),
    "models": NEVER_FILLED,
}
ENTITY = message(
    "foxglove.SceneEntity",
    timestamp=TIME,
    frame_id=TEXT,
    id=TEXT,
    lifetime=DURATION,
    frame_locked=FLAG,
    metadata=several(message("foxglove.KeyValuePair", key=TEXT, value=TEXT)),
    **PRIMITIVES,
)
DELETION = message(
    "foxglove.SceneEntityDeletion",
    timestamp=TIME,
    type=one_of("foxglove.SceneEntityDeletionType", MATCHING_ID=0, ALL=1),
    id=TEXT,
)
SCENE = message("foxglove.SceneUpdate", deletions=several(DELETION), entities=several(ENTITY))

MAYBE: Schema = {"type": ["number", "null"]}
TWIST = message("", vx=NUMBER, vy=NUMBER, omega=NUMBER)
PLACE = message("", x=NUMBER, y=NUMBER, heading=NUMBER)
STATE = {  # of ours: what there is to plot of a robot; what a recording lacks is left out
    **message("soccersim.Robot", timestamp=TIME, true=PLACE, believed=PLACE),
    "properties": {
        "timestamp": TIME,
        "true": PLACE,
        "believed": PLACE,
        "error": message("", position=NUMBER, heading=NUMBER),
        "twist": TWIST,
        "command": TWIST,
        "kick": NUMBER,
        "dribble": FLAG,
        "in_play": FLAG,
        "label": TEXT,
        "leg": {"type": "integer"},
        "reference": message("", x=MAYBE, y=MAYBE, heading=MAYBE),
        **{
            key: several(NUMBER)
            for key in ("wheel_speed", "wheel_setpoint", "slip", "load", "counts", "pwm")
        },
        "gyro": NUMBER,
    },
}
GAME = message(  # of ours: the state of a match
    "soccersim.Game",
    timestamp=TIME,
    phase=TEXT,
    whose=TEXT,
    started=FLAG,
    score=message("", home={"type": "integer"}, away={"type": "integer"}),
)


def coded(schema: Schema) -> bytes:
    """As it is written to the file."""
    return json.dumps(schema, separators=(",", ":")).encode()
