"""All that robots and teams know, and with what they came to know it, as arrays."""

from typing import NamedTuple

import numpy as np

from soccersim.estimation.ball_track import BallTracks, build_ball_tracks, put_down
from soccersim.estimation.localisation import Localisation, build_localisation
from soccersim.estimation.opponents import Opponents, build_opponents
from soccersim.sensing.camera import Camera, Draws, Frames, build_camera, new_frames
from soccersim.spec.robot import GRAVITY
from soccersim.spec.scenario import Scenario
from soccersim.state import Array, Whole


class Reports(NamedTuple):
    """The last report of each robot that reached its team."""

    pose: Array  # (R, 3) believed; field frame
    twist: Array  # (R, 3) body frame
    contact: Whole  # (R,) 1: the ball was in its mouth
    tick: Whole  # (R,) of which it tells


class Eyes(NamedTuple):
    """What robots look with, and what they make of it on board."""

    camera: Camera
    draws: Draws
    frames: Frames
    localisation: Localisation
    done: Whole  # (2,) frames the robots have worked on, frames the teams have heard of
    lag: Whole  # (2,) ticks from a frame to each of these
    scale: float  # relative error of distances that is reckoned with, standard deviation
    sights: Array  # (R, 6) room for one robot's sightings


class Known(NamedTuple):
    """What the two teams know: HOME is slot 0, AWAY slot 1."""

    team: Whole  # (R,) slot
    number: Whole  # (R,) on its back
    keeper: Whole  # (R,) 1: the keeper
    playing: Whole  # (R,) 1: on the field
    direction: Array  # (2,) +1: attacks +x; -1: attacks -x
    walls: Array  # (2,) m: no ball lies farther from the centre in x, in y
    reports: Reports
    balls: BallTracks
    opponents: Opponents


def build_eyes(scenario: Scenario, draws: Draws) -> Eyes:
    """Everybody sure of where it stands, no frame taken."""
    senses, hz, count = scenario.senses, scenario.timing.physics_hz, len(scenario.robots)
    camera = build_camera(senses, count, hz, scenario.seed)
    seen = round(senses.camera.delay * hz)
    heard = seen + round(senses.radio.delay * hz)
    return Eyes(
        camera=camera,
        draws=draws,
        frames=new_frames(heard // camera.every + 2, count),
        localisation=build_localisation(senses, count),
        done=np.zeros(2, np.int64),
        lag=np.array([seen, heard], np.int64),
        scale=senses.camera.scale_sd,
        sights=np.zeros((count, 6)),
    )


def build_known(scenario: Scenario) -> Known:
    """At the start: robots and ball are where the scenario puts them, and their teams know it."""
    players, at, field, ball = scenario.robots, scenario.coordinates, scenario.field, scenario.ball
    if ball is None:
        raise ValueError(f"{scenario.name} has no ball to look for")
    count = len(players)
    team = np.array([int(player.team == "away") for player in players], np.int64)
    starts = np.array([at.field_pose(player.start) for player in players], float)
    friction = max(GRAVITY * field.ball_friction, 1e-6)
    balls = build_ball_tracks(field.ball_rolling, friction, ball.shell, scenario.dt)
    put_down(balls, *at.field_pose((*ball.at, 0.0))[:2], -1)
    return Known(
        team=team,
        number=np.array([player.number for player in players], np.int64),
        keeper=np.array([player.keeper for player in players], np.int64),
        playing=np.ones(count, np.int64),
        direction=np.array([1.0, -1.0]),
        walls=np.array([field.half_length, field.half_width]) + field.border - ball.radius,
        reports=Reports(
            starts.reshape(count, 3),
            np.zeros((count, 3)),
            np.zeros(count, np.int64),
            np.zeros(count, np.int64),
        ),
        balls=balls,
        opponents=build_opponents((int(np.sum(team == 1)), int(np.sum(team == 0))), scenario.dt),
    )
