"""Films of a part, at another pace or size, and in other formats."""

import av
import numpy as np
import pygame
import pytest
from PIL import Image
from synthetic import kickabout, standing
from synthetic_match import match

from soccersim.problems import InputError
from soccersim.render.colours import Colours
from soccersim.render.cut import Cut, film_kind, film_size, frame_indices, shown
from soccersim.render.frames import FrameRenderer, save_frames
from soccersim.render.video import save_video

SMALL = (320, 214)


def painted(colour, size=(32, 8)):
    surface = pygame.Surface(size, 0, 32)
    surface.fill(colour)
    return surface


def pixels(surface):
    return pygame.surfarray.array3d(surface).swapaxes(0, 1)


def test_a_part_goes_from_its_first_to_its_last_second():
    scene = kickabout(1, seconds=4)
    assert frame_indices(scene, Cut(1.0, 2.0)) == list(range(50, 101, 2))
    assert frame_indices(scene, Cut(start=3.99)) == [199]
    assert frame_indices(scene, Cut(end=0.01)) == [0]
    assert frame_indices(scene, Cut(end=99.0)) == frame_indices(scene)


def test_slow_motion_shows_each_record_longer_and_fast_motion_leaves_some_out():
    scene = kickabout(1, seconds=4)
    assert frame_indices(scene, Cut(1.0, 1.04, speed=0.25)) == [50, 50, 51, 51, 52]
    assert frame_indices(scene, Cut(speed=4.0)) == list(range(0, 201, 8))


def test_records_of_a_part():
    scene = kickabout(1, seconds=4)
    assert shown(scene, None, None) == range(201)
    assert shown(scene, 1.0, 2.0) == range(50, 101)
    with pytest.raises(InputError, match=r"^no record lies between .* they are 0\.02 s apart$"):
        shown(scene, 1.001, 1.019)


@pytest.mark.parametrize(
    ("cut", "told"),
    [
        (Cut(2.0, 1.0), "--to 1 s must be later than --from 2 s"),
        (Cut(start=7.0), "--from 7: from 0 to 4 s are recorded"),
        (Cut(start=-1.0), "--from -1: from 0 to 4 s are recorded"),
        (Cut(start=float("nan")), "--from nan: from 0 to 4 s are recorded"),
        (Cut(speed=0.0), "--speed 0: it can be from 0.01 to 100"),
        (Cut(speed=float("nan")), "--speed nan: it can be from 0.01 to 100"),
    ],
)
def test_a_part_that_shows_nothing_is_refused_in_one_line(cut, told):
    with pytest.raises(InputError) as refused:
        frame_indices(kickabout(1, seconds=4), cut)
    assert str(refused.value) == told


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("641x428", "--size 641x428: H.264 needs even numbers"),
        ("640x427", "--size 640x427: H.264 needs even numbers"),
        ("640", "--size 640: width and height, as in 1280x854"),
        ("8x8", "--size 8x8: a side has 128 to 4096 px"),
        ("99998x2", "--size 99998x2: a side has 128 to 4096 px"),
        ("-6x4\n", "--size -6x4\\n: width and height, as in 1280x854"),
    ],
)
def test_a_size_that_no_film_has_is_refused_in_one_line(text, told):
    with pytest.raises(InputError) as refused:
        film_size(text)
    assert str(refused.value) == told


def test_a_size_is_read():
    assert film_size("640x428") == (640, 428)
    assert film_size(" 1920X1080 ") == (1920, 1080)


def test_the_ending_names_the_format():
    assert [film_kind(f"a.b/run{end}") for end in (".mp4", ".GIF", ".webp")] == [
        ".mp4",
        ".gif",
        ".webp",
    ]
    with pytest.raises(InputError, match=r"^run\.avi: a film's name ends in .mp4, .gif or .webp$"):
        film_kind("run.avi")
    with pytest.raises(InputError, match="a film's name ends in"):
        save_video(standing((0, 0, 0)), "film")


