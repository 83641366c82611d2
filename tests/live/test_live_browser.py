"""The base station's page in a real Chromium."""

import json
import math

import browser
import pytest
from stations import station

from soccersim.bundled import names

pytestmark = pytest.mark.skipif(not browser.installed(), reason="no chromium on this machine")
PIXEL = """(() => {{
  const box = document.getElementById("field").getBoundingClientRect();
  const [u, v] = soccersim.picture.view.pixel({0}, {1});
  return [box.left + u, box.top + v];
}})()"""


@pytest.fixture(scope="module")
def running():
    with station() as opened:
        yield opened


@pytest.fixture(scope="module")
def chromium():
    with browser.Browser() as chromium:
        yield chromium


@pytest.fixture(scope="module")
def tab(running, chromium):
    tab = chromium.open(running[0].url, 1280, 800)
    tab.wait("window.soccersim.moment && soccersim.moment.time > 0.3")
    yield tab
    assert tab.complaints() == []
    addresses = [a for a in tab.requests() if not a.startswith(("data:", running[0].url))]
    assert [a for a in addresses if "/live" not in a] == []


def moment(tab):
    return json.loads(tab.run("JSON.stringify(soccersim.moment)"))


def test_a_click_sends_the_robot_there(tab):
    at = tab.run(PIXEL.format(0.3, 0.7))
    tab.run("soccersim.actions.speed(4)")
    tab.click(*at)
    off = "Math.hypot(soccersim.moment.robots[0].x - 0.3, soccersim.moment.robots[0].y - 0.7)"
    tab.wait(f"{off} < 0.05", 15)
    target = moment(tab)["robots"][0]["target"]
    assert abs(target["x"] - 0.3) < 0.03
    assert abs(target["y"] - 0.7) < 0.03
    tab.wait("document.getElementById('list').textContent.includes('idris there after')")
    tab.run("soccersim.actions.speed(1)")
    told = tab.run("document.querySelector('#numbers').textContent")
    for word in ("true", "believes", "counts", "rpm", "PWM", "gyro", "wheel 3"):
        assert word in told


def test_a_drag_tells_the_heading(tab):
    x, y = tab.run(PIXEL.format(-0.5, 0.2))
    tab.mouse("mouseMoved", x, y, button="none")
    tab.mouse("mousePressed", x, y)
    tab.mouse("mouseMoved", x, y - 60)
    tab.mouse("mouseReleased", x, y - 60)
    tab.wait("Math.abs(soccersim.moment.robots[0].target.heading - Math.PI / 2) < 0.01")


def test_a_coordinate_is_typed_and_nonsense_is_told(tab):
    for name in ("x", "y"):
        tab.run(f"document.getElementById('{name}').value = '1,5'")
    tab.run("document.querySelector('#send').requestSubmit()")
    tab.wait("Math.abs(soccersim.moment.robots[0].target.x - 1.5) < 1e-9")
    tab.run("document.querySelector('#x').value = 'far'")
    tab.run("document.querySelector('#send').requestSubmit()")
    tab.wait("document.getElementById('toast').textContent.includes('metres')")


def test_stop_step_and_go_on(tab):
    tab.press(" ", "Space")
    tab.wait("soccersim.moment.paused")
    tick = moment(tab)["time"]
    tab.press(".", "Period")
    tab.wait(f"Math.abs(soccersim.moment.time - {tick} - 0.01) < 1e-6")
    tab.press("+", "Equal")
    tab.wait("soccersim.moment.speed === 2")
    tab.press("0", "Digit0")
    tab.press(" ", "Space")
    tab.wait(f"!soccersim.moment.paused && soccersim.moment.time > {tick} + 0.1")


def test_the_ball_is_put_and_a_robot_is_picked(tab):
    tab.press("b", "KeyB")
    tab.click(*tab.run(PIXEL.format(2, 1.5)))
    tab.wait("Math.hypot(soccersim.moment.ball.x - 2, soccersim.moment.ball.y - 1.5) < 0.03")
    tab.press("s", "KeyS")
    pose = moment(tab)["robots"][2]
    tab.click(*tab.run(PIXEL.format(pose["x"], pose["y"])))
    assert tab.run("soccersim.selected") == 2
    tab.press("2", "Digit2")
    assert tab.run("soccersim.selected") == 1


