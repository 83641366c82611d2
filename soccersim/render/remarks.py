"""What teams say on the pictures: labels beside their robots, and their notes on the field."""

from bisect import bisect_right
from functools import lru_cache
from itertools import chain
from math import cos, hypot, pi, sin
from typing import Any

import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.lettering import Blit, Lettering
from soccersim.render.overlay import Overlay
from soccersim.render.pitch import View
from soccersim.render.story import Story

LETTERS = {"label": 11, "note": 12}  # px
PLATE = (14, 20, 26, 175)  # behind words, so that lines and robots do not disturb them
ABOVE = 11  # px from a note's place to its words: they often tell of the robot there
APART = 2  # px between words, and between a robot and its label
WORDS = 4096  # kept for the next frame
SIDES = (  # of a robot where its label may stand, the first free one is taken
    *((0, 1), (0, -1), (1, 0), (-1, 0)),
    *((1, 1), (-1, 1), (1, -1), (-1, -1)),
    *((0, 2), (0, -2), (1, 2), (-1, 2), (1, -2), (-1, -2)),
)
CORNERS = 48  # of a circle as drawn
CIRCLE = [(cos(2 * pi * i / CORNERS), sin(2 * pi * i / CORNERS)) for i in range(CORNERS)]
TEAMS = tuple(look.TEAMS)  # by slot


class Remarks:
    """Labels and notes of both teams, each valid from its decision on."""

    def __init__(self, recording: Recording, view: View, scale: float, story: Story) -> None:
        match = recording.match or {"labels": [], "notes": []}
        self.view = view
        self.story = story
        self.radii = [p.model.radius * view.px_per_m for p in recording.scenario.robots]
        self.farthest = 2 * hypot(view.frame.width, view.frame.height)
        self.labels = [_Changes(match["labels"], row) for row in range(len(self.radii))]
        self.notes = [_Changes(match["notes"], slot) for slot in (0, 1)]
        self.above = ABOVE * scale
        self.inks = [look.tint(team) for team in TEAMS]
        self.letters = {
            (kind, slot): Lettering(size * scale, look.mix(ink, look.INK, 0.5), None)
            for kind, size in LETTERS.items()
            for slot, ink in enumerate(self.inks)
        }
        self.plate = lru_cache(WORDS)(self._plate)

    def draw_below(self, overlay: Overlay, index: int) -> None:
        """Lines and circles, below the robots."""
        decision = self.story.decision[index]
        for slot in (0, 1):
            for note in self.notes[slot].at(decision, []):
                if note[0] == "line":
                    ends = self.view.pixel(note[1], note[2]), self.view.pixel(note[3], note[4])
                    overlay.line(self.inks[slot], *ends)
                elif note[0] == "circle":
                    self._circle(overlay, slot, *note[1:])

    def draw_above(self, overlay: Overlay, index: int, bodies: list[Any]) -> None:
        """Words, above the robots at `bodies`: labels where nothing else is, as far as possible."""
        decision = self.story.decision[index]
        taken: list[pygame.Rect] = []
        blits: list[Blit] = []
        for slot in (0, 1):
            for note in self.notes[slot].at(decision, []):
                if note[0] == "text" and note[3].strip():
                    word = self.plate("note", slot, note[3])
                    x, y = self.view.pixel(note[1], note[2])
                    rect = word.get_rect(midbottom=(round(x), round(y - self.above)))
                    taken.append(rect.clamp(self.view.frame))
                    blits.append((word, taken[-1].topleft))
        blits += self._labels(decision, bodies, taken)
        overlay.lay(blits)

    def _labels(self, decision: int, bodies: list[Any], taken: list[pygame.Rect]) -> list[Blit]:
        """Each label at the first side of its robot where it hides nothing, else below it."""
        said = [(row, text) for row in range(len(self.radii))
                if (text := self.labels[row].at(decision, "").strip())]  # fmt: skip
        if not said:
            return []
        places = [self.view.pixel(pose[0], pose[1]) for pose in bodies]
        for (x, y), radius in zip(places, self.radii, strict=False):
            taken.append(
                pygame.Rect(x - 0.8 * radius, y - 0.8 * radius, 1.6 * radius, 1.6 * radius)
            )
        blits: list[Blit] = []
        for row, text in said:
            word = self.plate("label", self.story.sides[row], text)
            free = self._free(word, places[row], self.radii[row] + APART, taken)
            taken.append(free)
            blits.append((word, free.topleft))
        return blits

    def _free(
        self, word: pygame.Surface, place: tuple[float, float], far: float, taken: list[pygame.Rect]
    ) -> pygame.Rect:
        """Below the robot, above, beside, or farther off, where nothing else is."""
        frame, rect = self.view.frame, word.get_rect(center=place)
        down, across = far + rect.height / 2, far + rect.width / 2
        tries = (rect.move(u * across, v * down).clamp(frame) for u, v in SIDES)
        first = next(tries)
        return next((each for each in chain((first,), tries) if each.collidelist(taken) < 0), first)

    def _circle(self, overlay: Overlay, slot: int, x: float, y: float, r: float) -> None:
        u, v = self.view.pixel(x, y)
        radius = abs(r) * self.view.px_per_m
        if radius < self.farthest:  # a larger one has no line in the picture that one could read
            points = [(u + radius * c, v + radius * s) for c, s in CIRCLE]
            overlay.loop(self.inks[slot], points)

    def _plate(self, kind: str, slot: int, text: str) -> pygame.Surface:
        """Words on their plate."""
        letters = self.letters[kind, slot]
        width, height = letters.font.size(text)
        plate = pygame.Surface((width + 6, height), pygame.SRCALPHA, 32)
        pygame.draw.rect(plate, PLATE, plate.get_rect(), border_radius=3)
        plate = plate.premul_alpha()
        letters.write(plate, text, 3, height / 2)
        return plate


class _Changes:
    """What is said from which decision on."""

    def __init__(self, rows: list[list[Any]], whose: int) -> None:
        own = [row for row in rows if row[1] == whose]
        self.decisions = [row[0] for row in own]
        self.said = [row[2] for row in own]

    def at(self, decision: int, nothing: Any) -> Any:
        """What was said last up to this decision."""
        found = bisect_right(self.decisions, decision) - 1
        return self.said[found] if found >= 0 else nothing
