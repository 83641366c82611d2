"""The replay page in a real browser: it shows what the recording holds, and opens quickly."""

from math import cos, radians, sin

import numpy as np
import pytest
from browser import installed
from on_page import PIXEL, go
from synthetic_match import match
from tape import RECORD_HZ

from soccersim import Recording, Simulation, load_scenario
from soccersim.match.play import play_match
from soccersim.render import look
from soccersim.render.page import page

pytestmark = pytest.mark.skipif(installed() is None, reason="no Chromium on this machine")


def test_shows_the_poses_of_the_recording_at_a_time(opened, recording):
    tab = opened()
    for time in (0.0, 1.0, 4.48, 11.96):
        go(tab, time)
        record = round(time * RECORD_HZ)
        moment = tab.run("soccersim.app.moment")
        poses = [[robot[key] for key in ("x", "y", "heading")] for robot in moment["robots"]]
        assert np.abs(poses - recording.body[record, :10, :3]).max() < 0.004
        believed = [robot["believed"]["x"] for robot in moment["robots"]]
        assert np.abs(believed - recording.estimate[record, :, 0]).max() < 0.004
        assert abs(moment["ball"]["x"] - recording.ball[record, 0]) < 0.002


def test_between_two_frames_things_are_between(opened, recording):
    tab = opened()
    go(tab, 5.01)
    shown = tab.run("soccersim.app.moment.ball.x")
    assert abs(shown - (-9 + 1.5 * 5.01)) < 0.002


def test_draws_robots_in_their_colours_where_they_are(opened, recording):
    tab = opened()
    tab.run("Object.assign(soccersim.app.show, {believed: false, words: false, trails: false})")
    go(tab, 4.0)
    for robot in (0, 4, 7, 9):
        x, y, heading = recording.body[4 * RECORD_HZ, robot, :3].tolist()
        away = heading + radians(105)  # between a wheel and the nose
        place = [x + 0.15 * cos(away), y + 0.15 * sin(away)]
        team = "home" if robot < 5 else "away"
        assert tab.run(f"{PIXEL}({place})")[:3] == list(look.TEAMS[team])
    assert tab.run(f"{PIXEL}([9.0, 5.0])")[:3] in [list(colour) for colour in look.GRASS]


def test_draws_an_upright_field_as_well(opened, recording):
    tab = opened(width=390, height=844, touch=True, ratio=2.0)
    tab.run("Object.assign(soccersim.app.show, {believed: false, words: false, trails: false})")
    tab.run("soccersim.app.pick(8); soccersim.app.follow(true)")
    go(tab, 6.0)
    x, y, heading = recording.body[6 * RECORD_HZ, 8, :3].tolist()
    shown = {}
    for part, away in (("nose", 0.0), ("shell", radians(105)), ("other", radians(-105))):
        place = [x + 0.16 * cos(heading + away), y + 0.16 * sin(heading + away)]
        shown[part] = tuple(tab.run(f"{PIXEL}({place})")[:3])
    away = look.TEAMS["away"]
    assert shown == {"nose": look.NOSE, "shell": away, "other": away}


def test_shows_where_cameras_put_the_ball_until_that_is_switched_off(opened, recording):
    tab = opened()
    tab.run("soccersim.app.show.trails = false")
    go(tab, 4.0)
    place = [recording.ball[4 * RECORD_HZ, 0], 2.0]
    sightings = tab.run("soccersim.app.moment.sightings")
    assert {seen["robot"] for seen in sightings} == {7}
    assert len(sightings) == 13  # of half a second, 25 a second
    newest = sightings[-1]
    assert newest["share"] == 1
    assert [newest["x"], newest["y"]] == pytest.approx(place, abs=0.011)
    shown = tab.run(f"{PIXEL}([{newest['x']}, {newest['y']}])")[:3]
    assert np.abs(np.array(shown) - look.tint("away")).max() < 60
    tab.press("s")
    go(tab, 4.0)
    assert tab.run(f"{PIXEL}([{newest['x']}, {newest['y']}])")[:3] in map(list, look.GRASS)


def test_run_shows_its_path_and_its_wheels(opened, pages):
    run = Simulation(load_scenario("defender", settings=["duration=2"])).run()
    tab = opened(pages(run, "run"))
    go(tab, 1.0)
    route = tab.run("soccersim.app.moment.routes[0]")
    assert np.allclose(route[1], run.legs[0][0]["target"][:2])
    lines = tab.run("numbers.innerText").splitlines()
    driven, dead = (line.split("\t") for line in lines if line[:7] in ("wheel 2", "wheel 6"))
    counts = run.arrays["counts"][RECORD_HZ, 0, 5]
    assert dead[2:] == ["\u2013", "\u2013", f"{counts:.0f}".replace("-", "\u2212")]
    assert driven[4] == "\u2013"  # no encoder
    tab.run("soccersim.app.show.trails = soccersim.app.show.believed = false")
    go(tab, 0.0)
    colour = np.array(tab.run(f"{PIXEL}({route[-1]})")[:3])
    assert np.abs(colour - look.TARGET).max() < 40


def test_damaged_page_says_so(browser, pages, recording, tmp_path):
    text = page(recording)
    at = text.index('id="data">') + 4000
    (tmp_path / "damaged.html").write_text(text[:at] + "AAAAAAAAAAAA" + text[at + 12 :])
    tab = browser.open((tmp_path / "damaged.html").as_uri())
    tab.wait("!notice.hidden")
    assert "cannot be shown" in tab.run("notice.textContent")
    tab.close()


@pytest.mark.slow
def test_ten_minutes_open_in_under_a_second(opened, pages, tmp_path):
    play_match("roles", "chaser", recording=tmp_path / "match.npz")
    recording = Recording.load(tmp_path / "match.npz")
    tab = opened(pages(recording, "long"))
    assert tab.run("soccersim.opened") < 1000
    go(tab, 300.0)
    pose = recording.body[300 * RECORD_HZ, 3, :2]
    shown = tab.run("soccersim.app.moment.robots[3]")
    assert [shown["x"], shown["y"]] == pytest.approx(pose.tolist(), abs=0.004)


def test_short_match_opens_in_under_a_second(opened, pages):
    address = pages(match(20.0), "short")
    tries = (opened(address).run("soccersim.opened") for _ in range(3))
    assert any(milliseconds < 1000 for milliseconds in tries)


def test_even_a_window_of_a_few_pixels_is_drawn(opened):
    tab = opened(width=120, height=60)
    tab.run("Object.assign(field.style, {width: '3px', height: '2px'}); soccersim.app.resize()")
    tab.run("Object.keys(soccersim.app.show).forEach(key => soccersim.app.show[key] = true)")
    go(tab, 3.0)
    assert tab.run("soccersim.app.moment.time") == 3.0
