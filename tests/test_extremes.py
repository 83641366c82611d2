"""Whatever the format allows is simulated: finite to the end, or refused in one line."""

import json
import math
from contextlib import suppress
from functools import cache, reduce
from operator import getitem

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from soccersim import Simulation, load_scenario
from soccersim.problems import RunError
from soccersim.report import report
from soccersim.spec.scenario import Scenario


def touching(*changes):
    """Two MSL robots that drive into each other with the ball between, with settings."""
    words = [
        "duration=0.6",
        "ball={at: [0, 0.3]}",
        "robots.0.start=[-0.25, 0, 0]",
        "robots.1.start=[0.25, 0, 180]",
        "robots.0.path.0.to=[1, 0, 0]",
        "robots.1.path.0.to=[-1, 0, 180]",
    ]
    robots = load_scenario("kickabout").model_dump(mode="json")["robots"][:2]
    words.insert(0, f"robots={json.dumps(robots)}")
    return load_scenario("kickabout", settings=[*words, *changes])


EXTREMES = {
    "a robot of ten grams": ["robots.0.model.mass=0.01"],
    "a robot of a ton": ["robots.0.model.mass=1000"],
    "hardly any inertia": ["robots.0.model.inertia=1e-9"],
    "wheels of a millimetre": ["robots.0.model.drive.radius=0.001"],
    "wheels of a metre": [
        "robots.0.model.drive.radius=1",
        "robots.0.model.drive.motor.no_load_speed_rpm=280",
    ],
    "wheels without inertia": [
        "robots.0.model.drive.motor.wheel_inertia=1e-9",
        "robots.0.model.drive.motor.rotor_inertia=0",
    ],
    "the strongest motors": [
        "robots.0.model.drive.motor.stall_torque=1e6",
        "robots.0.model.drive.motor.torque_limit=null",
        "robots.0.model.drive.grip={static: 1e6, kinetic: 1e6}",
    ],
    "rims at 30 m/s": [
        "robots.0.model.drive.motor.no_load_speed_rpm=4990",
        "robots.0.model.drive.grip={static: 100, kinetic: 100}",
        "robots.0.model.control.limits={speed: 1e6, turn_rate: 1e6}",
    ],
    "ice": ["field.grip=1e-9"],
    "gains of a million": [
        "robots.0.model.control.x={kp: 1e6, ki: 1e6, kd: 1e6}",
        "robots.0.model.control.heading={kp: 1e6, ki: 1e6, kd: 1e6}",
        "robots.0.model.control.wheel={kp: 1e6, ki: 1e6}",
    ],
    "a million pulses": [
        "robots.0.model.drive.encoder={pulses_per_turn: 1000000, decoding: 4, missed: 0.5}"
    ],
    "one pulse, always missed": [
        "robots.0.model.drive.encoder={pulses_per_turn: 1, missed: 1, window: 1}"
    ],
    "a mad gyro": ["robots.0.model.gyro={bias_deg_s: 999, noise_deg_s_rthz: 1e6, scale_sd: 1}"],
    "the coarsest physics": [
        "timing={physics_hz: 100, record_hz: 50}",
        "robots.0.model.control.rate_hz=100",
    ],
    "the finest physics": ["timing={physics_hz: 10000, record_hz: 10000, frames_hz: 25}"],
    "a ball like a feather": ["ball.mass=0.001", "ball.shell=0.01"],
    "a ball like a rock": ["ball.mass=100", "ball.velocity=[0, -30]"],
    "the fastest ball against a feather": [
        "ball.velocity=[0, -30]",
        "robots.0.model.mass=0.01",
        "robots.1.model.mass=0.01",
    ],
    "a board that gives all back": ["field.board_elasticity=1", "field.goal.post_elasticity=1"],
}


@pytest.mark.parametrize("name", EXTREMES)
def test_a_run_at_the_edge_of_the_format_stays_finite(name):
    scenario = touching(*EXTREMES[name])
    recording = Simulation(scenario).run()
    assert recording.duration == pytest.approx(0.6, abs=0.01)
    for key, array in recording.arrays.items():
        assert np.isfinite(array).all(), key
    reach = scenario.field.half_length + scenario.field.border
    assert np.abs(recording.body[:, :, :2]).max() < reach
    json.dumps(report(recording), allow_nan=False)


@cache
def leaves():
    """A small scenario with everything in it, and the paths of its numbers."""
    words = ["duration=0.2", "timing={physics_hz: 500}", "field.border=2"]
    text = load_scenario("one-of-everything", settings=words).model_dump_json()
    paths = []

    def walk(value, path):
        items = value.items() if isinstance(value, dict) else enumerate(value)
        for key, entry in items:
            if isinstance(entry, dict | list):
                walk(entry, (*path, key))
            elif isinstance(entry, int | float) and not isinstance(entry, bool):
                paths.append((*path, key))

    walk(json.loads(text), ())
    kept = ("duration", "timing", "version", "seed")
    return text, [path for path in paths if path[0] not in kept]


def put(value, path, new):
    """Put a number at a path."""
    for step in path[:-1]:
        value = value[step]
    value[path[-1]] = new


def test_every_number_has_its_bounds():
    text, paths = leaves()
    for path in paths:
        for huge in (1e300, -1e300, 2**62, -(2**62)):
            value = json.loads(text)
            put(value, path, huge)
            with pytest.raises(ValidationError):
                Scenario.model_validate_json(json.dumps(value))


@settings(max_examples=60)
@given(data=st.data())
def test_a_run_of_any_valid_numbers_is_finite_or_ends_in_one_line(data):
    text, paths = leaves()
    value = json.loads(text)
    for path in data.draw(st.lists(st.sampled_from(paths), min_size=1, max_size=6, unique=True)):
        old = reduce(getitem, path, value)
        factor = 10 ** data.draw(st.floats(-9, 9))
        new = (old or 1) * factor * data.draw(st.sampled_from([1, 1, 1, -1]))
        put(value, path, math.ceil(new) if isinstance(old, int) else new)
    with suppress(ValidationError, RunError):
        recording = Simulation(Scenario.model_validate_json(json.dumps(value))).run()
        json.dumps(report(recording), allow_nan=False)
