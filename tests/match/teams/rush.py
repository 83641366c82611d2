"""A team for tests: the nearest robot fetches the ball and kicks it, the others drive about."""

from soccersim.strategy import Command, Strategy, skills


class Rush(Strategy):
    def __init__(self, rng, kick=6.0, hurry=False):
        super().__init__(rng)
        self.kick, self.hurry = kick, hurry

    def decide(self, view):
        if view.ball is None or not (self.hurry or skills.may_play(view)):
            return [Command(label="wait") for _ in view.robots]
        ball = view.ball
        near = skills.nearest(view.robots, ball.x, ball.y)
        commands = []
        for player in view.robots:
            if player is not near:
                place = -1.0 * player.number, player.number - 3.0
                commands.append(skills.go_to(view, player, *place))
            elif player.has_ball:
                commands.append(Command(1.0, 0.0, 0.0, kick=self.kick, dribble=True, label="kick"))
            else:
                commands.append(skills.intercept(view, player))
        return commands
