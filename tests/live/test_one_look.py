"""Frames, page and window: field, robots and ball look the same wherever they are drawn."""

import re
from importlib.resources import files
from math import cos, sin

import browser
import pytest
from stations import Talk, station

from soccersim import Simulation, load_scenario
from soccersim.live.catalogue import Catalogue
from soccersim.live.page import page
from soccersim.live.window import Driver
from soccersim.render import look
from soccersim.render.frames import FrameRenderer
from soccersim.render.page.shared import DRAWING
from soccersim.render.window import close_screen, open_screen

STRIKER, RADIUS = 1, 0.24  # a robot of training, m
FIELD = {  # places, m: what is seen there
    (-5.5, -2.9): look.GRASS[0],
    (-4.5, -2.9): look.GRASS[1],
    (0.0, 2.7): look.LINE,
    (6.4, 3.0): look.VERGE,
}
ROBOT = {  # angle from its heading, share of its radius
    (2.0, 0.68): look.TEAMS["home"],
    (0.0, 0.72): look.NOSE,
    (0.0, 0.36): look.HUB,  # beside its number
}
NEAR = 12  # of 255: edges are smoothed


def places(robot, ball):
    """All places that are looked at, and their colours, for poses of the robot and the ball."""
    x, y, heading = robot
    on_robot = {
        (x + share * RADIUS * cos(heading + angle), y + share * RADIUS * sin(heading + angle)): look
        for (angle, share), look in ROBOT.items()
    }
    return FIELD | on_robot | {tuple(ball): look.BALL_PATCH}


def check(colour_at, robot, ball):
    for (x, y), colour in places(robot, ball).items():
        seen = colour_at(x, y)
        assert all(abs(a - b) <= NEAR for a, b in zip(seen, colour, strict=True)), (x, y, seen)


def test_frames_look_so():
    recording = Simulation(load_scenario("training", settings=["duration=0.1"])).run()
    frames = FrameRenderer(recording)
    picture, bodies = frames.draw(0), recording.body[0].tolist()
    check(lambda x, y: at(picture, frames.view, x, y), bodies[STRIKER][:3], bodies[4][:2])


def test_the_window_looks_so(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    open_screen()
    catalogue = Catalogue("training")
    driver = Driver(catalogue, catalogue.first(), look.SIZE)
    driver.session._show(0.0)
    driver.turn()
    bodies = driver.session.play.simulation.machine.truth.body.tolist()
    window = driver.window
    check(lambda x, y: at(window.screen, window.view, x, y), bodies[STRIKER][:3], bodies[4][:2])
    close_screen()


def at(picture, view, x, y):
    return tuple(picture.get_at(tuple(map(round, view.pixel(x, y)))))[:3]


@pytest.mark.skipif(not browser.installed(), reason="no chromium on this machine")
def test_the_page_looks_so():
    with station() as (gate, _), Talk(gate) as talk, browser.Browser() as chromium:
        talk.say(do="open", scenario="training")
        talk.say(do="pause")
        tab = chromium.open(gate.url, *look.SIZE)
        tab.wait("window.soccersim.moment && soccersim.moment.paused")
        robot, ball = tab.run(f"""(() => {{
          const {{ robots: {{ {STRIKER}: robot }}, ball }} = soccersim.moment;
          return [[robot.x, robot.y, robot.heading], [ball.x, ball.y]];
        }})()""")
        pixel = """(() => {{
          const {{ picture }} = soccersim;
          const [u, v] = picture.view.pixel({}, {}).map((n) => Math.round(n * picture.ratio));
          return [...picture.pen.getImageData(u, v, 1, 1).data].slice(0, 3);
        }})()"""
        tab.until(lambda: any(tab.run(pixel.format(0, 0))), "the first picture")
        check(lambda x, y: tab.run(pixel.format(x, y)), robot, ball)


def test_scripts_that_draw_have_no_colours_of_their_own():
    """All come from look.py, but for the dark plate under words."""
    scripts = [files("soccersim.render.page") / f"{name}.js" for name in DRAWING]
    found = {c for s in scripts for c in re.findall(r"#[0-9a-f]{6,8}\b", s.read_text("utf-8"))}
    assert found <= {"#0e141ac0"}
    told = page()
    for name, colour in (("page", look.PAGE), ("home", look.TEAMS["home"]), ("ink", look.INK)):
        assert f"--{name}:#{bytes(colour).hex()};" in told
