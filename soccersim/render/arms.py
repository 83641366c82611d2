"""Arms on a frame: links as bars, joints as discs."""

from math import cos, sin

import numpy as np
import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.overlay import Overlay
from soccersim.render.pitch import View

LINK = (214, 220, 229)
EDGE = (38, 44, 56)
JOINT = (247, 201, 72)
THINNEST = 3.0  # px, of a link


def draw_arms(overlay: Overlay, view: View, recording: Recording, index: int) -> None:
    """Draw every arm at one record."""
    for arm, links in zip(recording.scenario.arms, recording.links[index], strict=True):
        width = max(arm.thickness * view.px_per_m, THINNEST)
        ends = []
        for (x, y, heading), length in zip(links[:, :3], arm.lengths, strict=True):
            dx, dy = length / 2 * cos(heading), length / 2 * sin(heading)
            ends.append((view.pixel(x - dx, y - dy), view.pixel(x + dx, y + dy)))
        for start, end in ends:
            _bar(overlay, start, end, width + 2.0, EDGE)
            _bar(overlay, start, end, width, LINK)
        for start, _ in ends:
            _disc(overlay, start, width * 0.75 + 1.0, EDGE)
            _disc(overlay, start, width * 0.75, JOINT)
        _disc(overlay, ends[-1][1], width * 0.5, look.BELIEVED)


def _bar(
    overlay: Overlay,
    start: tuple[float, float],
    end: tuple[float, float],
    width: float,
    colour: tuple[int, int, int],
) -> None:
    """A line with round ends."""
    a, b = np.array(start), np.array(end)
    along = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    side = np.array((-along[1], along[0])) * width / 2
    corners = [tuple(p) for p in (a + side, b + side, b - side, a - side)]
    overlay.mark(pygame.draw.polygon(overlay.surface, colour, corners))
    for end_point in (start, end):
        _disc(overlay, end_point, width / 2, colour)


def _disc(
    overlay: Overlay, place: tuple[float, float], radius: float, colour: tuple[int, int, int]
) -> None:
    overlay.mark(pygame.draw.aacircle(overlay.surface, colour, place, radius))
