"""Idris, Tables 2 to 4: the speed of each motor, by tachometer and by encoder."""

from collections.abc import Iterator

import numpy as np

from soccersim.reproduce.figures import GREY, PHYSICS, Figure, axes, canvas, draw_band, draw_paper
from soccersim.reproduce.idris_bench import WHEELS, motor_speeds, wheels_off_the_floor
from soccersim.reproduce.idris_paper import printed, relative
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.samples import band_cells, held_against, inside, rounded
from soccersim.reproduce.section import Section, Summary
from soccersim.reproduce.tables import PaperTable, table
from soccersim.state import Array

MOTORS = {2: "left", 3: "right", 4: "back"}  # table: the wheel it is about
COLUMNS = (
    *("PWM", "paper tachometer (rpm)", "paper encoder (rpm)", "paper error (%)"),
    *("input true speed (rpm)", "physics encoder (rpm)", "physics 5 %", "physics 95 %"),
    *("paper - physics encoder (rpm)", "physics error over encoder (%)"),
    *("physics error over tachometer (%)", "physics linear motor (rpm)"),
)


def motors(lab: Lab) -> Iterator[Section]:
    """Tables 2 to 4."""
    levels = table("idris-table2").numbers("pwm")
    text = wheels_off_the_floor(list(levels))
    speeds = np.array(lab.each(motor_speeds, text))
    linear = lab.map(motor_speeds, [wheels_off_the_floor(list(levels), linear=True)], [0])[0][0]
    for number, wheel in MOTORS.items():
        i = WHEELS.index(wheel)
        yield _motor(table(f"idris-table{number}"), number, speeds[..., i], linear[:, i])


def _motor(paper: PaperTable, number: int, speeds: Array, linear: Array) -> Section:
    """speeds are (S, 2, levels) rpm, true and by the encoder; linear is (levels,)."""
    tacho, encoder = paper.numbers("real"), paper.numbers("encoder")
    error, by_tacho = paper.numbers("error"), relative(encoder, tacho)
    true, read = speeds[0]
    rows = [
        [
            *(int(paper.numbers("pwm")[i]), tacho[i], encoder[i], error[i]),
            *(float(true[i]), float(read[i]), *band_cells(speeds[:, 1, i])[1:]),
            float(encoder[i] - read[i]),
            float(relative(true, read)[i]),
            float(relative(read, true)[i]),
            float(linear[i]),
        ]
        for i in range(len(tacho))
    ]
    marks = {
        i: f"over the tachometer, as the text has it, {by_tacho[i]:.2f} %: this is over the encoder"
        for i in range(len(tacho))
        if abs(round(by_tacho[i], 2) - error[i]) > 0.005
    }
    return Section(
        f"table-{number}",
        f"Table {number}: speed of the {MOTORS[number]} motor",
        COLUMNS,
        rounded(rows, 2),
        marks,
        _motor_summary(number, tacho, encoder, speeds),
        _motor_notes(tacho, encoder, speeds[:, 1], linear),
        lambda: _motor_figure(tacho, encoder, speeds, linear, paper.numbers("pwm")),
    )


def _motor_summary(number: int, tacho: Array, encoder: Array, speeds: Array) -> list[Summary]:
    true, read = speeds[:, 0], speeds[:, 1]
    off = "the encoder is 1.4 to 3.5 rpm ahead at PWM 60 to 90, which counting cannot do"
    rms = np.sqrt(((read - true)[:, 1:] ** 2).mean(axis=1))
    paper_off = (encoder - tacho)[1:]
    top = Summary("top speed (rpm)", float(tacho[-1]), None, float(true[0, -1]), fitted=True,
                  note="put in: the robot's PWM table is this column")  # fmt: skip
    return [
        held_against(
            "mean error over the encoder (%)",
            relative(true, read).mean(axis=1),
            printed=printed(number, "error"),
            recomputed=float(relative(tacho, encoder).mean()),
            note="what the paper computed: abs(encoder - tachometer) / encoder, over 27",
            outside=off,
        ),
        held_against(
            "mean error over the tachometer (%)",
            relative(read, true).mean(axis=1),
            printed=printed(number, "error"),
            recomputed=float(relative(encoder, tacho).mean()),
            note="the rule that its text states",
            outside=off,
        ),
        held_against(
            "rms of encoder less tachometer (rpm)",
            rms,
            recomputed=float(np.sqrt((paper_off**2).mean())),
            outside=off,
        ),
        held_against(
            "mean of encoder less tachometer (rpm)",
            (read - true)[:, 1:].mean(axis=1),
            recomputed=float(paper_off.mean()),
            outside="the paper's encoder is ahead at nearly every level; whole pulses err both "
            "ways alike",
        ),
        top,
    ]


def _motor_notes(tacho: Array, encoder: Array, read: Array, linear: Array) -> tuple[str, ...]:
    within = inside(encoder, read, rounding=0.05).sum()
    slow = tacho >= 50
    rms = np.sqrt(((linear - tacho)[slow] ** 2).mean())
    return (
        "Input: the true speed agrees with the tachometer by construction, for the robot's motors "
        "are given by this very column. Physics is what the encoder makes of it: 270 pulses a "
        "turn counted over 100 ms, one step being 2.22 rpm.",
        f"{within} of {len(tacho)} of the paper's encoder speeds lie inside "
        "our 5-95 % band. They are not multiples of 2.22 rpm: averaged or filtered before they "
        "were printed, and with an offset.",
        f"The linear motor is one line from 0 to 530 rpm at full voltage, less dry friction "
        f"(0.05 N m of 4): {rms:.1f} rpm rms off for PWM >= 20, {abs(linear - tacho).max():.1f} "
        "at most. The paper's motors bow upwards and show no dead zone.",
    )


def _motor_figure(
    tacho: Array, encoder: Array, speeds: Array, linear: Array, levels: Array
) -> Figure:
    with canvas(9.6, 4.4, 1, 2) as (figure, (left, right)):
        axes(left, "PWM (of 255)", "speed (rpm)", "Motor")
        left.plot(levels, linear, color=GREY, lw=1.4, label="physics, linear motor")
        left.plot(levels, speeds[0, 0], color=PHYSICS, lw=1.4, label="true speed (the input)")
        draw_paper(left, levels, tacho, "paper, tachometer")
        left.legend(loc="upper left", borderaxespad=0.8)
        axes(right, "speed (rpm)", "encoder less tachometer (rpm)", "Encoder")
        draw_band(right, tacho, speeds[:, 1] - speeds[:, 0], PHYSICS, "physics")
        draw_paper(right, tacho, encoder - tacho)
        right.legend(loc="upper right", borderaxespad=0.8)
    return figure
