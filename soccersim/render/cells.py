"""The table below the field: for every robot its leg and how far its belief is off."""

from typing import NamedTuple

import numpy as np
import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.lettering import Blit, Lettering
from soccersim.spec.player import Player


class Grid(NamedTuple):
    """How many cells there are, their letters in px, and where a cell's columns lie in it."""

    columns: int
    rows: int
    text: float
    name: float  # share of the cell's width; where the name begins
    leg: float  # where these end
    distance: float
    angle: float


GRIDS = (  # the first that holds all robots is taken
    Grid(4, 1, 15, 0.12, 0.52, 0.77, 0.97),
    Grid(5, 2, 13, 0.12, 0.50, 0.745, 0.975),
    Grid(5, 3, 12, 0.11, 0.49, 0.745, 0.975),
    Grid(6, 4, 11, 0.11, 0.48, 0.74, 0.98),
)
EDGE = 12  # px at the left and right of the table
CAPTION = 14  # px, height of the line that names the columns
GAP = 6  # px between two columns of cells
MINUS = "\u2212"  # as wide as the plus, unlike a hyphen
TALLEST = 30  # px, of a cell
WIDEST = 420  # px, the same
CAPTIONS = (("leg", "leg"), ("distance", "off by"), ("angle", "turned"))


class Cells:
    """One cell a robot; the frame of each is painted once, its figures in every picture."""

    def __init__(self, recording: Recording, size: tuple[int, int]) -> None:
        self.players = recording.scenario.robots
        self.leg = recording.leg
        off = recording.estimate - recording.body[:, : len(self.players), :3]
        self.distance = np.hypot(off[..., 0], off[..., 1])
        self.angle = np.degrees((off[..., 2] + np.pi) % (2 * np.pi) - np.pi)
        self.scale = look.scale(size)
        self.grid = next(g for g in GRIDS if g.columns * g.rows >= len(self.players))
        self.places = self._lay_out(size)
        self.text = self._lettering(look.INK, look.CARD)
        self.faint = self._lettering(look.FAINT, look.CARD)

    def _lettering(self, ink: look.Colour, ground: look.Colour) -> Lettering:
        return Lettering(self.grid.text * self.scale, ink, ground)

    def _lay_out(self, size: tuple[int, int]) -> list[pygame.Rect]:
        """The cells, row by row, in the middle of the band below the field."""
        columns = max(1, min(self.grid.columns, len(self.players)))
        gap, band = GAP * self.scale, look.BAND * self.scale
        width = min((size[0] - 2 * EDGE * self.scale) / columns, WIDEST * self.scale)
        pitch = min((band - (CAPTION + 4) * self.scale) / self.grid.rows, TALLEST * self.scale)
        left = (size[0] - columns * width) / 2
        top = size[1] - band + (CAPTION + 1) * self.scale
        return [
            pygame.Rect(
                round(left + i % columns * width + gap / 2),
                round(top + i // columns * pitch),
                int(width - gap),
                int(pitch - 1),
            )
            for i in range(len(self.players))
        ]

    def paint(self, picture: pygame.Surface) -> None:
        """Cards, numbers, names, and the captions above the first row."""
        caption = Lettering(11 * self.scale, look.FAINT, look.PAGE)
        for cell in self.places[: self.grid.columns]:
            for key, text in CAPTIONS:
                x = cell.x + getattr(self.grid, key) * cell.width - caption.width(text)
                caption.write(picture, text, x, cell.y - 8 * self.scale)
        for player, cell in zip(self.players, self.places, strict=True):
            self._paint_cell(picture, player, cell)

    def _paint_cell(self, picture: pygame.Surface, player: Player, cell: pygame.Rect) -> None:
        colour = look.TEAMS[player.team]
        pygame.draw.rect(picture, look.CARD, cell, border_radius=3)
        badge = pygame.Rect(
            cell.x, cell.y, round((self.grid.name - 0.02) * cell.width), cell.height
        )
        pygame.draw.rect(
            picture, colour, badge, border_top_left_radius=3, border_bottom_left_radius=3
        )
        number = Lettering(self.grid.text * self.scale, look.INK, colour, bold=True)
        x = badge.centerx - number.width(str(player.number)) / 2
        number.write(picture, str(player.number), x, cell.centery)
        left = cell.x + self.grid.name * cell.width
        count = len(player.path or player.open_loop or ())
        leg = self.text.width(f"{count}/{count} ")
        room = cell.x + self.grid.leg * cell.width - left - leg
        self.text.write(picture, self.text.fitted(player.name, room), left, cell.centery)

    def blits(self, index: int) -> list[Blit]:
        """The figures of one record."""
        grid = self.grid
        blits: list[Blit] = []
        rows = zip(
            self.players,
            self.places,
            self.leg[index].tolist(),
            self.distance[index].tolist(),
            self.angle[index].tolist(),
            strict=True,
        )
        for player, cell, leg, distance, angle in rows:
            x, width, y = cell.x, cell.width, cell.centery
            columns = (
                (self.faint, grid.leg, leg_text(player, leg)),
                (self.text, grid.distance, distance_text(distance)),
                (self.text, grid.angle, angle_text(angle)),
            )
            for letters, share, text in columns:
                blits.append(letters.ending_at(x + share * width, y, text))
        return blits


def leg_number(player: Player, leg: int) -> int:
    """Which leg or phase of its plan a robot is on, from 0; the last one after its end."""
    count = len(player.path or player.open_loop or ())
    return leg % count if player.repeat else min(leg, count - 1)


def leg_text(player: Player, leg: int) -> str:
    """Which leg of how many, from 1; nothing without a plan."""
    count = len(player.path or player.open_loop or ())
    return f"{leg_number(player, leg) + 1}/{count}" if count else ""


def distance_text(metres: float) -> str:
    """In the unit that leaves three figures."""
    if metres < 0.0995:
        return f"{metres * 1000:.0f} mm"
    return f"{metres * 100:.1f} cm" if metres < 0.9995 else f"{metres:.2f} m"


def angle_text(degrees: float) -> str:
    """With its sign: counter-clockwise is positive."""
    return f"{degrees:+.1f}°".replace("-", MINUS)
