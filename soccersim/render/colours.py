"""A picture as H.264 wants it, kept up to date: only what changed is turned into its colours.

To turn a whole picture of 1280 x 854 takes four times as long as to draw one. From frame to frame a
twentieth of it changes.
"""

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
import pygame
from numpy.typing import NDArray

from soccersim.kernel import kernel

if TYPE_CHECKING:
    from av.video.frame import VideoFrame

RED, BLUE = 0.2126, 0.0722  # shares of brightness, by ITU-R BT.709
GREEN = 1 - RED - BLUE
LUMA, CHROMA = 219 / 255, 112 / 255  # of their range in a film, which leaves room at both ends
BLACK, GREY = 16, 128
BITS = 13  # of the weights: they are whole numbers of 1 / 2**BITS

Plane = NDArray[np.uint8]


def _weights() -> tuple[tuple[int, int, int], ...]:
    """Of red, green and blue in brightness, blueness and redness."""
    blue, red = 2 * (1 - BLUE), 2 * (1 - RED)
    rows = (
        (LUMA * RED, LUMA * GREEN, LUMA * BLUE),
        (2 * CHROMA * -RED / blue, 2 * CHROMA * -GREEN / blue, 2 * CHROMA * (1 - BLUE) / blue),
        (2 * CHROMA * (1 - RED) / red, 2 * CHROMA * -GREEN / red, 2 * CHROMA * -BLUE / red),
    )
    return tuple((round(r * 2**BITS), round(g * 2**BITS), round(b * 2**BITS)) for r, g, b in rows)


BRIGHT, BLUISH, REDDISH = _weights()


class Colours:
    """One frame in yuv420p, with even sides, that follows a surface of 32 bits."""

    def __init__(self, frame: "VideoFrame") -> None:
        self.frame = frame
        self.last: NDArray[np.uint32] | None = None
        self.planes: list[Plane] = [
            np.frombuffer(memoryview(plane), np.uint8).reshape(plane.height, -1)
            for plane in frame.planes
        ]

    def follow(self, surface: pygame.Surface, changed: Iterable[pygame.Rect]) -> "VideoFrame":
        """The frame with this picture in it; changed: all that may differ from the last one."""
        pixels = np.ascontiguousarray(pygame.surfarray.pixels2d(surface).T, np.uint32)
        if self.last is None:
            self.last, changed = ~pixels, [surface.get_rect()]
        parts = [(rect.left, rect.top, rect.right, rect.bottom) for rect in changed]
        turn(pixels, self.last, np.array(parts, np.int64).reshape(-1, 4), *self.planes)
        return self.frame


@kernel
def turn(
    pixels: NDArray[np.uint32],
    last: NDArray[np.uint32],
    parts: NDArray[np.int64],
    luma: Plane,
    blueness: Plane,
    redness: Plane,
) -> None:
    """Turn what differs from the last picture in parts (N, 4): left, top, right, bottom.

    Two by two pixels share their colour, and have a brightness each.
    """
    half, grey, black = 1 << (BITS - 1), GREY << BITS, BLACK << BITS
    for part in range(parts.shape[0]):
        left, right = parts[part, 0] // 2, (parts[part, 2] + 1) // 2
        for v in range(parts[part, 1] // 2, (parts[part, 3] + 1) // 2):
            for u in range(left, right):
                reds, greens, blues = 0, 0, 0
                same = True
                for corner in range(4):
                    y, x = 2 * v + corner // 2, 2 * u + corner % 2
                    same = same and pixels[y, x] == last[y, x]
                if same:  # most is drawn again as it was
                    continue
                for corner in range(4):
                    y, x = 2 * v + corner // 2, 2 * u + corner % 2
                    last[y, x] = pixels[y, x]
                    pixel = int(pixels[y, x])
                    red, green, blue = (pixel >> 16) & 255, (pixel >> 8) & 255, pixel & 255
                    bright = BRIGHT[0] * red + BRIGHT[1] * green + BRIGHT[2] * blue
                    luma[y, x] = (bright + black + half) >> BITS
                    reds, greens, blues = reds + red, greens + green, blues + blue
                hue = BLUISH[0] * reds + BLUISH[1] * greens + BLUISH[2] * blues
                blueness[v, u] = (hue + 4 * (grey + half)) >> (BITS + 2)
                hue = REDDISH[0] * reds + REDDISH[1] * greens + REDDISH[2] * blues
                redness[v, u] = (hue + 4 * (grey + half)) >> (BITS + 2)
