"""The experiments on each loop of a robot, the rules' gains compared, and which to take."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from soccersim.control.tuning import (
    CLOSE_DEG,
    RULES,
    Measures,
    Option,
    Oscillation,
    Sweep,
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
from soccersim.spec.control import Pid
from soccersim.spec.player import Player
from soccersim.spec.robot import Robot
from soccersim.spec.scenario import Scenario
from soccersim.tune.rig import Answer, AxisLoop, Loop, Rig, WheelLoop

WATCHED = 6.0  # s of a move by which gains are compared
PERIODS = 10  # of a trial at some gain
GRIP = 0.6  # share of the floor's grip that a relay may use: beyond it wheels soon slide
HYSTERESIS = (0.2, 0.4, 0.8)  # of the swing under a bare relay; more where it is not felt
KICKS = (0.8, 1.0, 1.25)  # times that swing: a coarse encoder answers each a little differently
SHOWN = (0.7, 1.2)  # of the ultimate gain: kept for the picture, with the last that died away
APART = 1.25  # ratio of gains by sweep and relay above which they do not agree
PROBE, PROBES = 0.2, 4  # of the hardest push, the first; tests to find the one for GRIP
Shown = tuple[tuple[float, Answer], ...]


@dataclass(frozen=True)
class Experiment:
    """How a loop was brought to oscillate."""

    push: float  # of the relay
    grip: float  # the largest share of the floor's grip the relay used, by the wheels' slip
    points: tuple[Oscillation, ...]  # of relays without and with hysteresis
    trace: Trace  # of the last
    relay: Ultimate | None
    sweep: Sweep
    swept: Ultimate | None
    swing: float  # half from peak to peak, under the bare relay; 0: it did not oscillate
    shown: Shown  # gains about the ultimate one, and what they do

    @property
    def ultimate(self) -> Ultimate | None:
        """The sweep's point, which is what the words mean.

        The relay's where the sweep found none, or one at a much higher gain: a loop that hunts
        between an encoder's pulses may ring on at any gain.
        """
        if self.swept and self.relay and self.swept.gain > APART * self.relay.gain:
            return self.relay
        return self.swept or self.relay


@dataclass(frozen=True)
class Candidate:
    """Gains, and what the loop's step looks like with them."""

    rule: str  # of RULES, or "present"
    controller: str  # P, PI or PID
    gains: Pid
    printed: bool  # whether the rule's authors print it; else it was scaled
    answer: Answer
    measures: Measures


@dataclass(frozen=True)
class Tuned:
    """A loop's experiment, what the rules make of it, and which gains to take."""

    loop: Loop
    experiment: Experiment
    present: Candidate
    candidates: tuple[Candidate, ...]
    best: Candidate | None  # of the candidates; None: the loop did not oscillate
    keep: bool  # the present gains do no worse

    @property
    def chosen(self) -> Candidate:
        """What to write into the robot's file."""
        return self.present if self.keep or self.best is None else self.best


@dataclass(frozen=True)
class Tuning:
    """All loops of a robot: x, y, heading, and the wheels' where they have one."""

    scenario: Scenario
    player: Player
    loops: tuple[Tuned, ...]


def tune(
    scenario: Scenario, player: Player, progress: Callable[[float], None] = lambda share: None
) -> Tuning:
    """Tune a robot of the scenario: the wheels first, for the position loops act through them."""
    model = player.model
    groups = [["x", "y"], ["heading"]]
    if model.control.wheel_loop == "pi":
        groups.insert(0, ["wheel"])
    tuned: list[Tuned] = []
    count = sum(map(len, groups))
    for group in groups:
        loops = [_loop(scenario, player, model, name) for name in group]
        done = len(tuned)
        experiments, compared = [], []
        for k, loop in enumerate(loops):
            experiments.append(experiment(loop))
            progress((done + k + 0.5) / count)
            compared.append(compare(loop, experiments[-1].ultimate))
            progress((done + k + 1.0) / count)
        tuned += choose(loops, experiments, compared)
        for result in tuned[done:]:
            control = result.loop.control(result.chosen.gains)
            if result.loop.name == "wheel":
                model = model.model_copy(update={"control": control})
    order = ("x", "y", "heading", "wheel")
    return Tuning(scenario, player, tuple(sorted(tuned, key=lambda t: order.index(t.loop.name))))


def _loop(scenario: Scenario, player: Player, model: Robot, name: str) -> Loop:
    if name == "wheel":
        return WheelLoop(scenario, player, model)
    return AxisLoop(scenario, player, model, name)


