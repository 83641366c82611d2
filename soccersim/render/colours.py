"""A picture as H.264 wants it, kept up to date: only what changed is turned into its colours.

To turn a whole picture of 1280 x 854 costs more than to draw it. From frame to frame a twentieth of
it changes; to find that is two reads of the picture.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
import pygame
from numpy.typing import NDArray

if TYPE_CHECKING:
    from av.video.frame import VideoFrame

CELLS = (16, 8, 4, 2)  # px, width of a cell; it is two rows high, as the colours are
AT_ONCE = (
    1024  # cells: what they take stays near the processor; all of them at once take 4 times as long
)
WHOLE = 2**13  # of the matrix: its numbers are whole, so that sums of float32 are exact

RED, BLUE = 0.2126, 0.0722  # shares of brightness, by ITU-R BT.709
GREEN = 1 - RED - BLUE
LUMA, CHROMA = 219 / 255, 112 / 255  # of their range in a film, which leaves room at both ends
BLACK, GREY = 16, 128


def _matrix() -> NDArray[np.float32]:
    """(4, 3): from blue, green, red and nothing to brightness, blueness and redness."""
    blue, red = 2 * (1 - BLUE), 2 * (1 - RED)
    rows = (
        (LUMA * BLUE, 2 * CHROMA * (1 - BLUE) / blue, 2 * CHROMA * -BLUE / red),
        (LUMA * GREEN, 2 * CHROMA * -GREEN / blue, 2 * CHROMA * -GREEN / red),
        (LUMA * RED, 2 * CHROMA * -RED / blue, 2 * CHROMA * (1 - RED) / red),
        (0.0, 0.0, 0.0),
    )
    matrix: NDArray[np.float32] = np.rint(np.array(rows) * WHOLE).astype(np.float32)
    return matrix


MATRIX = _matrix()
SQUARE = np.concatenate((MATRIX[:, 1:], MATRIX[:, 1:]))  # (8, 2): of two pixels side by side


class Colours:
    """One frame in yuv420p, with even sides, that follows a surface of 32 bits."""

    def __init__(self, frame: "VideoFrame") -> None:
        width, height = frame.width, frame.height
        self.frame = frame
        self.cell = next(cell for cell in CELLS if width % cell == 0)
        self.columns = width // self.cell
        planes = [
            np.frombuffer(memoryview(plane), np.uint8).reshape(plane.height, -1)[:, : plane.width]
            for plane in frame.planes
        ]
        rows = height // 2
        self.luma = planes[0].reshape(rows, 2, self.columns, self.cell)
        self.chroma = [plane.reshape(rows, self.columns, self.cell // 2) for plane in planes[1:]]
        self.pixels: NDArray[np.uint32] | None = None
        self.differs = np.empty((height, width // 2), bool)

    def follow(self, surface: pygame.Surface) -> "VideoFrame":
        """The frame, with this surface's picture in it."""
        pixels = pygame.surfarray.pixels2d(surface).T.astype(np.uint32, copy=False)
        if self.pixels is None:
            self.pixels = pixels.copy()
            self.differs[:] = True
        else:
            np.not_equal(pixels.view(np.uint64), self.pixels.view(np.uint64), out=self.differs)
        marks = self.differs.view(f"u{self.cell // 2}")  # two pixels are one bool
        changed = np.flatnonzero((marks[0::2] | marks[1::2]).astype(bool))
        rows, columns = np.divmod(changed, self.columns)
        shape = (len(self.luma), 2, self.columns, self.cell)
        new, old = pixels.reshape(shape), self.pixels.reshape(shape)
        for start in range(0, len(rows), AT_ONCE):
            row, column = rows[start : start + AT_ONCE], columns[start : start + AT_ONCE]
            cells = new[row, :, column]
            old[row, :, column] = cells
            self._turn(cells, row, column)
        return self.frame

    def _turn(self, cells: NDArray[np.uint32], row: Any, column: Any) -> None:
        """Cells (K, 2, cell) into the planes."""
        count, half = len(cells), self.cell // 2
        parts = cells.view(np.uint8).reshape(count, 2, -1).astype(np.float32)
        luma = (parts.reshape(-1, 4) @ MATRIX[:, 0] + WHOLE * (BLACK + 0.5)) * (1 / WHOLE)
        self.luma[row, :, column] = luma.astype(np.uint8).reshape(count, 2, self.cell)
        pairs = (parts[:, 0] + parts[:, 1]).reshape(-1, 8)  # of columns
        chroma = (pairs @ SQUARE + 4 * WHOLE * (GREY + 0.5)) * (0.25 / WHOLE)
        whole = chroma.astype(np.uint8).reshape(count, half, 2)
        for plane, part in zip(self.chroma, (whole[..., 0], whole[..., 1]), strict=True):
            plane[row, column] = part
