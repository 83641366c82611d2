"""The replay page in a real browser: it plays, scrubs, and shows what the recording holds."""

from math import cos, radians, sin

import numpy as np
import pytest
from browser import Browser, installed
from synthetic_match import match
from tape import RECORD_HZ, STRIDE, event, tape

from soccersim import Recording, Simulation, load_scenario
from soccersim.match.play import play_match
from soccersim.render import look
from soccersim.render.page import page

pytestmark = pytest.mark.skipif(installed() is None, reason="no Chromium on this machine")
ATTACK = '</script><img src=x onerror="window.pwned=1"><script>window.pwned=1</script>'
SECONDS, EVENTS = 12.0, (3.0, 7.5)
PIXEL = """(([x, y]) => {
  const {picture} = soccersim.app, [u, v] = picture.view.pixel(x, y);
  const pen = new OffscreenCanvas(1, 1).getContext("2d", {willReadFrequently: true});
  pen.drawImage(picture.canvas, -Math.round(u * picture.ratio), -Math.round(v * picture.ratio));
  return [...pen.getImageData(0, 0, 1, 1).data];
})"""


def circling():
    """Ten robots on circles, a ball on a line, two events and words that attack the page."""
    time = np.arange(0, SECONDS, 1 / RECORD_HZ)
    robots = np.zeros((len(time), 10, 3))
    for i in range(10):
        angle = 0.5 * time + i
        robots[:, i, 0] = -8 + 1.8 * i + 0.8 * np.cos(angle)
        robots[:, i, 1] = 0.8 * np.sin(angle) - (3 if i % 2 else -3)
        robots[:, i, 2] = angle
    ball = np.stack((-9 + 1.5 * time, 0 * time), axis=1)
    believed = robots.copy()
    believed[:, 2, 0] += 0.5
    sighted = np.full((len(time[::STRIDE]), 10, 2), np.nan)
    sighted[:, 7, 0], sighted[:, 7, 1] = ball[::STRIDE, 0], 2.0
    return tape(
        *(robots, ball, believed),
        ball_sighted=sighted,
        events=[event(t, "goal", "home", f"at {t} s {ATTACK}") for t in EVENTS],
        labels=[[0, 0, ATTACK]],
        notes=[[0, 0, [["text", 0.0, 2.0, ATTACK], ["circle", 0.0, 0.0, 2.0]]]],
    )


@pytest.fixture(scope="module")
def recording():
    return circling()


