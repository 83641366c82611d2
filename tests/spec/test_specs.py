"""Scenarios, robots, sensors and fields: defaults that hold, bounds that keep a run whole."""

from typing import Any

import numpy as np
import pytest
from pydantic import BaseModel, ValidationError

from soccersim import load_scenario
from soccersim.bundled import names
from soccersim.spec.annotations import alternatives, is_model
from soccersim.spec.control import Control, Pid
from soccersim.spec.field import Field
from soccersim.spec.motor import Motor, PwmTable, table_speeds
from soccersim.spec.robot import FASTEST, Build, Grip, Robot, Wheels
from soccersim.spec.scenario import Scenario, Timing

WHEELS: dict[str, Any] = {"azimuth_deg": (0, 120, 240), "distance": 0.2, "radius": 0.05}
DRIVE = {"drive": {**WHEELS, "encoder": {}}, "odometry": {"heading": "wheels"}}


def wrong(model: type[BaseModel], **values: Any) -> str:
    """What is said about these values, each fault with its place."""
    with pytest.raises(ValidationError) as caught:
        model.model_validate(values)
    said = []
    for error in caught.value.errors():
        fault = error.get("ctx", {}).get("error")
        faults = getattr(fault, "faults", ())
        said += [f"{'.'.join(map(str, f.at))}: {f}" for f in faults] or [error["msg"]]
    return "; ".join(said)


def every_model(kind: Any, found: list[type[BaseModel]]) -> list[type[BaseModel]]:
    for each in alternatives(kind):
        if is_model(each) and each not in found:
            found.append(each)
            for field in each.model_fields.values():
                every_model(field.annotation, found)
        for argument in getattr(each, "__args__", ()):
            every_model(argument, found)
    return found


@pytest.mark.parametrize("model", every_model(Scenario, []), ids=lambda m: m.__name__)
def test_every_model_is_frozen_strict_and_explains_itself(model):
    assert model.model_config["frozen"]
    assert model.model_config["extra"] == "forbid"
    assert model.model_config["strict"]
    assert model.__doc__


@pytest.mark.parametrize("model", every_model(Scenario, []), ids=lambda m: m.__name__)
def test_defaults_are_valid_where_all_keys_have_one(model):
    given = {k: f.get_default() for k, f in model.model_fields.items() if not f.is_required()}
    required = [key for key, field in model.model_fields.items() if field.is_required()]
    if not required:
        assert model.model_validate(given) == model()


def test_a_robot_in_the_fewest_words():
    robot = Robot.model_validate(DRIVE)
    assert robot.yaw_inertia == pytest.approx(0.5 * robot.mass * robot.radius**2)
    assert robot.wheel_count == 3
    assert robot.odometry_wheels is robot.drive
    assert robot.control == Control()


def test_odometry_and_control_need_the_sensors_they_use():
    told = wrong(Robot, drive=WHEELS)
    assert "odometry.wheels: odometry counts on drive.encoder, and there is none: add it" in told
    assert "odometry.heading: there is no gyro: add `gyro: {}`, or write `wheels`" in told
    assert "control.wheel_loop: `pi` needs drive.encoder, and there is none" in told
    assert "there are no `dead` wheels: describe them, or write `drive`" in wrong(
        Robot, **{**DRIVE, "odometry": {"wheels": "dead", "heading": "wheels"}}
    )


def test_gains_are_all_or_nothing():
    assert "Field required" in wrong(Pid, kd=1.0)
    assert Pid(kp=1.0) == Pid(kp=1.0, ki=0.0, kd=0.0)


def test_a_motor_turns_no_rim_faster_than_a_tick_can_tell():
    drive = {**WHEELS, "motor": {"no_load_speed_rpm": FASTEST / 0.05 * 60 / 2 / np.pi + 1}}
    assert "motor.no_load_speed_rpm: turns the rim at 30 m/s: at most 30" in wrong(
        Robot, **{**DRIVE, "drive": drive}
    )


