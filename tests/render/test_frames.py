import hashlib
from math import pi

import numpy as np
import pygame
import pytest
from synthetic import field, kickabout, model, recording, standing

from soccersim.problems import MachineError
from soccersim.render import look
from soccersim.render.cells import angle_text, distance_text, leg_text
from soccersim.render.cut import Cut, frame_indices
from soccersim.render.frames import FrameRenderer, save_frames
from soccersim.render.hud import clock
from soccersim.render.likeness import Likeness
from soccersim.render.pitch import View
from soccersim.spec.field import Field
from soccersim.spec.player import Player
from soccersim.spec.robot import Robot

FIELDS = ("krsbi-2017", "krsbi", "msl")


def picture(surface):
    """(height, width, 3)"""
    height, width = surface.height, surface.width
    raw = np.frombuffer(surface.get_buffer().raw, np.uint8).reshape(height, width, 4)
    return raw[..., 2::-1].astype(int)


def places(renderer, index, colour, within=0):
    """Where on the field, in pixels of the picture, a colour is: (N, 2) of x, y."""
    pixels = picture(renderer.draw(index))
    frame = renderer.view.frame
    found = (np.abs(pixels - colour) <= within).all(axis=2)
    found[: frame.top] = found[frame.bottom :] = False
    rows, columns = np.nonzero(found)
    return np.stack((columns, rows), axis=1) + 0.5


# where things are


def test_robot_on_the_centre_spot_stands_in_the_middle_of_the_picture():
    renderer = FrameRenderer(standing((0, 0, 0.7), on="krsbi-2017"))
    body = places(renderer, 0, look.TEAMS["home"], within=30)
    body = body[np.hypot(*(body - (640, 427)).T) < 30]
    assert (body.min(axis=0) + body.max(axis=0)) / 2 == pytest.approx((640, 427), abs=1)


@pytest.mark.parametrize("on", FIELDS)
@pytest.mark.parametrize("at", [(0, 0), (2.31, -1.77), (-4.04, 2.9)])
def test_ball_is_drawn_where_it_is(at, on):
    renderer = FrameRenderer(standing((-1, -1, 0), ball=[at] * 5, on=on))
    assert places(renderer, 0, look.BALL).mean(axis=0) == pytest.approx(
        renderer.view.pixel(*at), abs=1
    )


@pytest.mark.parametrize("on", FIELDS)
def test_a_goal_to_the_right_is_scored_at_positive_x(on):
    renderer = FrameRenderer(standing((0, 0, 0), on=on))
    home = places(renderer, 0, look.TEAMS["home"], within=2)
    away = places(renderer, 0, look.TEAMS["away"], within=2)
    goal_line = renderer.view.pixel(field(on)["length"] / 2, 0)[0]
    assert len(away) > 50
    assert (away[:, 0] > goal_line - 1).all()
    assert home[:, 0].min() < 1280 - goal_line


@pytest.mark.parametrize("heading", [0, pi / 2, pi, -pi / 2, 2 * pi + 1])
def test_nose_points_where_the_robot_is_heading(heading):
    renderer = FrameRenderer(standing((0, 0, heading), on="krsbi-2017"))
    nose = places(renderer, 0, look.NOSE)
    nose = nose[np.hypot(*(nose - (640, 427)).T) < 30] - (640, 427)
    x, y = nose.mean(axis=0)
    assert np.exp(1j * np.arctan2(-y, x)) == pytest.approx(np.exp(1j * heading), abs=0.15)


@pytest.mark.parametrize("size", [(1280, 854), (640, 428), (1920, 1080), (801, 1001)])
@pytest.mark.parametrize("on", FIELDS)
def test_whole_field_with_its_board_is_in_the_picture(on, size):
    spec = Field.model_validate(field(on))
    view = View.fit(spec, size, 60)
    assert pygame.Rect(0, 60, size[0], size[1] - 120).contains(view.frame)
    x, y = view.pixel(spec.half_length + spec.border, spec.half_width + spec.border)
    assert view.frame.left < size[0] - x
    assert x < view.frame.right
    assert view.frame.top < y
    assert min(view.frame.width / size[0], view.frame.height / (size[1] - 120)) > 0.6


# what is drawn


@pytest.mark.parametrize(
    ("layout", "wheels"), [("three", (3, 0)), ("four", (4, 0)), ("six", (3, 3))]
)
def test_robot_has_the_wheels_it_is_built_with(layout, wheels):
    robot = Robot.model_validate(model(layout))
    sprite = Likeness(robot).paint(look.TEAMS["home"], px_per_m=400, heading=0.3).surface
    for colour, count in zip((look.TYRE, look.DEAD_TYRE), wheels, strict=True):
        tyres = pygame.mask.from_threshold(sprite, colour, (1, 1, 1, 255))
        assert len(tyres.connected_components(200)) == count