@pytest.mark.parametrize("size", [(128, 128), (200, 960), (642, 430)])
@pytest.mark.parametrize("scene", [kickabout(10, seconds=0.1), match(0.2)])
def test_every_size_can_be_drawn_and_filmed(scene, size, tmp_path):
    save_video(scene, tmp_path / "film.mp4", cut=Cut(end=0.1, size=size))
    with av.open(str(tmp_path / "film.mp4")) as film:
        picture = next(film.decode(video=0))
    assert (picture.width, picture.height) == size
    first = pixels(FrameRenderer(scene, size).draw(0)).astype(int)
    assert np.abs(picture.to_ndarray(format="rgb24") - first).mean() < 6


def test_frames_of_a_part_have_its_size(tmp_path):
    count = save_frames(kickabout(1, seconds=1), tmp_path, cut=Cut(0.2, 0.4, size=SMALL))
    assert count == len(list(tmp_path.iterdir())) == 6
    with Image.open(tmp_path / "000000.png") as first:
        assert first.size == SMALL


def turned(surface, size):
    """The whole of a surface as a frame."""
    return Colours(av.VideoFrame(*size, "yuv420p")).follow(surface, [])


def test_colours_are_those_of_bt709():
    """White, black, red, green and blue, as Rec. ITU-R BT.709-6, item 5 gives them in 8 bits."""
    for colour, expected in {
        (255, 255, 255): (235, 128, 128),
        (0, 0, 0): (16, 128, 128),
        (255, 0, 0): (63, 102, 240),
        (0, 255, 0): (173, 42, 26),
        (0, 0, 255): (32, 240, 118),
    }.items():
        frame = turned(painted(colour), (32, 8))
        planes = [np.frombuffer(plane, np.uint8)[0] for plane in frame.planes]
        assert tuple(planes) == expected


@pytest.mark.parametrize("size", [(1280, 854), (642, 430), (200, 960), (1000, 500)])
def test_a_followed_picture_is_the_same_as_one_turned_as_a_whole(size):
    for scene in (kickabout(10, seconds=4), match(4)):
        renderer = FrameRenderer(scene, size)
        following = Colours(av.VideoFrame(*size, "yuv420p"))
        for index in (0, 2, 4, 100, 102, 3):
            followed = following.follow(renderer.draw(index), renderer.changed)
            for one, other in zip(
                followed.planes, turned(renderer.surface, size).planes, strict=True
            ):
                table = [
                    np.frombuffer(p, np.uint8).reshape(p.height, -1)[:, : p.width]
                    for p in (one, other)
                ]
                assert np.array_equal(*table)


@pytest.mark.parametrize("kind", ["gif", "webp"])
def test_animations_show_every_frame_for_ever_and_come_out_the_same(kind, tmp_path):
    scene, cut = kickabout(4, seconds=1), Cut(0.2, 0.8, size=SMALL)
    for name in ("first", "second"):
        assert save_video(scene, tmp_path / f"{name}.{kind}", cut=cut) == 16
    first = tmp_path / f"first.{kind}"
    assert first.read_bytes() == (tmp_path / f"second.{kind}").read_bytes()
    renderer = FrameRenderer(scene, SMALL)
    with Image.open(first) as film:
        assert (film.n_frames, film.size, film.info["loop"]) == (16, SMALL, 0)
        for number in (0, 7, 15):
            film.seek(number)
            shows = np.array(film.convert("RGB")).astype(int)
            apart = np.abs(shows - pixels(renderer.draw(10 + 2 * number)))
            assert apart.mean() < 2 if kind == "gif" else apart.max() == 0
        assert film.info["duration"] == 40


def test_films_say_nothing_of_when_they_were_made(tmp_path):
    save_video(standing((0, 0, 0)), tmp_path / "run.mp4", cut=Cut(size=SMALL))
    with av.open(str(tmp_path / "run.mp4")) as film:
        assert "creation_time" not in {**film.metadata, **film.streams.video[0].metadata}


def test_a_film_that_ends_before_the_match_does_not_stand_still(tmp_path):
    scene = match(1.0)
    whole, part = (
        save_video(scene, tmp_path / "a.mp4", cut=Cut(end=end, size=SMALL)) for end in (None, 0.5)
    )
    assert (whole, part) == (25 + 50, 13)
