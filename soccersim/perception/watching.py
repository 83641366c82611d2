"""From frames to knowledge: each robot corrects its pose, each team its picture of the game."""

from math import sqrt

from soccersim.estimation.ball_track import NEAR, UNSEEN, doubt, expect, notice, settle
from soccersim.estimation.localisation import Localisation, carry, correction, lose
from soccersim.estimation.opponents import FREE, Opponents, drive_on, join, meet
from soccersim.estimation.track import Sighting
from soccersim.geometry import rotate
from soccersim.kernel import inner, kernel
from soccersim.perception.mind import Eyes, Known, Reports
from soccersim.sensing.camera import RADIAL, TANGENTIAL, Frames, spread, take_frames
from soccersim.state import Array, Whole

NOBODY = -1
AT_BOARD = 0.3  # m: the ball may rebound
LEAST = 1e-6  # m2: no sighting counts as surer than a millimetre


@kernel
def perceive(
    eyes: Eyes,
    known: Known,
    body: Array,
    contact: Whole,
    pose: Array,
    twist: Array,
    tick: int,
    dt: float,
) -> None:
    """One step: take this tick's frame if one is due, work on those that are ready, hear reports.

    body (R + 1, 6) and contact (R,) are what is so, pose and twist (R, 3) what the robots believe;
    pose is corrected.
    """
    frames, every = eyes.frames, eyes.camera.every
    if tick % every == 0:
        take_frames(
            eyes.camera,
            eyes.draws,
            frames,
            body,
            contact,
            pose,
            twist,
            known.team,
            known.playing,
            tick // every,
        )
    while eyes.done[0] * every + eyes.lag[0] <= tick:
        _work_on(frames, eyes.localisation, eyes.done[0], pose, every * dt)
        eyes.done[0] += 1
    while eyes.done[1] * every + eyes.lag[1] <= tick:
        number = eyes.done[1]
        at = number % frames.number.shape[0]
        if frames.number[at] == number:
            _hear(frames, known.reports, at, number * every)
            for slot in range(2):
                if number * every > known.balls.since[slot]:
                    _find_ball(eyes.camera.ball, eyes.scale, frames, known, slot, at, every, dt)
                if number * every > known.opponents.since[slot]:
                    drive_on(known.opponents, slot, number * every)
                    _find_opponents(
                        eyes.camera.opponents,
                        eyes.scale,
                        frames,
                        eyes.sights,
                        known.team,
                        known.opponents,
                        slot,
                        at,
                        number * every,
                    )
                    join(known.opponents, slot)
        eyes.done[1] += 1


@inner
def _work_on(
    frames: Frames, localisation: Localisation, number: int, pose: Array, seconds: float
) -> None:
    """Every robot's own pose from a frame, and with it all it has believed since."""
    at = number % frames.number.shape[0]
    if frames.number[at] != number:
        return
    for robot in range(pose.shape[0]):
        if frames.alive[at, robot] == 0:
            continue
        lose(localisation, robot, frames.twist[at, robot], seconds)
        if frames.fixed[at, robot] == 1:
            then = frames.pose[at, robot]
            x, y = then[0], then[1]
            dx, dy, turn = correction(localisation, robot, then, frames.fix[at, robot])
            carry(pose, robot, x, y, dx, dy, turn)
            for d in range(frames.number.shape[0]):
                if frames.number[d] >= number and frames.alive[d, robot] == 1:
                    carry(frames.pose[d], robot, x, y, dx, dy, turn)
        for k in range(3):
            frames.doubt[at, robot, k] = localisation.variance[robot, k]


@inner
def _hear(frames: Frames, reports: Reports, at: int, tick: int) -> None:
    """Reports on a frame that arrive; of a robot carried since then nothing is heard."""
    for robot in range(reports.pose.shape[0]):
        frames.sent[at, robot] *= frames.alive[at, robot]
        if frames.sent[at, robot] == 1:
            for k in range(3):
                reports.pose[robot, k] = frames.pose[at, robot, k]
                reports.twist[robot, k] = frames.twist[at, robot, k]
            reports.contact[robot] = frames.contact[at, robot]
            reports.tick[robot] = tick


@inner
def _find_ball(
    sight: Array,
    scale: float,
    frames: Frames,
    known: Known,
    slot: int,
    at: int,
    every: int,
    dt: float,
) -> None:
    """The team's track of the ball, from the sightings of all its robots."""
    surest, least = NOBODY, 0.0
    for robot in range(known.team.shape[0]):
        if _saw_ball(frames, known.team, slot, at, robot):
            sighting = _sighting(frames, at, robot, frames.ball[at, robot], sight, scale)
            if surest == NOBODY or sighting.along + sighting.across < least:
                surest, least = robot, sighting.along + sighting.across
    if surest == NOBODY:
        return
    tick = frames.number[at] * every
    if known.balls.seen[slot] != UNSEEN:
        x, y = known.balls.state[slot, 0], known.balls.state[slot, 1]
        expect(known.balls, slot, tick, _crowded(known, slot, x, y))
        sighting = _sighting(frames, at, surest, frames.ball[at, surest], sight, scale)
        doubt(known.balls, slot, sighting, every * dt)
    for robot in range(known.team.shape[0]):
        if _saw_ball(frames, known.team, slot, at, robot):
            sighting = _sighting(frames, at, robot, frames.ball[at, robot], sight, scale)
            notice(known.balls, slot, tick, sighting)
    settle(known.balls, slot)


