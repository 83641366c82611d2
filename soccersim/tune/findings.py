"""What tuning a robot came to: a document, the YAML to paste, and what to know about it."""

from typing import TYPE_CHECKING, Any

import numpy as np

from soccersim.control.tuning import Measures, Ultimate
from soccersim.spec.control import Pid
from soccersim.tune.session import APART, GRIP, WATCHED, Candidate, Experiment, Tuned, Tuning

if TYPE_CHECKING:
    from soccersim.render.tune_plots import LoopPicture

ALIKE = 0.03  # of a step: overshoots of all gains nearer than this are not the gains' doing


def document(tuning: Tuning) -> dict[str, Any]:
    """Everything, ready for JSON; SI, headings in radians."""
    return {
        "scenario": tuning.scenario.name,
        "robot": tuning.player.name,
        "seed": tuning.scenario.seed,
        "loops": [_loop(tuned) for tuned in tuning.loops],
        "yaml": yaml(tuning),
        "notes": notes(tuning),
    }


def _loop(tuned: Tuned) -> dict[str, Any]:
    loop, tried = tuned.loop, tuned.experiment
    at = tried.ultimate
    source = "sweep" if at is tried.swept else "relay"
    return {
        "loop": loop.name,
        "unit": loop.unit,
        "push_unit": loop.push_unit,
        "step": loop.step,
        "ultimate": {**_point(at), "from": source} if at else None,
        "relay": _relay(tried),
        "sweep": {
            **_point(tried.swept),
            "trials": [{"gain": gain, "growth": grown} for gain, grown in tried.sweep.trials],
        },
        "present": _candidate(tuned.present),
        "rules": [_candidate(candidate) for candidate in tuned.candidates],
        "best_rule": _candidate(tuned.best) if tuned.best else None,
        "keep_present": tuned.keep,
        "recommended": _candidate(tuned.chosen),
        "why": why(tuned),
    }


def _point(at: Ultimate | None) -> dict[str, float | None]:
    return {"gain": at.gain if at else None, "period": at.period if at else None}


def _relay(tried: Experiment) -> dict[str, Any]:
    points = [
        {"gain": p.gain, "period": p.period, "phase_deg": p.phase_deg, "swing": p.swing}
        for p in tried.points
    ]
    return {**_point(tried.relay), "push": tried.push, "grip": tried.grip, "points": points}


def _candidate(candidate: Candidate) -> dict[str, Any]:
    measures = candidate.measures
    return {
        "rule": candidate.rule,
        "controller": candidate.controller,
        "printed": candidate.printed,
        "kp": candidate.gains.kp,
        "ki": candidate.gains.ki,
        "kd": candidate.gains.kd,
        "rise_time": measures.rise_time,
        "overshoot": measures.overshoot,
        "settling_time": measures.settling_time,
        "iae": measures.iae,
        "final_error": measures.final_error,
        "ripple": measures.ripple,
        "sound": measures.sound,
    }


def yaml(tuning: Tuning) -> str:
    """The lines for the robot's file; where the present gains do best, those, and it says so."""
    lines = ["control:"]
    for tuned in tuning.loops:
        best, gains = tuned.best, _gains(tuned.chosen.gains)
        rule = f"{best.rule} {best.controller}" if best else ""
        if best and tuned.keep:
            rule = f"as it is; {rule}: {_gains(best.gains)}"
        lines.append(f"  {tuned.loop.name}: {gains}  # {rule or 'as it is'}")
    return "\n".join(lines) + "\n"


def _gains(gains: Pid) -> str:
    given = {"kp": gains.kp, "ki": gains.ki, "kd": gains.kd}
    text = ", ".join(f"{k}: {v:g}" for k, v in given.items() if v or k == "kp")
    return "{" + text + "}"