def experiment(loop: Loop) -> Experiment:
    """Relay tests without and with hysteresis, then a sweep of the gain about what they say."""
    push = PROBE * loop.hardest
    rig, bare = relay(loop, push, 0.0)
    for _ in range(PROBES):
        if abs(rig.grip - GRIP) < 0.1 or (rig.grip < GRIP and push == loop.hardest):
            break
        push = min(push * _room(rig.grip), loop.hardest)
        rig, bare = relay(loop, push, 0.0)
    points, trace = [point for point in (oscillation(bare),) if point], bare
    for share in HYSTERESIS if points else ():
        rig, trace = relay(loop, push, share * points[0].swing)
        points += [point for point in (oscillation(trace),) if point]
        if points[-1].phase_deg > -180.0 + CLOSE_DEG:
            break
    guess = ultimate_of(points) if points else None
    swing = points[0].swing if points else 0.0
    nothing: tuple[Sweep, None, Shown] = (Sweep(), None, ())
    sweep, swept, shown = confirm(loop, guess, swing) if guess else nothing
    return Experiment(push, rig.grip, tuple(points), trace, guess, sweep, swept, swing, shown)


def relay(loop: Loop, push: float, hysteresis: float) -> tuple[Rig, Trace]:
    """A relay test on the open loop."""
    rig = loop.rig()
    pushes, answers = relay_test(rig, push, hysteresis)
    return rig, Trace(loop.dt, pushes, answers)


def _room(grip: float) -> float:
    """How much harder to push, by the share of the grip used: slip, not grip, grows with it."""

    def slip(share: float) -> float:
        return float(share / np.sqrt(1.0 - share * share))

    return slip(GRIP) / slip(min(max(grip, 0.01), 0.99))


def confirm(loop: Loop, guess: Ultimate, swing: float) -> tuple[Sweep, Ultimate | None, Shown]:
    """Close in on the gain at which a step as large as the relay's swing rings on undamped."""
    seconds, steps = (PERIODS + 0.5) * guess.period, guess.period / loop.dt

    def ring(gain: float, kick: float) -> Answer:
        return loop.answer(Pid(kp=gain), kick, seconds, raised=True)

    def trial(gain: float) -> float:
        grown = [growth(ring(gain, swing * k).value, steps, swing * k) for k in KICKS]
        return float(np.prod(grown) ** (1 / len(KICKS)))

    sweep = sweep_gain(trial, guess.gain)
    about = sweep.gain or guess.gain
    gains = (SHOWN[0] * about, sweep.low or about, SHOWN[1] * about)
    shown = tuple((gain, ring(gain, swing)) for gain in gains)
    if sweep.gain is None:
        return sweep, None, shown
    return sweep, Ultimate(sweep.gain, period_of(shown[1][1].value, steps) * loop.dt), shown


def compare(loop: Loop, ultimate: Ultimate | None) -> list[Candidate]:
    """The present gains, then those of every rule, each with its answer to the loop's step."""
    gains = loop.present
    kind = "PID" if gains.kd else "PI" if gains.ki else "P"
    found = [_candidate(loop, "present", kind, gains, True)]
    if ultimate is None:
        return found
    for rule, shares in RULES.items():
        for controller in loop.controllers:
            share = shares[controller]
            found.append(_candidate(loop, rule, controller, share.gains(ultimate), share.printed))
    return found


def _candidate(loop: Loop, rule: str, controller: str, gains: Pid, printed: bool) -> Candidate:
    answer = loop.answer(gains, loop.step, WATCHED)
    measures = measure_step(answer.time, answer.value, loop.step)
    return Candidate(rule, controller, gains, printed, answer, measures)


def choose(
    loops: Sequence[Loop], experiments: Sequence[Experiment], compared: Sequence[list[Candidate]]
) -> list[Tuned]:
    """The same rule and controller for all these loops; or what they have, if that is no worse."""
    options = [
        Option(alike[0].controller, alike[0].gains.kp, tuple(c.measures for c in alike))
        for alike in zip(*compared, strict=True)
    ]
    at = 1 + gentlest(options[1:]) if options[1:] else None
    keep = at is None or not better(options[at], options[0])
    return [
        Tuned(loop, tried, found[0], tuple(found[1:]), None if at is None else found[at], keep)
        for loop, tried, found in zip(loops, experiments, compared, strict=True)
    ]
