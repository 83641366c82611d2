"""A recording as an MCAP log with Foxglove's messages: Foxglove, Lichtblick and others open it."""

import json
from collections.abc import Callable, Iterator
from heapq import merge
from itertools import takewhile
from math import inf
from operator import itemgetter
from os import PathLike, fspath
from typing import Any

from soccersim.export import schemas
from soccersim.export.frames import DIGITS, MAP, between, nanosecond, placed, ros_names, stamp
from soccersim.export.happenings import happenings
from soccersim.export.primitives import scene
from soccersim.export.remarks import labels, notes
from soccersim.export.scene import field_entities, other_entities, robot_entities
from soccersim.export.sightings import sightings
from soccersim.export.state import game, states
from soccersim.problems import InputError, MachineError, Problem
from soccersim.record.recording import Recording
from soccersim.render.cut import shown

Progress = Callable[[int, int], None]  # how many records are done, of how many
Message = tuple[str, Any]  # topic and content
PIECE = 250  # records turned at once: bounds the memory of a long match


def save_mcap(
    recording: Recording,
    path: str | PathLike[str],
    progress: Progress | None = None,
    start: float | None = None,
    end: float | None = None,
) -> int:
    """Write the log and say how many messages it has; the same recording gives the same bytes.

    Times count from the beginning of the run. start and end: only what is between, in seconds.
    """
    writer_of, hz = mcap_writer(), int(recording.meta["physics_hz"])
    records = shown(recording, start, end)
    try:
        with open(path, "wb") as file:
            writer = writer_of(file)
            writer.start(profile="", library=f"soccersim {recording.meta['soccersim']}")
            writer.add_metadata("soccersim", _about(recording))
            log, count = _Topics(writer), 0
            for tick, topic, content in _messages(recording, records, progress):
                count += 1
                log.add(topic, content, nanosecond(tick, hz), count)
            writer.finish()
    except OSError as error:
        raise MachineError(f"{fspath(path)}: {error.strerror or error}") from error
    return count


def mcap_writer() -> Any:
    """The class of the mcap library that writes logs; InputError where it is not installed."""
    try:
        from mcap.writer import Writer
    except ImportError:
        missing = "a log needs mcap, which is not installed: pip install 'soccersim[log]'"
        raise InputError(Problem(missing)) from None
    return Writer


def _about(recording: Recording) -> dict[str, str]:
    about = {
        "scenario": recording.scenario.name,
        "seed": str(recording.meta["seed"]),
        "digest": recording.digest,
    }
    if match := recording.match:
        about |= {side: str(match[side]) for side in ("home", "away")}
    return about


class _Topics:
    """Channels of a log, made when the first message of a topic comes."""

    def __init__(self, writer: Any) -> None:
        self.writer = writer
        self.schemas: dict[str, int] = {}
        self.channels: dict[str, int] = {}

    def add(self, topic: str, content: Any, time: int, number: int) -> None:
        """Write one message; time in nanoseconds."""
        if topic not in self.channels:
            self.channels[topic] = self.writer.register_channel(topic, "json", self._schema(topic))
        data = json.dumps(content, allow_nan=False, separators=(",", ":")).encode()
        self.writer.add_message(self.channels[topic], time, data, time, number)

    def _schema(self, topic: str) -> int:
        schema = KINDS.get(topic) or KINDS[topic[topic.rindex("/") :]]
        title = schema["title"]
        if title not in self.schemas:
            coded = schemas.coded(schema)
            self.schemas[title] = self.writer.register_schema(title, "jsonschema", coded)
        return self.schemas[title]


KINDS = {  # topic, or its end: what stands there
    "/tf": schemas.TRANSFORMS,
    "/field": schemas.SCENE,
    "/robots": schemas.SCENE,
    "/believed": schemas.POSES_IN_FRAME,
    "/ball": schemas.POSE_IN_FRAME,
    "/state": schemas.STATE,
    "/game": schemas.GAME,
    "/joints": schemas.JOINTS,
    "/log": schemas.LOG,
    "/labels": schemas.SCENE,
    "/notes": schemas.SCENE,
    "/sightings": schemas.SCENE,
}