def test_gains_are_chosen_by_sliders(tab, running):
    tab.run("document.getElementById('tuning').open = true")
    tab.run("""(() => {
      const slider = document.querySelector('[data-loop=position][data-gain=kp]');
      slider.value = 5;
      slider.dispatchEvent(new Event("input"));
    })()""")
    picked, gains = tab.run("soccersim.selected"), running[1].play.told_gains
    tab.until(lambda: gains()[picked]["position"][0] == 5, "the gain of the slider")


def test_another_scenario_is_opened_and_the_line_comes_back(tab, running):
    tab.run("document.getElementById('scenario').value = 'defender'")
    tab.run("document.getElementById('open').requestSubmit()")
    tab.wait("soccersim.moments.told.scenario === 'defender' && soccersim.moment?.time > 0.1")
    assert tab.run("document.getElementById('badges').children.length") == 1
    tab.run("soccersim.link.socket.close()")
    tab.wait("soccersim.link.up && document.getElementById('veil').hidden")
    tab.wait("soccersim.moment && soccersim.link.rate > 10")
    assert "Hz" in tab.run("document.getElementById('meter').textContent")


def test_help_comes_and_goes_by_keys(tab):
    guide = "document.getElementById('guide').open"
    for key in ("Escape", "?"):
        tab.press("?", "Slash")
        tab.wait(guide)
        tab.press("h", "KeyH")  # for the guide: no robot halts
        tab.press(key)
        tab.wait(f"!{guide}")


def test_the_papers_runs_are_found_and_say_what_they_are(tab):
    groups = tab.run("[...document.querySelectorAll('#scenario optgroup')].map((g) => g.label)")
    assert groups == ["the papers' runs", "matches", "others"]
    papers = tab.run("document.querySelector('#scenario optgroup').textContent")
    assert all(name in papers for name in ("defender", "idris-table7", "linear", "arm-table2"))
    tab.run("""(() => {
      const select = document.getElementById("scenario");
      select.value = "idris-table7";
      select.dispatchEvent(new Event("change"));
    })()""")
    assert "sixteen moves" in tab.run("document.getElementById('tells').textContent")


def test_who_lost_his_token_is_told_so(chromium):
    with station(host="0.0.0.0") as (gate, _):
        tab = chromium.open(f"http://127.0.0.1:{gate.port}/?token={gate.token}")
        tab.wait("window.soccersim.moment")
        tab.run("history.replaceState(null, '', '/?token=old'); soccersim.link.socket.close()")
        veil = "document.getElementById('veil')"
        tab.wait(f"!{veil}.hidden && {veil}.textContent.includes('open the address as it was')")
        tab.close()


def test_a_telephone_has_room_for_it(running, chromium):
    tab = chromium.open(running[0].url, 390, 844, touch=True, dark=False, ratio=2)
    tab.wait("window.soccersim.moment")
    assert tab.run("document.documentElement.scrollWidth") <= 390
    assert tab.run("document.getElementById('field').clientHeight") > 300
    assert tab.run("getComputedStyle(document.body).backgroundColor") == "rgb(241, 244, 246)"
    assert tab.complaints() == []
    tab.close()


def open_in(tab, name):
    tab.run(f"soccersim.actions.open('{name}')")
    tab.wait(f"soccersim.moments.told.opened === '{name}' && soccersim.moment?.time > 0.15")
    tab.click(*tab.run(PIXEL.format(0.5, 0.5)))
    tab.press("h", "KeyH")
    tab.press("ArrowUp", "ArrowUp")


def test_arms_alone_have_no_robots_to_pick(tab):
    open_in(tab, "arm-table2")
    assert tab.run("soccersim.selected") == -1
    assert tab.run("soccersim.moment.links.length") > 0


def test_a_match_shows_what_cameras_see_and_obeys_the_referee_box(tab):
    open_in(tab, "friendly-match")
    tab.wait("soccersim.moment.sightings.length > 3")
    seen = moment(tab)
    off = [
        math.hypot(s["x"] - seen["ball"]["x"], s["y"] - seen["ball"]["y"])
        for s in seen["sightings"]
    ]
    assert min(off) < 0.3
    press = "document.querySelectorAll('[data-call={}]')[1].click()"
    tab.run(press.format("goal"))
    tab.wait("soccersim.moment.score[1] === 1")
    tab.run(press.format("subgoal"))
    tab.wait("soccersim.moment.score[1] === 0")


@pytest.mark.slow
@pytest.mark.parametrize("name", names("scenario"))
def test_every_scenario_is_shown(tab, name):
    open_in(tab, name)
    assert tab.complaints() == []
