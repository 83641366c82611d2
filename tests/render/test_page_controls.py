"""The replay page in a real browser: it plays, scrubs, answers to keys, mouse and fingers."""

import pytest
from browser import installed
from on_page import ATTACK, EVENTS, SECONDS, go, on_screen
from tape import RECORD_HZ

from soccersim.render import look

pytestmark = pytest.mark.skipif(installed() is None, reason="no Chromium on this machine")


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
