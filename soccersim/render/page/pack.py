"""Numbers over time in few bytes: whole steps, told as changes of changes, then deflated.

The page's unpack.js reads what is written here:

    zlib( length of the document, uint32 | the document, JSON | bytes of the channels )

A channel is a table (T, columns) of one step. Column by column, each number is rounded to whole
steps and `order` times replaced by its change from the row before. The changes are written as
zigzag (0, -1, 1, -2, ...) in one byte, or, from 255 on, as 255 and a uint32. All little-endian.
"""

import json
import zlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

WIDE = 255  # says that four bytes follow
FARTHEST = 2.0**28  # steps; what is farther is shown here, and changes fit into their bytes
KNOWN = "?"  # ends the name of a channel that tells where another one is known

Array = NDArray[Any]
Whole = NDArray[np.int64]


@dataclass
class Packer:
    """Takes in channels of T rows, then gives the bytes."""

    rows: int
    told: list[dict[str, Any]] = field(default_factory=list)
    parts: list[bytes] = field(default_factory=list)
    shown: dict[str, Array] = field(default_factory=dict)  # as the page will read them

    def add(
        self, key: str, values: Array, step: float = 1.0, order: int = 2, on: str | None = None
    ) -> None:
        """A channel (T, columns) or (T,); on: of which the difference to this one is told.

        NaN is where it is not known; there the channel keeps its last number.
        """
        table = np.asarray(values, float).reshape(self.rows, -1)
        known = np.isfinite(table)
        if not known.all():
            self.add(key + KNOWN, known, order=1)
            table = held(table, known)
        below = self.shown[on] if on else 0.0
        far = FARTHEST * step
        steps = np.rint(np.clip(table - below, -far, far) / step).astype(np.int64)
        self.shown[key] = steps * step + below
        self.told.append(
            {"key": key, "columns": table.shape[1], "step": step, "order": order, "on": on}
        )
        self.parts.append(coded(steps, order))

    def packed(self, document: dict[str, Any]) -> bytes:
        """The document, with the list of channels in it, and all channels."""
        whole = document | {"rows": self.rows, "channels": self.told}
        text = json.dumps(whole, allow_nan=False, separators=(",", ":")).encode()
        head = len(text).to_bytes(4, "little") + text
        return zlib.compress(head + b"".join(self.parts), 9)


def held(table: Array, known: Array) -> Array:
    """Each number that is not known replaced by the last one that was, or by 0."""
    row = np.where(known, np.arange(len(table))[:, None], -1)
    last = np.maximum.accumulate(row, axis=0)
    found: Array = np.take_along_axis(np.where(known, table, 0.0), last.clip(0), axis=0)
    return found


def coded(steps: Whole, order: int) -> bytes:
    """The changes of whole steps, column by column."""
    change = steps
    for _ in range(order):
        change = np.diff(change, axis=0, prepend=0 * change[:1])
    zigzag = np.where(change < 0, -2 * change - 1, 2 * change).T.ravel()
    wide = zigzag >= WIDE
    place = np.cumsum(np.where(wide, 5, 1))
    place -= np.where(wide, 5, 1)
    size = len(zigzag) + 4 * int(wide.sum())
    data = np.empty(size, np.uint8)
    data[place] = np.where(wide, WIDE, zigzag)
    for byte in range(4):
        data[place[wide] + 1 + byte] = (zigzag[wide] >> (8 * byte)) & 0xFF
    return data.tobytes()
