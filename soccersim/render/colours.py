"""A picture as H.264 wants it, kept up to date: only what changed is turned into its colours.

To turn a whole picture of 1280 x 854 takes four times as long as to draw one. From frame to frame a
twentieth of it changes.
"""

from collections.abc import Sequence
from itertools import chain
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
Pairs = NDArray[np.uint64]  # two pixels side by side: the left one is the lower half


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
        self.last: Pairs | None = None
        self.planes: list[Plane] = [
            np.frombuffer(memoryview(plane), np.uint8).reshape(plane.height, -1)
            for plane in frame.planes
        ]

    def follow(self, surface: pygame.Surface, changed: Sequence[pygame.Rect]) -> "VideoFrame":
        """The frame with this picture in it; changed: all that may differ from the last one."""
        pixels = np.ascontiguousarray(pygame.surfarray.pixels2d(surface).T, "<u4")
        pairs = pixels.view("<u8")
        if self.last is None:
            self.last, changed = ~pairs, [surface.get_rect()]
        parts = np.fromiter(chain.from_iterable(changed), np.int64, 4 * len(changed))
        turn(pairs, self.last, parts.reshape(-1, 4), *self.planes)
        return self.frame


@kernel
def turn(
    pairs: Pairs,
    last: Pairs,
    parts: NDArray[np.int64],
    luma: Plane,
    blueness: Plane,
    redness: Plane,
) -> None:
    """Turn what differs from the last picture in parts (N, 4): left, top, width, height.

    Two by two pixels share their colour, and have a brightness each.
    """
    half, grey, black = 1 << (BITS - 1), GREY << BITS, BLACK << BITS
    for part in range(parts.shape[0]):
        left, top = parts[part, 0], parts[part, 1]
        right, bottom = left + parts[part, 2], top + parts[part, 3]
        for v in range(top // 2, (bottom + 1) // 2):
            for u in range(left // 2, (right + 1) // 2):
                upper, lower = pairs[2 * v, u], pairs[2 * v + 1, u]
                if upper == last[2 * v, u] and lower == last[2 * v + 1, u]:
                    continue  # most is drawn again as it was
                last[2 * v, u], last[2 * v + 1, u] = upper, lower
                reds, greens, blues = 0, 0, 0
                for corner in range(4):
                    pair = int(upper if corner < 2 else lower)
                    pixel = pair >> 32 if corner % 2 else pair
                    red, green, blue = (pixel >> 16) & 255, (pixel >> 8) & 255, pixel & 255
                    bright = BRIGHT[0] * red + BRIGHT[1] * green + BRIGHT[2] * blue
                    luma[2 * v + corner // 2, 2 * u + corner % 2] = (bright + black + half) >> BITS
                    reds, greens, blues = reds + red, greens + green, blues + blue
                hue = BLUISH[0] * reds + BLUISH[1] * greens + BLUISH[2] * blues
                blueness[v, u] = (hue + 4 * (grey + half)) >> (BITS + 2)
                hue = REDDISH[0] * reds + REDDISH[1] * greens + REDDISH[2] * blues
                redness[v, u] = (hue + 4 * (grey + half)) >> (BITS + 2)
