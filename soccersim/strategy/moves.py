"""Going to places and turning, as Commands."""

from collections.abc import Sequence

from soccersim.strategy import paths
from soccersim.strategy.api import Command, Player, View
from soccersim.strategy.motion import drive_to, towards, turn_to


def go_to(
    view: View,
    player: Player,
    x: float,
    y: float,
    heading: float | None = None,
    *,
    speed: float | None = None,
    avoid: bool = True,
    keep_off: Sequence[tuple[float, float, float]] = (),
    area: bool = True,
) -> Command:
    """Go to a place and stop there.

    heading: to stand with; None: looking at the ball. speed: at most, m/s. avoid: round other
    robots. keep_off: discs (x, y, radius) that the robot's centre keeps out of. area: False keeps
    it out of the own penalty area.
    """
    beyond = 0.0
    if not area:
        x, y = paths.out_of_area(view, player, x, y)
        x, y, beyond = paths.round_area(view, player, x, y)
    discs = [*keep_off, *(paths.others(view, player) if avoid else ())]
    if discs:
        x, y, more, fast = paths.next_point(view, player, x, y, discs)
        beyond += more
        speed = fast if speed is None else min(speed, fast)
    if heading is None:
        heading = towards(player, view.ball.x, view.ball.y) if view.ball else player.heading
    return Command(*drive_to(player, x, y, heading, speed=speed, beyond=beyond))


def face(view: View, player: Player, x: float, y: float) -> Command:
    """Stand and turn towards a place."""
    return Command(omega=turn_to(player, towards(player, x, y)))
