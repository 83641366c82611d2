"""What moves on the field in a match: notes and halos below, robots and ball, words above."""

from math import radians

from soccersim.record.recording import Recording
from soccersim.render.arms import draw_arms
from soccersim.render.moments import Moments
from soccersim.render.overlay import Overlay
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

    def draw(self, overlay: Overlay, index: int) -> None:
        """One record."""
        bodies = self.recording.body[index, :, :3].tolist()
        in_play = self.story.in_play[self.story.decision[index]]
        self.remarks.draw_below(overlay, index)
        self.moments.draw_below(overlay, index, bodies)
        self.draw_bodies(overlay, index, bodies, in_play)
        self.moments.draw_above(overlay, index, bodies[len(self.players)])
        self.remarks.draw_above(overlay, index, bodies)
        draw_arms(overlay, self.view, self.recording, index)