@inner
def _saw_ball(frames: Frames, team: Whole, slot: int, at: int, robot: int) -> bool:
    """Whether a robot of this team reports on the ball."""
    told = team[robot] == slot and frames.sent[at, robot] == 1
    return bool(told and frames.ball_seen[at, robot] == 1)


@inner
def _crowded(known: Known, slot: int, x: float, y: float) -> bool:
    """Whether somebody the team knows of, or the board, is near a place."""
    if abs(x) > known.walls[0] - AT_BOARD or abs(y) > known.walls[1] - AT_BOARD:
        return True
    for robot in range(known.team.shape[0]):
        if known.team[robot] == slot and known.playing[robot] == 1:
            dx, dy = known.reports.pose[robot, 0] - x, known.reports.pose[robot, 1] - y
            if dx * dx + dy * dy < NEAR * NEAR:
                return True
    for k in range(known.opponents.most[slot]):
        if known.opponents.seen[slot, k] != FREE:
            state = known.opponents.state[slot, k]
            dx, dy = state[0] - x, state[1] - y
            if dx * dx + dy * dy < NEAR * NEAR:
                return True
    return False


@inner
def _find_opponents(
    sight: Array,
    scale: float,
    frames: Frames,
    sights: Array,
    team: Whole,
    opponents: Opponents,
    slot: int,
    at: int,
    tick: int,
) -> None:
    """The team's tracks of its opponents; sights (R, 6) is room for one robot's sightings."""
    robots = team.shape[0]
    for robot in range(robots):
        if team[robot] != slot or frames.sent[at, robot] == 0:
            continue
        count = 0
        for other in range(robots):
            if frames.seen[at, robot, other] == 1:
                place = frames.other[at, robot, other]
                s = _sighting(frames, at, robot, place, sight, scale)
                sights[count, 0], sights[count, 1] = s.x, s.y
                sights[count, 2], sights[count, 3] = s.ux, s.uy
                sights[count, 4], sights[count, 5] = s.along, s.across
                count += 1
        meet(opponents, slot, tick, robot, sights, count)


@inner
def _sighting(
    frames: Frames, at: int, robot: int, place: Array, sight: Array, scale: float
) -> Sighting:
    """What a robot saw at a place (2,) in its body frame, in the field frame by its own pose."""
    pose, sure = frames.pose[at, robot], frames.doubt[at, robot]
    distance = sqrt(place[0] * place[0] + place[1] * place[1])
    x, y = rotate(place[0], place[1], pose[2])  # body to field
    radial, tangential = spread(sight, RADIAL, distance), spread(sight, TANGENTIAL, distance)
    own, stretch = 0.5 * (sure[0] + sure[1]) + LEAST, scale * distance
    return Sighting(
        pose[0] + x,
        pose[1] + y,
        x / distance,
        y / distance,
        own + radial * radial + stretch * stretch,
        own + tangential * tangential + distance * distance * sure[2],
    )


@kernel
def reveal(known: Known, body: Array, contact: Whole, tick: int) -> None:
    """Let both teams know what is so: body (B, 6) and contact (R,) at this tick."""
    robots = known.team.shape[0]
    reports = known.reports
    for robot in range(robots):
        vx, vy = rotate(body[robot, 3], body[robot, 4], -body[robot, 2])  # field to body
        reports.twist[robot, 0], reports.twist[robot, 1] = vx, vy
        reports.twist[robot, 2] = body[robot, 5]
        for k in range(3):
            reports.pose[robot, k] = body[robot, k]
        reports.contact[robot] = contact[robot]
        reports.tick[robot] = tick
    for slot in range(2):
        _reveal_others(known, body, slot, robots, tick)


@inner
def _reveal_others(known: Known, body: Array, slot: int, robots: int, tick: int) -> None:
    """Ball and opponents of one team."""
    balls, opponents, met = known.balls, known.opponents, 0
    balls.state[slot, 0], balls.state[slot, 1] = body[robots, 0], body[robots, 1]
    balls.state[slot, 2], balls.state[slot, 3] = body[robots, 3], body[robots, 4]
    balls.time[slot] = balls.seen[slot] = opponents.time[slot] = tick
    for robot in range(robots):
        if known.team[robot] != slot:
            state = opponents.state[slot, met]
            state[0], state[1] = body[robot, 0], body[robot, 1]
            state[2], state[3] = body[robot, 3], body[robot, 4]
            opponents.seen[slot, met] = tick if known.playing[robot] == 1 else FREE
            met += 1
