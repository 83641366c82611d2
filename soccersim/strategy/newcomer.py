"""Newcomer: the nearest robot goes for the ball and shoots, the others keep their places."""

from soccersim.strategy import Command, Phase, Player, Strategy, View, skills


class Newcomer(Strategy):
    """A team to start from. decide() is asked 25 times a second; change it as you like."""

    def __init__(self, rng, far_shot=8.0):
        super().__init__(rng)
        self.far_shot = far_shot  # m from the goal; an option, which a scenario may set

    def decide(self, view: View) -> list[Command]:
        """One command a robot, in the order of view.robots."""
        return [self.command(view, robot) for robot in view.robots]

    def command(self, view: View, robot: Player) -> Command:
        """What one robot does."""
        ball = view.ball
        if robot.role == "keeper":
            return skills.block(view, robot, out=0.6)
        if ball is None:
            return skills.go_to(view, robot, *self.place(view, robot))
        field_players = [each for each in view.robots if each.role != "keeper"]
        nearest = skills.nearest(field_players, ball.x, ball.y)
        if view.phase is Phase.PLAY:
            return self.play(view, robot) if robot is nearest else self.support(view, robot)
        return self.restart(view, robot, robot is nearest)

    def play(self, view: View, robot: Player) -> Command:
        """Attack with the ball, or get it."""
        if not robot.has_ball:
            return skills.intercept(view, robot)
        goal = view.field.length / 2
        if skills.distance(robot, goal, 0.0) < self.far_shot:
            return skills.shoot(view, robot)
        mate, _ = skills.best_pass(view, robot)
        if mate:
            return skills.pass_to(view, robot, mate)
        return skills.dribble(view, robot, goal, 0.0)

    def support(self, view: View, robot: Player) -> Command:
        """Keep the own place, which moves along with the ball."""
        x, y = self.place(view, robot)
        return skills.go_to(view, robot, x + view.ball.x / 2, y, area=False)

    def restart(self, view: View, robot: Player, takes: bool) -> Command:
        """Before the ball is in play: take the kick, or keep away from it."""
        mate, _ = skills.best_pass(view, robot)
        aim = mate or skills.nearest([r for r in view.robots if r is not robot], robot.x, robot.y)
        if not (view.ours and takes and aim):
            return skills.keep_distance(view, robot, *self.place(view, robot))
        if view.started:
            return skills.pass_to(view, robot, aim)
        return skills.stand_ready(view, robot, aim.x, aim.y)

    def place(self, view: View, robot: Player) -> tuple[float, float]:
        """Where a robot stands while the ball is in the middle."""
        wing = view.field.width / 4
        places = [(-5.0, -wing / 2), (-5.0, wing / 2), (-1.5, -wing), (-1.5, wing)]
        return places[robot.number % len(places)]