@pytest.fixture(scope="module")
def browser():
    with Browser() as started:
        yield started


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Writes pages; gives their addresses."""
    folder = tmp_path_factory.mktemp("pages")

    def write(recording, name="page"):
        path = folder / f"{name}.html"
        path.write_text(page(recording, title=f"a title {ATTACK}"), encoding="utf-8")
        return path.as_uri()

    return write


@pytest.fixture(scope="module")
def address(pages, recording):
    return pages(recording)


@pytest.fixture
def opened(browser, address):
    """Opens a page; nothing may have been complained of when the test ends."""
    tabs = []

    def tab(url=address, **more):
        new = browser.open(url, **more)
        new.run("soccersim.ready")
        tabs.append(new)
        return new

    yield tab
    for each in tabs:
        assert each.complaints() == []
        assert each.requests() == [each.run("location.href.split('#')[0]")]
        each.close()


def go(tab, time):
    """Show a time, and wait until it is drawn."""
    tab.run(f"soccersim.app.player.seek({time})")
    tab.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")


def on_screen(tab, x, y):
    """A place of the field as one of the window."""
    u, v = tab.run(f"""(b => {{
      const [u, v] = soccersim.app.picture.view.pixel({x}, {y});
      return [b.x + u, b.y + v];
    }})(field.getBoundingClientRect())""")
    return u, v


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


def test_plays_at_its_speed_and_pauses(opened):
    tab = opened()
    tab.run("soccersim.app.player.setSpeed(4)")
    begun = tab.run("performance.now()")
    tab.press(" ", "Space")
    tab.wait("soccersim.app.player.time > 2")
    played, now = tab.run("[soccersim.app.player.time, performance.now()]")
    passed = 4 * (now - begun) / 1000
    assert 0.5 * passed < played <= passed  # a machine that is busy with else plays slower
    tab.press(" ", "Space")
    stopped = tab.run("soccersim.app.player.time")
    tab.run("new Promise(done => setTimeout(done, 60))")
    assert tab.run("soccersim.app.player.time") == stopped
    assert not tab.run("soccersim.app.player.playing")


def test_stops_at_the_end(opened):
    tab = opened()
    tab.run("soccersim.app.player.setSpeed(16); soccersim.app.player.seek(11)")
    tab.run("document.getElementById('play').click()")
    tab.wait("!soccersim.app.player.playing")
    assert tab.run("soccersim.app.player.time") == pytest.approx(SECONDS)


def test_scrubs_where_the_time_line_is_pressed_and_dragged(opened):
    tab = opened()
    box = tab.run("(b => [b.x, b.y, b.width, b.height])(timeline.getBoundingClientRect())")
    x, y = box[0] + box[2] / 2, box[1] + box[3] / 2
    tab.click(x, y)
    assert tab.run("soccersim.app.player.time") == pytest.approx(SECONDS / 2, abs=0.05)
    tab.mouse("mousePressed", x, y)
    tab.mouse("mouseMoved", x + box[2] / 4, y)
    tab.mouse("mouseReleased", x + box[2] / 4, y)
    assert tab.run("soccersim.app.player.time") == pytest.approx(0.75 * SECONDS, abs=0.1)


def test_marks_of_the_time_line_tell_what_they_are(opened):
    tab = opened()
    place = "timeline.getBoundingClientRect()"
    x = tab.run(f"{place}.x + soccersim.app.timeline.x({EVENTS[1]})")
    tab.mouse("mouseMoved", x, tab.run(f"{place}.y + 10"), button="none")
    assert f"at {EVENTS[1]} s" in tab.run("tip.textContent")
    assert not tab.run("tip.hidden")


def test_steps_by_frames_and_jumps_by_events(opened):
    tab = opened()
    go(tab, 5.0)
    tab.press(".")
    assert tab.run("soccersim.app.player.time") == pytest.approx(5.02)
    tab.press(",")
    tab.press(",")
    assert tab.run("soccersim.app.player.time") == pytest.approx(4.98)
    times = []
    for key in "pnn":
        tab.press(key)
        times.append(tab.run("soccersim.app.player.time"))
    assert times == pytest.approx([EVENTS[0], EVENTS[1], EVENTS[1]])
    tab.run("document.querySelector('#list button').click()")
    assert tab.run("soccersim.app.player.time") == pytest.approx(EVENTS[0])


def test_follows_the_robot_that_was_clicked_and_tells_its_numbers(opened, recording):
    tab = opened()
    go(tab, 2.0)
    x, y, _ = recording.body[2 * RECORD_HZ, 2, :3].tolist()
    tab.click(*on_screen(tab, x, y))
    tab.press("f")
    go(tab, 6.0)
    x, y, _ = recording.body[6 * RECORD_HZ, 2, :3].tolist()
    centre = tab.run("[field.clientWidth / 2, field.clientHeight / 2]")
    assert tab.run(f"soccersim.app.picture.view.pixel({x}, {y})") == pytest.approx(centre, abs=2)
    told = tab.run("numbers.innerText").split()
    assert told[0] == "home-3"
    assert f"{x:.2f}".replace("-", "\u2212") in " ".join(told)
    assert "0.500" in told  # how far its belief is off
    tab.press("Escape")
    assert tab.run("soccersim.app.picture.view.zoom") == 1


def test_what_teams_wrote_stays_text(opened):
    tab = opened()
    go(tab, 8.0)
    tab.run("soccersim.app.pick(0)")
    go(tab, 8.0)
    assert tab.run("window.pwned") is None
    assert tab.run("document.title") == f"a title {ATTACK}"
    assert ATTACK in tab.run("said.textContent")
    assert ATTACK in tab.run("numbers.textContent")
    assert tab.run("document.querySelectorAll('img, #list b').length") == 0
    notes = [[["text", 0, 2, ATTACK], ["circle", 0, 0, 2]], []]
    assert tab.run("soccersim.app.moment.notes") == notes


def test_toggles_and_help_answer_to_keys(opened):
    tab = opened()
    before = tab.run("soccersim.app.show")
    for key in "bcl":
        tab.press(key)
    after = tab.run("soccersim.app.show")
    changed = {key for key in before if before[key] != after[key]}
    assert changed == {"believed", "commands", "words"}
    tab.press("?")
    assert tab.run("guide.open")
    assert "Space" in tab.run("guide.innerText")


@pytest.mark.parametrize("dark", [True, False], ids=["dark", "light"])
def test_is_as_dark_as_the_system_wants_until_somebody_chooses(opened, dark):
    tab = opened(dark=dark)
    ground = "getComputedStyle(document.body).backgroundColor"
    page = f"rgb{look.PAGE}"
    assert (tab.run(ground) == page) == dark
    tab.press("m")
    assert (tab.run(ground) == page) != dark


@pytest.mark.parametrize(("width", "height"), [(390, 844), (360, 640)])
def test_on_a_phone_the_field_stands_upright_and_nothing_is_cut_off(opened, width, height):
    tab = opened(width=width, height=height, touch=True, ratio=2.0)
    assert tab.run("document.documentElement.scrollWidth") <= width
    assert tab.run("soccersim.app.picture.view.upright")
    assert tab.run("field.width / field.clientWidth") == 2
    buttons = "[...document.querySelectorAll('#transport .buttons button')]"
    assert tab.run(f"Math.min(...{buttons}.map(b => b.getBoundingClientRect().width))") >= 27
    buttons = "[...document.querySelectorAll('#transport button')]"
    assert tab.run(f"Math.max(...{buttons}.map(b => b.getBoundingClientRect().right))") <= width
    assert tab.run("toggles.getBoundingClientRect().bottom") <= height
    assert tab.run("said.scrollWidth <= said.clientWidth")


def test_fingers_pick_zoom_and_scrub(opened, recording):
    tab = opened(width=390, height=844, touch=True, ratio=2.0)
    go(tab, 2.0)
    x, y, _ = recording.body[2 * RECORD_HZ, 6, :3].tolist()
    robot = on_screen(tab, x, y)
    tab.touch([robot])
    assert tab.run("soccersim.app.selected") == 6
    left, right = on_screen(tab, 0, 3), on_screen(tab, 0, -3)
    apart = [(left[0] - 40, left[1]), (right[0] + 40, right[1])]
    tab.touch([left, apart[0]], [right, apart[1]])
    assert tab.run("soccersim.app.picture.view.zoom") > 1.3
    tab.wait("!whole.hidden")
    box = tab.run("(b => [b.x, b.y, b.width, b.height])(timeline.getBoundingClientRect())")
    x, y = box[0] + box[2] / 4, box[1] + box[3] / 2
    tab.touch([(x, y), (x + box[2] / 4, y)])
    assert tab.run("soccersim.app.player.time") == pytest.approx(SECONDS / 2, abs=0.1)
    assert tab.run("soccersim.app.selected") == 6


def test_address_may_name_a_moment(opened, address):
    tab = opened(f"{address}#t=4.5")
    assert tab.run("soccersim.app.player.time") == 4.5
    tab.run("location.hash = 't=99'")
    tab.wait(f"soccersim.app.player.time === {SECONDS}")


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
