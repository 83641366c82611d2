"""From knowledge to the sheet of a decision: brought forward to now, in the team's frame."""

from math import pi

from soccersim.estimation.ball_track import UNSEEN, rolled
from soccersim.estimation.opponents import FREE
from soccersim.geometry import rotate, se2_arc, wrap_angle
from soccersim.kernel import inner, kernel
from soccersim.perception.mind import Mind
from soccersim.sheet import BALL, BALL_KNOWN, HEADER, OPPONENT, OPPONENTS_KNOWN, ROBOT
from soccersim.state import Array

FORESIGHT = 0.25  # s: for no longer is anybody believed to keep its velocity


@kernel
def tell(m: Mind, sheet: Array, slot: int, tick: int, dt: float) -> None:
    """Write ball, own robots and opponents of one team into its sheet (see soccersim.sheet)."""
    _tell_ball(m, sheet, slot, tick, dt)
    at = HEADER
    for robot in range(m.team.shape[0]):
        if m.team[robot] == slot:
            _tell_robot(m, sheet, at, robot, tick, dt)
            at += ROBOT
    known, way = 0, m.direction[slot]
    for k in range(m.opponents.most[slot]):
        if m.opponents.seen[slot, k] == FREE:
            continue
        state = m.opponents.state[slot, k]
        ahead = min((tick - m.opponents.time[slot]) * dt, FORESIGHT)
        sheet[at] = way * (state[0] + ahead * state[2])
        sheet[at + 1] = way * (state[1] + ahead * state[3])
        sheet[at + 2], sheet[at + 3] = way * state[2], way * state[3]
        sheet[at + 4] = (tick - m.opponents.seen[slot, k]) * dt
        at += OPPONENT
        known += 1
    sheet[OPPONENTS_KNOWN] = known


@inner
def _tell_ball(m: Mind, sheet: Array, slot: int, tick: int, dt: float) -> None:
    if m.balls.seen[slot] == UNSEEN:
        sheet[BALL_KNOWN] = 0.0
        return
    way, balls = m.direction[slot], m.balls
    ahead = (tick - balls.time[slot]) * dt
    x, y, vx, vy = rolled(balls.state[slot], ahead, balls.rolling)
    sheet[BALL_KNOWN] = 1.0
    sheet[BALL] = way * min(max(x, -m.walls[0]), m.walls[0])
    sheet[BALL + 1] = way * min(max(y, -m.walls[1]), m.walls[1])
    sheet[BALL + 2], sheet[BALL + 3] = way * vx, way * vy
    sheet[BALL + 4] = (tick - balls.seen[slot]) * dt


@inner
def _tell_robot(m: Mind, sheet: Array, at: int, robot: int, tick: int, dt: float) -> None:
    reports = m.reports
    age = (tick - reports.tick[robot]) * dt
    ahead = min(age, FORESIGHT) if m.playing[robot] == 1 else 0.0
    vx, vy, omega = reports.twist[robot, 0], reports.twist[robot, 1], reports.twist[robot, 2]
    x, y, heading = reports.pose[robot, 0], reports.pose[robot, 1], reports.pose[robot, 2]
    dx, dy = se2_arc(ahead * vx, ahead * vy, ahead * omega)
    dx, dy = rotate(dx, dy, heading)  # body to field
    way = m.direction[m.team[robot]]
    turned = 0.0 if way > 0.0 else pi
    sheet[at] = m.playing[robot]
    sheet[at + 1] = m.number[robot]
    sheet[at + 2] = m.keeper[robot]
    sheet[at + 3], sheet[at + 4] = way * (x + dx), way * (y + dy)
    sheet[at + 5] = wrap_angle(heading + ahead * omega + turned)
    sheet[at + 6], sheet[at + 7], sheet[at + 8] = vx, vy, omega
    sheet[at + 9] = reports.contact[robot]
    sheet[at + 10] = age
