"""Utama, first experiment: the square of Figures 6 and 7."""

from collections.abc import Iterator

import numpy as np

from soccersim.reproduce.error_models import slipped_ends
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.samples import distance, held_against
from soccersim.reproduce.section import Cell, Section, Summary
from soccersim.reproduce.tables import table
from soccersim.reproduce.utama_figures import figure_6, figure_7
from soccersim.reproduce.utama_points import (
    CHOSEN,
    COLUMNS,
    FITTED,
    median_seed,
    outside,
    row,
    simulate,
    track,
)
from soccersim.state import Array

SIDE = 2000.0  # mm
PATH = ("forward", "left", "back", "right")  # as the text on the path has it


def sections(lab: Lab) -> Iterator[Section]:
    """The table of the legs' errors with Figure 6, then Figure 7."""
    runs = simulate(lab, "square")
    seed = median_seed(lab, runs)
    (one,) = lab.map(track, ["square"], [seed])
    corners = np.vstack(([0.0, 0.0], runs.target[:, :2]))
    errors = table("utama-square").numbers("error")
    physics = leg_errors(runs.true[:, 1:], corners)
    fitted = leg_errors(slipped_ends(corners, lab.seeds), corners)
    rows = _rows(errors, physics, fitted)
    yield Section(
        "square",
        "The square of 2 m and Figure 6",
        COLUMNS,
        rows,
        _marks(),
        _summary(errors, physics, fitted),
        (
            "The paper prints average errors alone, in percent of a leg, and neither how many runs "
            "they are of nor which error: ours is shown both ways, how far the corner is missed, "
            "and by how much along the leg.",
            CHOSEN,
            FITTED + " Here the sensors are taken to end on the corners, for the paper has no "
            "points of the square.",
            _outside(rows),
        ),
        lambda: figure_6(corners, runs, one),
    )
    yield Section(
        "figure-7",
        "Figure 7: position and direction over time",
        (),
        (),
        notes=(
            f"One run of the square, of seed {seed}: its drift is the median of all.",
            "The paper's curves are not printed as numbers.",
        ),
        figure=lambda: figure_7(one),
    )


def leg_errors(ends: Array, corners: Array) -> tuple[Array, Array]:
    """(S, 4) errors of the legs' (S, 4, 2 or 3) ends in percent of a leg.

    First how far the corner is missed, then by how much along the leg.
    """
    off = ends[..., :2] - corners[1:]
    sides = np.diff(corners, axis=0) / SIDE
    along = np.abs((off * sides).sum(axis=-1))
    return 100.0 * distance(ends, corners[1:]) / SIDE, 100.0 * along / SIDE


def _rows(
    errors: Array, physics: tuple[Array, Array], fitted: tuple[Array, Array]
) -> list[list[Cell]]:
    return [
        row(f"{k + 1} {towards}", what, float(errors[k]), physics[i][:, k], fitted[i][:, k])
        for k, towards in enumerate(PATH)
        for i, what in enumerate(("error of place (%)", "error along the leg (%)"))
    ]


def _marks() -> dict[int, str]:
    """Two rows a leg."""
    return {
        2 * k + i: f"printed as {leg['direction']}: {leg['note']}"
        for k, leg in enumerate(table("utama-square").rows)
        if leg["misprint"] == "direction"
        for i in (0, 1)
    }


def _summary(
    errors: Array, physics: tuple[Array, Array], fitted: tuple[Array, Array]
) -> list[Summary]:
    summary = []
    for name, (place, _) in (("physics", physics), ("fitted", fitted)):
        summary.append(
            held_against(
                f"mean of the four errors of place, {name} (%)",
                place.mean(axis=1),
                recomputed=float(errors.mean()),
                fitted=name == "fitted",
                note="" if name == "fitted" else "chosen by order of magnitude",
            )
        )
    return summary


def _outside(rows: list[list[Cell]]) -> str:
    names = outside(rows)
    if not names:
        return "All of the paper's errors lie inside our 5-95 % bands."
    return (
        f"Outside the physics' band: {', '.join(names)}. Which error the paper averaged is not "
        "told; each leg is held against two, and its last one's 478 mm are a whole run's drift."
    )
