"""What a browser is told first: the stage for the drawing, names, and what may be done."""

from typing import Any

from soccersim.live.catalogue import Catalogue
from soccersim.live.messages import SPEEDS
from soccersim.live.play import Play
from soccersim.render import likeness
from soccersim.render.page import document
from soccersim.sheet import PHASES
from soccersim.spec.robot import Robot


def hello(play: Play, layout: dict[str, Any], catalogue: Catalogue) -> dict[str, Any]:
    """All that does not change while it runs, as JSON."""
    scenario = play.scenario
    models = [player.model for player in scenario.robots]
    kinds = [model for i, model in enumerate(models) if models.index(model) == i]
    match = scenario.match
    return {
        "type": "hello",
        "layout": layout,
        "scenario": scenario.name,
        "about": scenario.about,
        "seed": scenario.seed,
        "hz": play.hz,
        "control": max([1, *(play.hz // model.control.rate_hz for model in models)]),
        "field": document.field(scenario.field),
        "look": document.palette(),
        "models": [_model(kind) for kind in kinds],
        "robots": [
            {
                "name": player.name,
                "number": player.number,
                "team": int(player.team == "away"),
                "keeper": player.keeper,
                "model": kinds.index(player.model),
                "start": scenario.coordinates.field_pose(player.start),
                "targets": [scenario.coordinates.field_pose(leg.to) for leg in player.path or ()],
                "repeat": player.repeat,
                "kick": player.model.kicker.speed if player.model.kicker else 0,
                "dribbler": player.model.dribbler is not None,
                "driven": len(player.model.drive.azimuth_deg),
                "wheels": player.model.wheel_count,
                "encoders": [
                    bool(wheels and wheels.encoder)
                    for wheels in (player.model.drive, player.model.dead)
                ],
            }
            for player in scenario.robots
        ],
        "ball": scenario.ball.radius if scenario.ball else None,
        "arms": [{"lengths": arm.lengths, "thickness": arm.thickness} for arm in scenario.arms],
        "match": [match.home.strategy, match.away.strategy] if match else None,
        "phases": PHASES,
        "speeds": SPEEDS,
        "scenarios": catalogue.scenarios,
        "teams": catalogue.teams,
        "opened": catalogue.current.scenario,
    }


def _model(model: Robot) -> dict[str, Any]:
    """A kind of robot as it is drawn."""
    wheels = [[round(float(number), 4) for number in mark] for mark in likeness.wheel_marks(model)]
    return {"radius": model.radius, "wheels": wheels}
