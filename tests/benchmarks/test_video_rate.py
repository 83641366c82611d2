"""Frames to MP4: how near drawing, turning and encoding come to encoding alone, in one run."""

from pathlib import Path
from runpy import run_path
from time import process_time

import av
import numpy as np
import pytest

from soccersim import Recording, play_match
from soccersim.render import look
from soccersim.render.colours import Colours
from soccersim.render.cut import Cut, frame_indices
from soccersim.render.frames import FrameRenderer
from soccersim.render.video import film_stream, save_video, write_film

HERE = Path(__file__).parents[1] / "render"
SECONDS, PASSES = 10.0, 5  # of film; the quickest pass counts, as others only ever make it slower
SHARE = 0.8  # of the encoder's own rate, from a renderer that has drawn robots before to the file
WHOLE = 0.65  # the same with all that is done once: backgrounds, each robot at each heading


def turned(renderer, indices):
    """All frames of the film, as the encoder gets them."""
    size, frames = renderer.surface.size, []
    colours = Colours(av.VideoFrame(*size, "yuv420p"))
    for number, index in enumerate(indices):
        followed = colours.follow(renderer.draw(index), [renderer.surface.get_rect()])
        frame = av.VideoFrame(*size, "yuv420p")
        for new, old in zip(frame.planes, followed.planes, strict=True):
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
        play_match("roles", "chaser", duration=20.0, recording=tmp_path / "match.npz")
        scene = Recording.load(tmp_path / "match.npz")
    else:
        scene = run_path(str(HERE / "synthetic.py"))["kickabout"](10, seconds=20.0)
    cut, fps = Cut(4.0, 4.0 + SECONDS), scene.scenario.timing.frames_hz
    renderer, indices = FrameRenderer(scene, cut.size), frame_indices(scene, cut)
    frames = turned(renderer, indices)
    works = {
        "alone": lambda path: encode(frames, path, fps),
        "film": lambda path: write_film(path, ".mp4", renderer, indices, fps),
        "whole": lambda path: save_video(scene, path, cut=cut),
    }
    paths = {name: tmp_path / f"{name}.mp4" for name in works}
    times = {name: [] for name in works}
    for _ in range(PASSES):
        for name, work in works.items():
            times[name].append(timed(lambda work=work, name=name: work(paths[name])))
    rates = {name: len(frames) / min(each) for name, each in times.items()}
    shares = {name: rates[name] / rates["alone"] for name in ("film", "whole")}
    with capsys.disabled():
        told = ", ".join(f"{name} {rate:.0f}" for name, rate in rates.items())
        shown = ", ".join(f"{name} {share:.2f}" for name, share in shares.items())
        print(f"\n{kind}: frames a second of CPU time: {told}; shares: {shown}")
    assert len({path.read_bytes() for path in paths.values()}) == 1
    assert shares["film"] >= SHARE
    assert shares["whole"] >= WHOLE
