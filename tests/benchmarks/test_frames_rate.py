from pathlib import Path
from runpy import run_path
from time import process_time

import pytest

from soccersim.render.cut import frame_indices
from soccersim.render.frames import FrameRenderer

HERE = Path(__file__).parents[1] / "render"
synthetic = run_path(str(HERE / "synthetic.py"))
synthetic_match = run_path(str(HERE / "synthetic_match.py"))

# a frame may cost as much as copying so many whole pictures; it was half of that when written
COPIES = {"kickabout": 8.0, "match": 16.0}
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


def check(scene, copies, per_second, capsys):
    """Draw all of it, so fast."""
    renderer = FrameRenderer(scene)
    indices = frame_indices(scene)
    copy = seconds_each(lambda _: renderer.surface.blit(renderer.ground.surface, (0, 0)), indices)
    frame = seconds_each(renderer.draw, indices)
    with capsys.disabled():
        print(f"\n{1 / frame:.0f} frames/s, a frame is {frame / copy:.1f} copies of the picture")
    assert frame / copy < copies
    assert frame < 1 / per_second


@pytest.mark.benchmark
def test_ten_robots_at_four_hundred_frames_a_second(capsys):
    check(synthetic["kickabout"](10, seconds=60.0), COPIES["kickabout"], 400, capsys)


@pytest.mark.benchmark
def test_match_with_labels_and_notes_at_six_hundred_frames_a_second(capsys):
    check(synthetic_match["match"](120.0), COPIES["match"], 600, capsys)
