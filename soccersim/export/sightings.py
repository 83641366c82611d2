"""Where the robots' cameras put the ball: a dot for each sighting, gone after a second."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from soccersim.export.frames import MAP, stamp
from soccersim.export.primitives import ball, entity, scene
from soccersim.record.recording import Recording
from soccersim.render import look

LASTS = {"sec": 1, "nsec": 0}
SMALL = 0.5  # diameter of a dot beside that of the ball


def sightings(recording: Recording, first: int) -> Iterator[tuple[int, str, Any]]:
    """Tick, topic and content at each decision from a tick on at which a sighting came."""
    seen, hz = recording.arrays.get("ball_sighted"), int(recording.meta["physics_hz"])
    if seen is None or recording.ball is None:
        return
    radius = recording.scenario.ball.radius  # type: ignore[union-attr]
    colours = [look.tint(player.team) for player in recording.scenario.robots]
    came = np.isfinite(seen[..., 0])
    ticks = recording.arrays["decision_tick"]
    for decision in np.flatnonzero(came.any(axis=1) & (ticks >= first)).tolist():
        robots = np.flatnonzero(came[decision]).tolist()
        dots = [
            ball(seen[decision, robot], radius, 2 * SMALL * radius, colours[robot])
            for robot in robots
        ]
        tick = int(ticks[decision])
        # each has a name of its own, so that it does not take the place of one before
        shown = entity(str(decision), MAP, stamp(tick, hz), LASTS, spheres=dots)
        yield tick, "/sightings", scene([shown])
