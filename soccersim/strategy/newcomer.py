"""Newcomer: who can have the ball first goes for it, passes and shoots; the others keep places."""

from typing import Any

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills

# m, where field players stand while the ball is in the middle
PLACES = ((-6.0, -1.5), (-4.0, 2.0), (2.5, -3.5), (4.0, 2.5))


class Newcomer(Strategy):
    """A team to start from. decide() is asked 25 times a second; change it as you like."""

    def __init__(self, rng: Any, far_shot: float = 6.0) -> None:
        super().__init__(rng)
        self.far_shot = far_shot  # m from the goal; an option, which a scenario may set

    def decide(self, view: View) -> list[Command]:
        """One command a robot, in the order of view.robots."""
        field_players = [robot for robot in view.robots if robot.role != "keeper"]
        first = skills.quickest(view, field_players)
        return [self.command(view, robot, robot is first) for robot in view.robots]

    def command(self, view: View, robot: Player, is_first: bool) -> Command:
        """What one robot does."""
        if robot.role == "keeper":
            return skills.block(view, robot, out=0.6)
        if view.phase is not Phase.PLAY:
            return self.restart(view, robot, is_first)
        if is_first:
            return self.attack(view, robot)
        return skills.go_to(view, robot, *self.place(view, robot), area=False)

    def attack(self, view: View, robot: Player) -> Command:
        """Get the ball; with it shoot, pass, or kick it ahead."""
        if not robot.has_ball:
            return skills.intercept(view, robot)
        goal = view.field.length / 2
        if skills.distance(robot, goal, 0.0) < self.far_shot:
            return skills.shoot(view, robot)
        mate, _ = skills.best_pass(view, robot)
        if mate:
            return skills.pass_to(view, robot, mate)
        return skills.kick_at(view, robot, goal, robot.y, speed=4.0, sure=0.1)

    def restart(self, view: View, robot: Player, takes: bool) -> Command:
        """Before the ball is in play: take the kick if it is ours, or keep away from it."""
        x, y = self.place(view, robot)
        mates = [each for each in view.robots if each.role != "keeper"]
        mate = skills.nearest((each for each in mates if each is not robot), x, y)
        if not (view.ours and takes and mate):
            return skills.keep_distance(view, robot, x, y)
        if view.started:
            return skills.pass_to(view, robot, mate)
        return skills.stand_ready(view, robot, mate.x, mate.y)

    def place(self, view: View, robot: Player) -> tuple[float, float]:
        """Where a robot without the ball stands: its place, moved along with the ball."""
        x, y = PLACES[robot.number % len(PLACES)]
        return (x + view.ball.x / 2, y) if view.ball else (x, y)
