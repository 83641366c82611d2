"""Frames and films of matches."""

from itertools import combinations

import av
import numpy as np
import pygame
import pytest
from synthetic_match import match
from tape import RECORD_HZ, event, tape
from test_frames import picture, places

from soccersim.problems import InputError
from soccersim.render import look
from soccersim.render.cut import frame_indices
from soccersim.render.frames import FrameRenderer, save_frames
from soccersim.render.match_hud import minutes
from soccersim.render.story import LEVELS, Story
from soccersim.render.video import save_video

LONG = "teams/the_very_long_name_of_a_team_from_surabaya.py:PressingStrategy"
BLUE, ORANGE = look.TEAMS["home"], look.TEAMS["away"]


def standing(records=50, poses=None, ball=(0.0, 5.0), **told):
    """Ten robots that stand in a row, and a ball beside them."""
    ways = np.zeros((records, 10, 3))
    ways[:, :, 0] = np.arange(-9, 11, 2)
    for row, pose in (poses or {}).items():
        ways[:, row] = pose
    return tape(ways, np.tile(ball, (records, 1)), **told)


def near(renderer, index, place, colour, reach=10, within=3):
    """How many pixels of a colour there are about a place."""
    found = places(renderer, index, colour, within=within)
    return int((np.hypot(*(found - renderer.view.pixel(*place)).T) < reach).sum())


def changed(first, second):
    """Where two pictures differ: (N, 2) of x, y."""
    rows, columns = np.nonzero((first != second).any(axis=2))
    return np.stack((columns, rows), axis=1) + 0.5


# what is told


def test_decision_is_told_for_some_seconds_then_fades():
    story = Story(match(60))
    levels = [story.said(record).level for record in range(20 * 50, 25 * 50)]
    assert set(levels) == {LEVELS}
    assert story.said(20 * 50).text == "over the touch line, last touched by home-3"
    fading = [story.said(record).level for record in range(25 * 50, 26 * 50)]
    assert fading == sorted(fading, reverse=True)
    assert story.said(27 * 50) is None


def test_signal_and_start_leave_the_reason_of_the_stoppage_to_be_read():
    assert Story(match(60)).said(24 * 50).text.startswith("over the touch line")


def test_phase_says_whose_restart_it_is_and_who_played_the_ball():
    story = Story(match(60))
    assert story.state(50) == ("kick-off", 0, "getting ready")
    assert story.state(int(3.5 * 50)) == ("kick-off", 0, "START given")
    assert story.state(21 * 50) == ("STOP", None, "all robots halt")
    assert story.state(int(22.5 * 50))[:2] == ("throw-in", 1)
    word, slot, about = story.state(int(7.5 * 50))
    assert (word, slot, about) == ("in play", 0, "last touched by 5")


def test_score_cheers_for_who_has_just_scored():
    story = Story(match(60, score=(5, 11)))
    assert (story.score(39 * 50), story.cheering(39 * 50)) == ([5, 11], None)
    assert (story.score(41 * 50), story.cheering(41 * 50)) == ([6, 11], 0)
    assert story.cheering(44 * 50) is None


def test_last_picture_tells_how_the_match_ended():
    goal = event(1.0, "goal", "away", "goal by away-2 for away, 0:1")
    over = event(1.0, "end", None, "the match ends 0:1")
    story = Story(standing(events=[goal, over], match={"score": [0, 1]}))
    assert (story.state(48)[0], story.score(48), story.seconds(48)) == ("in play", [0, 0], 0.96)
    assert (story.state(49)[0], story.score(49), story.seconds(49)) == ("full time", [0, 1], 1.0)
    assert story.said(49).text == "the match ends 0:1"


def test_forfeit_is_told_with_its_score():
    fault = {"side": "away", "kind": "bad_command", "tick": 500, "detail": ""}
    story = Story(standing(faults=[fault], match={"score": [3, 0]}))
    assert (story.state(49)[0], story.score(49)) == ("forfeit", [3, 0])
    assert story.said(49).text == "away forfeits the match: bad command"


def test_match_cut_short_has_no_end():
    assert Story(standing()).state(49)[0] == "in play"


def test_clock_counts_minutes_and_seconds():
    assert [minutes(s) for s in (0, 59, 61, 600)] == ["00:00", "00:59", "01:01", "10:00"]


