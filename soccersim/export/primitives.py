"""What scenes are made of: Foxglove's boxes, cylinders, lines and words, in colours of ours."""

from math import cos, sin
from typing import Any

from soccersim.render import look

ROUND = 48  # corners of a circle
THIN = 0.002  # m, of what lies on the floor
UPRIGHT = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
NEVER = {"sec": 0, "nsec": 0}  # as a lifetime: for good
ALL = 1  # as the type of a deletion
KINDS = ("arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models")
Entity = dict[str, Any]
Place = tuple[float, float]


def scene(entities: list[Entity], instead: Any = None) -> dict[str, Any]:
    """The message that shows these entities, from a time on instead of all before them."""
    gone = [] if instead is None else [{"timestamp": instead, "type": ALL, "id": ""}]
    return {"deletions": gone, "entities": entities}


def entity(
    name: str, frame: str, at: Any = NEVER, lifetime: Any = NEVER, **parts: list[Any]
) -> Entity:
    """Something that moves with a frame, from a time on; parts by the names of KINDS."""
    said = {"timestamp": at, "frame_id": frame, "id": name, "lifetime": lifetime}
    every = {kind: parts.get(kind, []) for kind in KINDS}
    return {**said, "frame_locked": True, "metadata": [], **every}


def slab(middle: Place, size: Place, z: float, colour: look.Colour) -> dict[str, Any]:
    """A rectangle on the floor."""
    sides = {"x": float(size[0]), "y": float(size[1]), "z": THIN}
    return {"pose": lying(middle, z), "size": sides, "color": rgba(colour)}


def cylinder(pose: Any, size: dict[str, float], colour: look.Colour) -> dict[str, Any]:
    """An upright one."""
    whole = {"bottom_scale": 1.0, "top_scale": 1.0}
    return {"pose": pose, "size": size, **whole, "color": rgba(colour)}


def ball(place: Place, z: float, across: float, colour: look.Colour) -> dict[str, Any]:
    """A sphere with this diameter, its middle so high."""
    size = dict.fromkeys("xyz", across)
    return {"pose": lying(place, z), "size": size, "color": rgba(colour)}


def line(
    way: list[Place], width: float, colour: look.Colour = look.LINE, z: float = THIN
) -> dict[str, Any]:
    """A line through these places."""
    return {
        "type": 0,
        "pose": lying((0, 0), z),
        "thickness": width,
        "scale_invariant": False,
        "points": [{"x": float(x), "y": float(y), "z": 0.0} for x, y in way],
        "color": rgba(colour),
        "colors": [],
        "indices": [],
    }


def arc(middle: Place, radius: float, start: float, end: float) -> list[Place]:
    """Places on a circle, from angle to angle."""
    angles = [start + (end - start) * i / ROUND for i in range(ROUND + 1)]
    return [(middle[0] + radius * cos(a), middle[1] + radius * sin(a)) for a in angles]


def words(text: str, pose: Any, size: float, colour: look.Colour = look.INK) -> dict[str, Any]:
    """A text that faces whoever looks, its letters so many metres high."""
    return {
        "pose": pose,
        "billboard": True,
        "font_size": size,
        "scale_invariant": False,
        "color": rgba(colour),
        "text": text,
    }


def lying(place: Place, z: float = 0.0) -> dict[str, Any]:
    """A pose that is not turned."""
    position = {"x": float(place[0]), "y": float(place[1]), "z": z}
    return {"position": position, "orientation": UPRIGHT}


def rgba(colour: look.Colour) -> dict[str, float]:
    """A colour that hides what is behind."""
    r, g, b = (round(part / 255, 4) for part in colour)
    return {"r": r, "g": g, "b": b, "a": 1.0}
