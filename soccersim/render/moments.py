"""What a match shows on the field besides bodies: kicks, who has the ball, believed balls."""

from bisect import bisect_right
from functools import cache
from math import hypot

import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.canvas import Canvas
from soccersim.render.lettering import Blit
from soccersim.render.overlay import Overlay
from soccersim.render.pitch import View
from soccersim.render.story import Story
from soccersim.touches import Kick

FLASH = 0.36  # s that a kick is shown
STEPS = 8  # pictures of a flash
SPREAD = (7.0, 22.0)  # px, radius of a flash's ring: first and last
STREAK = (0.12, 26.0, 90.0)  # px of the streak: s of the ball's speed, at least, at most
GHOST = 6.5  # px, radius of a believed ball at least
APART = 4.0  # px between truth and belief from which a believed ball is shown
OLD = 0.5  # s; a ball believed from older sightings is fainter
HALO = 3.0  # px beyond the shell of the robot that has the ball
TEAMS = tuple(look.TEAMS)  # by slot

Pose = tuple[float, float, float]


class Moments:
    """All as sprites that are painted once."""

    def __init__(self, recording: Recording, view: View, scale: float, story: Story) -> None:
        self.view = view
        self.scale = scale
        self.story = story
        self.believed = recording.arrays["ball_believed"].tolist()
        self.contact: list[list[int]] = recording.arrays["contact"].tolist()
        ball = recording.scenario.ball
        self.ball_radius = max((ball.radius if ball else 0.0) * view.px_per_m, GHOST * scale)
        self.radii = [player.model.radius for player in recording.scenario.robots]
        self.kicks = story.kicks
        self.ticks = [kick.tick for kick in self.kicks]
        self.ghost = cache(self._ghost)
        self.flash = cache(self._flash)
        self.halo = cache(self._halo)

    def draw_below(self, overlay: Overlay, index: int, bodies: list[Pose]) -> None:
        """A halo round the robots that have the ball in their mouths; kicks."""
        contact = self.contact[self.story.decision[index]]
        blits = [
            self._at(self.halo(self.radii[row]), *bodies[row][:2])
            for row, has in enumerate(contact)
            if has
        ]
        tick, hz = self.story.ticks[index], self.story.hz
        first = bisect_right(self.ticks, tick - FLASH * hz)
        for kick in self.kicks[first : bisect_right(self.ticks, tick)]:
            age = (tick - kick.tick) / hz / FLASH
            step = min(int(STEPS * age), STEPS - 1)
            self._streak(overlay, kick, step)
            blits.append(self._at(self.flash(self.story.sides[kick.robot], step), kick.x, kick.y))
        overlay.lay(blits)

    def draw_above(self, overlay: Overlay, index: int, ball: Pose) -> None:
        """The ball as each team believes it; ball: as it truly is."""
        overlay.lay(self._ghosts(index, ball))

    def _ghosts(self, index: int, ball: Pose) -> list[Blit]:
        """The believed balls that one can see to be wrong."""
        blits: list[Blit] = []
        for slot, (x, y, _, _, age) in enumerate(self.believed[self.story.decision[index]]):
            # nan: nothing is known, and no comparison holds
            if hypot(x - ball[0], y - ball[1]) * self.view.px_per_m > APART:
                blits.append(self._at(self.ghost(slot, age > OLD), x, y))
        return blits

    def _at(self, sprite: pygame.Surface, x: float, y: float) -> Blit:
        u, v = self.view.pixel(x, y)
        return sprite, (round(u - sprite.width / 2), round(v - sprite.height / 2))

    def _streak(self, overlay: Overlay, kick: Kick, step: int) -> None:
        """A line from the kick to where it goes; the faster the ball, the longer."""
        speed = hypot(kick.vx, kick.vy)
        if speed == 0.0:
            return
        seconds, least, most = STREAK
        ahead = seconds * speed * self.view.px_per_m
        length = min(max(ahead, least * self.scale), most * self.scale)
        x, y = self.view.pixel(kick.x, kick.y)
        end = (x + length * kick.vx / speed, y - length * kick.vy / speed)
        ink = look.tint(TEAMS[self.story.sides[kick.robot]])
        shade = look.mix(ink, look.FLOOR, step / STEPS)
        overlay.line(shade, (x, y), end, max(2, round(3 * self.scale)))

    def _flash(self, slot: int, step: int) -> pygame.Surface:
        first, last = SPREAD
        radius = (first + (last - first) * step / (STEPS - 1)) * self.scale
        canvas = Canvas.around(radius, 1.0)
        alpha = round(255 * (1 - step / STEPS))
        width = max(1.0, 2.5 * self.scale * (1 - step / STEPS))
        canvas.ring((0, 0), radius, width, (*look.tint(TEAMS[slot]), alpha))
        return canvas.shrunk()

    def _ghost(self, slot: int, old: bool) -> pygame.Surface:
        canvas = Canvas.around(self.ball_radius, 1.0)
        ink = look.tint(TEAMS[slot])
        width = max(1.2, 1.6 * self.scale)
        canvas.disc((0, 0), self.ball_radius, (*look.TEAMS[TEAMS[slot]], 30 if old else 60))
        canvas.ring((0, 0), self.ball_radius, width, (*ink, 120 if old else 255))
        return canvas.shrunk()

    def _halo(self, radius: float) -> pygame.Surface:
        pixels = radius * self.view.px_per_m + HALO * self.scale
        canvas = Canvas.around(pixels, 1.0)
        canvas.disc((0, 0), pixels, (*look.BALL, 130))
        return canvas.shrunk()
