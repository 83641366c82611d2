"""The window, on a screen that is none: what keys do, and what is drawn."""

import time

import pygame
import pytest

from soccersim.live.catalogue import Catalogue
from soccersim.live.frame import HEAD
from soccersim.live.window import Driver
from soccersim.problems import MachineError
from soccersim.render import look
from soccersim.render.hands import Hands
from soccersim.render.window import close_screen, open_screen

SIZE = (640, 428)


@pytest.fixture
def driver(monkeypatch, request):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    open_screen()
    catalogue = Catalogue(*request.param)
    driver = Driver(catalogue, catalogue.first(), SIZE)
    driver.session.start()
    yield driver
    driver.session.end()
    close_screen()


def press(key, kind=pygame.KEYDOWN):
    pygame.event.post(pygame.event.Event(kind, key=key))


def until(driver, so, seconds=8):
    end = time.monotonic() + seconds
    while not so():
        assert driver.turn()
        assert time.monotonic() < end
        time.sleep(0.01)


def body(driver):
    return driver.session.play.simulation.machine.truth.body[driver.picked]


@pytest.mark.parametrize("driver", [("training",)], indirect=True)
def test_keys_drive_a_robot_and_the_picture_shows_it(driver):
    until(driver, lambda: driver.picture is not None)
    driver.turn()
    pixel = tuple(map(round, driver.window.view.pixel(*body(driver)[:2])))
    assert driver.window.screen.get_at(pixel)[:3] not in look.GRASS
    press(pygame.K_TAB)
    until(driver, lambda: driver.picked == 1)
    press(pygame.K_s)
    until(driver, lambda: body(driver)[3] < -0.5)
    press(pygame.K_s, pygame.KEYUP)
    until(driver, lambda: abs(body(driver)[3]) < 0.05)
    press(pygame.K_q)
    until(driver, lambda: body(driver)[5] > 0.5)
    press(pygame.K_q, pygame.KEYUP)
    press(pygame.K_p)
    until(driver, lambda: driver.session.paused)
    press(pygame.K_MINUS)
    until(driver, lambda: driver.session.speed == 0.5)
    press(pygame.K_1)
    press(pygame.K_SPACE)
    until(driver, lambda: driver.picked == 0 and "no kicker" in driver.word)
    press(pygame.K_ESCAPE)
    assert not driver.turn()


@pytest.mark.parametrize("driver", [("training",)], indirect=True)
def test_the_window_says_what_it_waits_for(driver, monkeypatch):
    monkeypatch.setattr(driver.session, "waits", lambda: ("compiling the physics", 12.3))
    head = dict.fromkeys(HEAD, 0.0)
    assert driver._words(head, [1] * 4)[1] == "compiling the physics: 12 s"


@pytest.mark.parametrize("driver", [("friendly-match",)], indirect=True)
def test_one_robot_against_a_team(driver):
    assert driver.picked == 1  # not the keeper
    press(pygame.K_w)
    pilot = driver.session.play.pilot
    until(driver, lambda: driver.picked in pilot.taken)
    press(pygame.K_w, pygame.KEYUP)
    press(pygame.K_TAB)
    until(driver, lambda: driver.picked == 2 and not pilot.taken)
    press(pygame.K_a)
    until(driver, lambda: driver.picked in pilot.taken)
    press(pygame.K_a, pygame.KEYUP)
    driver.turn()
    press(pygame.K_h)
    until(driver, lambda: not pilot.taken)


@pytest.mark.parametrize("driver", [("training",)], indirect=True)
def test_a_click_sends_it(driver):
    x, y = map(round, driver.window.view.pixel(0.0, 0.5))
    pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONDOWN, button=1, pos=(x, y)))
    until(driver, lambda: abs(driver.session.play.targets[0][1] - 0.5) < 0.05)


def test_sticks_have_a_dead_middle_and_keys_add_up():
    hands = Hands()
    hands.sticks[:] = [0.1, -0.1, 0.0]
    assert hands.way == (0, 0, 0)
    hands.sticks[:] = [-1.0, -0.5, 1.0]
    assert hands.way == (0.5, 1.0, -1.0)
    hands.held |= {pygame.K_w, pygame.K_UP}
    assert hands.way[0] == 1.0


@pytest.mark.parametrize("driver", [("training",)], indirect=True)
def test_a_gamepad_drives_as_docs_say(driver):
    driver.picked = 1
    for axis, value in ((1, -32767), (0, 0), (2, -32767), (5, 32767)):
        move = pygame.event.Event(pygame.CONTROLLERAXISMOTION, axis=axis, value=value)
        pygame.event.post(move)
    until(driver, lambda: body(driver)[3] > 0.3 and body(driver)[5] > 0.3)
    assert driver.hands.way == (1.0, 0.0, 1.0)
    pygame.event.post(pygame.event.Event(pygame.CONTROLLERBUTTONDOWN, button=1))
    until(driver, lambda: driver.dribbles)
    pygame.event.post(pygame.event.Event(pygame.CONTROLLERDEVICEREMOVED, instance_id=0))
    until(driver, lambda: driver.hands.way == (0, 0, 0) and not driver.driving)


def test_keys_that_are_let_go_elsewhere_are_let_go():
    hands = Hands()
    for event in (
        pygame.event.Event(pygame.KEYDOWN, key=pygame.K_w),
        pygame.event.Event(pygame.WINDOWFOCUSLOST),
    ):
        hands._take(event)
    assert hands.way == (0, 0, 0)


def test_without_a_display_it_says_so(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("sys.platform", "linux")
    with pytest.raises(MachineError, match="no display for a window"):
        open_screen()
