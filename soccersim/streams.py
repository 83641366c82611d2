"""Randomness: one named stream for every user of it, so that adding one leaves the others alone."""

import hashlib

import numpy as np


def stream(seed: int, robot: int, name: str) -> np.random.Generator:
    """The stream of one sensor, or other cause of chance, of one robot.

    Keyed by (seed, robot, name) alone: never by the order in which streams are made.
    """
    key = int.from_bytes(hashlib.sha256(name.encode()).digest()[:8], "little")
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence([seed, robot, key])))
