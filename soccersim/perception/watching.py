"""From frames to knowledge: each robot corrects its pose, each team its picture of the game."""

from math import sqrt

from soccersim.estimation.ball_track import NEAR, UNSEEN, doubt, expect, notice
from soccersim.estimation.localisation import carry, correction, lose
from soccersim.estimation.opponents import FREE, drive_on, join, meet
from soccersim.estimation.track import Sighting
from soccersim.geometry import rotate
from soccersim.kernel import inner, kernel
from soccersim.perception.mind import Mind
from soccersim.sensing.camera import RADIAL, TANGENTIAL, spread, take_frames
from soccersim.state import Array, Whole

NOBODY = -1
LEAST = 1e-6  # m2: no sighting counts as surer than a millimetre


@kernel
def perceive(
    m: Mind, body: Array, contact: Whole, pose: Array, twist: Array, tick: int, dt: float
) -> None:
    """One step: take this tick's frame if one is due, work on those that are ready, hear reports.

    body (R + 1, 6) and contact (R,) are what is so, pose and twist (R, 3) what the robots believe;
    pose is corrected.
    """
    every = m.camera.every
    if tick % every == 0:
        take_frames(
            m.camera,
            m.draws,
            m.frames,
            body,
            contact,
            pose,
            twist,
            m.team,
            m.playing,
            tick // every,
        )
    while m.done[0] * every + m.lag[0] <= tick:
        _work_on(m, m.done[0], pose, every * dt)
        m.done[0] += 1
    while m.done[1] * every + m.lag[1] <= tick:
        _hear(m, 0, m.done[1], dt)
        _hear(m, 1, m.done[1], dt)
        m.done[1] += 1


@inner
def _work_on(m: Mind, number: int, pose: Array, seconds: float) -> None:
    """Every robot's own pose from a frame, and with it all it has believed since."""
    frames = m.frames
    at = number % frames.number.shape[0]
    if frames.number[at] != number:
        return
    for robot in range(pose.shape[0]):
        if frames.alive[at, robot] == 0:
            continue
        lose(m.localisation, robot, frames.twist[at, robot], seconds)
        if frames.fixed[at, robot] == 1:
            then = frames.pose[at, robot]
            x, y = then[0], then[1]
            dx, dy, turn = correction(m.localisation, robot, then, frames.fix[at, robot])
            carry(pose, robot, x, y, dx, dy, turn)
            for d in range(frames.number.shape[0]):
                if frames.number[d] >= number and frames.alive[d, robot] == 1:
                    carry(frames.pose[d], robot, x, y, dx, dy, turn)
        for k in range(3):
            frames.doubt[at, robot, k] = m.localisation.variance[robot, k]


@inner
def _hear(m: Mind, slot: int, number: int, dt: float) -> None:
    """A team takes in the reports on one frame."""
    frames = m.frames
    at = number % frames.number.shape[0]
    if frames.number[at] != number:
        return
    tick = number * m.camera.every
    for robot in range(m.team.shape[0]):
        if _told(m, slot, at, robot):
            for k in range(3):
                m.reports.pose[robot, k] = frames.pose[at, robot, k]
                m.reports.twist[robot, k] = frames.twist[at, robot, k]
            m.reports.contact[robot] = frames.contact[at, robot]
            m.reports.tick[robot] = tick
    if tick > m.balls.since[slot]:
        _find_ball(m, slot, at, tick, dt)
    if tick > m.opponents.since[slot]:
        _find_opponents(m, slot, at, tick, number)


@inner
def _told(m: Mind, slot: int, at: int, robot: int) -> bool:
    """Whether a robot of this team reports on the frame."""
    mine = m.team[robot] == slot
    return bool(mine and m.frames.alive[at, robot] == 1 and m.frames.sent[at, robot] == 1)


