"""A window on the screen that shows a moment of play."""

import os
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from soccersim.problems import MachineError
from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.arms import draw_arms
from soccersim.render.lettering import Lettering
from soccersim.render.overlay import Overlay
from soccersim.render.pitch import View, paint_pitch
from soccersim.render.play import Play
from soccersim.spec.scenario import Scenario

NOWHERE = ("dummy", "offscreen")  # drivers of SDL that show nothing, taken where there is no screen
EDGE = 20  # px
FULL = 0.94  # of the screen that the window may take


def open_screen() -> tuple[int, int]:
    """The size a picture may have; MachineError where there is no screen."""
    asked = os.environ.get("SDL_VIDEODRIVER", "")
    screens = any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))
    try:
        if sys.platform == "linux" and not screens and not asked:
            raise pygame.error("no display")  # said before SDL looks for one, and complains
        pygame.display.init()
        if pygame.display.get_driver() in NOWHERE and not asked:
            raise pygame.error("no display")
        width, height = pygame.display.get_desktop_sizes()[0]
    except (pygame.error, IndexError) as error:
        pygame.display.quit()
        raise MachineError(
            "there is no display for a window: leave out --window, and open the page in a browser"
        ) from error
    share = min(1.0, FULL * width / look.SIZE[0], FULL * height / look.SIZE[1])
    return round(look.SIZE[0] * share), round(look.SIZE[1] * share)


class Window:
    """The picture of one scenario, on the screen."""

    def __init__(self, scenario: Scenario, size: tuple[int, int]) -> None:
        self.scenario, self.size, self.scale = scenario, size, look.scale(size)
        self.screen = pygame.display.set_mode(size)
        pygame.display.set_caption(f"soccersim: {scenario.name}")
        self.view = View.fit(scenario.field, size, round(look.BAND * self.scale))
        robots = len(scenario.robots)
        bodies = robots + (scenario.ball is not None) + 3 * len(scenario.arms)
        # one record, written anew for every picture
        self.moment = Recording(
            {"scenario": scenario.model_dump(mode="json")},
            {"body": np.zeros((1, bodies, 6)), "estimate": np.zeros((1, robots, 3))},
        )
        self.play = Play(self.moment, self.view, self.scale)
        self.grounds = {home: paint_pitch(scenario.field, self.view, home) for home in (-1, 1)}
        self.title = Lettering(26 * self.scale, look.INK, look.PAGE, bold=True)
        self.small = Lettering(14 * self.scale, look.FAINT, look.PAGE)

    def show(
        self,
        body: NDArray[Any],
        believed: NDArray[Any],
        playing: Sequence[int],
        home: int,
        picked: int,
        target: NDArray[Any],
        words: Sequence[str],
    ) -> None:
        """Draw a moment: poses (B, 3) and (R, 3), who is in play, home's goal's side.

        target: of the robot that is picked, (3,); nan where it has none. words: above to the left,
        in the middle and to the right, then two lines below.
        """
        arrays = self.moment.arrays
        arrays["body"][0, :, :3], arrays["estimate"][0] = body, believed
        screen = self.screen
        screen.fill(look.PAGE)
        screen.blit(self.grounds[home], self.view.frame)
        screen.set_clip(self.view.frame)
        self._ring(body[picked], self.scenario.robots[picked].model.radius)
        overlay = Overlay(screen, screen)
        if np.isfinite(target).all():
            overlay.lay([self.play._at("target", target.tolist())])
        self.play.draw_bodies(overlay, 0, body.tolist(), playing)
        draw_arms(overlay, self.view, self.moment, 0)
        screen.set_clip(None)
        self._write(words)
        pygame.display.flip()

    def _ring(self, pose: NDArray[Any], radius: float) -> None:
        """Round the robot that is driven."""
        centre = self.view.pixel(float(pose[0]), float(pose[1]))
        pygame.draw.aacircle(
            self.screen, look.INK, centre, round(radius * self.view.px_per_m) + 7, 2
        )

    def _write(self, words: Sequence[str]) -> None:
        left, middle, right, first, second = words
        width, height = self.size
        edge, top, scale = EDGE * self.scale, look.BAND * self.scale / 2, self.scale
        self.title.write(self.screen, left, edge, top)
        self.title.write(self.screen, middle, (width - self.title.width(middle)) / 2, top)
        self.title.write(self.screen, right, width - edge - self.title.width(right), top)
        room = width - 2 * edge
        low = height - look.BAND * scale
        self.small.write(self.screen, self.small.fitted(first, room), edge, low + 25 * scale)
        self.small.write(self.screen, self.small.fitted(second, room), edge, low + 50 * scale)


def close_screen() -> None:
    """The window goes."""
    pygame.display.quit()
