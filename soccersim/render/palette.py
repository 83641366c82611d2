"""The 256 colours of a GIF: chosen from some of its frames, then used for all of them.

One palette for the whole film, so that no frame has to wait for the ones after it, and a still
background stays still in every bit.
"""

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from av.video.frame import VideoFrame

TICK = Fraction(1, 100)  # s, a GIF's own unit of time; of no use here but asked for


class Palette:
    """Turns frames to the nearest of these colours, without dither: it would shimmer."""

    def __init__(self, av: Any, size: tuple[int, int], samples: Iterable["VideoFrame"]) -> None:
        self.number = 0
        graph = av.filter.Graph()
        source = _source(graph, size)
        chooser = graph.add("palettegen", "stats_mode=full")
        sink = graph.add("buffersink")
        source.link_to(chooser)
        chooser.link_to(sink)
        graph.configure()
        for number, frame in enumerate(samples):
            frame.pts = number
            source.push(frame)
        source.push(None)
        self._use(av, size, sink.pull())

    def _use(self, av: Any, size: tuple[int, int], colours: "VideoFrame") -> None:
        graph = av.filter.Graph()
        self.source, palette = _source(graph, size), _source(graph, (16, 16))
        user = graph.add("paletteuse", "dither=none")
        self.sink = graph.add("buffersink")
        self.source.link_to(user, 0, 0)
        palette.link_to(user, 0, 1)
        user.link_to(self.sink)
        graph.configure()
        colours.pts = 0
        palette.push(colours)
        palette.push(None)
        self.graph = graph

    def turned(self, frame: "VideoFrame") -> "VideoFrame":
        """The frame in these colours."""
        frame.pts, self.number = self.number, self.number + 1
        self.source.push(frame)
        turned: VideoFrame = self.sink.pull()
        return turned


def _source(graph: Any, size: tuple[int, int]) -> Any:
    width, height = size
    return graph.add_buffer(width=width, height=height, format="bgra", time_base=TICK)
