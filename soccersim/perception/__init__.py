"""What each team knows of the game, put together from cameras, odometry and radio.

    frame -> own pose corrected -> report by radio -> the team's tracks -> the sheet of a decision

A robot works on a frame `camera.delay` after it was taken; its report, with all that the frame
showed, reaches the team's computer `radio.delay` later, or never. What the sheet tells is brought
forward to the moment of the decision; its ages say how old the news is.
"""

from collections.abc import Sequence
from math import cos, nan, sin

import numpy as np

from soccersim.estimation.ball_track import put_down
from soccersim.estimation.localisation import SURE
from soccersim.estimation.opponents import FREE
from soccersim.kernel import settled
from soccersim.perception.mind import build_eyes, build_known
from soccersim.perception.telling import tell
from soccersim.perception.watching import perceive, reveal
from soccersim.sensing.camera import DrawSource
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Estimate, Readings, Truth, Whole


class Perception:
    """Both teams' knowledge: `step` at every beat, then `fill` for each decision."""

    def __init__(self, scenario: Scenario) -> None:
        self._all_seeing = scenario.perception == "truth"
        teams = [int(player.team == "away") for player in scenario.robots]
        self._draws = DrawSource(teams, scenario.seed)
        self._eyes = build_eyes(scenario, self._draws.draws)
        self._known = build_known(scenario)
        self._dt = scenario.dt
        self._tick = -1  # of the last step
        self._told = 0  # frames of which sightings have been told
        self._perceive, self._tell = settled(perceive), settled(tell)
        self._rulings: tuple[Sequence[int] | Whole, Sequence[float] | Array]
        self.beat: int = self._eyes.camera.every
        """Ticks from frame to frame: `step` is called at least that often."""

    def step(
        self,
        truth: Truth,
        readings: Readings,
        estimate: Estimate,
        tick: int,
        in_play: Sequence[int] | Whole,
        direction: Sequence[float] | Array,
    ) -> None:
        """Look, work on what was seen, hear reports; corrects estimate.pose of the robots.

        in_play (R,) says who plays: the others neither see, nor are seen, nor report.
        direction (2,) is +1 where a team attacks +x, else -1. Both are looked at again by `fill`:
        in between the referee may have changed them.
        """
        eyes, known = self._eyes, self._known
        self._tick, self._rulings = tick, (in_play, direction)
        known.playing[:] = in_play
        known.direction[:] = direction
        if self._all_seeing:
            reveal(known, truth.body, readings.contact, tick)
            return
        if tick % eyes.camera.every == 0:
            self._draws.prepare(tick // eyes.camera.every)
        pose, twist = estimate.pose, estimate.twist
        self._perceive(eyes, known, truth.body, readings.contact, pose, twist, tick, self._dt)

    def fill(self, sheet: Array, slot: int, tick: int) -> None:
        """Write what a team knows into its sheet: numbers 8 and on, as soccersim.sheet says."""
        self._known.playing[:], self._known.direction[:] = self._rulings
        self._tell(self._known, sheet, slot, tick, self._dt)

    def sighted(self) -> Array:
        """(R, 2) m, field frame: where each robot's camera put the ball; NaN where it did not.

        In the last frame that the robots have worked on, laid on from the pose each believes to
        have had at its moment; all NaN where no frame has come since the last call.
        """
        frames, done = self._eyes.frames, int(self._eyes.done[0])
        at = (done - 1) % len(frames.number)
        told: list[float] = []
        shown = (frames.ball_seen[at] * frames.alive[at]).tolist()
        if done == self._told or self._all_seeing:
            shown = [0] * len(shown)
        self._told = done
        # plain numbers: numpy takes twice the time for so few
        for (x, y, heading), (ahead, left), seen in zip(
            frames.pose[at].tolist(), frames.ball[at].tolist(), shown, strict=True
        ):
            c, s = cos(heading), sin(heading)  # body to field
            place = (x + c * ahead - s * left, y + s * ahead + c * left)
            told += place if seen else (nan, nan)
        return np.array(told).reshape(-1, 2)

    def place(self, robot: int, pose: Sequence[float]) -> None:
        """A robot was carried to a pose (field frame) and told so: forget its past.

        Its own team knows the place; the other team looks anew for all its opponents.
        """
        known, other = self._known, 1 - int(self._known.team[robot])
        self._eyes.frames.alive[:, robot] = 0
        self._eyes.localisation.variance[robot] = SURE**2
        known.reports.pose[robot] = pose
        known.reports.twist[robot] = 0.0
        known.reports.contact[robot] = 0
        known.reports.tick[robot] = max(self._tick, 0)
        known.opponents.seen[other] = FREE
        known.opponents.since[other] = self._tick

    def place_ball(self, x: float, y: float) -> None:
        """The referee put the ball down, field frame: everybody saw where."""
        put_down(self._known.balls, x, y, self._tick)
