"""A recording as a film: MP4 with H.264, which every player shows, an animated GIF, or a WebP."""

from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from fractions import Fraction
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Protocol, cast

import numpy as np
import pygame

from soccersim.problems import InputError, MachineError, Problem
from soccersim.record.recording import Recording
from soccersim.render.colours import Colours
from soccersim.render.cut import Cut, film_kind, frame_indices
from soccersim.render.frames import FrameRenderer, Progress

if TYPE_CHECKING:
    from av.container import OutputContainer
    from av.packet import Packet
    from av.video.frame import VideoFrame
    from av.video.stream import VideoStream

THREADS = 2  # the bytes of a film depend on it, so it is never the number of this machine's cores
CODECS: dict[str, tuple[str, str, dict[str, str]]] = {  # kind: codec, its pixels, its options
    ".mp4": ("libx264", "yuv420p", {"crf": "18", "preset": "veryfast"}),  # crisp lines, letters
    ".gif": ("gif", "pal8", {}),
    ".webp": ("libwebp_anim", "bgra", {"lossless": "1", "quality": "50", "compression_level": "2"}),
}
FOREVER = {".webp": {"loop": "0"}}  # a GIF goes round and round by itself
ENDS = 2.0  # s that the end of a match stands still, to be read
BT709 = 1  # as H.264 writes it down
OPAQUE = np.uint32(0xFF000000)
SAMPLES = 60  # frames whose colours go into the palette of a GIF


class Renderer(Protocol):
    """Whatever draws pictures onto one surface."""

    surface: pygame.Surface
    changed: list[pygame.Rect]  # all that may differ from the picture drawn before

    def draw(self, index: int) -> pygame.Surface:
        """The picture of one record."""


def save_video(
    recording: Recording,
    path: str | PathLike[str],
    progress: Progress | None = None,
    cut: Cut | None = None,
    kind: str = "",
) -> int:
    """Write the film and say how many frames it has; the same recording gives the same bytes.

    kind: `.mp4`, `.gif` or `.webp`, instead of what the path ends in.
    """
    cut, kind = cut or Cut(), kind or film_kind(path)
    av = pyav()
    indices = frame_indices(recording, cut)
    if recording.match and cut.end is None:
        indices += [len(recording.tick) - 1] * round(ENDS * recording.scenario.timing.frames_hz)
    renderer = FrameRenderer(recording, cut.size)
    fps = recording.scenario.timing.frames_hz
    try:
        write_film(path, kind, renderer, indices, fps, progress)
    except (OSError, av.FFmpegError) as error:
        reason = getattr(error, "strerror", None) or error
        raise MachineError(f"{fspath(path)}: {reason}") from error
    return len(indices)


def write_film(
    path: str | PathLike[str],
    kind: str,
    renderer: Renderer,
    indices: list[int],
    fps: int,
    progress: Progress | None = None,
) -> None:
    """Encode these pictures of a renderer, one after the other."""
    av, options = pyav(), FOREVER.get(kind, {})
    with av.open(fspath(path), "w", format=kind[1:], options=options) as file:
        encoder = Encoder(file, film_stream(file, kind, renderer.surface.size, fps))
        try:
            for number, frame in enumerate(_frames(av, kind, renderer, indices, encoder)):
                frame.pts, frame.time_base = number, Fraction(1, fps)
                encoder.start(frame)
                if progress:
                    progress(number + 1, len(indices))
        finally:  # an interrupted film can be seen up to where it came
            encoder.start(None)
            encoder.wait()


class Encoder:
    """Encodes a frame in a thread of its own: meanwhile the next picture is drawn."""

    def __init__(self, file: "OutputContainer", stream: "VideoStream") -> None:
        self.file, self.stream = file, stream
        self.thread = ThreadPoolExecutor(1)
        self.encoding: Future[list[Packet[Any]]] | None = None

    def start(self, frame: "VideoFrame | None") -> None:
        """The next frame, which must stay as it is until wait() returns; None ends the film."""
        self.wait()
        self.encoding = self.thread.submit(self.stream.encode, frame)

    def wait(self) -> None:
        """Until the last frame is read, and what came of it is in the file."""
        if self.encoding:
            packets, self.encoding = self.encoding.result(), None
            self.file.mux(packets)


def film_stream(
    file: "OutputContainer", kind: str, size: tuple[int, int], fps: int
) -> "VideoStream":
    """The stream of a film, with our encoder's settings."""
    codec, pixels, options = CODECS[kind]
    stream: VideoStream = cast("VideoStream", file.add_stream(codec, fps, options))
    stream.width, stream.height = size
    stream.pix_fmt = pixels
    stream.thread_count = THREADS
    context = stream.codec_context
    if kind == ".mp4":
        context.colorspace = context.color_primaries = context.color_trc = BT709
    return stream


def pyav() -> Any:
    """The library that encodes; InputError where it is not installed."""
    try:
        import av
    except ImportError:
        missing = "a video needs PyAV, which is not installed: pip install 'soccersim[video]'"
        raise InputError(Problem(missing)) from None
    return av


def _frames(
    av: Any, kind: str, renderer: Renderer, indices: list[int], encoder: Encoder
) -> Iterator["VideoFrame"]:
    """Each frame of the film as its encoder wants it."""
    if kind == ".mp4":
        colours = Colours(av.VideoFrame(*renderer.surface.size, "yuv420p"))
        for index in indices:
            picture = renderer.draw(index)
            encoder.wait()
            yield colours.follow(picture, renderer.changed)
    elif kind == ".webp":
        for index in indices:
            yield copied(av, renderer.draw(index))
    else:
        from soccersim.render.palette import Palette

        step = max(1, len(indices) // SAMPLES)
        samples = (copied(av, renderer.draw(index)) for index in indices[::step])
        palette = Palette(av, renderer.surface.size, samples)
        for index in indices:
            yield palette.turned(copied(av, renderer.draw(index)))


def copied(av: Any, surface: pygame.Surface) -> "VideoFrame":
    """A copy of a surface as a frame that hides what is below: surfaces leave their fourth byte."""
    pixels = pygame.surfarray.pixels2d(surface).T | OPAQUE
    whole = pixels.astype("<u4").view("u1").reshape(surface.height, surface.width, 4)
    frame: VideoFrame = av.VideoFrame.from_ndarray(whole, format="bgra")
    return frame
