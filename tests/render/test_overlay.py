"""What a overlay draws can be taken off again: the picture is the ground, to the pixel."""

import numpy as np
import pygame
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from soccersim.render import look
from soccersim.render.overlay import Overlay

SIZE = (300, 200)
PLACES = st.tuples(*[st.floats(-300, 600, width=32)] * 2)


@pytest.fixture(scope="module")
def ground():
    surface = pygame.Surface(SIZE, 0, 32)
    noise = np.random.default_rng(1).integers(0, 256, (*SIZE, 3), np.uint8)
    pygame.surfarray.blit_array(surface, noise)
    return surface


def pixels(surface):
    return pygame.surfarray.array3d(surface)


@given(start=PLACES, end=PLACES, width=st.integers(1, 8))
@example(start=(-300.0, -200.0), end=(600.0, 400.0), width=1)
@example(start=(20.5, 190.0), end=(280.0, 187.5), width=3)
def test_a_line_leaves_nothing_behind(ground, start, end, width):
    overlay = Overlay(ground)
    overlay.surface.set_clip((10, 10, 270, 170))
    overlay.line(look.BELIEVED, start, end, width)
    overlay.clear()
    assert np.array_equal(pixels(overlay.surface), pixels(ground))


@given(centre=PLACES, radius=st.floats(0.1, 500))
@example(centre=(150.0, 100.0), radius=60.0)
def test_a_circle_leaves_nothing_behind(ground, centre, radius):
    overlay = Overlay(ground)
    overlay.surface.set_clip((10, 10, 270, 170))
    (x, y), turns = centre, np.linspace(0, 2 * np.pi, 48, endpoint=False)
    overlay.loop(look.BELIEVED, [(x + radius * np.cos(t), y + radius * np.sin(t)) for t in turns])
    overlay.clear()
    assert np.array_equal(pixels(overlay.surface), pixels(ground))


def test_a_long_line_marks_little_more_than_itself(ground):
    overlay = Overlay(ground)
    overlay.line(look.BELIEVED, (5.0, 5.0), (295.0, 195.0))
    assert sum(rect.width * rect.height for rect in overlay.drawn) < 0.3 * SIZE[0] * SIZE[1]


def test_sprites_leave_nothing_behind_and_are_told_once_more_when_taken_off(ground):
    overlay, sprite = Overlay(ground), pygame.Surface((30, 20), pygame.SRCALPHA, 32)
    sprite.fill(look.BALL)
    overlay.lay([(sprite, (290, -5)), (sprite, (40, 40))])
    assert overlay.drawn == [pygame.Rect(290, 0, 10, 15), pygame.Rect(40, 40, 30, 20)]
    assert overlay.surface.get_at((50, 50)) == look.BALL
    assert len(overlay.clear()) == 2
    assert overlay.drawn == []
    assert np.array_equal(pixels(overlay.surface), pixels(ground))


def test_what_changes_on_the_ground_shows_where_it_is_told(ground):
    own = ground.copy()
    overlay, spot = Overlay(own), pygame.Rect(100, 50, 8, 8)
    own.fill(look.BALL, spot)
    assert overlay.clear([spot]) == [spot]
    assert np.array_equal(pixels(overlay.surface), pixels(own))
