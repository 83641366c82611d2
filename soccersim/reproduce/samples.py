"""Numbers over many seeds: what a paper's single number is held against."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soccersim.reproduce.section import Cell, Summary
from soccersim.state import Array


def poses(runs: Sequence[dict[str, Any]], key: str, robot: int = 0) -> Array:
    """(S, K, 3) poses at the legs' ends: `target`, `odometry` or `truth`; framed, m and rad."""
    return np.array([[leg[key] for leg in run["robots"][robot]["legs"]] for run in runs])


def times(runs: Sequence[dict[str, Any]], robot: int = 0) -> Array:
    """(S, K) seconds each leg took."""
    return np.array([[leg["time"] for leg in run["robots"][robot]["legs"]] for run in runs])


def distance(one: Array, other: Array) -> Array:
    """(...) how far points or poses (..., 2 or 3) lie apart."""
    return np.hypot(one[..., 0] - other[..., 0], one[..., 1] - other[..., 1])


def band(samples: Array) -> tuple[Array, Array, Array]:
    """Median, 5 % and 95 % over the first axis."""
    low, middle, high = np.percentile(samples, (5, 50, 95), axis=0)
    return middle, low, high


def band_cells(samples: Array) -> list[float]:
    """Median, 5 % and 95 % of (S,) numbers, as cells."""
    return [float(value) for value in band(samples)]


def rounded(rows: Iterable[Sequence[Cell]], decimals: int) -> list[list[Cell]]:
    """Rows with every float cut to so many decimals: what is beyond them is chance."""
    return [
        [round(cell, decimals) if isinstance(cell, float) else cell for cell in row] for row in rows
    ]


def percentile(value: float, samples: Array) -> float:
    """The share of the samples below the value, in percent; half of those equal to it."""
    return float(100 * (np.mean(samples < value) + np.mean(samples == value) / 2))


def inside(paper: Array, samples: Array, rounding: float = 0.0) -> NDArray[np.bool_]:
    """Which of the paper's (...) numbers lie in the 5-95 % band of (S, ...) samples.

    `rounding` is half a unit of the last digit that the paper prints.
    """
    _, low, high = band(samples)
    within: NDArray[np.bool_] = (low - rounding <= paper) & (paper <= high + rounding)
    return within


def held_against(
    what: str,
    samples: Array,
    *,
    printed: float | None = None,
    recomputed: float | None = None,
    fitted: bool = False,
    note: str = "",
    outside: str = "",
) -> Summary:
    """A Summary of (S,) samples; `outside` is added where the paper's number is out of the band."""
    middle, low, high = band_cells(samples)
    summary = Summary(what, printed, recomputed, middle, (low, high), fitted, note)
    if summary.inside is not False or not outside:
        return summary
    return replace(summary, note="; ".join(filter(None, (note, outside))))