def why(tuned: Tuned) -> str:
    """Why these gains."""
    best = tuned.best
    if best is None:
        return "it could not be brought to oscillate: the present gains stay"
    name = f"{best.rule} {best.controller}"
    if not tuned.keep:
        if best.measures.sound:
            return f"{name}: the simplest, with the lowest gain, of those near the least error"
        return f"{name}: no answer is sound, this one comes nearest"
    if not tuned.present.measures.sound:
        return f"the present gains stay: no answer is sound, nor is that of {name}, the best rule"
    if not best.measures.sound:
        return f"the present gains stay: {name}, the best rule, {_fault(best.measures)}"
    change = best.measures.iae / tuned.present.measures.iae - 1
    if change < 0.02:
        return f"the present gains stay: {name}, the best rule, does little or no better"
    return f"the present gains stay: {name}, the best rule, has {change:.0%} more error"


def _fault(m: Measures) -> str:
    """What is not sound about an answer."""
    if m.overshoot > 0.1:
        return f"overshoots by {m.overshoot:.0%}"
    if m.ripple > 0.02:
        return f"does not come to rest within {WATCHED:.0f} s"
    return f"is still {abs(m.final_error):.0%} off at the end"


def notes(tuning: Tuning) -> list[str]:
    """What a reader of the tables should know."""
    said = [
        "experiments: the robot alone, its limits and profile off, a relay's push about "
        f"{GRIP:.0%} of the floor's grip, at most a quarter of the motors' power",
        "answers: the scenario's own limits and profile, odometry as the robot sees it",
    ]
    if tuning.player.model.control.wheel_loop == "table":
        said.append("no wheel loop: `wheel_loop: table` drives these wheels by the PWM table alone")
    else:
        said.append(
            "wheel: turning on the spot, with the PWM table ahead of it as it drives; "
            "x, y and heading were tuned with the recommended wheel gains"
        )
    for tuned in tuning.loops:
        said += [f"{tuned.loop.name}: {text}" for text in _remarks(tuned)]
    return said


def _remarks(tuned: Tuned) -> list[str]:
    """What is peculiar to a loop."""
    tried = tuned.experiment
    if tried.relay is None:
        return ["a relay did not make it oscillate: no ultimate gain, no rule"]
    said = []
    if tried.swept is None:
        said.append("no gain made it ring on undamped: the relay's point is used")
    elif not 1 / APART < tried.relay.gain / tried.swept.gain < APART:
        apart = tried.relay.gain / tried.swept.gain - 1
        said.append(
            f"the relay's gain is {apart:+.0%} off the sweep's: a swing of {tried.swing:.2g} "
            f"{tuned.loop.unit} is coarse to these sensors; the lower gain is used"
        )
    over = [c.measures.overshoot for c in tuned.candidates if c.controller == "P"]
    if min(over) > 0.1 and max(over) - min(over) < ALIKE and tuned.loop.name != "wheel":
        key = "turn_acceleration" if tuned.loop.name == "heading" else "acceleration"
        said.append(
            f"P overshoots by {min(over):.0%} with every gain: its wheels are slower than "
            f"`limits.{key}`; lower that"
        )
    return said


def pictures(tuning: Tuning) -> "list[LoopPicture]":
    """What soccersim.render.tune_plots draws of it."""
    from soccersim.render.tune_plots import Curve, LoopPicture

    drawn = []
    for tuned in tuning.loops:
        loop, tried = tuned.loop, tuned.experiment
        time = [k * tried.trace.dt for k in range(len(tried.trace.push))]
        rows = [tuned.present, *tuned.candidates, tuned.chosen]
        steps = [Curve(c.rule, c.answer.time, c.answer.value, c.controller) for c in rows]
        drawn.append(
            LoopPicture(
                name=loop.name,
                unit=loop.unit,
                push_unit=loop.push_unit,
                said=_said(tried),
                push=Curve("push", np.array(time), tried.trace.push),
                answer=Curve("answer", np.array(time), tried.trace.answer),
                period=tried.points[-1].period if tried.points else 0.0,
                swing=tried.swing,
                trials=[Curve(f"{gain:.3g}", a.time, a.value) for gain, a in tried.shown],
                step=loop.step,
                steps=steps,
            )
        )
    return drawn


def _said(tried: Experiment) -> str:
    """The ultimate point by both ways, in a line."""
    found = [
        f"{name} Ku {at.gain:.3g}, Tu {at.period:.3g} s"
        for name, at in (("relay", tried.relay), ("sweep", tried.swept))
        if at
    ]
    return "; ".join(found) or "did not oscillate"
