"""What moves on the field, seen from above: robots as they are built, the ball, the marks."""

from functools import lru_cache
from math import cos, pi, sin

import pygame

from soccersim.render import look
from soccersim.render.canvas import Canvas, sector, turned
from soccersim.render.likeness import NOSE, Likeness
from soccersim.spec.robot import Robot

STEPS = 240  # headings a sprite is drawn at: 1.5 degrees, under a pixel at the rim
KEPT = 3000  # sprites kept for the next frame, a few kilobytes each
GHOST_NOSE = 0.66  # of the radius: where a ghost's nose begins, so as not to hide a number
TARGET_RADIUS = 0.13  # m
TARGET_LEAST = 7.0  # px
GLOW = 9.0  # px, radius: on a large field the eye must find the ball
DIM = 100  # of 255: how strong a robot is that is out of play
ALPHA_GHOST = (240, 55, 215)  # of its outline, its disc and its nose


def paint_ball(radius: float, px_per_m: float, heading: float) -> Canvas:
    """A white ball with dark patches, its shadow, and a glow where it is small."""
    glow = GLOW / px_per_m
    canvas = Canvas.around(max(glow, 1.45 * radius), px_per_m)
    canvas.disc((0, 0), glow, look.GLOW)
    canvas.disc((0.2 * radius, -0.28 * radius), 1.04 * radius, look.SHADOW)
    canvas.disc((0, 0), radius, look.BALL_RIM)
    white = radius - min(0.09 * radius, 0.6 / px_per_m)
    canvas.disc((0, 0), white, look.BALL)
    corners = [i * 0.4 * pi for i in range(5)]
    patch = [(0.34 * radius * cos(angle), 0.34 * radius * sin(angle)) for angle in corners]
    canvas.polygon(turned(patch, heading), look.BALL_PATCH)
    for angle in corners:
        side = sector(white, angle - 0.22, angle + 0.22, 0.78 * radius)
        canvas.polygon(turned(side, heading), look.BALL_PATCH)
    return canvas


def paint_ghost(radius: float, px_per_m: float, heading: float) -> Canvas:
    """Where a robot believes it is: a see-through disc with the nose of a robot."""
    canvas = Canvas.around(1.1 * radius, px_per_m)
    outline, disc, nose = ((*look.BELIEVED, alpha) for alpha in ALPHA_GHOST)
    width = max(0.06 * radius, 1.6 / px_per_m)
    canvas.disc((0, 0), radius, disc)
    canvas.polygon(turned(sector(radius, -NOSE, NOSE, GHOST_NOSE * radius), heading), nose)
    canvas.ring((0, 0), radius, width, outline)
    return canvas


def target_radius(px_per_m: float) -> float:
    """Of a target's ring, m: large enough to be seen."""
    return max(TARGET_RADIUS, TARGET_LEAST / px_per_m)


def paint_target(px_per_m: float, heading: float) -> Canvas:
    """Where a robot shall go."""
    radius = target_radius(px_per_m)
    canvas = Canvas.around(2.0 * radius, px_per_m)
    draw_target(canvas, radius, max(0.16 * radius, 1.6 / px_per_m), heading)
    return canvas


def draw_target(canvas: Canvas, radius: float, width: float, heading: float) -> None:
    """A ring with a cross in the middle of the canvas, and an arrow head for the heading."""
    canvas.ring((0, 0), radius, width, look.TARGET)
    for angle in (0.0, pi / 2):
        start, end = turned([(-0.62 * radius, 0), (0.62 * radius, 0)], heading + angle)
        canvas.line(start, end, width, look.TARGET)
    arrow = [(1.85 * radius, 0.0), (1.12 * radius, 0.5 * radius), (1.12 * radius, -0.5 * radius)]
    canvas.polygon(turned(arrow, heading), look.TARGET)


class Sprites:
    """Robots, ball and marks at one scale; what was drawn once is kept, up to a bound."""

    def __init__(self, models: list[Robot], ball_radius: float, px_per_m: float) -> None:
        self.models = models
        self.likenesses = [Likeness(model) for model in models]
        self.ball_radius = ball_radius
        self.px_per_m = px_per_m
        self.take = lru_cache(KEPT)(self._paint)

    def _paint(self, kind: str, step: int, model: int = 0) -> pygame.Surface:
        """One of `home`, `away`, `ghost`, `target`, `ball`, turned to one of STEPS headings.

        `home off` and `away off` are robots out of play.
        """
        heading = step * 2 * pi / STEPS
        if kind == "ball":
            return paint_ball(self.ball_radius, self.px_per_m, heading).shrunk()
        if kind == "target":
            return paint_target(self.px_per_m, heading).shrunk()
        if kind == "ghost":
            return paint_ghost(self.models[model].radius, self.px_per_m, heading).shrunk()
        team, _, off = kind.partition(" ")
        likeness = self.likenesses[model]
        sprite = likeness.paint(look.TEAMS[team], self.px_per_m, heading).shrunk()
        if off:
            sprite.fill((DIM,) * 4, special_flags=pygame.BLEND_RGBA_MULT)
        return sprite
