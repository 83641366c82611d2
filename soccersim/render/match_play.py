"""What moves on the field in a match: notes and halos below, robots and ball, words above."""

from math import radians

import pygame

from soccersim.record.recording import Recording
from soccersim.render.arms import draw_arms
from soccersim.render.moments import Moments
from soccersim.render.pitch import View
from soccersim.render.play import Play
from soccersim.render.remarks import Remarks
from soccersim.render.story import Story

APART = 4.0  # px between truth and belief from which the ghost is shown: less is a match's usual
TURNED = radians(6.0)  # the same of the heading


class MatchPlay(Play):
    """Play as it is in a match: nobody follows a path, and teams have their say."""

    apart, turned = APART, TURNED

    def __init__(self, recording: Recording, view: View, scale: float, story: Story) -> None:
        super().__init__(recording, view, scale)
        self.story = story
        self.moments = Moments(recording, view, scale, story)
        self.remarks = Remarks(recording, view, scale, story)

    def draw(self, surface: pygame.Surface, index: int) -> None:
        """One record."""
        bodies = self.recording.body[index, :, :3].tolist()
        in_play = self.story.in_play[self.story.decision[index]]
        self.remarks.draw_below(surface, index)
        self.moments.draw_below(surface, index, bodies)
        self.draw_bodies(surface, index, bodies, in_play)
        self.moments.draw_above(surface, index, bodies[len(self.players)])
        self.remarks.draw_above(surface, index, bodies)
        draw_arms(surface, self.view, self.recording, index)
