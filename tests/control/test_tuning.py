"""Rules of tuning by the book, and ultimate points of plants whose ultimate points are known."""

from collections import deque
from math import exp, pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim.control.tuning import (
    CONTROLLERS,
    RULES,
    Measures,
    Option,
    Oscillation,
    Trace,
    Ultimate,
    better,
    gentlest,
    growth,
    measure_step,
    oscillation,
    period_of,
    relay_test,
    sweep_gain,
    ultimate_of,
)


def gains(rule, controller, gain, period):
    pid = RULES[rule][controller].gains(Ultimate(gain, period))
    return pid.kp, pid.ki, pid.kd


# rules


def test_ziegler_and_nichols_as_they_print_it():
    assert gains("ziegler-nichols", "P", 10.0, 2.0) == (5.0, 0.0, 0.0)
    assert gains("ziegler-nichols", "PI", 10.0, 2.0) == (4.5, 2.7, 0.0)  # Ti = Tu / 1.2
    assert gains("ziegler-nichols", "PID", 10.0, 2.0) == (6.0, 6.0, 1.5)  # Ti = Tu/2, Td = Tu/8


def test_tyreus_and_luyben_as_they_print_it():
    assert gains("tyreus-luyben", "PI", 3.2, 1.0) == (1.0, 0.455, 0.0)  # Ku / 3.2, 2.2 Tu
    assert gains("tyreus-luyben", "PID", 2.2, 6.3) == (1.0, 0.0722, 1.0)  # Ku / 2.2, Tu / 6.3


def test_some_and_no_overshoot_as_seborg_prints_them():
    assert gains("some-overshoot", "PID", 100.0, 0.6) == (33.0, 110.0, 6.6)
    assert gains("no-overshoot", "PID", 100.0, 0.6) == (20.0, 66.7, 4.0)


def test_what_a_rule_does_not_print_is_marked():
    printed = {rule: [c for c in CONTROLLERS if RULES[rule][c].printed] for rule in RULES}
    assert printed == {
        "ziegler-nichols": ["P", "PI", "PID"],
        "tyreus-luyben": ["PI", "PID"],
        "some-overshoot": ["PID"],
        "no-overshoot": ["PID"],
    }


@given(
    gain=st.floats(0.1, 1000),
    period=st.floats(0.02, 10),
    controller=st.sampled_from(CONTROLLERS),
    rule=st.sampled_from(sorted(set(RULES) - {"ziegler-nichols"})),
)
def test_the_gentler_rules_are_gentler(gain, period, controller, rule):
    soft, classic = (gains(r, controller, gain, period) for r in (rule, "ziegler-nichols"))
    assert 0 < soft[0] < classic[0]
    assert soft[1] <= classic[1]


# a relay on plants whose ultimate point is known


def integrator(gain, delay, dt):
    """y' = gain u(t - delay): Ku = pi / (2 gain delay), Tu = 4 delay."""
    waiting, y = deque([0.0] * round(delay / dt)), 0.0

    def plant(push):
        nonlocal y
        waiting.append(push)
        y += gain * waiting.popleft() * dt
        return y

    return plant


def lags(orders, dt, delay=0.0):
    """1 / (s + 1)^orders: for three Ku = 8, Tu = 2 pi / sqrt 3."""
    state, waiting = [0.0] * orders, deque([0.0] * round(delay / dt))
    keep = exp(-dt / 10)

    def plant(push):
        waiting.append(push)
        push = waiting.popleft()
        for _ in range(10):  # ten small steps: the lags follow each other closely
            before = push
            for k in range(orders):
                state[k] = before + (state[k] - before) * keep
                before = state[k]
        return state[-1]

    return plant


def relay(plant, dt, hysteresis=0.0, amplitude=1.0):
    return oscillation(Trace(dt, *relay_test(plant, amplitude, hysteresis)))


def test_relay_on_an_integrator_with_delay():
    point = relay(integrator(2.0, 0.5, 0.002), 0.002)
    assert point.gain == pytest.approx(pi / (2 * 2.0 * 0.5), rel=0.02)
    assert point.period == pytest.approx(4 * 0.5, rel=0.01)
    assert point.phase_deg == pytest.approx(-180, abs=1.5)
    # the usual 4 d / (pi a) takes the triangle for a sine and is off by 19 %
    assert 4 / (pi * point.swing) == pytest.approx(0.81 * pi / 2, rel=0.02)


@pytest.mark.parametrize("amplitude", [0.01, 1.0, 300.0])
def test_relay_on_three_lags_whatever_its_push(amplitude):
    point = relay(lags(3, 0.01), 0.01, amplitude=amplitude)
    assert point.gain == pytest.approx(8.0, rel=0.03)
    assert point.period == pytest.approx(2 * pi / sqrt(3), rel=0.02)


def test_hysteresis_moves_the_point_and_two_points_lead_back():
    bare = relay(lags(3, 0.01), 0.01)
    held = [relay(lags(3, 0.01), 0.01, share * bare.swing) for share in (0.15, 0.4)]
    assert bare.gain > held[0].gain > held[1].gain
    assert bare.phase_deg < held[0].phase_deg < held[1].phase_deg
    found = ultimate_of(held)
    assert found.gain == pytest.approx(8.0, rel=0.1)
    assert abs(found.gain - 8.0) < abs(held[0].gain - 8.0)


def test_points_on_both_sides_are_joined():
    sides = [Oscillation(4.0, 1.0, -170.0, 1.0), Oscillation(9.0, 0.5, -190.0, 1.0)]
    assert ultimate_of(sides).gain == pytest.approx(6.0)
    assert ultimate_of(sides).period == pytest.approx(sqrt(0.5))
    near = Oscillation(5.0, 0.7, -179.0, 1.0)
    assert ultimate_of([*sides, near]) == Ultimate(5.0, 0.7)