def test_wheels_stand_at_their_azimuth_and_distance():
    robot = Robot.model_validate(model("three"))
    canvas = Likeness(robot).paint(look.TEAMS["home"], px_per_m=400, heading=0.0)
    tyres = pygame.mask.from_threshold(canvas.surface, look.TYRE, (1, 1, 1, 255))
    for wheel in tyres.connected_components(200):
        x, y = wheel.centroid()
        place = complex(x - canvas.middle[0], canvas.middle[1] - y) / canvas.px_per_m
        assert abs(place) == pytest.approx(0.19, abs=0.005)
        azimuth = np.degrees(np.angle(place)) % 360
        assert min(abs(azimuth - drawn) for drawn in (60, 180, 300)) < 2


@pytest.mark.parametrize("radius", [0.25, 0.4])
def test_body_has_its_radius(radius):
    robot = Robot.model_validate(model("three", radius=radius))
    canvas = Likeness(robot).paint(look.TEAMS["away"], px_per_m=200, heading=0.0)
    outline = pygame.mask.from_threshold(canvas.surface, look.OUTLINE, (1, 1, 1, 255))
    box = outline.get_bounding_rects()[0]
    assert box.width / canvas.px_per_m == pytest.approx(2 * radius, abs=0.01)


def test_ghost_is_seen_only_where_belief_and_truth_differ():
    sure = FrameRenderer(standing((1, 1, 0)))
    astray = FrameRenderer(standing((1, 1, 0), believed=np.tile([2, 1.5, 0.5], (5, 1, 1))))
    turned = FrameRenderer(standing((1, 1, 0), believed=np.tile([1, 1, 0.5], (5, 1, 1))))
    assert len(places(sure, 0, look.BELIEVED, within=25)) == 0
    assert len(places(turned, 0, look.BELIEVED, within=25)) > 20
    ghost = places(astray, 0, look.BELIEVED, within=25)
    reach = np.hypot(*(ghost - astray.view.pixel(2, 1.5)).T).min()
    assert reach < 0.26 * astray.view.px_per_m


def test_target_of_the_leg_is_marked():
    paths = [[(3, 2, 0), (-3, -2, 1)]]
    renderer = FrameRenderer(standing((0, 0, 0), paths=paths, leg=[[0], [0], [1], [1], [2]]))
    for index, target in ((0, (3, 2)), (2, (-3, -2)), (4, (-3, -2))):
        marks = places(renderer, index, look.TARGET, within=8)
        assert marks.mean(axis=0) == pytest.approx(renderer.view.pixel(*target), abs=5)
    plain = FrameRenderer(standing((0, 0, 0)))
    assert len(places(plain, 0, look.TARGET, within=8)) == 0


def test_trail_shows_where_the_robot_came_from():
    x = np.linspace(-3, 3, 201)
    way = np.stack((x, 0 * x + 1, 0 * x), axis=1)[:, None]
    renderer = FrameRenderer(recording(way))
    spot = [round(c) for c in renderer.view.pixel(-1.5, 1)]
    before, after = (picture(renderer.draw(i))[spot[1], spot[0]] for i in (0, 200))
    assert abs(after - before).sum() > 30
    ahead = [round(c) for c in renderer.view.pixel(1.5, 1)]
    start, half = (picture(renderer.draw(i))[ahead[1], ahead[0]] for i in (0, 100))
    assert (start == half).all()


def test_robot_that_is_put_elsewhere_leaves_no_trail_across_the_field():
    way = np.zeros((100, 1, 3))
    way[:, 0, 0] = np.linspace(-4, -3.5, 100)
    way[50:, 0, 1] = 3.0
    renderer = FrameRenderer(recording(way))
    x, y = (round(c) for c in renderer.view.pixel(-3.75, 1.5))
    empty, passed = (picture(renderer.draw(i))[y, x - 20 : x + 20] for i in (0, 99))
    assert (empty == passed).all()


def test_nothing_is_drawn_outside_the_field():
    corner = (6.7, 4.7, 0.8)  # against the board
    lost = np.tile([-7.1, 4.7, 2.0], (5, 1, 1))
    scene = standing(corner, believed=lost, ball=[(-6.88, -4.88)] * 5, paths=[[(7.2, -5.1, 0)]])
    renderer = FrameRenderer(scene)
    pixels, frame = picture(renderer.draw(4)), renderer.view.frame
    beside = pixels[frame.top : frame.bottom]
    assert (beside[:, : frame.left] == look.PAGE).all()
    assert (beside[:, frame.right :] == look.PAGE).all()
    for row in (frame.top - 1, frame.bottom):
        assert (pixels[row] == look.PAGE).all()


# what is written


def test_clock_counts_minutes_seconds_and_tenths():
    assert clock(0) == "00:00.0"
    assert clock(754) == "01:15.4"
    assert clock(36_000) == "60:00.0"


