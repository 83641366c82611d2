"""Film frames of a recording, drawn off-screen: no display is needed."""

from collections.abc import Callable
from io import BytesIO
from os import PathLike
from pathlib import Path

import numpy as np
import pygame

from soccersim.problems import MachineError
from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.hud import Hud
from soccersim.render.pitch import View, paint_pitch
from soccersim.render.play import Play
from soccersim.render.trails import Trails

Progress = Callable[[int, int], None]  # how many frames are done, of how many


class FrameRenderer:
    """Draws the records of one recording; the same record gives the same pixels, always."""

    def __init__(self, recording: Recording, size: tuple[int, int] = look.SIZE) -> None:
        field = recording.scenario.field
        scale = look.scale(size)
        self.records = range(len(recording.tick))
        self.view = View.fit(field, size, round(look.BAND * scale))
        self.hud = Hud(recording, size)
        self.trails = Trails(recording, self.view)
        self.play = Play(recording, self.view, scale)
        self.surface, self.ground, self.background = (pygame.Surface(size, 0, 32) for _ in range(3))
        self.background.fill(look.PAGE)
        self.background.blit(paint_pitch(field, self.view), self.view.frame)
        self.hud.paint(self.background)
        self.ground.blit(self.background, (0, 0))
        self.ground.set_clip(self.view.frame)  # once filled, only play changes it
        self.pieces = -1  # of the trails that lie on the ground

    def draw(self, index: int) -> pygame.Surface:
        """The picture of one record. The next draw() paints over it: copy it to keep it."""
        index = self.records[index]
        surface = self.surface
        self._lay_ground(self.trails.finished(index))
        surface.blit(self.ground, (0, 0))
        surface.set_clip(self.view.frame)
        self.trails.draw(surface, index)
        self.play.draw(surface, index)
        surface.set_clip(None)
        surface.fblits(self.hud.blits(index))
        return surface

    def _lay_ground(self, pieces: int) -> None:
        """The background with so many pieces of the trails, unless it lies there already."""
        if pieces == self.pieces:
            return
        self.pieces = pieces
        self.ground.blit(self.background, (0, 0))
        self.trails.lay(self.ground, pieces)


def frame_indices(recording: Recording, fps: float | None = None) -> list[int]:
    """The record that each frame of a film shows: the last one before it is due."""
    fps = fps or recording.scenario.timing.frames_hz
    ticks_per_frame = float(recording.meta["physics_hz"]) / fps
    first, last = int(recording.tick[0]), int(recording.tick[-1])
    count = int((last - first) / ticks_per_frame + 1e-9) + 1
    due = first + np.arange(count) * ticks_per_frame
    indices = np.searchsorted(recording.tick, due + 1e-6, side="right") - 1
    return [int(index) for index in indices]


def save_frames(
    recording: Recording, folder: str | PathLike[str], progress: Progress | None = None
) -> int:
    """Write 000000.png and so on into a folder, made if it is not there; how many they are."""
    renderer = FrameRenderer(recording)
    indices = frame_indices(recording)
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
