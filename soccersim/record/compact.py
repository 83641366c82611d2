"""Numbers of a match in few bytes: rounded to a step, and told as changes from record to record.

A match of ten minutes has 30,000 records of eleven bodies. Steps are powers of two, so that a
rounded number is exact; they are far below what a picture or a statistic shows. The digest is
taken from the unrounded numbers. NaN is kept.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

MILLIMETRE = 2.0**-10  # m, about; of speeds m/s and rad/s
TENTH = 2.0**-13  # a tenth of a millimetre, and of 0.1 mrad, about
STEPS: dict[str, list[float]] = {  # of each array of a match that is rounded, along its last axis
    "body": [TENTH] * 3 + [MILLIMETRE] * 3,
    "estimate": [TENTH] * 3,
    "orders": [MILLIMETRE] * 5,
    "ball_believed": [MILLIMETRE] * 5,
    "ball_sighted": [MILLIMETRE] * 2,
}
Numbers = NDArray[Any]
NOTHING = -(2**31)  # stands for NaN


def rounded(key: str, array: Numbers) -> Numbers:
    """The array as a match keeps it: float32, in whole steps; others as they are."""
    if key not in STEPS:
        return array
    steps = np.array(STEPS[key])
    near: Numbers = np.rint(array / steps) * steps
    return near.astype(np.float32)


def packed(key: str, array: Numbers) -> Numbers:
    """Whole steps of change along the first axis, int32; rounded numbers come back unchanged."""
    if key not in STEPS:
        return array
    steps = np.rint(array / np.array(STEPS[key], np.float32))  # exact: a step is a power of two
    steps[np.isnan(steps)] = NOTHING
    whole = steps.astype(np.int32)
    return np.diff(whole, axis=0, prepend=whole[:1] * 0)  # what is too large wraps round


def unpacked(key: str, array: Numbers) -> Numbers:
    """What packed was given, as float32."""
    if key not in STEPS:
        return array
    whole = np.cumsum(array, axis=0, dtype=np.int32)  # wraps round as the differences did
    values: Numbers = whole * np.array(STEPS[key], np.float32)
    values = values.astype(np.float32, copy=False)
    values[whole == NOTHING] = np.nan
    return values
