"""Numbers over time in few letters: whole steps, told as changes of changes, deflated, spelt.

The page's unpack.js reads what is written here:

    spelt( zlib( length of the document, uint32 | the document, JSON | bytes of the channels ) )

A channel is a table (T, columns) of one step. Column by column, each number is rounded to whole
steps and `order` times replaced by its change from the row before. The changes are written as
zigzag (0, -1, 1, -2, ...) in one byte, or, from 255 on, as 255 and a uint32. All little-endian.

Noisy numbers seldom repeat: looking for repetitions makes their Huffman codes longer. So each
channel is deflated in every way that zlib knows, and the shortest is taken: a tenth less in all. A
letter of base64 holds 6 bits, two of 91 letters hold 13: a page is 8 % smaller.
"""

import json
import zlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

WIDE = 255  # says that four bytes follow
FARTHEST = 2.0**28  # steps; what is farther is shown here, and changes fit into their bytes
WAYS = (zlib.Z_FILTERED, zlib.Z_HUFFMAN_ONLY, zlib.Z_RLE, zlib.Z_DEFAULT_STRATEGY)
HEAD, END = b"\x78\xda", b"\x03\x00"  # of a zlib stream; the last block of it, empty
LETTERS, FIRST, LEFT_OUT = 91, ord("#"), ord("<")  # "#" to "~"; no "<", which may end a script
PAIR = 13  # bits
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

        NaN is where it is not known; there the channel keeps its last number; of order 0 it has 0.
        """
        table = np.asarray(values, float).reshape(self.rows, -1)
        known = np.isfinite(table)
        if not known.all():
            self.add(key + KNOWN, known, order=1)
            table = held(table, known) if order else np.nan_to_num(table)
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
        return deflated([len(text).to_bytes(4, "little") + text, *self.parts])


def deflated(parts: list[bytes]) -> bytes:
    """One zlib stream of all parts, each in the way that takes the fewest bytes."""
    pieces = [min((_deflated(part, way) for way in WAYS), key=len) for part in parts]
    check = zlib.adler32(b"".join(parts)).to_bytes(4, "big")
    return b"".join((HEAD, *pieces, END, check))


def _deflated(part: bytes, way: int) -> bytes:
    """Blocks of a zlib stream that refer to nothing before them, up to a whole byte."""
    squeeze = zlib.compressobj(9, zlib.DEFLATED, -15, 9, way)
    return squeeze.compress(part) + squeeze.flush(zlib.Z_FULL_FLUSH)


def spelt(data: bytes) -> str:
    """Bytes as letters that stand in any HTML as they are, after four bytes that say how many."""
    whole = len(data).to_bytes(4, "little") + data
    bits = np.unpackbits(np.frombuffer(whole, np.uint8))
    rows = np.pad(bits, (0, -len(bits) % PAIR)).reshape(-1, PAIR)
    pairs = np.zeros(len(rows), np.int64)
    for column in rows.T:
        pairs = 2 * pairs + column
    letters = np.stack(np.divmod(pairs, LETTERS), axis=1).astype(np.uint8) + FIRST
    letters += letters >= LEFT_OUT
    return letters.tobytes().decode()


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
