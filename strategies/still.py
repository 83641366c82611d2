"""Does nothing: what every other team must beat."""

from collections.abc import Sequence

from soccersim.strategy import Command, Strategy, View


class Still(Strategy):
    """Five robots that stand where they are."""

    def decide(self, view: View) -> Sequence[Command]:
        """No robot moves."""
        return [Command() for _ in view.robots]
