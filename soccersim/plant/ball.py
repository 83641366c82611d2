"""The ball on the floor: it slides until its turning has caught up with it, then it rolls.

The contact sees v - w, where w is the velocity at which the ball's own turning would carry it.
Sliding friction changes v by -mu g and w by +mu g / k along v - w (k = I / (m r2)), so a kicked
hollow ball (k = 2/3) rolls at 0.6 of its launch speed. Source: any text on a sliding ball, such as
Lewandowski, The Mechanics of Pool, with k left general.
"""

from math import sqrt
from typing import NamedTuple

from soccersim.kernel import kernel
from soccersim.spec.scenario import Scenario
from soccersim.state import Truth

GRAVITY = 9.81  # m/s2
REST_SPEED = 0.01  # m/s; slower, carpet stops it (as in ER-Force's simulator)


class Rolling(NamedTuple):
    """The ball's constants; mass 0 means that there is no ball."""

    mass: float  # kg
    shell: float  # I / (m r2)
    friction: float  # coefficient while sliding
    deceleration: float  # m/s2 while rolling
    row: int = -1  # of the ball in truth.body; the last one unless arms follow


def build_ball(scenario: Scenario) -> Rolling:
    """The ball of a scenario on its field."""
    ball, field = scenario.ball, scenario.field
    if ball is None:
        return Rolling(0.0, 1.0, 0.0, 0.0)
    row = len(scenario.robots)
    return Rolling(ball.mass, ball.shell, field.ball_friction, field.ball_rolling, row)


@kernel
def roll_ball(ball: Rolling, truth: Truth, dt: float) -> None:
    """Leave the floor's push on the ball in truth.wrench and its new turning in truth.ball_roll."""
    row = ball.row
    vx, vy = truth.body[row, 3], truth.body[row, 4]
    wx, wy = truth.ball_roll[0], truth.ball_roll[1]
    sx, sy = vx - wx, vy - wy
    slide = sqrt(sx * sx + sy * sy)
    loss = ball.friction * GRAVITY * dt  # of speed, while sliding
    gain = loss / ball.shell
    if slide > loss + gain:
        vx, vy = vx - loss * sx / slide, vy - loss * sy / slide
        wx, wy = wx + gain * sx / slide, wy + gain * sy / slide
    else:  # it rolls from now on, at the speed that keeps v + k w
        vx = (vx + ball.shell * wx) / (1.0 + ball.shell)
        vy = (vy + ball.shell * wy) / (1.0 + ball.shell)
        speed = sqrt(vx * vx + vy * vy)
        slower = speed - ball.deceleration * dt
        keep = slower / speed if slower > REST_SPEED else 0.0
        vx, vy = vx * keep, vy * keep
        wx, wy = vx, vy
    truth.wrench[row, 0] = ball.mass * ((vx - truth.body[row, 3]) / dt)
    truth.wrench[row, 1] = ball.mass * ((vy - truth.body[row, 4]) / dt)
    truth.wrench[row, 2] = 0.0
    truth.ball_roll[0], truth.ball_roll[1] = wx, wy
