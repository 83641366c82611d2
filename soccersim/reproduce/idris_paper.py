"""What Idris' paper says about its own tables, and the rule by which it does."""

import numpy as np

from soccersim.reproduce.tables import table
from soccersim.state import Array

RULE = "abs(measured - real) / real, a real value of 0 counted as 0"


def printed(number: int, column: str, place: str = "table", what: str = "") -> float:
    """A figure that the paper prints about one of its tables; `what` where there are several."""
    for row in table("idris-summaries").rows:
        about = (row["table"], row["column"], row["place"]) == (number, column, place)
        if about and what in ("", row["what"]) and isinstance(row["printed"], float):
            return row["printed"]
    raise ValueError(f"the paper prints nothing about {column} of Table {number} in its {place}")


def relative(measured: Array, real: Array) -> Array:
    """(..., n) errors in percent of the real value; 0 where that is 0, as the paper counts."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(real == 0.0, 0.0, 100.0 * np.abs(measured - real) / np.abs(real))