# what is drawn


@pytest.mark.parametrize("size", [(1280, 854), (640, 428), (1920, 1080), (801, 1001)])
@pytest.mark.parametrize("name", ["roles", LONG])
def test_no_two_words_of_the_head_up_display_overlap(size, name):
    text = "no goal: " + "home-3 kicked from its own half " * 5
    events = [event(1.0, "no_goal", "home", text), event(12.0, "goal", "away", text)]
    scene = match(20, home=name, away=name, score=(12, 12), events=events)
    renderer = FrameRenderer(scene, size)
    everything = pygame.Rect((0, 0), size)
    for index in (60, 300, 650, 999):
        rects = [surface.get_rect(topleft=at) for surface, at in renderer.hud.blits(index)]
        *rects, line, now = rects
        assert line.inflate(4, 0).contains(now)
        assert all(everything.contains(rect) for rect in (*rects, line))
        assert not any(rect.colliderect(renderer.view.frame) for rect in rects)
        assert not any(one.colliderect(two) for one, two in combinations((*rects, line), 2))


def test_each_team_keeps_the_goal_at_its_end_and_ends_change_at_half_time():
    renderer = FrameRenderer(match(4, talk=False))
    for index, home_x in ((50, -11.3), (150, 11.3)):
        assert near(renderer, index, (home_x, 0.9), BLUE, 30) > 20
        assert near(renderer, index, (-home_x, 0.9), BLUE, 30) == 0
        assert near(renderer, index, (-home_x, 0.9), ORANGE, 30) > 20


def test_robot_out_of_play_is_dim():
    in_play = np.ones((25, 10))
    in_play[:, 0] = 0
    renderer = FrameRenderer(standing(in_play=in_play))
    assert near(renderer, 10, (-9, 0), BLUE) == 0
    assert near(renderer, 10, (-7, 0), BLUE) > 20


def test_ball_believed_elsewhere_is_shown_in_the_teams_colour():
    believed = np.full((25, 2, 5), np.nan)
    believed[:, 0] = (2.0, -4.0, 0, 0, 0.1)
    believed[:, 1] = (0.02, 5.0, 0, 0, 0.1)  # as it is
    renderer = FrameRenderer(standing(ball_believed=believed))
    plain = FrameRenderer(standing())
    places_ = changed(picture(renderer.draw(20)), picture(plain.draw(20)))
    assert np.hypot(*(places_ - renderer.view.pixel(2, -4)).T).max() < 12
    assert near(renderer, 20, (2, -4), look.tint("home"), within=12) > 5


def test_kick_flashes_where_it_was_and_where_to():
    ball = np.zeros((50, 2))
    ball[20:, 0] = np.arange(30) * 10 / RECORD_HZ
    ways = standing().body[:, :10, :3].copy()
    ways[:, 2] = (-0.35, 0, 0)
    kicked = FrameRenderer(tape(ways, ball, kicks=[(20, 2)]))
    rolled = FrameRenderer(tape(ways, ball))
    assert (picture(kicked.draw(19)) == picture(rolled.draw(19))).all()
    flash = changed(picture(kicked.draw(25)), picture(rolled.draw(25)))
    flash = flash[(flash[:, 1] > 80) & (flash[:, 1] < 774)]
    x, y = kicked.view.pixel(0.2, 0)
    assert len(flash) > 40
    assert (np.abs(flash - (x + 25, y)) < (60, 25)).all()
    later = changed(picture(kicked.draw(45)), picture(rolled.draw(45)))
    assert ((later[:, 1] < 80) | (later[:, 1] > 774)).all()


