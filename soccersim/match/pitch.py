"""The field and the rules' figures as a team is told them."""

from soccersim.spec.field import Area
from soccersim.spec.robot import GRAVITY
from soccersim.spec.scenario import Scenario
from soccersim.strategy import api


def team_rows(scenario: Scenario, slot: int) -> list[int]:
    """The rows of a slot's robots, HOME 0 or AWAY 1."""
    team = ("home", "away")[slot]
    return [row for row, player in enumerate(scenario.robots) if player.team == team]


def pitch_of(scenario: Scenario, slot: int) -> api.Pitch:
    """What a team's View has as its field."""
    field, ball, match = scenario.field, scenario.ball, scenario.match
    if ball is None or match is None:
        raise ValueError(f"{scenario.name} is no match")
    rules = match.rules
    return api.Pitch(
        length=field.length,
        width=field.width,
        border=field.border,
        goal_width=field.goal.width,
        goal_depth=field.goal.depth,
        penalty_area=_area(field.penalty_area),
        goal_area=_area(field.goal_area),
        penalty_mark=field.penalty_mark,
        centre_circle=field.centre_circle,
        ball_radius=ball.radius,
        ball_sliding=field.ball_friction * GRAVITY,
        ball_rolling=field.ball_rolling,
        rules=api.Rules(**{name: getattr(rules, name) for name in api.Rules.__slots__}),
        bodies=tuple(_body(scenario, row) for row in team_rows(scenario, slot)),
    )


def _area(area: Area | None) -> api.Area | None:
    return api.Area(area.depth, area.width) if area else None


def _body(scenario: Scenario, row: int) -> api.Body:
    model = scenario.robots[row].model
    limits = model.control.limits
    return api.Body(
        radius=model.radius,
        speed=limits.speed,
        acceleration=limits.acceleration or api.Body().acceleration,
        turn_rate=limits.turn_rate,
        turn_acceleration=limits.turn_acceleration or api.Body().turn_acceleration,
        kick_speed=model.kicker.speed if model.kicker else 0.0,
        has_dribbler=model.dribbler is not None,
    )