@inner
def _find_ball(m: Mind, slot: int, at: int, tick: int, dt: float) -> None:
    """The team's track of the ball, from the sightings of all its robots."""
    surest, least = NOBODY, 0.0
    for robot in range(m.team.shape[0]):
        if _told(m, slot, at, robot) and m.frames.ball_seen[at, robot] == 1:
            sighting = _sighting(m, at, robot, m.camera.ball, m.frames.ball[at, robot])
            spread_ = sighting.along + sighting.across
            if surest == NOBODY or spread_ < least:
                surest, least = robot, spread_
    if surest == NOBODY:
        return
    if m.balls.seen[slot] != UNSEEN:
        expect(m.balls, slot, tick, _crowded(m, slot))
        sighting = _sighting(m, at, surest, m.camera.ball, m.frames.ball[at, surest])
        doubt(m.balls, slot, sighting, m.camera.every * dt)
    for robot in range(m.team.shape[0]):
        if _told(m, slot, at, robot) and m.frames.ball_seen[at, robot] == 1:
            sighting = _sighting(m, at, robot, m.camera.ball, m.frames.ball[at, robot])
            notice(m.balls, slot, tick, sighting)


@inner
def _crowded(m: Mind, slot: int) -> bool:
    """Whether somebody the team knows of is near the ball it believes in."""
    x, y = m.balls.state[slot, 0], m.balls.state[slot, 1]
    for robot in range(m.team.shape[0]):
        if m.team[robot] == slot and m.playing[robot] == 1:
            dx, dy = m.reports.pose[robot, 0] - x, m.reports.pose[robot, 1] - y
            if dx * dx + dy * dy < NEAR * NEAR:
                return True
    for k in range(m.opponents.most[slot]):
        if m.opponents.seen[slot, k] != FREE:
            dx, dy = m.opponents.state[slot, k, 0] - x, m.opponents.state[slot, k, 1] - y
            if dx * dx + dy * dy < NEAR * NEAR:
                return True
    return False


@inner
def _find_opponents(m: Mind, slot: int, at: int, tick: int, number: int) -> None:
    """The team's tracks of its opponents."""
    robots = m.team.shape[0]
    drive_on(m.opponents, slot, tick)
    for robot in range(robots):
        if not _told(m, slot, at, robot):
            continue
        for other in range(robots):
            if m.frames.seen[at, robot, other] == 1:
                place = m.frames.other[at, robot, other]
                sighting = _sighting(m, at, robot, m.camera.opponents, place)
                meet(m.opponents, slot, tick, number * robots + robot, sighting)
    join(m.opponents, slot)


@inner
def _sighting(m: Mind, at: int, robot: int, sight: Array, place: Array) -> Sighting:
    """What a robot saw at a place (2,) in its body frame, in the field frame by its own pose."""
    pose, sure = m.frames.pose[at, robot], m.frames.doubt[at, robot]
    distance = sqrt(place[0] * place[0] + place[1] * place[1])
    x, y = rotate(place[0], place[1], pose[2])  # body to field
    radial, scale = spread(sight, RADIAL, distance), m.scale * distance
    tangential = spread(sight, TANGENTIAL, distance)
    own = 0.5 * (sure[0] + sure[1]) + LEAST
    return Sighting(
        pose[0] + x,
        pose[1] + y,
        x / distance,
        y / distance,
        own + radial * radial + scale * scale,
        own + tangential * tangential + distance * distance * sure[2],
    )


@kernel
def reveal(m: Mind, body: Array, contact: Whole, tick: int) -> None:
    """Let both teams know what is so: body (B, 6) and contact (R,) at this tick."""
    robots = m.team.shape[0]
    for robot in range(robots):
        vx, vy = rotate(body[robot, 3], body[robot, 4], -body[robot, 2])  # field to body
        m.reports.twist[robot, 0], m.reports.twist[robot, 1] = vx, vy
        m.reports.twist[robot, 2] = body[robot, 5]
        for k in range(3):
            m.reports.pose[robot, k] = body[robot, k]
        m.reports.contact[robot] = contact[robot]
        m.reports.tick[robot] = tick
    for slot in range(2):
        m.balls.state[slot, 0], m.balls.state[slot, 1] = body[robots, 0], body[robots, 1]
        m.balls.state[slot, 2], m.balls.state[slot, 3] = body[robots, 3], body[robots, 4]
        m.balls.time[slot] = m.balls.seen[slot] = m.opponents.time[slot] = tick
        known = 0
        for robot in range(robots):
            if m.team[robot] != slot:
                state = m.opponents.state[slot, known]
                state[0], state[1] = body[robot, 0], body[robot, 1]
                state[2], state[3] = body[robot, 3], body[robot, 4]
                m.opponents.seen[slot, known] = tick if m.playing[robot] == 1 else FREE
                known += 1
