"""The session in a window on the screen: one robot is driven by hand, alone or against a team."""

import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.live import frame
from soccersim.live import messages as say
from soccersim.live.catalogue import Catalogue
from soccersim.live.messages import SPEEDS, Message, Wrong
from soccersim.live.play import Play
from soccersim.live.session import Session
from soccersim.problems import InputError, Problem
from soccersim.render.hands import HELP, Hands, take_hands
from soccersim.render.window import Window, close_screen, open_screen
from soccersim.sheet import PHASES

FRAMES = 60  # a second, at most
ORDERS = 0.1  # s between two orders while a key is held
TURNING = 0.6  # of the fastest turn: a key knows no half
KICK = 0.7  # of the kicker's speed
SHOWN = 4.0  # s that a word is shown
STILL = (0.0, 0.0, 0.0)


class Driver:
    """Somebody at the keys: turns what he does into messages, and moments into a picture."""

    def __init__(self, catalogue: Catalogue, play: Play, size: tuple[int, int]) -> None:
        self.picture: bytes | None = None
        self.word, self.worded = "", 0.0
        self.session = Session(catalogue, play, self._listen)
        self.window = Window(play.scenario, size)
        self.hands: Hands = take_hands()
        robots = play.scenario.robots
        own = [i for i, robot in enumerate(robots) if robot.team == "home" and not robot.keeper]
        self.picked = (own or [0])[0]
        self.dribbles, self.driving, self.ordered = False, False, 0.0

    def turn(self) -> bool:
        """One picture; False: enough."""
        for deed in self.hands.look():
            if deed == "quit":
                return False
            self._do(*deed.split())
        self._drive(time.monotonic())
        if self.picture is not None:
            self._show(np.frombuffer(self.picture, "<f8"))
        return True

    def ask(self, message: Message) -> None:
        """Let the session do it; what goes wrong is shown."""
        self.session.ask(message).add_done_callback(self._told)

    def _listen(self, told: bytes | dict[str, Any]) -> None:
        """From the session's thread."""
        if isinstance(told, bytes):
            self.picture = told
        elif told["type"] == "news":
            self.word, self.worded = told["events"][-1]["text"], time.monotonic()

    def _told(self, answer: "Future[dict[str, Any]]") -> None:
        wrong = answer.exception()
        if isinstance(wrong, Wrong):
            self.word, self.worded = str(wrong), time.monotonic()

    def _do(self, deed: str, *more: str) -> None:
        """One key that is no driving."""
        robot, session = self.picked, self.session
        if deed == "kick":
            kicker = session.play.scenario.robots[robot].model.kicker
            self.ask(say.Kick(do="kick", robot=robot, speed=KICK * kicker.speed if kicker else 1.0))
        elif deed == "dribble":
            self.dribbles = not self.dribbles
            self.ask(say.Dribble(do="dribble", robot=robot, on=self.dribbles))
        elif deed == "pause":
            self.ask(say.Resume(do="resume") if session.paused else say.Pause(do="pause"))
        elif deed in ("faster", "slower"):
            at = SPEEDS.index(session.speed) + (1 if deed == "faster" else -1)
            factor = SPEEDS[min(max(at, 0), len(SPEEDS) - 1)]
            self.ask(say.Speed(do="speed", factor=factor))
        elif deed == "again":
            self.ask(session.catalogue.current)
        elif deed == "release":
            self.ask(say.Release(do="release", robot=robot))
        elif deed in ("next", "pick"):
            self._pick(deed, *more)
        elif deed == "click":
            self._go(int(more[0]), int(more[1]))

    def _pick(self, deed: str, *more: str) -> None:
        """Another robot of the same team; the one before plays with its team again."""
        robots = self.session.play.scenario.robots
        team = robots[self.picked].team
        own = [i for i, robot in enumerate(robots) if robot.team == team]
        if deed == "next":
            found = own[(own.index(self.picked) + 1) % len(own)]
        else:
            found = next((i for i in own if robots[i].number == int(more[0])), self.picked)
        if found != self.picked and self.session.play.scenario.match:
            self.ask(say.Release(do="release", robot=self.picked))
        self.picked, self.dribbles, self.driving = found, False, False

    def _go(self, u: int, v: int) -> None:
        """A click sends the robot there."""
        view = self.window.view
        x, y = (u - view.centre[0]) / view.px_per_m, (view.centre[1] - v) / view.px_per_m
        if abs(x) <= say.FAR and abs(y) <= say.FAR:
            self.ask(say.Go(do="go", robot=self.picked, x=x, y=y))

    def _drive(self, now: float) -> None:
        """While a key is held, and once when it is let go."""
        way = self.hands.way
        if way == STILL and self.driving:
            self.driving = False
            self.ask(say.Halt(do="halt", robot=self.picked))
        elif way != STILL and (not self.driving or now - self.ordered > ORDERS):
            self.driving, self.ordered = True, now
            limits = self.session.play.scenario.robots[self.picked].model.control.limits
            speed, turn = min(limits.speed, 20.0), min(TURNING * limits.turn_rate, 20.0)
            self.ask(
                say.Drive(
                    do="drive",
                    robot=self.picked,
                    vx=speed * way[0],
                    vy=speed * way[1],
                    omega=turn * way[2],
                )
            )

    def _show(self, numbers: NDArray[np.float64]) -> None:
        scenario = self.session.play.scenario
        head = dict(zip(frame.HEAD, numbers.tolist(), strict=False))
        moment = frame.poses(numbers, scenario)
        side = -1 if head["direction"] > 0 else 1
        words = self._words(head, moment.playing)
        target = moment.targets[self.picked]
        shown = moment.body, moment.believed, moment.playing
        self.window.show(*shown, side, self.picked, target, words)

    def _words(self, head: dict[str, float], playing: list[int]) -> list[str]:
        """What stands above and below the field."""
        scenario = self.session.play.scenario
        seconds = head["tick"] / scenario.timing.physics_hz
        clock = f"{int(seconds // 60)}:{seconds % 60:04.1f}"
        match, middle, right = scenario.match, scenario.name, ""
        if match:
            score = f"{int(head['home'])} : {int(head['away'])}"
            middle = f"{match.home.strategy}  {score}  {match.away.strategy}"
            right = PHASES[int(head["phase"])].replace("_", "-")
        if head["paused"]:
            right = "stands still"
        if waits := self.session.waits():
            middle = f"{waits[0]}: {waits[1]:.0f} s"
        word = self.word if time.monotonic() - self.worded < SHOWN else ""
        player = scenario.robots[self.picked]
        state = "" if playing[self.picked] else ", out of play"
        told = f"{player.name}{state} · {head['factor']:.2f}\u00d7" + (f" · {word}" if word else "")
        return [clock, middle, right, told, HELP]


def show_window(catalogue: Catalogue, begin: Callable[[], None]) -> None:
    """Play until the window is closed.

    begin is called once there is a display: MachineError where there is none. InputError where
    there is no robot.
    """
    size = open_screen()
    try:
        play = catalogue.first()
        if not play.scenario.robots:
            wrong = f"{play.scenario.name} has no robot to drive: leave out --window"
            raise InputError(Problem(wrong))
        begin()
        driver = Driver(catalogue, play, size)
        driver.session.start()
        try:
            due = time.monotonic()
            while driver.turn():
                due = max(due + 1 / FRAMES, time.monotonic())
                time.sleep(max(0.0, due - time.monotonic()))
        finally:
            driver.session.end()
    finally:
        close_screen()
