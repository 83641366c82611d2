"""Omnidirectional cameras: what each robot's frame shows of itself, the ball and the opponents.

A frame holds what was believed at its moment beside what it shows, because it is worked on later.
Nothing hides anything, and nothing is taken for something else.
"""

from collections.abc import Sequence
from math import radians, sqrt
from typing import NamedTuple

import numpy as np

from soccersim.geometry import rotate
from soccersim.kernel import inner
from soccersim.sensing.noise import BLOCK
from soccersim.spec.senses import Senses, Sight
from soccersim.state import Array, Whole
from soccersim.streams import stream

RANGE, RADIAL, TANGENTIAL, DROPOUT = 0, 1, 4, 7  # where a sight's numbers stand
UNMADE = -1  # number of a frame that has not been taken


class Camera(NamedTuple):
    """How well the cameras see; all take their frames at the same moments."""

    every: int  # ticks from frame to frame
    dropout: float  # chance that a whole frame is lost
    report_loss: float  # chance that what a robot sends of it is lost
    scale: Array  # (R,) relative error of all distances
    ball: Array  # (8,) range m, a b c of the radial spread, a b c of the tangential, dropout
    opponents: Array  # (8,) the same
    lines: Array  # (3,) standard deviation m, rad, dropout of the own pose


class Draws(NamedTuple):
    """Chance of the next frames: frame n uses row n % BLOCK."""

    frame: Array  # (BLOCK, R) uniform in [0, 1)
    report: Array  # (BLOCK, R) uniform
    pose: Array  # (BLOCK, R, 4) three standard normals, a uniform
    ball: Array  # (BLOCK, R, 3) two standard normals, a uniform
    other: Array  # (BLOCK, R, R, 3) the same, of each robot that may be seen


class Frames(NamedTuple):
    """The last frames of all robots, a ring: frame n stands in slot n % D."""

    number: Whole  # (D,) which frame; -1: none
    alive: Whole  # (D, R) 1: the robot was playing, and has not been carried since
    sent: Whole  # (D, R) 1: what it reports of the frame arrives
    pose: Array  # (D, R, 3) believed then, with the corrections made since; field frame
    doubt: Array  # (D, R, 3) variance of that pose, m2, m2, rad2
    twist: Array  # (D, R, 3) believed then; body frame
    contact: Whole  # (D, R) 1: the ball was in its mouth
    fixed: Whole  # (D, R) 1: the lines told the pose
    fix: Array  # (D, R, 3) x, y, heading; field frame
    ball_seen: Whole  # (D, R)
    ball: Array  # (D, R, 2) m; body frame
    seen: Whole  # (D, R, R) 1: robot (second) saw robot (third)
    other: Array  # (D, R, R, 2) m; body frame of the one who saw


def build_camera(senses: Senses, robots: int, physics_hz: int, seed: int) -> Camera:
    """The cameras, each with its own error of scale drawn."""
    spec = senses.camera
    drawn = [stream(seed, i, "camera.build").standard_normal() for i in range(robots)]
    lines = spec.lines
    return Camera(
        every=physics_hz // spec.rate_hz,
        dropout=spec.dropout,
        report_loss=senses.radio.report_loss,
        scale=spec.scale_sd * np.array(drawn, float),
        ball=_sight(spec.ball),
        opponents=_sight(spec.opponents),
        lines=np.array([lines.distance_sd, radians(lines.heading_sd_deg), lines.dropout]),
    )


def _sight(spec: Sight) -> Array:
    return np.array([spec.range, *spec.radial, *spec.tangential, spec.dropout])


def new_frames(depth: int, robots: int) -> Frames:
    """No frame taken; depth is how many are under way at most."""
    whole, z = np.int64, np.zeros
    one, all_ = (depth, robots), (depth, robots, robots)
    return Frames(
        number=np.full(depth, UNMADE),
        alive=z(one, whole),
        sent=z(one, whole),
        pose=z((*one, 3)),
        doubt=z((*one, 3)),
        twist=z((*one, 3)),
        contact=z(one, whole),
        fixed=z(one, whole),
        fix=z((*one, 3)),
        ball_seen=z(one, whole),
        ball=z((*one, 2)),
        seen=z(all_, whole),
        other=z((*all_, 2)),
    )