def _messages(
    recording: Recording, records: range, progress: Progress | None
) -> Iterator[tuple[int, str, Any]]:
    """Tick, topic and content of all messages, in order of time."""
    ticks = recording.tick.tolist()
    names = ros_names(player.name for player in recording.scenario.robots)
    arms = ros_names(arm.name for arm in recording.scenario.arms)
    first = ticks[records[0]] if records else 0
    last = ticks[records[-1]] if records and records[-1] + 1 < len(ticks) else inf
    yield first, "/field", scene(field_entities(recording.scenario.field))
    moving = robot_entities(recording, names) + other_entities(recording, arms)
    yield first, "/robots", scene(moving)
    sparse = _sparse(recording, names, first, from_start=not records.start)
    told = takewhile(lambda each: each[0] <= last, sparse)
    waiting = next(told, None)
    for done in range(0, len(records), PIECE):
        piece = records[done : done + PIECE]
        for index, messages in zip(piece, _piece(recording, piece, names, arms), strict=True):
            while waiting and waiting[0] < ticks[index]:
                yield waiting
                waiting = next(told, None)
            for topic, content in messages:
                yield ticks[index], topic, content
            if progress:
                progress(index - records[0] + 1, len(records))
    if waiting:
        yield waiting
    yield from told
    if progress:
        progress(1, 1)


def _sparse(
    recording: Recording, names: list[str], first: int, from_start: bool
) -> Iterator[tuple[int, str, Any]]:
    """Messages that do not come with every record, in order of time, none before a tick."""
    log = (
        (max(tick, first), "/log", content)
        for tick, content in happenings(recording)
        if tick >= first or from_start
    )
    said = labels(recording, names, first), notes(recording, first)
    return merge(log, *said, sightings(recording, first), key=itemgetter(0))


def _piece(
    recording: Recording, piece: range, names: list[str], arms: list[str]
) -> Iterator[list[Message]]:
    """All messages of each of some records."""
    part, hz = slice(piece.start, piece.stop), int(recording.meta["physics_hz"])
    robots = len(names)
    true = recording.body[part, :robots, :3].astype(float)
    belief = recording.estimate[part].astype(float)
    odom, believed = placed(between(true, belief)), placed(belief)
    ball = recording.ball
    balls = [] if ball is None else placed(ball[part, :3], recording.scenario.ball.radius)  # type: ignore[union-attr]
    links = placed(recording.links[part].reshape(len(piece), -1, 6)[..., :3]) if arms else []
    angles = recording.arrays["joint"][part] if arms and "joint" in recording.arrays else None
    teams, told = game(recording, part), states(recording, part)
    for row, tick in enumerate(recording.tick[part].tolist()):
        at = stamp(tick, hz)
        lies = []
        for robot, name in enumerate(names):
            lies.append((MAP, f"{name}/odom", odom[row][robot]))
            lies.append((f"{name}/odom", f"{name}/base_link", believed[row][robot]))
        if balls:
            lies.append((MAP, "ball", balls[row]))
        if links:
            children = [f"{arm}/link_{number}" for arm in arms for number in (1, 2, 3)]
            lies += [(MAP, child, pair) for child, pair in zip(children, links[row], strict=True)]
        messages = [
            ("/tf", {"transforms": [_transform(at, *each) for each in lies]}),
            ("/believed", {**_in_map(at), "poses": [_pose(pair) for pair in believed[row]]}),
        ]
        if balls:
            messages.append(("/ball", {**_in_map(at), "pose": _pose(balls[row])}))
        if angles is not None:
            messages.append(("/joints", {"timestamp": at, "joints": _joints(arms, angles[row])}))
        for topic, content in teams[row] if teams else ():
            pose = isinstance(content, tuple)
            more = {**_in_map(at), "pose": _pose(content)} if pose else {"timestamp": at, **content}
            messages.append((topic, more))
        for name, state in zip(names, told[row], strict=True):
            messages.append((f"/{name}/state", {"timestamp": at, **state}))
        yield messages


def _joints(arms: list[str], angles: Any) -> list[dict[str, Any]]:
    """Each arm's joints, from the base to the tip."""
    names = [f"{arm}/joint_{number}" for arm in arms for number in (1, 2, 3)]
    turned = (round(float(angle), DIGITS) for angle in angles.flat)
    return [{"name": n, "position": angle} for n, angle in zip(names, turned, strict=True)]


def _in_map(at: dict[str, int]) -> dict[str, Any]:
    return {"timestamp": at, "frame_id": MAP}


def _pose(pair: Any) -> dict[str, Any]:
    return {"position": pair[0], "orientation": pair[1]}


def _transform(at: dict[str, int], parent: str, child: str, pair: Any) -> dict[str, Any]:
    return {
        "timestamp": at,
        "parent_frame_id": parent,
        "child_frame_id": child,
        "translation": pair[0],
        "rotation": pair[1],
    }
