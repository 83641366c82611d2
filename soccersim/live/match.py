"""A match that is watched while it is played, with a referee's buttons and robots to take over."""

import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from soccersim.live import messages as say
from soccersim.live.messages import Wrong
from soccersim.live.pilot import Pilot
from soccersim.live.play import Play
from soccersim.live.whistle import Whistle
from soccersim.match.game import Forfeits, Game
from soccersim.match.seats import Seat
from soccersim.sheet import BALL, BALL_KNOWN
from soccersim.spec.scenario import Scenario
from soccersim.strategy.check import Answer, Mark

STANDING = (0.0, 0.0, 0.0)  # m/s, m/s, rad/s


class LiveGame(Game):
    """A game that goes on in pieces of any length, and hands orders over before they are sent."""

    def __init__(self, scenario: Scenario, seats: Sequence[Seat], pilot: Pilot) -> None:
        super().__init__(scenario)
        self.referee: Whistle = Whistle(scenario)
        self.seats, self.pilot = seats, pilot
        self.answers: list[Answer] = []
        self.sighted = self.perception.sighted()  # (R, 2) m, field frame
        self.over = False

    def advance(self, ticks: int) -> None:
        """So many ticks, or until the match is over."""
        simulation = self.simulation
        goal = simulation.tick + ticks
        while simulation.tick < goal and not self.over:
            self._between(simulation.tick)
            left = self.beat - simulation.tick % self.beat
            simulation.hurry(min(goal - simulation.tick, left))
            if simulation.done:
                self._between(simulation.tick)  # the referee's last word
                self.over = True

    def _between(self, tick: int) -> None:
        if tick % self.beat == 0 or self.simulation.done:
            self.answers = self._beat(self.seats, tick) or self.answers

    def _ask(self, seats: Sequence[Seat], tick: int) -> list[Answer]:
        """What both teams answer, with our orders for the robots that are taken over."""
        answers = super()._ask(seats, tick)
        self.sighted = self.perception.sighted()
        for slot, answer in enumerate(answers):
            poses = self.simulation.machine.estimate.pose
            self.pilot.take_over(answer.orders, self.rows[slot], poses)
        return answers


class MatchPlay(Play):
    """A match; robots that people have sent somewhere do not hear their teams."""

    def __init__(self, scenario: Scenario) -> None:
        self.pilot = Pilot(scenario)
        self._folder = tempfile.mkdtemp(prefix="soccersim-live-")
        self.seats: list[Seat] = []
        try:
            self.seats = seats_of(scenario, Path(self._folder))
            self.game = LiveGame(scenario, self.seats, self.pilot)
        except BaseException:
            self.close()
            raise
        super().__init__(scenario, self.game.simulation)
        self.targets = self.pilot.targets

    def _run(self, ticks: int) -> None:
        game = self.game
        try:
            game.advance(ticks)
        except Forfeits as forfeits:
            home, away = forfeits.score(game.referee.score)
            for slot, fault in zip(forfeits.slots, forfeits.faults(self.tick), strict=True):
                why = fault.detail.splitlines()[-1:] or [fault.kind]
                self.tell(f"{fault.side} forfeits, {home}:{away}: {why[0]}", "forfeit", slot)
            game.referee.score, game.over = (home, away), True
        for event in game.log.events:
            side = None if event.side is None else ("home", "away").index(event.side)
            told = {"time": round(event.time, 3), "text": event.text, "side": side}
            self.news.append({**told, "kind": event.kind})
        game.log.events.clear()
        self.pilot.made(game.simulation.machine.handling.kicks.tolist())
        for row, off in self.pilot.arrived(game.simulation.machine.estimate.pose):
            name = self.scenario.robots[row].name
            self.tell(f"{name} is there, {100 * off:.1f} cm off as it believes", "reached")
        self.over = game.over

    def go(self, message: say.Go) -> None:
        """Its team's orders are put aside for ours."""
        self._cancel("drive", message.robot)
        pose = self.simulation.machine.estimate.pose[message.robot]
        heading = float(pose[2]) if message.heading is None else message.heading
        self.pilot.go(message.robot, (message.x, message.y, heading))

    def drive(self, message: say.Drive) -> None:
        """Our twist instead of its team's."""
        self.pilot.drive(message.robot, (message.vx, message.vy, message.omega))

    def halt(self, robot: int) -> None:
        """It stands, until it is released."""
        self._cancel("drive", robot)
        self.pilot.drive(robot, STANDING)

    def release(self, robot: int) -> None:
        """It hears its team again."""
        self._cancel("drive", robot)
        self.pilot.release(robot)

    def kick(self, message: say.Kick) -> None:
        """With every order, until it is made."""
        super().kick(message)
        kicks = int(self.simulation.machine.handling.kicks[message.robot])
        self.pilot.kick(message.robot, message.speed, kicks)

    def disarm(self, robot: int) -> None:
        """No kick any more."""
        self.pilot.kicks.pop(robot, None)

    def dribble(self, message: say.Dribble) -> None:
        """Only for robots that do not hear their teams."""
        super().dribble(message)
        if message.robot not in self.pilot.taken:
            raise Wrong("dribble: this robot obeys its team; send or halt it first")
        self.pilot.dribble(message.robot, message.on)

    def ball(self, message: say.Ball) -> None:
        """All see where it is put."""
        super().ball(message)
        self.game.perception.place_ball(message.x, message.y)

    def referee(self, message: say.Referee) -> None:
        """A button of the referee's."""
        self.game.referee.press(message)

    def close(self) -> None:
        """End the teams' processes."""
        for seat in self.seats:
            seat.close()
        shutil.rmtree(self._folder, ignore_errors=True)

    def seen(self, slot: int) -> list[float]:
        """x, y and age of the ball as a team believes it to be; nan: never seen."""
        sheet, side = self.game.sheets[slot], float(self.game.referee.direction[slot])
        if not sheet[BALL_KNOWN]:
            return [float("nan")] * 3
        x, y, _, _, age = sheet[BALL : BALL + 5].tolist()
        return [side * x, side * y, age]

    def labels(self) -> list[str]:
        """What teams call what their robots do."""
        labels = [""] * len(self.scenario.robots)
        for slot, answer in enumerate(self.game.answers):
            for row, label in zip(self.game.rows[slot], answer.labels, strict=True):
                labels[row] = "by hand" if row in self.pilot.taken else label
        return labels

    def notes(self) -> list[list[list[Any]]]:
        """What teams drew, field frame."""
        return [
            [_on_field(note, float(self.game.referee.direction[slot])) for note in answer.notes]
            for slot, answer in enumerate(self.game.answers)
        ]


def _on_field(note: Mark, side: float) -> list[Any]:
    """A note of the team frame in the field frame."""
    kind, *numbers = note
    places = 4 if kind == "line" else 2
    turned = [round(side * float(number), 2) for number in numbers[:places]]
    return [kind, *turned, *numbers[places:]]


def seats_of(scenario: Scenario, folder: Path) -> list[Seat]:
    """Each team in a process of its own where the system can, so that none holds up the rest."""
    import select

    from soccersim.match.seating import Isolate, take_seats
    from soccersim.match.turn import Turn
    from soccersim.strategy.load import locate

    match = scenario.match
    if match is None:
        raise ValueError(f"{scenario.name} has no `match`")
    origins = locate(match.home.strategy), locate(match.away.strategy)
    apart: Isolate = "team" if hasattr(select, "poll") else "match"
    return take_seats(scenario, origins, apart, Turn(), folder)