class DrawSource:
    """Keeps the draws filled: one stream for each robot and thing seen."""

    def __init__(self, teams: Sequence[int], seed: int) -> None:
        count = len(teams)
        shape = (BLOCK, count)
        z = np.zeros
        self.draws = Draws(
            z(shape), z(shape), z((*shape, 4)), z((*shape, 3)), z((*shape, count, 3))
        )
        self._drawn = 0  # blocks so far
        self._flat: list[tuple[np.random.Generator, Array]] = []
        self._mixed: list[tuple[np.random.Generator, Array]] = []
        for i, team in enumerate(teams):
            for name, flat in (
                ("camera.frame", self.draws.frame),
                ("radio.report", self.draws.report),
            ):
                self._flat.append((stream(seed, i, name), flat[:, i]))
            for name, mixed in (("camera.pose", self.draws.pose), ("camera.ball", self.draws.ball)):
                self._mixed.append((stream(seed, i, name), mixed[:, i]))
            for j, other in enumerate(teams):
                if other != team:
                    source = stream(seed, i, f"camera.robot.{j}")
                    self._mixed.append((source, self.draws.other[:, i, j]))

    def prepare(self, number: int) -> None:
        """Draw what frame `number` needs."""
        while self._drawn <= number // BLOCK:
            for source, column in self._flat:
                column[:] = source.random(BLOCK)
            for source, columns in self._mixed:
                columns[:, :-1] = source.standard_normal((BLOCK, columns.shape[1] - 1))
                columns[:, -1] = source.random(BLOCK)
            self._drawn += 1


@inner
def take_frames(
    camera: Camera,
    draws: Draws,
    frames: Frames,
    body: Array,
    contact: Whole,
    pose: Array,
    twist: Array,
    team: Whole,
    playing: Whole,
    number: int,
) -> None:
    """Every robot's frame of this moment; body (B, 6) has the robots' rows, then the ball's.

    pose and twist (R, 3) are the robots' beliefs, team and playing (R,) who is whose and plays.
    """
    slot, row = number % frames.number.shape[0], number % BLOCK
    frames.number[slot] = number
    robots = pose.shape[0]
    for i in range(robots):
        for k in range(3):
            frames.pose[slot, i, k], frames.twist[slot, i, k] = pose[i, k], twist[i, k]
        frames.contact[slot, i] = contact[i]
        frames.alive[slot, i] = playing[i]
        frames.sent[slot, i] = 1 if draws.report[row, i] >= camera.report_loss else 0
        whole = playing[i] == 1 and draws.frame[row, i] >= camera.dropout
        found = _find_itself(camera.lines, draws.pose[row, i], body[i], frames.fix[slot, i])
        frames.fixed[slot, i] = 1 if whole and found else 0
        scale, at = camera.scale[i], frames.ball[slot, i]
        found = _look(camera.ball, scale, draws.ball[row, i], body, i, robots, at)
        frames.ball_seen[slot, i] = 1 if whole and found else 0
        for j in range(robots):
            there = whole and playing[j] == 1 and team[j] != team[i]
            draw, at = draws.other[row, i, j], frames.other[slot, i, j]
            found = there and _look(camera.opponents, scale, draw, body, i, j, at)
            frames.seen[slot, i, j] = 1 if found else 0


@inner
def _find_itself(lines: Array, draw: Array, pose: Array, fix: Array) -> bool:
    """Leave in fix (3,) what the lines tell of a robot's pose, field frame; whether they do.

    The error is the robot's own, in its body frame: the game turned round has it turned too.
    """
    dx, dy = rotate(lines[0] * draw[0], lines[0] * draw[1], pose[2])  # body to field
    fix[0], fix[1], fix[2] = pose[0] + dx, pose[1] + dy, pose[2] + lines[1] * draw[2]
    return bool(draw[3] >= lines[2])


@inner
def _look(
    sight: Array, scale: float, draw: Array, body: Array, robot: int, thing: int, at: Array
) -> bool:
    """Leave in at (2,) where a robot sees a thing, body frame; whether it does."""
    x, y = body[thing, 0] - body[robot, 0], body[thing, 1] - body[robot, 1]
    distance = sqrt(x * x + y * y)
    if distance == 0.0 or distance > sight[RANGE] or draw[2] < sight[DROPOUT]:
        return False
    x, y = rotate(x / distance, y / distance, -body[robot, 2])  # field to body
    along = distance * (1.0 + scale) + spread(sight, RADIAL, distance) * draw[0]
    across = spread(sight, TANGENTIAL, distance) * draw[1]
    at[0], at[1] = x * along - y * across, y * along + x * across
    return True


@inner
def spread(sight: Array, kind: int, distance: float) -> float:
    """Standard deviation at a distance, m: a + b d + c d2."""
    return float(sight[kind] + distance * (sight[kind + 1] + distance * sight[kind + 2]))
