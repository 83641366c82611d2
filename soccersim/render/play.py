"""What moves on the field at one moment: targets, robots, what they believe, the ball."""

from collections.abc import Sequence
from math import cos, hypot, pi, sin

import pygame

from soccersim.record.recording import Recording
from soccersim.render import look
from soccersim.render.arms import draw_arms
from soccersim.render.cells import leg_number
from soccersim.render.lettering import Blit, Lettering
from soccersim.render.likeness import HUB
from soccersim.render.overlay import Overlay
from soccersim.render.pitch import View
from soccersim.render.sprites import STEPS, Sprites, target_radius
from soccersim.spec.player import Player
from soccersim.spec.scenario import Scenario

BALL_RADIUS = 0.11  # m; asked for where there is no ball, and never seen
APART = 2.0  # px between truth and belief from which the ghost is shown
TURNED = 2.0 * pi / 180  # the same of the heading
NUMBER = 1.55  # size of a number's letters beside the radius of the hub
SMALLEST = 9  # px, of a number's letters
TINY = 6.0  # px; a smaller robot goes without its number, which would hide it
LABEL = 12  # px, letters of a number at a target
BEHIND = 1.9  # radii from the target to its number, away from its arrow

Pose = tuple[float, float, float]


class Play:
    """Everything that moves, as sprites at their places."""

    apart, turned = APART, TURNED

    def __init__(self, recording: Recording, view: View, scale: float) -> None:
        scenario = recording.scenario
        self.recording = recording
        self.view = view
        self.players = scenario.robots
        models = [player.model for player in self.players]
        self.looks = [models.index(model) for model in models]  # alike: one set of sprites
        ball_radius = scenario.ball.radius if scenario.ball else BALL_RADIUS
        self.sprites = Sprites(models, ball_radius, view.px_per_m)
        self.targets = [_targets(scenario, player) for player in self.players]
        self.numbers = [_numbers(player, view.px_per_m) for player in self.players]
        several = sum(map(bool, self.targets)) > 1
        self.labels = [_label(player, several, scale) for player in self.players]

    def draw(self, overlay: Overlay, index: int) -> None:
        """Targets below, robots on them, belief over both, the ball over all."""
        overlay.lay(self._targets(index))
        self.draw_bodies(overlay, index, self.recording.body[index, :, :3].tolist())
        draw_arms(overlay, self.view, self.recording, index)

    def draw_bodies(
        self,
        overlay: Overlay,
        index: int,
        bodies: list[Pose],
        in_play: Sequence[int] | None = None,
    ) -> None:
        """Robots, what they believe, the ball; robots that are not in play are dim."""
        believed = self.recording.estimate[index].tolist()
        playing = in_play or [1] * len(self.players)
        ghosts: list[Blit] = []
        for robot, (true, belief) in enumerate(zip(bodies, believed, strict=False)):
            if playing[robot] and self._differ(true, belief):
                start, end = self.view.pixel(*true[:2]), self.view.pixel(*belief[:2])
                overlay.line(look.BELIEVED, start, end)
                ghosts.append(self._at("ghost", belief, self.looks[robot]))
        overlay.lay(self._robots(bodies, playing))
        if self.recording.scenario.ball:
            ghosts.append(self._at("ball", bodies[len(self.players)]))
        overlay.lay(ghosts)

    def _at(self, kind: str, pose: Pose, robot: int = 0) -> Blit:
        """A sprite and its corner, for a pose of its centre."""
        x, y = self.view.pixel(pose[0], pose[1])
        sprite = self.sprites.take(kind, round(pose[2] * STEPS / (2 * pi)) % STEPS, robot)
        return sprite, (round(x - sprite.width / 2), round(y - sprite.height / 2))

    def _robots(self, bodies: list[Pose], playing: Sequence[int]) -> list[Blit]:
        blits: list[Blit] = []
        for pose, player, kind, numbers, plays in zip(
            bodies, self.players, self.looks, self.numbers, playing, strict=False
        ):
            x, y = self.view.pixel(pose[0], pose[1])
            number = numbers[plays]
            blits.append(self._at(player.team if plays else f"{player.team} off", pose, kind))
            blits.append((number, (round(x - number.width / 2), round(y - number.height / 2))))
        return blits

    def _targets(self, index: int) -> list[Blit]:
        """The target of each robot's leg, with its number where there are several."""
        blits: list[Blit] = []
        aside = BEHIND * target_radius(self.view.px_per_m) * self.view.px_per_m
        legs = self.recording.leg[index].tolist()
        for player, targets, leg, label in zip(
            self.players, self.targets, legs, self.labels, strict=True
        ):
            if targets:
                pose = targets[leg_number(player, leg)]
                x, y = self.view.pixel(pose[0], pose[1])
                blits.append(self._at("target", pose))
                x, y = x - aside * cos(pose[2]), y + aside * sin(pose[2])
                blits.append((label, (round(x - label.width / 2), round(y - label.height / 2))))
        return blits

    def _differ(self, true: Pose, belief: Pose) -> bool:
        """Whether one can see that a robot is not where it believes."""
        apart = hypot(true[0] - belief[0], true[1] - belief[1]) * self.view.px_per_m
        turned = (true[2] - belief[2] + pi) % (2 * pi) - pi
        return apart > self.apart or abs(turned) > self.turned


def _targets(scenario: Scenario, player: Player) -> list[Pose]:
    return [scenario.coordinates.field_pose(leg.to) for leg in player.path or ()]


def _label(player: Player, several: bool, scale: float) -> pygame.Surface:
    """Whose target it is, where there are several."""
    letters = Lettering(LABEL * scale, look.tint(player.team), None, bold=True)
    return letters.word(str(player.number) if several else "")


def _numbers(player: Player, px_per_m: float) -> tuple[pygame.Surface, pygame.Surface]:
    """A robot's number, to stand upright on its hub: out of play, and in play."""
    text = str(player.number) if player.model.radius * px_per_m >= TINY else ""
    size = NUMBER * HUB * player.model.radius * px_per_m * (1.0 if len(text) < 2 else 0.8)
    dim, bright = (
        Lettering(max(size, SMALLEST), ink, None, bold=True).word(text)
        for ink in (look.FAINT, look.INK)
    )
    return dim, bright
