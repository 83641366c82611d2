"""From knowledge to the sheet of a decision: brought forward to now, in the team's frame."""

from math import pi

from soccersim.estimation.ball_track import UNSEEN, BallTracks, gone_on
from soccersim.estimation.opponents import FREE
from soccersim.geometry import rotate, se2_arc, wrap_angle
from soccersim.kernel import inner, kernel
from soccersim.perception.mind import Known, Reports
from soccersim.sheet import BALL, BALL_KNOWN, HEADER, OPPONENT, OPPONENTS_KNOWN, ROBOT
from soccersim.state import Array

FORESIGHT = 0.25  # s: for no longer is anybody believed to keep its velocity


@kernel
def tell(known: Known, sheet: Array, slot: int, tick: int, dt: float) -> None:
    """Write ball, own robots and opponents of one team into its sheet (see soccersim.sheet)."""
    way = known.direction[slot]
    _tell_ball(known.balls, known.walls, sheet, slot, way, tick, dt)
    at = HEADER
    for robot in range(known.team.shape[0]):
        if known.team[robot] == slot:
            sheet[at] = known.playing[robot]
            sheet[at + 1] = known.number[robot]
            sheet[at + 2] = known.keeper[robot]
            _tell_robot(known.reports, sheet, at, robot, way, tick, dt)
            at += ROBOT
    opponents, met = known.opponents, 0
    for k in range(opponents.most[slot]):
        if opponents.seen[slot, k] == FREE:
            continue
        state = opponents.state[slot, k]
        ahead = min((tick - opponents.time[slot]) * dt, FORESIGHT)
        sheet[at] = way * (state[0] + ahead * state[2])
        sheet[at + 1] = way * (state[1] + ahead * state[3])
        sheet[at + 2], sheet[at + 3] = way * state[2], way * state[3]
        sheet[at + 4] = (tick - opponents.seen[slot, k]) * dt
        at += OPPONENT
        met += 1
    sheet[OPPONENTS_KNOWN] = met


@inner
def _tell_ball(
    balls: BallTracks, walls: Array, sheet: Array, slot: int, way: float, tick: int, dt: float
) -> None:
    if balls.seen[slot] == UNSEEN:
        sheet[BALL_KNOWN] = 0.0
        return
    x, y, vx, vy = gone_on(balls, slot, tick)
    sheet[BALL_KNOWN] = 1.0
    sheet[BALL] = way * min(max(x, -walls[0]), walls[0])
    sheet[BALL + 1] = way * min(max(y, -walls[1]), walls[1])
    sheet[BALL + 2], sheet[BALL + 3] = way * vx, way * vy
    sheet[BALL + 4] = (tick - balls.seen[slot]) * dt


@inner
def _tell_robot(
    reports: Reports, sheet: Array, at: int, robot: int, way: float, tick: int, dt: float
) -> None:
    """Pose, twist, contact and age; one that is not playing is where it was last."""
    age = (tick - reports.tick[robot]) * dt
    ahead = min(age, FORESIGHT) * sheet[at]
    vx, vy, omega = reports.twist[robot, 0], reports.twist[robot, 1], reports.twist[robot, 2]
    heading = reports.pose[robot, 2]
    dx, dy = se2_arc(ahead * vx, ahead * vy, ahead * omega)
    dx, dy = rotate(dx, dy, heading)  # body to field
    sheet[at + 3] = way * (reports.pose[robot, 0] + dx)
    sheet[at + 4] = way * (reports.pose[robot, 1] + dy)
    sheet[at + 5] = wrap_angle(heading + ahead * omega + (0.0 if way > 0.0 else pi))
    sheet[at + 6], sheet[at + 7], sheet[at + 8] = vx, vy, omega
    sheet[at + 9] = reports.contact[robot]
    sheet[at + 10] = age
