"""Frames to MP4: how near drawing and encoding together come to encoding alone, in one run."""

from pathlib import Path
from runpy import run_path
from time import perf_counter

import av
import numpy as np
import pytest

from soccersim.render import look
from soccersim.render.colours import Colours
from soccersim.render.cut import Cut, frame_indices
from soccersim.render.frames import FrameRenderer
from soccersim.render.video import film_stream, save_video

HERE = Path(__file__).parents[1] / "render"
SECONDS, PASSES = 10.0, 5  # of film; the quickest pass counts, as others only ever make it slower
SHARE = 0.8


def kept(scene, cut):
    """All frames of the film, as the encoder gets them."""
    renderer, frames = FrameRenderer(scene, cut.size), []
    colours = Colours(av.VideoFrame(*cut.size, "yuv420p"))
    for number, index in enumerate(frame_indices(scene, cut)):
        frame = av.VideoFrame(*cut.size, "yuv420p")
        for new, old in zip(frame.planes, colours.follow(renderer.draw(index)).planes, strict=True):
            new.update(np.frombuffer(old, np.uint8))
        frame.pts = number
        frames.append(frame)
    return frames


def encode(frames, path, fps):
    """The encoder alone, with the same settings, into a file as well."""
    with av.open(str(path), "w", format="mp4") as file:
        stream = film_stream(file, ".mp4", look.SIZE, fps)
        for frame in frames:
            file.mux(stream.encode(frame))
        file.mux(stream.encode(None))


def timed(work):
    start = perf_counter()
    work()
    return perf_counter() - start


@pytest.mark.benchmark
@pytest.mark.parametrize("kind", ["kickabout", "match"])
def test_a_film_is_made_at_four_fifths_of_the_encoders_own_rate(kind, tmp_path, capsys):
    if kind == "match":
        scene = run_path(str(HERE / "synthetic_match.py"))["match"](60.0)
    else:
        scene = run_path(str(HERE / "synthetic.py"))["kickabout"](10, seconds=20.0)
    cut = Cut(4.0, 4.0 + SECONDS)
    frames, fps = kept(scene, cut), scene.scenario.timing.frames_hz
    both, alone = [], []
    for _ in range(PASSES):
        both.append(timed(lambda: save_video(scene, tmp_path / "film.mp4", cut=cut)))
        alone.append(timed(lambda: encode(frames, tmp_path / "alone.mp4", fps)))
    share = min(alone) / min(both)
    with capsys.disabled():
        rates = [len(frames) / min(times) for times in (both, alone)]
        print(f"\n{kind}: {rates[0]:.0f} frames/s, encoder alone {rates[1]:.0f}: {share:.2f}")
    assert (tmp_path / "film.mp4").read_bytes() == (tmp_path / "alone.mp4").read_bytes()
    assert share >= SHARE
