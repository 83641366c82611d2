"""The mates of somebody at the keys: they keep the goal, stand free, and leave the ball to him.

`soccersim live friendly-match --home human --away chaser --window`: the robot that he drives does
not hear this team. Which one that is he chooses as the match goes on, so all leave the ball alone.

Its strength: a pass finds somebody. Its weakness: without the human nothing happens at all.
"""

from collections.abc import Sequence
from dataclasses import replace

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills
from soccersim.strategy.manners import careful

OUT = 0.9  # m before its line that the keeper stands
ASIDE = 2.0  # m from the ball, so that the human has room
SPOTS = ((-0.45, 0.0), (0.35, 0.5), (0.35, -0.5), (-0.1, 0.55))  # 1.0: half of length, of width


class Human(Strategy):
    """A keeper, and field players who wait in good places."""

    def decide(self, view: View) -> Sequence[Command]:
        """Nobody goes for the ball."""
        team = [player for player in view.robots if player.role == "field"]
        spots = {player.number: SPOTS[row % len(SPOTS)] for row, player in enumerate(team)}
        return [
            skills.block(view, player, 0.0 if view.phase is Phase.PENALTY else OUT)
            if player.role == "keeper"
            else wait(view, player, *spots[player.number])
            for player in view.robots
        ]


def wait(view: View, player: Player, x: float, y: float) -> Command:
    """Stand there, and look at the ball."""
    at = x * view.field.length / 2.0, y * view.field.width / 2.0
    if view.phase is not Phase.PLAY:
        command = skills.keep_distance(view, player, *at)
    else:
        discs = [(view.ball.x, view.ball.y, ASIDE)] if view.ball else []
        command = skills.go_to(view, player, *at, keep_off=discs, area=False)
    return replace(careful(view, player, command), label="waits")
