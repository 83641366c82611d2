"""Film frames of a recording, drawn off-screen: no display is needed."""

from collections.abc import Callable
from functools import cache
from io import BytesIO
from os import PathLike
from pathlib import Path

import pygame

from soccersim.problems import MachineError
from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.cut import Cut, frame_indices
from soccersim.render.hud import Hud
from soccersim.render.match_hud import MatchHud
from soccersim.render.match_play import MatchPlay
from soccersim.render.pitch import View, paint_pitch
from soccersim.render.play import Play
from soccersim.render.story import Story
from soccersim.render.trails import Trails

Progress = Callable[[int, int], None]  # how many frames are done, of how many


class FrameRenderer:
    """Draws the records of one recording; the same record gives the same pixels, always."""

    def __init__(self, recording: Recording, size: tuple[int, int] = look.SIZE) -> None:
        scale = look.scale(size)
        self.field = recording.scenario.field
        self.records = range(len(recording.tick))
        self.view = View.fit(self.field, size, round(look.BAND * scale))
        self.trails = Trails(recording, self.view)
        self.hud: Hud | MatchHud
        if recording.match is None:
            self.story = None
            self.hud = Hud(recording, size)
            self.play = Play(recording, self.view, scale)
        else:
            self.story = Story(recording)
            self.hud = MatchHud(recording, size, self.story)
            self.play = MatchPlay(recording, self.view, scale, self.story)
        self.surface, self.ground = (pygame.Surface(size, 0, 32) for _ in range(2))
        self.background = cache(self._background)
        self.laid = (0, 0)  # what lies on the ground: pieces of the trails, home's goal's side

    def draw(self, index: int) -> pygame.Surface:
        """The picture of one record. The next draw() paints over it: copy it to keep it."""
        index = self.records[index]
        surface = self.surface
        self._lay_ground(self.trails.finished(index), self._home(index))
        surface.blit(self.ground, (0, 0))
        surface.set_clip(self.view.frame)
        self.trails.draw(surface, index)
        self.play.draw(surface, index)
        surface.set_clip(None)
        surface.fblits(self.hud.blits(index))
        return surface

    def _home(self, index: int) -> int:
        """The sign of x at which home has its goal."""
        return -self.story.direction[self.story.decision[index]] if self.story else -1

    def _lay_ground(self, pieces: int, home: int) -> None:
        """The background with so many pieces of the trails, unless it lies there already."""
        if self.laid == (pieces, home):
            return
        background = self.background(home)
        self.ground.set_clip(self.view.frame if self.laid[1] else None)  # all, the first time
        self.laid = (pieces, home)
        self.ground.blit(background, (0, 0))
        self.ground.set_clip(self.view.frame)
        self.trails.lay(self.ground, pieces)

    def _background(self, home: int) -> pygame.Surface:
        """What never changes, besides the sides' ends."""
        background = pygame.Surface(self.surface.size, 0, 32)
        background.fill(look.PAGE)
        background.blit(paint_pitch(self.field, self.view, home), self.view.frame)
        self.hud.paint(background)
        return background


def save_frames(
    recording: Recording,
    folder: str | PathLike[str],
    progress: Progress | None = None,
    cut: Cut | None = None,
) -> int:
    """Write 000000.png and so on into a folder, made if it is not there; how many they are."""
    cut = cut or Cut()
    indices = frame_indices(recording, cut)
    renderer = FrameRenderer(recording, cut.size)
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
        for number, index in enumerate(indices):
            path = Path(folder) / f"{number:06d}.png"
            path.write_bytes(_png(renderer.draw(index)))
            if progress:
                progress(number + 1, len(indices))
    except OSError as error:
        raise MachineError(f"{path}: {error.strerror or error}") from error
    return len(indices)


def _png(surface: pygame.Surface) -> bytes:
    file = BytesIO()  # not straight to the disk: pygame does not tell when that is full
    pygame.image.save(surface, file, "frame.png")
    return file.getvalue()
