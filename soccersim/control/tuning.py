"""Tuning a loop by its ultimate point: the gain at which it just oscillates, and the period.

A relay in place of the controller makes a loop oscillate near that point (Astrom and Hagglund,
Automatica 20, 1984); a sweep of the gain confirms it; rules turn it into gains. All of it works on
anything that answers a push, a robot's loop or a textbook's plant.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import exp, inf, log, sqrt

import numpy as np

from soccersim.spec.control import Pid
from soccersim.state import Array

Plant = Callable[[float], float]  # holds a push for one step; what is measured at the step's end
CONTROLLERS = ("P", "PI", "PID")
PERIODS = 10  # of a relay test
MEASURED = 6  # periods at its end, which are taken for steady
STEP = 1.35  # from gain to gain of a sweep, until one grows and one dies away
NEAR = 1.02  # ratio of gains at which a sweep is done
BAND = 0.02  # of the step: settled
STAYS = 0.95  # of the time watched: what settles later may swing on
CLOSE_DEG = 3.0  # of phase: as good as the same
EQUAL = 1.02  # ratio of costs that makes no difference
WORTH = 1.05  # ratio of costs that a change is worth
SAME = 0.01  # of the step: nor do overshoots that differ by less


@dataclass(frozen=True)
class Ultimate:
    """The gain at which a loop under proportional control just oscillates, and its period in s."""

    gain: float
    period: float


@dataclass(frozen=True)
class Share:
    """A controller as shares of the ultimate gain and period; no ti: no integral."""

    kp: float
    ti: float | None = None
    td: float = 0.0
    printed: bool = True  # False: the rule's PID alone is published, see _scaled

    def gains(self, at: Ultimate) -> Pid:
        """In the parallel form kp e + ki (sum of e) + kd (rate of e), to three digits."""
        kp = self.kp * at.gain
        ki = kp / (self.ti * at.period) if self.ti else 0.0
        return Pid(kp=_short(kp), ki=_short(ki), kd=_short(kp * self.td * at.period))


def _short(value: float) -> float:
    return float(f"{value:.3g}")


CLASSIC = {  # Ziegler and Nichols, Trans. ASME 64, 1942
    "P": Share(0.5),
    "PI": Share(0.45, ti=1 / 1.2),
    "PID": Share(0.6, ti=1 / 2, td=1 / 8),
}


def _scaled(pid: Share) -> dict[str, Share]:
    """P and PI of a rule that prints a PID: the classic ones, as much gentler as its PID is."""
    ratio = pid.kp / CLASSIC["PID"].kp
    p, pi = CLASSIC["P"], CLASSIC["PI"]
    return {
        "P": Share(ratio * p.kp, printed=False),
        "PI": Share(ratio * pi.kp, ti=pi.ti, printed=False),
        "PID": pid,
    }


RULES = {
    "ziegler-nichols": CLASSIC,
    # Tyreus and Luyben, Ind. Eng. Chem. Res. 31, 1992: for processes that integrate
    "tyreus-luyben": _scaled(Share(1 / 2.2, ti=2.2, td=1 / 6.3)) | {"PI": Share(1 / 3.2, ti=2.2)},
    # Seborg, Edgar, Mellichamp, Process Dynamics and Control, 1989, table 12.2
    "some-overshoot": _scaled(Share(0.33, ti=1 / 2, td=1 / 3)),
    "no-overshoot": _scaled(Share(0.2, ti=1 / 2, td=1 / 3)),
}


@dataclass(frozen=True)
class Trace:
    """A relay test: what was pushed and what was measured, at the same instants."""

    dt: float
    push: Array
    answer: Array


@dataclass(frozen=True)
class Oscillation:
    """What a relay test shows of the loop: a point of its frequency response."""

    gain: float  # push over answer, of the two fundamentals
    period: float  # s
    phase_deg: float  # of the answer against the push, -360..0; -180 is the ultimate point
    swing: float  # half from peak to peak of the answer


def relay_test(
    plant: Plant, amplitude: float, hysteresis: float = 0.0, patience: int = 3000
) -> tuple[Array, Array]:
    """Push a plant to and fro with a relay; (pushes, answers), or what came of it in time.

    The relay turns once the answer has passed zero by the hysteresis, which must be above the
    noise.
    """
    pushes: list[float] = []
    answers: list[float] = []
    push, answer, turns = amplitude, 0.0, 0
    while turns < 2 * PERIODS and len(pushes) < patience:
        wanted = -amplitude if answer > hysteresis else amplitude if answer < -hysteresis else push
        turns += wanted != push
        push = wanted
        pushes.append(push)
        answers.append(answer)
        answer = plant(push)
    return np.array(pushes), np.array(answers)


def oscillation(trace: Trace) -> Oscillation | None:
    """Gain and phase at the period of a relay test; None where it did not oscillate.

    From the fundamentals of both, not from the peaks: a triangle as of an integrator has a
    fundamental of 0.81 of its peak, and the usual 4 d / (pi a) misses the gain by as much.
    """
    rising = np.flatnonzero((trace.push[1:] > 0) & (trace.push[:-1] < 0)) + 1
    periods = min(len(rising) - 1, MEASURED)
    if periods < 2:
        return None
    first, last = rising[-1 - periods], rising[-1]
    push, answer = trace.push[first:last], trace.answer[first:last]
    wave = np.exp(-2j * np.pi * periods * np.arange(last - first) / (last - first))
    ratio = (answer @ wave) / (push @ wave)
    if ratio == 0.0:
        return None
    return Oscillation(
        gain=float(1.0 / abs(ratio)),
        period=float((last - first) * trace.dt / periods),
        phase_deg=float(np.degrees(np.angle(ratio)) % 360.0 - 360.0),
        swing=float(np.ptp(answer) / 2),
    )


def ultimate_of(points: Sequence[Oscillation]) -> Ultimate:
    """The ultimate point from relay tests with different hysteresis.

    Hysteresis, and the whole steps that a sampled loop's period is made of, leave a test beside
    -180 degrees; the line through the two nearest, in the logarithms, is followed to it.
    """
    near, *rest = sorted(points, key=lambda point: abs(point.phase_deg + 180.0))
    apart = [point for point in rest if abs(point.phase_deg - near.phase_deg) > CLOSE_DEG]
    if not apart or abs(near.phase_deg + 180.0) < CLOSE_DEG:
        return Ultimate(near.gain, near.period)
    far = apart[0]
    t = (-180.0 - near.phase_deg) / (far.phase_deg - near.phase_deg)
    t = min(max(t, -0.5), 1.0)
    gain = exp(log(near.gain) + t * log(far.gain / near.gain))
    return Ultimate(gain, exp(log(near.period) + t * log(far.period / near.period)))


def growth(answer: Array, period: float, step: float) -> float:
    """By what factor the swing after a step grows each period; below 1 it dies away.

    period is in samples; answer holds nine or more, of which the first is left out. Near the
    ultimate gain the swing begins as large as the step: one that soon is twice that has grown
    already, one half of it has died away, though it may go on so for ever on a coarse encoder.
    """
    early = float(np.std(answer[round(period) : round(4 * period)])) * sqrt(2.0)
    late = float(np.std(answer[-round(3 * period) :])) * sqrt(2.0)
    between = (len(answer) - 4 * period) / period  # periods from the one's middle to the other's
    return float((late / min(max(early, 0.5 * step), 2.0 * step)) ** (1.0 / between))


def period_of(answer: Array, guess: float) -> float:
    """The period, in steps, of the strongest wave within a factor of 2 of the guess."""
    periods = guess * np.geomspace(0.5, 2.0, 401)
    late = answer[round(guess) :]
    late = (late - late.mean()) * np.hanning(len(late))
    waves = np.exp(-2j * np.pi * np.arange(len(late)) / periods[:, None])
    return float(periods[int(np.argmax(np.abs(waves @ late)))])


@dataclass(frozen=True)
class Sweep:
    """Gains tried, each with its growth a period, and the nearest two that die away and grow."""

    trials: tuple[tuple[float, float], ...] = ()
    low: float | None = None
    high: float | None = None

    @property
    def gain(self) -> float | None:
        """The gain at which it just oscillates; None: not found."""
        return sqrt(self.low * self.high) if self.low and self.high else None


def sweep_gain(trial: Callable[[float], float], first: float, most: int = 16) -> Sweep:
    """Close in on the gain at which the swing neither grows nor dies away; trial tells growth."""
    sweep, gain = Sweep(), first
    for _ in range(most):
        grown = trial(gain)
        low, high = (sweep.low, gain) if grown >= 1.0 else (gain, sweep.high)
        sweep = Sweep((*sweep.trials, (gain, grown)), low, high)
        if low and high and high < low * NEAR:
            break
        gain = sweep.gain or (low * STEP if low else gain / STEP)
    return sweep


@dataclass(frozen=True)
class Measures:
    """How good a step response is; None: not within the time."""

    rise_time: float | None  # s, from 10 to 90 % of the step
    overshoot: float  # share of the step
    settling_time: float | None  # s, until it stays within 2 % of the step
    iae: float  # integral of the absolute error, in the quantity's unit times s
    final_error: float  # share of the step, mean of the last tenth
    ripple: float  # share of the step, half from peak to peak in the last tenth

    @property
    def sound(self) -> bool:
        """Whether it arrives, rests there, and does not shoot far past."""
        return self.overshoot <= 0.1 and abs(self.final_error) <= 0.05 and self.ripple <= 0.02


def measure_step(time: Array, answer: Array, step: float) -> Measures:
    """The measures of an answer to a step from 0 at time 0."""
    share = answer / step
    tail = share[-max(len(share) // 10, 1) :]
    outside = np.flatnonzero(np.abs(share - 1.0) > BAND)
    settled = 0 if len(outside) == 0 else outside[-1] + 1
    low, high = (_passes(time, share, level) for level in (0.1, 0.9))
    return Measures(
        rise_time=high - low if low is not None and high is not None else None,
        overshoot=max(0.0, float(share.max()) - 1.0),
        settling_time=float(time[settled]) if settled < STAYS * len(share) else None,
        iae=float(np.trapezoid(np.abs(step - answer), time)),
        final_error=float(tail.mean()) - 1.0,
        ripple=float(np.ptp(tail)) / 2,
    )


def _passes(time: Array, share: Array, level: float) -> float | None:
    """When an answer first passes a level, between two samples."""
    above = np.flatnonzero(share >= level)
    if len(above) == 0:
        return None
    k = int(above[0])
    if k == 0:
        return float(time[0])
    part = (level - share[k - 1]) / (share[k] - share[k - 1])
    return float(time[k - 1] + part * (time[k] - time[k - 1]))


@dataclass(frozen=True)
class Option:
    """A controller, its gain, and the answers with it of all the loops that it is to serve."""

    controller: str
    kp: float
    measures: tuple[Measures, ...]

    @property
    def cost(self) -> float:
        """The IAE of all answers, more by what each overshoots; infinite if one is not sound."""
        if not all(m.sound for m in self.measures):
            return inf
        return sum(m.iae * (1.0 + m.overshoot) for m in self.measures)


def gentlest(options: Sequence[Option]) -> int:
    """Which to take: of the sound ones near the least cost the simplest, with the lowest gain.

    Where none is sound, the one that overshoots least, all else alike.
    """
    least = min(option.cost for option in options)
    if least == inf:
        worst = [max(m.overshoot + abs(m.final_error) for m in o.measures) for o in options]
        near = [k for k in range(len(options)) if worst[k] <= min(worst) + SAME]
    else:
        near = [k for k, option in enumerate(options) if option.cost <= least * EQUAL]
    return min(near, key=lambda k: (CONTROLLERS.index(options[k].controller), options[k].kp))


def better(option: Option, present: Option) -> bool:
    """Whether a change is worth it."""
    if option.cost == present.cost == inf:
        return gentlest((option, present)) == 0
    return option.cost * WORTH < present.cost
