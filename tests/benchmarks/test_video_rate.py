"""Frames to MP4: how near turning and encoding pictures come to encoding alone, in one run."""

from pathlib import Path
from runpy import run_path
from time import process_time

import av
import numpy as np
import pytest

from soccersim.render import look
from soccersim.render.colours import Colours
from soccersim.render.cut import Cut, frame_indices
from soccersim.render.frames import FrameRenderer
from soccersim.render.video import film_stream, save_video, write_film

HERE = Path(__file__).parents[1] / "render"
SECONDS, PASSES = 6.0, 5  # of film; the quickest pass counts, as others only ever make it slower
SHARE = 0.8  # of the encoder's own rate, from drawn frames to the file
DRAWN = 0.45  # the same with drawing, in so short a film: no robot has been drawn before


class Drawn:
    """A renderer that has drawn all its pictures."""

    def __init__(self, scene, cut):
        renderer = FrameRenderer(scene, cut.size)
        self.pictures = [renderer.draw(index).copy() for index in frame_indices(scene, cut)]
        self.surface = self.pictures[0]

    def draw(self, index):
        return self.pictures[index]


def turned(drawn):
    """All frames of the film, as the encoder gets them."""
    size, frames = drawn.surface.size, []
    colours = Colours(av.VideoFrame(*size, "yuv420p"))
    for number, picture in enumerate(drawn.pictures):
        frame = av.VideoFrame(*size, "yuv420p")
        for new, old in zip(frame.planes, colours.follow(picture).planes, strict=True):
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
    """CPU time of all threads: other programs share the cores, and would be measured as well."""
    start = process_time()
    work()
    return process_time() - start


@pytest.mark.benchmark
@pytest.mark.parametrize("kind", ["kickabout", "match"])
def test_a_film_is_made_at_four_fifths_of_the_encoders_own_rate(kind, tmp_path, capsys):
    if kind == "match":
        scene = run_path(str(HERE / "synthetic_match.py"))["match"](60.0)
    else:
        scene = run_path(str(HERE / "synthetic.py"))["kickabout"](10, seconds=20.0)
    cut, fps = Cut(4.0, 4.0 + SECONDS), scene.scenario.timing.frames_hz
    drawn = Drawn(scene, cut)
    frames, indices = turned(drawn), list(range(len(drawn.pictures)))
    works = {
        "alone": lambda path: encode(frames, path, fps),
        "film": lambda path: write_film(path, ".mp4", drawn, indices, fps),
        "whole": lambda path: save_video(scene, path, cut=cut),
    }
    paths = {name: tmp_path / f"{name}.mp4" for name in works}
    times = {name: [] for name in works}
    for _ in range(PASSES):
        for name, work in works.items():
            times[name].append(timed(lambda work=work, name=name: work(paths[name])))
    rates = {name: len(frames) / min(each) for name, each in times.items()}
    with capsys.disabled():
        told = ", ".join(f"{name} {rate:.0f}" for name, rate in rates.items())
        print(
            f"\n{kind}: frames a second of CPU time: {told}; {rates['film'] / rates['alone']:.2f}"
        )
    assert len({path.read_bytes() for path in paths.values()}) == 1
    assert rates["film"] >= SHARE * rates["alone"]
    assert rates["whole"] >= DRAWN * rates["alone"]