def test_errors_are_told_in_a_fitting_unit():
    assert [distance_text(d) for d in (0, 0.0432, 0.0996, 0.1234, 1.5, 12.3)] == [
        "0 mm", "43 mm", "10.0 cm", "12.3 cm", "1.50 m", "12.30 m",
    ]  # fmt: skip
    assert angle_text(-2.44) == "\N{MINUS SIGN}2.4°"
    assert angle_text(0.0) == "+0.0°"


def test_legs_count_from_one_and_a_repeated_path_starts_again():
    path = [{"to": [x, 0.0, 0.0]} for x in (1.0, 2.0, 3.0)]
    parts = {"name": "striker", "model": model(), "start": [0.0, 0.0, 0.0]}
    once = Player.model_validate({**parts, "path": path})
    again = Player.model_validate({**parts, "path": path, "repeat": True})
    idle = Player.model_validate(parts)
    assert [leg_text(once, leg) for leg in (0, 2, 3)] == ["1/3", "3/3", "3/3"]
    assert [leg_text(again, leg) for leg in (0, 2, 3)] == ["1/3", "3/3", "1/3"]
    assert leg_text(idle, 0) == ""


@pytest.mark.parametrize("robots", [1, 4, 5, 10, 11, 15, 16, 22])
def test_every_robot_has_its_cell_and_no_two_overlap(robots):
    renderer = FrameRenderer(kickabout(robots, seconds=0.1))
    cells = renderer.hud.cells.places
    band = pygame.Rect(0, renderer.view.frame.bottom, 1280, 854 - renderer.view.frame.bottom)
    assert len(cells) == robots
    for i, cell in enumerate(cells):
        assert band.contains(cell)
        assert cell.collidelist(cells[:i]) == -1


# laws of the whole


def test_a_record_looks_the_same_whatever_was_drawn_before():
    scene = kickabout(10, seconds=3)
    renderer = FrameRenderer(scene)
    for before in (100, 0, 149, 6):
        renderer.draw(before)
        drawn = picture(renderer.draw(77))
        assert (drawn == picture(FrameRenderer(scene).draw(77))).all()
    assert (picture(renderer.draw(-1)) == picture(renderer.draw(150))).all()
    with pytest.raises(IndexError):
        renderer.draw(151)


def test_drawing_leaves_the_recording_as_it_is():
    scene = kickabout(3, seconds=1)
    before = {k: hashlib.sha256(a.tobytes()).hexdigest() for k, a in scene.arrays.items()}
    renderer = FrameRenderer(scene)
    for index in frame_indices(scene):
        renderer.draw(index)
    assert before == {k: hashlib.sha256(a.tobytes()).hexdigest() for k, a in scene.arrays.items()}


def test_no_display_is_opened():
    FrameRenderer(kickabout(2, seconds=1)).draw(5)
    assert not pygame.display.get_init()


def test_twenty_two_robots_without_ball_or_path():
    poses = [(i % 6 - 3, i // 6 - 1, 0.1 * i) for i in range(22)]
    pixels = picture(FrameRenderer(standing(*poses, teams=("home", "away"))).draw(0))
    assert pixels.shape == (854, 1280, 3)


def test_a_recording_of_one_record():
    scene = standing((0, 0, 0), records=1)
    assert frame_indices(scene) == [0]
    FrameRenderer(scene).draw(0)


# files


def test_frames_are_due_at_the_scenarios_rate():
    scene = kickabout(1, seconds=2)
    assert frame_indices(scene) == list(range(0, 101, 2))
    assert frame_indices(scene, Cut(speed=0.5)) == list(range(101))
    assert frame_indices(scene, Cut(speed=25 / 30))[:4] == [0, 1, 3, 5]
    assert len(frame_indices(scene, Cut(speed=25 / 30))) == 61


def test_frames_are_written_and_counted(tmp_path):
    scene = kickabout(2, seconds=0.4, on="krsbi")
    told = []
    count = save_frames(scene, tmp_path / "frames", progress=lambda *done: told.append(done))
    files = sorted(file.name for file in (tmp_path / "frames").iterdir())
    assert files == [f"{i:06d}.png" for i in range(11)]
    assert count == 11
    assert told == [(i + 1, 11) for i in range(11)]
    first = pygame.image.load(tmp_path / "frames" / "000003.png")
    assert first.size == look.SIZE
    drawn = FrameRenderer(scene).draw(6)
    assert first.get_at((640, 427)) == drawn.get_at((640, 427))


def test_a_folder_that_cannot_be_written_is_named(tmp_path):
    (tmp_path / "taken").write_text("a file")
    folder = tmp_path / "taken" / "frames"
    with pytest.raises(MachineError, match=str(folder)):
        save_frames(standing((0, 0, 0)), folder)