def test_a_plant_that_does_not_answer_does_not_oscillate():
    pushes, answers = relay_test(lambda push: 0.0, 1.0, patience=500)
    assert len(pushes) == 500
    assert set(pushes) == {1.0}
    assert oscillation(Trace(0.01, pushes, answers)) is None


# a sweep of the gain


def ring(plant, gain, steps, step=1.0):
    """Proportional control after a step of the set-point."""
    answer, answers = 0.0, []
    for _ in range(steps):
        answers.append(answer)
        answer = plant(gain * (step - answer))
    return np.array(answers)


def test_sweep_closes_in_on_the_ultimate_gain_of_three_lags():
    dt, period = 0.01, 2 * pi / sqrt(3)

    def trial(gain):
        return growth(ring(lags(3, dt), gain, round(10.5 * period / dt)), period / dt, 1.0)

    sweep = sweep_gain(trial, 3.0)
    assert sweep.gain == pytest.approx(8.0, rel=0.02)
    last = ring(lags(3, dt), sweep.low, round(10.5 * period / dt))
    assert period_of(last, 1.4 * period / dt) * dt == pytest.approx(period, rel=0.02)


def test_sweep_says_so_where_nothing_grows():
    sweep = sweep_gain(lambda gain: 0.9, 1.0, most=5)
    assert sweep.gain is None
    assert [gain for gain, _ in sweep.trials] == sorted(gain for gain, _ in sweep.trials)
    assert len(sweep.trials) == 5


@pytest.mark.parametrize("factor", [0.8, 0.95, 1.0, 1.05])
def test_growth_is_the_factor_from_period_to_period(factor):
    t = np.arange(1050) / 100
    assert growth(factor**t * np.cos(2 * pi * t), 100, 1.0) == pytest.approx(factor, rel=0.02)


def test_a_swing_that_stays_small_has_not_grown():
    hunting = 0.1 * np.sign(np.sin(np.arange(1050) / 20))
    assert growth(hunting, 100, 1.0) < 0.85
    assert growth(50 * hunting, 100, 1.0) > 1.05


# measures of a step response

T = np.linspace(0, 40, 40_001)


@pytest.mark.parametrize("tau", [0.5, 2.0])
def test_measures_of_a_first_order_lag(tau):
    m = measure_step(T, 3.0 * (1 - np.exp(-T / tau)), 3.0)
    assert m.rise_time == pytest.approx(tau * np.log(9), rel=1e-3)
    assert m.settling_time == pytest.approx(tau * np.log(50), rel=1e-3)
    assert m.iae == pytest.approx(3.0 * tau, rel=1e-3)
    assert m.overshoot == 0.0
    assert m.sound


@pytest.mark.parametrize("damping", [0.2, 0.5, 0.7])
def test_overshoot_of_a_second_order_system(damping):
    root = sqrt(1 - damping**2)
    wave = np.cos(root * T) + damping / root * np.sin(root * T)
    m = measure_step(T, -2.0 * (1 - np.exp(-damping * T) * wave), -2.0)
    assert m.overshoot == pytest.approx(exp(-pi * damping / root), rel=1e-4)
    assert m.sound == (m.overshoot <= 0.1)


def test_settling_time_of_a_second_order_system_by_its_last_crossing():
    damping, root = 0.5, sqrt(0.75)
    answer = 1 - np.exp(-damping * T) * (np.cos(root * T) + damping / root * np.sin(root * T))
    outside = T[np.abs(answer - 1) > 0.02]
    assert measure_step(T, answer, 1.0).settling_time == pytest.approx(outside[-1], abs=0.002)
    assert outside[-1] == pytest.approx(8.076, abs=0.01)  # Ogata: about 4 / (damping * omega)


def test_what_never_arrives_has_no_times():
    m = measure_step(T, np.zeros_like(T), 1.0)
    assert (m.rise_time, m.settling_time, m.overshoot, m.final_error) == (None, None, 0.0, -1.0)
    assert not m.sound


def test_what_swings_on_is_not_sound():
    m = measure_step(T, 1 + 0.03 * np.sin(30 * T), 1.0)
    assert m.ripple == pytest.approx(0.03, rel=0.01)
    assert m.settling_time is None
    assert not m.sound


# which to take


def option(controller, kp, iae, overshoot=0.0):
    return Option(controller, kp, (Measures(0.1, overshoot, 0.2, iae, 0.0, 0.0),))


def test_the_simplest_and_lowest_of_nearly_equals_is_taken():
    rules = [option("PID", 1, 1.0), option("P", 9, 1.01), option("P", 4, 1.015), option("P", 2, 2)]
    assert gentlest(rules) == 2


def test_a_sound_answer_goes_before_a_fast_one():
    assert gentlest([option("P", 9, 0.1, overshoot=0.3), option("PI", 2, 5.0)]) == 1


def test_where_none_is_sound_the_smallest_overshoot_counts():
    assert gentlest([option("P", 9, 0.1, overshoot=0.5), option("PI", 2, 5.0, overshoot=0.2)]) == 1


def test_a_change_must_be_worth_it():
    assert better(option("P", 1, 0.9), option("P", 1, 1.0))
    assert not better(option("P", 1, 0.97), option("P", 1, 1.0))
    assert not better(option("P", 1, 0.9, overshoot=0.09), option("P", 1, 1.0))
    assert not better(option("P", 1, 0.1, overshoot=0.5), option("P", 1, 1.0))
    assert better(option("P", 1, 2.0), option("P", 1, 1.0, overshoot=0.5))
