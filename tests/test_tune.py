"""Tuning a robot: its loops oscillate where theory says, and what is recommended is calm."""

from dataclasses import replace
from math import atan, pi, sqrt

import numpy as np
import pytest
import yaml
from factory import NO_SLIP, bundled, player, robot, scenario

from soccersim.control.tuning import Ultimate
from soccersim.spec.control import Control, Pid
from soccersim.spec.load import load_scenario
from soccersim.tune import document, tune
from soccersim.tune.findings import pictures
from soccersim.tune.rig import AxisLoop, WheelLoop
from soccersim.tune.session import experiment

NAMES = {"utama": ["x", "y", "heading"]} | {
    name: ["x", "y", "heading", "wheel"] for name in ("idris", "msl")
}


def loop(name, model, **more):
    """A loop of a robot alone on a wide field."""
    written = scenario(player(model), **more)
    kind = WheelLoop if name == "wheel" else AxisLoop
    names = () if name == "wheel" else (name,)
    return kind(written, written.robots[0], written.robots[0].model, *names)


@pytest.fixture(scope="module", params=sorted(NAMES))
def tuned(request):
    written = scenario(player(bundled(request.param)), seed=3)
    return request.param, tune(written, written.robots[0])


# the experiments


def crossing(lag, delay):
    """Where 1 / (s (lag s + 1)) with a delay has a phase of -180 degrees: gain, period."""
    low, high = 0.1, 500.0
    for _ in range(60):
        omega = sqrt(low * high)
        late = atan(lag * omega) + omega * delay > pi / 2
        low, high = (low, omega) if late else (omega, high)
    return Ultimate(low * sqrt(1 + (lag * low) ** 2), 2 * pi / low)


@pytest.mark.parametrize("axis", ["x", "y", "heading"])
def test_a_frictionless_robot_oscillates_where_its_motors_and_its_sampling_say(axis):
    motor = {"friction_torque": 0.0}
    drive = {"grip": NO_SLIP, "motor": motor}
    model = robot(drive=drive, control={"wheel_loop": "table"})
    share = model.yaw_inertia / 0.19**2 if axis == "heading" else 2 * model.mass
    inertia = model.drive.motor.inertia + share / 3 * 0.05**2  # that a wheel feels
    lag = inertia * model.drive.motor.no_load_speed_rpm * 2 * pi / 60 / 4.0  # stall torque
    delay = 0.005 + 0.001  # half a control step held, half a tick moved with the old velocity
    expected, found = crossing(lag, delay), experiment(loop(axis, model))
    assert found.swept.gain == pytest.approx(expected.gain, rel=0.04)
    assert found.swept.period == pytest.approx(expected.period, rel=0.04)
    assert found.relay.gain == pytest.approx(expected.gain, rel=0.1)
    assert found.relay.period == pytest.approx(expected.period, rel=0.05)


def test_a_wheel_whose_encoder_counts_longer_oscillates_slower():
    swept = [
        experiment(loop("wheel", robot(drive={"encoder": {"window": window}}))).ultimate
        for window in (0.02, 0.1, 0.2)
    ]
    assert swept[0].gain > swept[1].gain > swept[2].gain
    assert swept[0].period < swept[1].period < swept[2].period


def test_relay_and_sweep_agree_or_it_is_said(tuned):
    name, tuning = tuned
    notes = [note for note in document(tuning)["notes"] if "off the sweep's" in note]
    for result in tuning.loops:
        tried, said = result.experiment, any(n.startswith(result.loop.name) for n in notes)
        assert said != (0.8 < tried.relay.gain / tried.swept.gain < 1.25)
        assert tried.ultimate.gain <= 1.25 * min(tried.relay.gain, tried.swept.gain)
        assert not said or (name == "idris" and result.loop.unit == "m")  # 1.2 mm a pulse


def test_the_relay_stays_in_the_linear_range(tuned):
    for result in tuned[1].loops:
        assert result.experiment.grip < 0.85
        assert len(result.experiment.points) >= 2


