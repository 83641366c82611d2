"""Which numbers of a recording go into the page, and how finely."""

from dataclasses import dataclass
from math import ceil

import numpy as np

from soccersim.record.recording import Recording
from soccersim.render.page.notes import PLACE, noted, places
from soccersim.render.page.pack import Array, Packer, Whole
from soccersim.render.story import Story


@dataclass(frozen=True)
class Finesse:
    """Steps, and rows a second: half a step is the largest error."""

    hz: int
    place: float  # m
    heading: float  # rad
    believed: float  # m
    speed: float  # m/s and rad/s, of commands
    sighted: float  # m, of where a camera put the ball


DEGREE = float(np.pi) / 180
FINEST = Finesse(50, 0.001, 0.1 * DEGREE, 0.002, 0.01, 0.02)  # a run, or a minute of a match
FINE = Finesse(25, 0.002, 0.25 * DEGREE, 0.005, 0.05, 0.05)
COARSE = Finesse(25, 0.005, 0.5 * DEGREE, 0.008, 0.1, 0.1)  # for restless teams in a long match
BALL = 0.01  # m, of where a team believes the ball to be
AGE = 0.02  # s


def frames(recording: Recording, hz: int) -> list[int]:
    """The records that are shown, always with the last."""
    count = len(recording.tick)
    every = max(1, round(recording.scenario.timing.record_hz / hz))
    shown = list(range(0, count, every))
    return shown if shown[-1] == count - 1 else [*shown, count - 1]


def channels(recording: Recording, story: Story | None, fine: Finesse, shown: list[int]) -> Packer:
    """All channels; docs/replay.md tells which."""
    packer = Packer(len(shown))
    packer.add("tick", recording.tick[shown])
    _add_bodies(packer, recording, fine, shown)
    if story:
        _add_match(packer, recording, story, fine, shown)
    else:
        _add_run(packer, recording, fine, shown)
    return packer


def _add_poses(packer: Packer, name: str, poses: Array, step: float, fine: Finesse) -> None:
    """x, y and heading (T, n, 3) as three channels."""
    packer.add(f"{name}_x", poses[..., 0], step)
    packer.add(f"{name}_y", poses[..., 1], step)
    packer.add(f"{name}_heading", poses[..., 2], fine.heading)


def _add_bodies(packer: Packer, recording: Recording, fine: Finesse, shown: list[int]) -> None:
    """Robots as they are and as they believe, the ball, the links of arms."""
    count = len(recording.scenario.robots)
    body, estimate = recording.body[shown].astype(float), recording.estimate[shown].astype(float)
    _add_poses(packer, "robot", body[:, :count], fine.place, fine)
    turn = 2 * np.pi  # a belief may have begun whole turns away
    off = np.rint((estimate[:1, :, 2] - body[:1, :count, 2]) / turn) * turn
    estimate[..., 2] -= off
    for axis, name in enumerate(("x", "y", "heading")):
        step = max(fine.heading, 0.25 * DEGREE) if name == "heading" else fine.believed
        packer.add(f"believed_{name}", estimate[..., axis], step, order=1, on=f"robot_{name}")
    ball = recording.ball
    if ball is not None:
        _add_poses(packer, "ball", ball[shown].astype(float)[:, None], fine.place, fine)
    if recording.scenario.arms:
        links = recording.links[shown].reshape(len(shown), -1, 6)
        _add_poses(packer, "link", links[..., :3], fine.place, fine)


def _add_match(
    packer: Packer, recording: Recording, story: Story, fine: Finesse, shown: list[int]
) -> None:
    """What was decided, and what both teams knew and ordered."""
    decision = np.array(story.decision, int)[shown]
    at = {key: recording.arrays[key][decision] for key in ("orders", "in_play", "contact")}
    order = at["orders"].astype(float)
    packer.add("command_x", order[..., 0], fine.speed, order=1)
    packer.add("command_y", order[..., 1], fine.speed, order=1)
    packer.add("command_turn", order[..., 2], fine.speed, order=1)
    packer.add("kick", order[..., 3], 0.1, order=1)
    packer.add("dribble", order[..., 4], order=1)
    packer.add("in_play", at["in_play"], order=1)
    packer.add("contact", at["contact"], order=1)
    seen = recording.arrays["ball_believed"][decision].astype(float)
    packer.add("seen_x", seen[..., 0], BALL, order=1)
    packer.add("seen_y", seen[..., 1], BALL, order=1)
    packer.add("seen_age", seen[..., 4], AGE, order=1)
    if np.isfinite(recording.arrays.get("ball_sighted", np.nan)).any():
        _add_sightings(packer, recording, fine, decision)
    for slot in (0, 1):
        told = noted(recording, slot, decision.tolist())
        packer.add(f"notes_{slot}", places(told), PLACE)
    packer.add("holder", np.array(story.holder)[shown], order=1)
    packer.add("direction", np.array(story.direction)[decision], order=1)
    possession = [story.possession(record) for record in shown]
    packer.add("possession", np.array([-1 if p is None else p for p in possession]), order=1)


def _add_sightings(packer: Packer, recording: Recording, fine: Finesse, decision: Whole) -> None:
    """Where each camera put the ball, from where it was when the picture was taken, or about then.

    A row tells the newest sighting since the row before.
    """
    sighted = recording.arrays["ball_sighted"]
    table = np.full((len(decision), *sighted.shape[1:]), np.nan)
    told = slice(0, decision[-1] + 1)
    row = np.searchsorted(decision, np.arange(told.stop))  # the first that tells of each decision
    at, robot = np.nonzero(np.isfinite(sighted[told, :, 0]))
    table[row[at], robot] = sighted[at, robot]
    then = np.maximum(np.arange(len(decision)) - late(recording, fine), 0)
    for axis, part in enumerate(("x", "y")):
        offset = table[..., axis] - packer.shown[f"ball_{part}"][then]
        packer.add(
            f"sighted_{part}", offset if part == "x" else np.nan_to_num(offset), fine.sighted, 0
        )


def late(recording: Recording, fine: Finesse) -> int:
    """How many rows a picture is old when the robot has worked on it, about."""
    return ceil(recording.scenario.senses.camera.delay * fine.hz)


def _add_run(packer: Packer, recording: Recording, fine: Finesse, shown: list[int]) -> None:
    """The plan that robots follow, and what the run recorded of their wheels."""
    arrays = recording.arrays
    packer.add("leg", recording.leg[shown], order=1)
    _add_poses(packer, "reference", recording.reference[shown], fine.place, fine)
    if "command" in arrays:
        for axis, name in enumerate(("x", "y", "turn")):
            packer.add(f"command_{name}", arrays["command"][shown][..., axis], fine.speed, order=1)
    for key, step, order in (
        ("wheel_speed", 0.05, 1),
        ("wheel_setpoint", 0.05, 1),
        ("pwm", 1.0, 1),
        ("counts", 1.0, 2),
        ("gyro", 0.001, 1),
    ):
        if key in arrays:
            packer.add(key, arrays[key][shown], step, order)
