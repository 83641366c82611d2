from pathlib import Path
from runpy import run_path
from time import process_time

import pytest

from soccersim.render.frames import FrameRenderer, frame_indices

synthetic = run_path(str(Path(__file__).parents[1] / "render" / "synthetic.py"))

COPIES = 8.0  # a frame may cost as much as copying so many whole pictures; it was 4 when written
PASSES = 3  # the quickest counts: other programs only ever make it slower


def seconds_each(work, indices):
    """CPU time of one call, the quickest of a few passes."""
    passes = []
    for _ in range(PASSES):
        start = process_time()
        for index in indices:
            work(index)
        passes.append((process_time() - start) / len(indices))
    return min(passes)


@pytest.mark.benchmark
def test_ten_robots_at_four_hundred_frames_a_second(capsys):
    scene = synthetic["kickabout"](10, seconds=60.0)
    renderer = FrameRenderer(scene)
    indices = frame_indices(scene)
    copy = seconds_each(lambda _: renderer.surface.blit(renderer.ground, (0, 0)), indices)
    frame = seconds_each(renderer.draw, indices)
    with capsys.disabled():
        print(f"\n{1 / frame:.0f} frames/s, a frame is {frame / copy:.1f} copies of the picture")
    assert frame / copy < COPIES
    assert frame < 1 / 400