def test_a_pwm_table_may_have_a_dead_zone_but_never_falls():
    table = PwmTable(pwm=(0, 20, 255), rpm=((0, 0, 500),))
    speeds = table_speeds(Motor(pwm_table=table), 3) * 60 / (2 * np.pi)
    assert speeds.shape == (3, 256)
    assert speeds[:, 20] == pytest.approx(0)
    assert speeds[:, 255] == pytest.approx(500)
    assert Motor(pwm_table=table).top_speed_rpm == 530
    assert "pwm: must run from 0 to 255" in wrong(PwmTable, pwm=(0, 254), rpm=((0, 1),))
    for row in ((1, 2), (0, 0), (0, 5, 4)):
        pwm = (0, 255) if len(row) == 2 else (0, 9, 255)
        assert "rpm.0: must start with 0 and nowhere fall" in wrong(PwmTable, pwm=pwm, rpm=(row,))
    assert "rpm.0: needs 3 entries, one per PWM level" in wrong(
        PwmTable, pwm=(0, 9, 255), rpm=((0, 1),)
    )


def test_wheels_must_move_the_robot_in_all_three_ways():
    parallel = {**WHEELS, "direction_deg": (0, 0, 180)}
    assert "azimuth_deg: all wheels push along parallel lines (rank < 3)" in wrong(
        Wheels, **parallel
    )
    concurrent = {**WHEELS, "direction_deg": (0, 120, 240)}
    assert "rank < 3" in wrong(Wheels, **concurrent)
    assert "distance: needs 3 entries" in wrong(Wheels, **{**WHEELS, "distance": (0.1, 0.1)})
    assert "roller_deg: must lie within 80" in wrong(Wheels, **{**WHEELS, "roller_deg": 85.0})


def test_no_scatter_leaves_a_wheel_without_size():
    for key in ("radius_sd", "distance_sd", "motor_sd"):
        assert "less than or equal to 0.1" in wrong(Build, **{key: 0.2})
    assert "greater than or equal to -0.3" in wrong(Build, radius_bias=-0.5)


def test_a_spinning_wheel_holds_no_better_than_a_standing_one():
    assert "kinetic: must not exceed `static`" in wrong(Grip, static=0.4, kinetic=0.5)


def test_rates_divide():
    assert "record_hz: must divide physics_hz = 500: 10, 20" in wrong(Timing, record_hz=60)
    assert "frames_hz: must divide record_hz = 50: 10, 25, 50" in wrong(Timing, frames_hz=30)
    assert Timing(physics_hz=250).record_hz == 50


FIELD: dict[str, Any] = {"length": 9.0, "width": 6.0, "goal": {"width": 2.0}}


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"goal": {"width": 5.9}}, "goal.width: with its posts is wider than the field"),
        (
            {"goal": {"width": 2.0, "depth": 0.9}},
            "goal.depth: reaches into the board: at most 0.875",
        ),
        ({"penalty_area": {"depth": 5.0, "width": 3.0}}, "penalty_area: is larger than the field"),
        (
            {"penalty_mark": 5.0},
            "penalty_mark: must not exceed half the length of the field: 4.5 m",
        ),
        ({"centre_circle": 4.0}, "centre_circle: must not exceed half the width of the field: 3 m"),
    ],
)
def test_a_field_holds_its_own_lines(change, told):
    Field.model_validate(FIELD)
    assert told in wrong(Field, **{**FIELD, **change})


@pytest.mark.parametrize("name", names("robot"))
def test_a_robots_wheels_turn_it_the_way_its_base_says(name):
    robot = load_scenario("linear", settings=[f"robots.0.model={name}", "robots.0.open_loop=null"])
    wheels = robot.robots[0].model.drive
    assert wheels.base.wheels == len(wheels.azimuth_deg)
    assert np.linalg.matrix_rank(wheels.base.jacobian) == 3


def test_the_default_ball_is_a_football():
    ball = load_scenario("kickabout").ball
    assert (ball.mass, ball.radius, ball.shell) == (0.43, 0.11, pytest.approx(2 / 3))
