"""What plays the matches here: versions, platform and our own code, as one digest."""

import hashlib
import json
import os
from functools import cache
from pathlib import Path

from soccersim import __version__
from soccersim.record.digest import fingerprint

PACKAGE = Path(__file__).parents[1]
BESIDE = {"cli", "render", "reproduce", "regress", "tune", "bundled", "bench.py"}  # play no match


@cache
def engine() -> str:
    """SHA-256 of all that may change how a match comes out, besides its own key."""
    # what is 0 unless it is set: the order of texts in sets, see processes.py
    texts = os.environ.get("PYTHONHASHSEED", "0")
    told = [__version__, fingerprint(), texts, sources()]
    return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()


def environment() -> dict[str, str]:
    """The same for people."""
    return {"soccersim": __version__, **fingerprint(), "engine": engine()[:16]}


def sources() -> str:
    """SHA-256 of our code: an edit of it makes other matches, also where the version stays."""
    digest = hashlib.sha256()
    for path in sorted(PACKAGE.rglob("*.py")):
        name = path.relative_to(PACKAGE)
        if name.parts[0] not in BESIDE:
            digest.update(f"{name.as_posix()}\n".encode() + path.read_bytes())
    return digest.hexdigest()