def test_below_the_ultimate_gain_a_swing_dies_above_it_grows(tuned):
    for result in tuned[1].loops:
        (low, dying), _, (high, growing) = result.experiment.shown
        swings = [np.ptp(a.value[-len(a.value) // 4 :]) for a in (dying, growing)]
        coarse = tuned[0] == "idris" and result.loop.unit == "m"  # 1.2 mm a pulse: it hunts
        assert low < result.experiment.swept.gain < high
        assert coarse or swings[0] < swings[1]


@pytest.mark.parametrize("axis", ["x", "heading", "wheel"])
def test_what_a_rig_looks_ahead_to_is_what_the_robot_then_measures(axis):
    rig = loop(axis, bundled("idris")).rig()
    for push in (0.1, 0.1, -0.1, 0.05):
        rig(push)
        readings, estimate, machine = rig.readings, rig.estimate, rig.sim.machine
        rig.push(rig.sim, estimate, push)
        rig.sim.advance(rig.sim.scenario.every(100))  # in whose first tick the robot itself reads
        assert np.array_equal(readings.wheel_speed, machine.readings.wheel_speed)
        assert np.array_equal(estimate.pose, machine.estimate.pose)
        assert machine.truth.wheel_speed.any()


def test_a_loop_without_answer_keeps_its_gains(monkeypatch):
    monkeypatch.setattr("soccersim.tune.session.oscillation", lambda trace: None)
    written = scenario(player(bundled("utama")))
    found = document(tune(written, written.robots[0]))
    for entry in found["loops"]:
        assert entry["ultimate"] is None
        assert entry["rules"] == []
        assert entry["keep_present"]
        assert "could not be brought to oscillate" in entry["why"]
    assert any("no ultimate gain" in note for note in found["notes"])


# what comes of it


def test_what_is_recommended_does_not_oscillate(tuned):
    name, tuning = tuned
    assert [result.loop.name for result in tuning.loops] == NAMES[name]
    for result in tuning.loops:
        assert result.chosen.measures.sound, f"{name} {result.loop.name}"


def test_recommended_gains_are_calm_in_a_long_move_too(tuned):
    for result in tuned[1].loops:
        if result.loop.name != "wheel":
            answer = result.loop.answer(result.chosen.gains, 2 * result.loop.step, 12.0)
            rest = answer.value[-200:]
            assert np.ptp(rest) < 0.02 * result.loop.step


def test_a_rule_is_taken_only_where_it_is_better(tuned):
    for result in tuned[1].loops:
        if not result.keep:
            now, new = result.present.measures, result.best.measures
            assert new.iae < now.iae or not now.sound


def test_the_yaml_is_a_control_block(tuned):
    found = document(tuned[1])
    written = yaml.safe_load(found["yaml"])
    control = Control.model_validate(written["control"])
    for entry in found["loops"]:
        gains = getattr(control, entry["loop"])
        assert (gains.kp, gains.ki) == (entry["recommended"]["kp"], entry["recommended"]["ki"])


def test_a_robot_driven_by_its_pwm_table_has_no_wheel_loop(tuned):
    name, tuning = tuned
    notes = " ".join(document(tuning)["notes"])
    assert ("no wheel loop" in notes) == (name == "utama")


def test_answers_of_every_rule_stand_beside_the_present_ones(tuned):
    for entry in document(tuned[1])["loops"]:
        kinds = 2 if entry["loop"] == "wheel" else 3
        assert len(entry["rules"]) == 4 * kinds
        assert entry["present"]["rule"] == "present"
        for row in (entry["present"], *entry["rules"]):
            assert row["iae"] > 0
            assert row["overshoot"] >= 0


def test_pictures_hold_every_curve(tuned):
    for drawn, result in zip(pictures(tuned[1]), tuned[1].loops, strict=True):
        assert len(drawn.trials) == 3
        assert len(drawn.steps) == len(result.candidates) + 2


def test_same_seed_same_gains_another_seed_other_sensors():
    first, again, other = (document_of(load_scenario("defender", seed=seed)) for seed in (5, 5, 6))
    assert first == again
    assert first["loops"][0]["relay"] != other["loops"][0]["relay"]


def document_of(written):
    found = document(tune(written, written.robots[0]))
    del found["seed"]
    return found


def test_limits_bind_the_answers_but_not_the_experiment():
    free, bound = (
        loop("x", robot(control={"limits": {"acceleration": a, "turn_acceleration": 5.0}}))
        for a in (3.0, 0.3)
    )
    gains = Pid(kp=3.0)
    steps = [one.answer(gains, 0.5, 3.0).value for one in (free, bound)]
    rings = [one.answer(gains, 0.01, 3.0, raised=True).value for one in (free, bound)]
    assert steps[1][50] < 0.5 * steps[0][50]
    assert np.array_equal(*rings)


def test_the_wheels_turn_on_the_spot_before_their_step():
    wheels = loop("wheel", bundled("msl"))
    answer = wheels.answer(wheels.present, wheels.step, 2.0)
    assert abs(answer.value[0]) < 0.1 * wheels.step
    assert answer.value[-1] == pytest.approx(wheels.step, rel=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["four-wheel", "garcia", "idris", "msl", "utama"])
def test_every_bundled_robot_stays_calm_over_seeds(name):
    for seed in range(4):
        written = scenario(player(bundled(name)), seed=seed)
        for result in tune(written, written.robots[0]).loops:
            chosen = result.chosen.measures
            assert chosen.ripple < 0.02
            assert result.experiment.ultimate is not None
            assert replace(chosen, overshoot=0.0).sound, f"{seed} {result.loop.name}"
