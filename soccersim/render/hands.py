"""Keys and gamepad: what somebody at the window wants."""

from dataclasses import dataclass, field

import pygame
from pygame._sdl2 import controller

WAYS = {  # key: ahead, left, turning
    pygame.K_UP: (1, 0, 0),
    pygame.K_w: (1, 0, 0),
    pygame.K_DOWN: (-1, 0, 0),
    pygame.K_s: (-1, 0, 0),
    pygame.K_a: (0, 1, 0),
    pygame.K_LEFT: (0, 1, 0),
    pygame.K_d: (0, -1, 0),
    pygame.K_RIGHT: (0, -1, 0),
    pygame.K_q: (0, 0, 1),
    pygame.K_e: (0, 0, -1),
}
DEEDS = {
    pygame.K_SPACE: "kick",
    pygame.K_LSHIFT: "dribble",
    pygame.K_p: "pause",
    pygame.K_PLUS: "faster",
    pygame.K_EQUALS: "faster",
    pygame.K_MINUS: "slower",
    pygame.K_r: "again",
    pygame.K_TAB: "next",
    pygame.K_h: "release",
    pygame.K_ESCAPE: "quit",
}
BUTTONS = {  # where they lie on an Xbox pad, whatever is printed on them
    pygame.CONTROLLER_BUTTON_A: "kick",
    pygame.CONTROLLER_BUTTON_B: "dribble",
    pygame.CONTROLLER_BUTTON_X: "next",
    pygame.CONTROLLER_BUTTON_START: "pause",
}
STICKS = (
    pygame.CONTROLLER_AXIS_LEFTX,
    pygame.CONTROLLER_AXIS_LEFTY,
    pygame.CONTROLLER_AXIS_RIGHTX,
)
FULL = 32767  # of an axis
DEAD = 0.15  # of a stick's way that counts as none
HELP = (
    "W A S D or arrows: drive · Q E: turn · click: go there · Space: kick · Shift: dribble"
    " · Tab, 1-9: another robot · H: back to its team · P: stop · + \u2212: speed · R: again"
    " · Esc: end"
)


@dataclass
class Hands:
    """What keys and sticks say; `deeds` since the last look."""

    held: set[int] = field(default_factory=set)
    sticks: list[float] = field(default_factory=lambda: [0.0] * len(STICKS))
    deeds: list[str] = field(default_factory=list)
    pads: dict[int, controller.Controller] = field(default_factory=dict)  # kept, or they are silent

    def look(self) -> list[str]:
        """All deeds since the last look: kick, dribble, pause, pick 3, click 100 200, ..."""
        for event in pygame.event.get():
            self._take(event)
        deeds, self.deeds = self.deeds, []
        return deeds

    @property
    def way(self) -> tuple[float, float, float]:
        """Ahead, left, turning to the left, each -1 to 1."""
        sums = [float(sum(WAYS[key][i] for key in self.held)) for i in range(3)]
        left, ahead, turn = (value if abs(value) > DEAD else 0.0 for value in self.sticks)
        whole = sums[0] - ahead, sums[1] - left, sums[2] - turn
        ahead, left, turn = (max(-1.0, min(1.0, part)) for part in whole)
        return ahead, left, turn

    def _take(self, event: pygame.event.Event) -> None:
        if event.type == pygame.QUIT:
            self.deeds.append("quit")
        elif event.type == pygame.KEYDOWN:
            self._press(event.key)
        elif event.type == pygame.KEYUP:
            self.held.discard(event.key)
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.held.clear()  # of what is let go elsewhere we do not hear
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self.deeds.append(f"click {event.pos[0]} {event.pos[1]}")
        elif event.type == pygame.CONTROLLERDEVICEADDED:
            pad = controller.Controller(event.device_index)
            self.pads[pad.id] = pad
        elif event.type == pygame.CONTROLLERDEVICEREMOVED:
            self.pads.pop(event.instance_id, None)
            self.sticks = [0.0] * len(STICKS)
        elif event.type == pygame.CONTROLLERAXISMOTION and event.axis in STICKS:
            self.sticks[STICKS.index(event.axis)] = event.value / FULL
        elif event.type == pygame.CONTROLLERBUTTONDOWN and event.button in BUTTONS:
            self.deeds.append(BUTTONS[event.button])

    def _press(self, key: int) -> None:
        if key in WAYS:
            self.held.add(key)
        elif key in DEEDS:
            self.deeds.append(DEEDS[key])
        elif pygame.K_1 <= key <= pygame.K_9:
            self.deeds.append(f"pick {key - pygame.K_0}")


def take_hands() -> Hands:
    """Ready for keys, and for gamepads that are there or come."""
    controller.init()
    return Hands()
