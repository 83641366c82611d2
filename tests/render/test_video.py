import sys

import av
import numpy as np
import pytest
from synthetic import kickabout, standing

from soccersim.problems import InputError, MachineError
from soccersim.render import look
from soccersim.render.video import save_video


def test_film_has_every_frame_at_its_rate_and_size(tmp_path):
    told = []
    count = save_video(
        kickabout(2, seconds=1, on="krsbi"),
        tmp_path / "run.mp4",
        progress=lambda *done: told.append(done),
    )
    assert count == 26
    assert told == [(i + 1, 26) for i in range(26)]
    with av.open(str(tmp_path / "run.mp4")) as film:
        stream = film.streams.video[0]
        assert (stream.codec_context.name, stream.format.name) == ("h264", "yuv420p")
        assert (stream.width, stream.height, stream.average_rate) == (*look.SIZE, 25)
        assert sum(1 for _ in film.decode(stream)) == 26


def test_film_shows_the_colours_of_the_frames(tmp_path):
    save_video(standing((0, 0, 0)), tmp_path / "run.mp4")
    with av.open(str(tmp_path / "run.mp4")) as film:
        pixels = next(film.decode(video=0)).to_ndarray(format="rgb24").astype(int)
    assert np.abs(pixels[300, 660] - look.GRASS[0]).max() <= 6


def test_same_recording_gives_the_same_film(tmp_path):
    scene = kickabout(4, seconds=1)
    for name in ("first.mp4", "second.mp4"):
        save_video(scene, tmp_path / name)
    assert (tmp_path / "first.mp4").read_bytes() == (tmp_path / "second.mp4").read_bytes()


def test_without_av_it_says_how_to_get_it(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(InputError, match=r"pip install 'soccersim\[video\]'"):
        save_video(standing((0, 0, 0)), tmp_path / "run.mp4")
    assert not (tmp_path / "run.mp4").exists()


def test_a_film_that_cannot_be_written_is_named(tmp_path):
    path = tmp_path / "nowhere" / "run.mp4"
    with pytest.raises(MachineError, match=str(path)):
        save_video(standing((0, 0, 0)), path)


def test_an_interrupted_film_can_be_seen_up_to_there(tmp_path):
    def stop(done, _):
        if done == 12:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        save_video(kickabout(1, seconds=1), tmp_path / "run.mp4", progress=stop)
    with av.open(str(tmp_path / "run.mp4")) as film:
        assert sum(1 for _ in film.decode(video=0)) == 12
