"""Idris' bench, simulated: a gyro on an arc, wheels off the floor, wheels rolled by hand.

Each experiment is a scenario that is run by the whole simulator; its text is the scenario as
JSON, for the processes that run the seeds.
"""

from collections.abc import Sequence
from math import pi

import numpy as np

from soccersim.repeat import recorded
from soccersim.spec.frame import Frame
from soccersim.spec.load import load_scenario
from soccersim.spec.player import Leg, Phase, Player
from soccersim.spec.scenario import Scenario
from soccersim.spec.sensors import Encoder
from soccersim.state import Array

WHEELS = ("right", "left", "back")  # the robot's order
PULSE_CM = 0.1164  # cm a pulse: pi 10.0 / 270 rounded, as Table 5's entries show
HOLD = 0.6  # s each PWM level is held: 12 time constants of motor and wheel
OFF_THE_FLOOR = 1e-9  # of the wheels' grip: nothing holds them
APART = 2.0  # m between the robots that are rolled side by side


def turned_along_the_arc(angles_deg: Sequence[float]) -> str:
    """The robot turned by hand from 0 through each angle in turn, its gyro summed all the while."""
    legs = [Leg(to=(0.0, 0.0, angle), turn="as_written") for angle in angles_deg]
    return _pushed("idris-gyro", [((0.0, 0.0, 0.0), legs)])


def rolled_along_a_ruler(distances_cm: Sequence[float]) -> str:
    """Three robots, one for each wheel, pushed so that this wheel rolls straight ahead.

    The wheels are as drawn: the table's entries tell their diameter to 0.1 %.
    """
    drive = load_scenario("idris-table6").robots[0].model.drive
    plans = []
    for i, direction in enumerate(drive.direction_deg or ()):
        y = 100.0 * APART * (i - 1)
        legs = [Leg(to=(distance, y, -direction)) for distance in distances_cm]
        plans.append(((0.0, y, -direction), legs))
    return _pushed("idris-mileage", plans, ("radius_sd=0", "distance_sd=0"))


def wheels_off_the_floor(levels: Sequence[float], linear: bool = False) -> str:
    """All motors at each PWM level in turn; linear: without the table, by the motor's line."""
    settings = [f"field.grip={OFF_THE_FLOOR}", "robots.0.model.drive.build.motor_sd=0"]
    if linear:
        settings.append("robots.0.model.drive.motor.pwm_table=null")
    scenario = load_scenario("idris-table7", settings=settings)
    phases = tuple(Phase(seconds=HOLD, pwm=(int(level),) * len(WHEELS)) for level in levels)
    player = scenario.robots[0].model_copy(update={"path": None, "open_loop": phases})
    return scenario.model_copy(update={"robots": (player,)}).model_dump_json()


def _pushed(
    name: str,
    plans: Sequence[tuple[tuple[float, float, float], Sequence[Leg]]],
    build: Sequence[str] = (),
) -> str:
    """Idris' robot once for every start and path, pushed by the hand of Table 6."""
    settings = [f"robots.0.model.drive.build.{setting}" for setting in build]
    scenario = load_scenario("idris-table6", settings=settings)
    players: list[Player] = [
        scenario.robots[0].model_copy(
            update={"name": f"{name}-{i}", "start": start, "path": tuple(legs)}
        )
        for i, (start, legs) in enumerate(plans)
    ]
    changes = {"name": name, "frame": Frame(), "robots": tuple(players)}
    return scenario.model_copy(update=changes).model_dump_json()


def motor_speeds(text: str, seed: int) -> Array:
    """(2, levels, wheels) rpm: the true speeds, and the encoders' of the last 100 ms."""
    recording = recorded(text, seed)
    scenario = recording.scenario
    hz, encoder = scenario.timing.record_hz, _encoder(scenario)
    held = round(HOLD * hz)
    ends = np.arange(held, held * len(scenario.robots[0].open_loop or ()) + 1, held) - 1
    true = recording.arrays["wheel_speed"][ends, 0] * 30 / pi
    counts = recording.arrays["counts"][:, 0]
    pulses = counts[ends] - counts[ends - round(encoder.window * hz)]
    return np.array([true, pulses * 60 / (encoder.window * encoder.edges_per_turn)])


def mileages(text: str, seed: int) -> Array:
    """(distances, wheels) cm that the pulses of the wheels amount to."""
    recording = recorded(text, seed)
    scenario = recording.scenario
    every = scenario.every(scenario.timing.record_hz)
    counts = recording.arrays["counts"]
    wheels = [
        [counts[leg["end_tick"] // every - 1, i, i] for leg in legs]
        for i, legs in enumerate(recording.legs)
    ]
    return PULSE_CM * np.array(wheels, dtype=float).T


def _encoder(scenario: Scenario) -> Encoder:
    encoder = scenario.robots[0].model.drive.encoder
    if encoder is None:
        raise ValueError(f"{scenario.name}: the driven wheels have no encoders")
    return encoder
