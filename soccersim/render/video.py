"""A recording as a film: MP4 with H.264, which every player shows."""

from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

import numpy as np
import pygame

from soccersim.problems import InputError, MachineError, Problem
from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.frames import FrameRenderer, Progress, frame_indices

if TYPE_CHECKING:
    from av.video.frame import VideoFrame
    from av.video.stream import VideoStream

THREADS = 2  # the bytes of a film depend on it, so it is never the number of this machine's cores
OPTIONS = {"crf": "18", "preset": "veryfast"}  # crisp lines and letters
COLOURS = "ITU709"  # as players expect them in a film as wide as ours
ENDS = 2.0  # s that the end of a match stands still, to be read
BT709 = 1  # the same, as H.264 writes it down


def save_video(
    recording: Recording, path: str | PathLike[str], progress: Progress | None = None
) -> int:
    """Write the film and say how many frames it has; the same recording gives the same bytes."""
    av = _av()
    renderer, indices = FrameRenderer(recording), frame_indices(recording)
    if recording.match:
        indices += [len(recording.tick) - 1] * round(ENDS * recording.scenario.timing.frames_hz)
    try:
        with av.open(fspath(path), "w", format="mp4") as file:
            stream = _stream(file, recording.scenario.timing.frames_hz)
            try:
                for number, index in enumerate(indices):
                    file.mux(stream.encode(_frame(renderer.draw(index), av)))
                    if progress:
                        progress(number + 1, len(indices))
            finally:  # an interrupted film can be seen up to where it came
                file.mux(stream.encode(None))
    except (OSError, av.FFmpegError) as error:
        reason = getattr(error, "strerror", None) or error
        raise MachineError(f"{fspath(path)}: {reason}") from error
    return len(indices)


def _av() -> Any:
    try:
        import av
    except ImportError:
        missing = "a video needs PyAV, which is not installed: pip install 'soccersim[video]'"
        raise InputError(Problem(missing)) from None
    return av


def _frame(surface: pygame.Surface, av: Any) -> "VideoFrame":
    pixels = np.frombuffer(surface.get_buffer().raw, np.uint8)
    frame: VideoFrame = av.VideoFrame.from_ndarray(
        pixels.reshape(surface.height, surface.width, 4), format="bgra"
    )
    return frame.reformat(format="yuv420p", dst_colorspace=COLOURS)


def _stream(file: Any, fps: int) -> "VideoStream":
    stream: VideoStream = file.add_stream("libx264", rate=fps, options=OPTIONS)
    stream.width, stream.height = look.SIZE
    stream.pix_fmt = "yuv420p"
    stream.thread_count = THREADS
    context = stream.codec_context
    context.colorspace = context.color_primaries = context.color_trc = BT709
    return stream