def test_labels_and_notes_are_drawn_in_the_field_whatever_they_are():
    labels = [[0, row, "label of twenty-four chr"] for row in range(10)]
    notes = [
        [0, 0, [["line", -1000.0, 3.0, 1000.0, 3.0], ["text", 900.0, 900.0, "far away"]]],
        [0, 1, [["circle", 0.0, 0.0, 1000.0], ["circle", 4.0, 4.0, 0.5], ["text", 0, 0, " "]]],
    ]
    poses = {0: (-11.7, -7.7, 0), 9: (11.7, 7.7, 0)}
    said = FrameRenderer(standing(poses=poses, labels=labels, notes=notes))
    silent = FrameRenderer(standing(poses=poses))
    where = changed(picture(said.draw(9)), picture(silent.draw(9)))
    frame = said.view.frame
    assert (where > (frame.left, frame.top)).all()
    assert (where < (frame.right, frame.bottom)).all()
    line = where[np.abs(where[:, 1] - said.view.pixel(0, 3)[1]) < 1]
    assert np.ptp(line[:, 0]) > 0.95 * frame.width
    circle = np.hypot(*(where - said.view.pixel(4, 4)).T) / said.view.px_per_m
    assert (np.abs(circle - 0.5) < 0.05).sum() > 60


def test_labels_hide_neither_each_other_nor_robots():
    poses = {0: (0, 0, 0), 1: (0.6, 0, 0), 2: (0, 0.6, 0), 3: (-5, -7.6, 0)}
    labels = [[0, row, f"robot {row}"] for row in range(4)]
    scene = standing(poses=poses, labels=labels)
    renderer = FrameRenderer(scene)
    remarks = renderer.play.remarks
    bodies = scene.body[0, :, :3].tolist()
    taken = []
    blits = remarks._labels(0, bodies, taken)
    rects = [word.get_rect(topleft=at) for word, at in blits]
    assert len(rects) == 4
    assert not any(one.colliderect(two) for one, two in combinations(rects, 2))
    for x, y, _ in bodies[:10]:
        robot = pygame.Rect(0, 0, 12, 12)
        robot.center = renderer.view.pixel(x, y)
        assert robot.collidelist(rects) < 0


def test_trails_are_short():
    ways = standing(records=500).body[:, :10, :3].copy()
    ways[:, 0, 0] = np.linspace(-8, 8, 500)
    ways[:, 0, 1] = -3.0
    still = ways.copy()
    still[:, 0] = ways[-1, 0]
    ball = np.tile((0.0, 5.0), (500, 1))
    drawn, plain = (picture(FrameRenderer(tape(w, ball)).draw(499)) for w in (ways, still))
    where = changed(drawn, plain)
    view = FrameRenderer(tape(ways, ball)).view
    assert 1.2 < (view.pixel(8, 0)[0] - where[:, 0].min()) / view.px_per_m < 5.5


def test_ball_that_is_put_elsewhere_leaves_no_trail():
    ball = np.zeros((50, 2))
    ball[:25] = (-6.0, -3.0)
    ball[25:] = (6.0, -3.0)
    ways = standing().body[:, :10, :3]
    moved, there = (FrameRenderer(tape(ways, b)) for b in (ball, ball[25:].repeat(2, axis=0)))
    assert (picture(moved.draw(40)) == picture(there.draw(40))).all()


# laws of the whole


def test_a_record_of_a_match_looks_the_same_whatever_was_drawn_before():
    scene = match(30)
    renderer = FrameRenderer(scene)
    for before in (1499, 0, 740, 1000, 12):
        renderer.draw(before)
        for index in (1020, 700):
            drawn = picture(renderer.draw(index))
            assert (drawn == picture(FrameRenderer(scene).draw(index))).all()


@pytest.mark.parametrize("name", ["msl-match", "krsbi-match", "friendly-match"])
def test_every_bundled_match_can_be_drawn(name):
    renderer = FrameRenderer(match(2, name=name), (640, 428))
    for index in (0, 50, 99):
        assert picture(renderer.draw(index)).shape == (428, 640, 3)


def test_film_of_a_match_stands_still_at_its_end(tmp_path):
    scene = standing(records=10)
    assert save_video(scene, tmp_path / "match.mp4") == len(frame_indices(scene)) + 50
    with av.open(str(tmp_path / "match.mp4")) as film:
        frames = [f.to_ndarray(format="gray") for f in film.decode(video=0)]
    assert np.abs(frames[-1].astype(int) - frames[-40]).mean() < 0.5


def test_match_that_never_began_cannot_be_drawn(tmp_path):
    scene = standing(records=0)
    for save in (save_frames, save_video):
        with pytest.raises(InputError, match="before the match began"):
            save(scene, tmp_path / "nothing.mp4")
    assert list(tmp_path.iterdir()) == []
