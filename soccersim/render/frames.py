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
from soccersim.render.lettering import Blit
from soccersim.render.match_hud import MatchHud
from soccersim.render.match_play import MatchPlay
from soccersim.render.overlay import Overlay
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
        self.size = size
        self.background = cache(self._background)
        self.ground = Overlay(self.background(-1))  # with the trails, as far as they are complete
        self.overlay = Overlay(self.ground.surface)
        self.surface = self.overlay.surface
        self.bands = Overlay(self.ground.surface, self.surface)
        for each in (self.ground, self.overlay):
            each.surface.set_clip(self.view.frame)
        self.changed: list[pygame.Rect] = []  # all that may differ from the picture before
        self.laid = (0, -1)  # what lies on the ground: pieces of the trails, home's goal's side
        self.told: list[Blit] = []  # of the head-up display

    def draw(self, index: int) -> pygame.Surface:
        """The picture of one record. The next draw() paints over it: copy it to keep it."""
        index = self.records[index]
        overlay = self.overlay
        laid = self._lay_ground(self.trails.finished(index), self._home(index))
        self.changed = overlay.clear(laid)
        self.trails.draw(overlay, index)
        self.play.draw(overlay, index)
        self.changed += overlay.drawn
        self._tell(self.hud.blits(index))
        return overlay.surface

    def _tell(self, blits: list[Blit]) -> None:
        """The head-up display, where it says something else than before."""
        if blits == self.told:
            return
        self.told = blits
        self.surface.set_clip(None)
        self.changed += self.bands.clear()
        self.bands.lay(blits, 0)
        self.changed += self.bands.drawn
        self.surface.set_clip(self.view.frame)

    def _home(self, index: int) -> int:
        """The sign of x at which home has its goal."""
        return -self.story.direction[self.story.decision[index]] if self.story else -1

    def _lay_ground(self, pieces: int, home: int) -> list[pygame.Rect]:
        """So many pieces of the trails, and the goals' sides; what of the ground has changed."""
        if self.laid == (pieces, home):
            return []
        ground, turned = self.ground, home != self.laid[1]
        self.laid = (pieces, home)
        ground.ground = self.background(home)
        changed = ground.clear([self.view.frame] if turned else [])
        self.trails.lay(ground, pieces)
        return changed + ground.drawn

    def _background(self, home: int) -> pygame.Surface:
        """What never changes, besides the sides' ends."""
        background = pygame.Surface(self.size, 0, 32)
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
