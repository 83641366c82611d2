"""The digest of a run: a SHA-256 chain over its records, and the platform it holds for."""

import hashlib
import platform
from collections.abc import Sequence
from functools import cache
from importlib.metadata import version

import numpy as np
from numpy.typing import NDArray

START = b"soccersim 1"
Chain = NDArray[np.uint8]
KEPT = 4  # bytes of a link in a recording: a change goes unseen once in four thousand million


class Digest:
    """A chain of SHA-256: each link hashes the last one and one record's numbers."""

    def __init__(self) -> None:
        self._link = hashlib.sha256(START).digest()

    def add(self, arrays: Sequence[NDArray[np.float64]]) -> Chain:
        """Take in records, first axis time: of each its arrays as little-endian float64.

        Returns (T, KEPT), the first bytes of each link: they tell where two runs part.
        """
        links = bytearray()
        flat = [np.ascontiguousarray(a, "<f8").reshape(len(a), -1) for a in arrays]
        for row in np.concatenate(flat, axis=1):
            self._link = hashlib.sha256(self._link + row.tobytes()).digest()
            links += self._link[:KEPT]
        return np.frombuffer(bytes(links), np.uint8).reshape(-1, KEPT)

    @property
    def hex(self) -> str:
        """The chain so far."""
        return self._link.hex()


def fingerprint() -> dict[str, str]:
    """The platform on which a digest comes out the same."""
    features = str(np.show_config(mode="dicts").get("SIMD Extensions"))
    return {
        "os": platform.system(),
        "machine": platform.machine(),
        "libc": " ".join(platform.libc_ver()),
        "cpu": hashlib.sha256(features.encode()).hexdigest()[:12],
        "python": platform.python_version(),
        **_versions(),
    }


@cache
def _versions() -> dict[str, str]:
    """Of the packages that numbers come from; to ask for one takes half a millisecond."""
    return {name: version(name) for name in ("numpy", "pymunk", "numba")}
