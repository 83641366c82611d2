"""Below the field of a match: possession, shots and passes so far, and the match as a time line."""

from functools import cache

import numpy as np
import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.canvas import Canvas
from soccersim.render.lettering import Blit, Lettering
from soccersim.render.story import QUIET, Story

TEAMS = tuple(look.TEAMS)  # by slot
EDGE = 20  # px at the left and right
FIRST, SECOND = 17, 51  # px, middles of the two rows, from the top of the band
BAR = (300, 19)  # px, of the possession bar
ENDS = 50  # px, at either end of the time line, for its times
RIBBON = 6  # px, height of the line itself
TALL = 40  # px, of the line with its marks
LANE = 11  # px, from the line's middle to the marks of a team
GOAL, SHOT = 7.5, 2.6  # px, radii of marks
IDLE = (70, 80, 94)  # where nobody had the ball


class MatchBand:
    """What has been painted is kept: a picture needs parts of it."""

    def __init__(self, recording: Recording, size: tuple[int, int], story: Story) -> None:
        self.story = story
        self.size = size
        self.scale = scale = look.scale(size)
        self.top = size[1] - look.BAND * scale
        self.about = f"{recording.scenario.name}  ·  seed {recording.meta['seed']}"
        self.faint = Lettering(13 * scale, look.FAINT, look.PAGE)
        self.text = Lettering(14 * scale, look.INK, look.PAGE)
        self.bar = pygame.Rect((0, 0), tuple(round(side * scale) for side in BAR))
        self.bar.center = (size[0] // 2, round(self.top + FIRST * scale))
        left = round((EDGE + ENDS) * scale)
        self.line = pygame.Rect(left, 0, size[0] - 2 * left, 2 * round(TALL * scale / 2))
        self.line.centery = round(self.top + SECOND * scale)
        self.bars = cache(self._bar)
        strip = self._strip(recording)
        self.played = cache(lambda width: strip.subsurface((0, 0, width, strip.height)))
        self.now = pygame.Surface((max(1, round(2 * scale)), self.line.height), 0, 32)
        self.now.fill(look.INK)

    def paint(self, picture: pygame.Surface) -> None:
        """What never changes, once, onto the background."""
        scale, line = self.scale, self.line
        room = self.bar.left - (EDGE + 270) * scale
        about = self.faint.fitted(self.about, room)
        self.faint.write(picture, about, EDGE * scale, self.bar.centery)
        self._paint_legend(picture)
        self._paint_line(picture, look.CARD)
        for x, text in ((EDGE * scale, "0:00"), (line.right + 8 * scale, self._end())):
            self.faint.write(picture, text, x, line.centery)

    def blits(self, index: int) -> list[Blit]:
        """What one record shows, to be blitted onto the background."""
        story, bar = self.story, self.bar
        blits: list[Blit] = [(self.bars(story.possession(index)), bar.topleft)]
        gap = 14 * self.scale
        for slot in (0, 1):
            text = self._figures(slot, index)
            right = bar.left - gap if slot == 0 else bar.right + gap + self.text.width(text)
            blits.append(self.text.ending_at(right, bar.centery, text))
        reached = min(self._x(story.seconds(index)), self.line.width)
        if reached:
            blits.append((self.played(reached), self.line.topleft))
        left = self.line.left + reached - self.now.width // 2
        blits.append((self.now, (left, self.line.top)))
        return blits

    def _figures(self, slot: int, index: int) -> str:
        """Shots and passes of one side so far."""
        story = self.story
        shots, on_goal = story.shots.until(slot, index), story.on_goal.until(slot, index)
        passes = story.passes.until(slot, index)
        parts = [f"shots {shots} ({on_goal} on goal)", f"passes {passes}"]
        return "    ".join(parts if slot == 0 else reversed(parts))

    def _x(self, seconds: float) -> int:
        """Where a moment is on the time line, px from its beginning."""
        return round(self.line.width * seconds / self.story.duration)

    def _end(self) -> str:
        seconds = round(self.story.duration)
        return f"{seconds // 60}:{seconds % 60:02d}"

    def _bar(self, share: int | None) -> pygame.Surface:
        """Home's share in per cent from the left, away's from the right; None: nobody had it."""
        bar = pygame.Surface(self.bar.size, 0, 32)
        home, away = (look.TEAMS[team] for team in TEAMS)
        width, height = bar.size
        bar.fill(look.CARD if share is None else away)
        if share is not None:
            bar.fill(home, (0, 0, round(width * share / 100), height))
        letters = Lettering(13 * self.scale, look.INK, None, bold=True)
        inset = 8 * self.scale
        if share is not None:
            letters.write(bar, f"{share} %", inset, height / 2)
            other = f"{100 - share} %"
            letters.write(bar, other, width - inset - letters.width(other), height / 2)
        text = "possession"
        letters.write(bar, text, (width - letters.width(text)) / 2, height / 2)
        return bar

    def _paint_line(self, picture: pygame.Surface, ground: look.Colour) -> None:
        """The empty time line, with a notch at half time."""
        line, half = self.line, max(2, round(RIBBON * self.scale))
        picture.fill(ground, (line.left, line.centery - half // 2, line.width, half))
        notch = round(10 * self.scale)
        picture.fill(look.FAINT, (line.centerx, line.centery - notch, 1, 2 * notch))

    def _strip(self, recording: Recording) -> pygame.Surface:
        """The whole time line with its marks; a picture shows it up to its moment."""
        strip = pygame.Surface(self.line.size, 0, 32)
        strip.fill(look.PAGE)
        self._paint_ribbon(strip, recording)
        middle, lane = strip.height // 2, LANE * self.scale
        story = self.story
        for slot, way in ((0, -1), (1, 1)):
            colour = look.tint(TEAMS[slot])
            for record in story.shots.records[slot]:
                place = (self._x(story.seconds(record)), middle + way * lane)
                pygame.draw.aacircle(strip, colour, place, max(1.5, SHOT * self.scale))
        for event, way in ((e, -1 if e["side"] == "home" else 1) for e in story.goals):
            self._paint_goal(strip, self._x(event["time"]), middle + way * lane, event)
        return strip

    def _paint_ribbon(self, strip: pygame.Surface, recording: Recording) -> None:
        """Who had the ball most of each pixel's time; the referee's whistles across."""
        middle, tall = strip.height // 2, max(2, round(RIBBON * self.scale))
        sides = np.array([*self.story.sides, -1])[np.array(self.story.holder, int)]
        ends = (np.arange(strip.width + 1) * self.story.duration / strip.width).tolist()
        cuts = np.searchsorted(recording.time, ends)
        for x in range(strip.width):
            some = sides[cuts[x] : max(cuts[x + 1], cuts[x] + 1)]
            home, away = np.sum(some == 0), np.sum(some == 1)
            colour = look.TEAMS[TEAMS[0 if home >= away else 1]] if home + away else IDLE
            strip.fill(colour, (x, middle - tall // 2, 1, tall))
        notch = round(5 * self.scale)
        for event in self.story.events:
            if event["kind"] not in QUIET:
                strip.fill(look.FAINT, (self._x(event["time"]), middle - notch, 1, 2 * notch))

    def _paint_goal(self, strip: pygame.Surface, x: float, y: float, event: dict[str, str]) -> None:
        colour = look.TEAMS[event["side"]]
        radius = GOAL * self.scale
        pygame.draw.aacircle(strip, look.INK, (x, y), radius)
        pygame.draw.aacircle(strip, colour, (x, y), radius - max(1.0, 1.5 * self.scale))

    def _paint_legend(self, picture: pygame.Surface) -> None:
        """The signs of what is believed: a robot's pose, the ball of either team."""
        scale, text = self.scale, "as believed"
        x = self.size[0] - EDGE * scale - self.faint.width(text)
        self.faint.write(picture, text, x, self.bar.centery)
        side = 2 * round(9 * scale)
        canvas = Canvas((3 * side, side), side / 2, ground=look.PAGE)
        canvas.ring((-1.6, 0.0), 0.8, 0.2, look.BELIEVED)
        for at, team in ((0.3, TEAMS[0]), (1.9, TEAMS[1])):
            canvas.ring((at, 0.0), 0.5, 0.2, look.tint(team))
        place = (round(x - 3 * side - 8 * scale), round(self.bar.centery - side / 2))
        picture.blit(canvas.shrunk(), place)
