"""The recordings of a run that are kept: in a folder beside the store, whole or not at all."""

import os
from contextlib import suppress
from pathlib import Path
from zipfile import BadZipFile

from soccersim.problems import MachineError
from soccersim.regress.leg import Leg
from soccersim.regress.row import Row

PART = ".part"  # ends the name of a file that is not whole yet


class Recordings:
    """The folder; it is made when there is something to put into it."""

    def __init__(self, store: Path) -> None:
        self.folder = store.with_name(f"{store.name}.recordings")

    def keep(self, leg: Leg, data: bytes) -> str:
        """Write a leg's recording; its name in the folder. MachineError where that fails."""
        name = f"pair-{leg.pair:06d}-leg-{leg.leg}-{leg.key[:12]}.npz"
        path, part = self.folder / name, self.folder / (name + PART)
        try:
            self.folder.mkdir(exist_ok=True)
            with open(part, "wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            part.replace(path)
        except OSError as error:
            with suppress(OSError):
                part.unlink()
            raise MachineError(f"{path}: {error.strerror or error}") from error
        return name

    def parting(self, one: Row, two: Row) -> int | None:
        """The first tick at which two matches differ; None: nowhere, or it is not known."""
        if one.digest == two.digest or not (one.recording and two.recording):
            return None
        import numpy as np

        told = []
        for row in (one, two):
            try:
                with np.load(self.folder / row.recording, allow_pickle=False) as file:
                    told.append((file["tick"], file["chain"]))
            except (OSError, ValueError, KeyError, BadZipFile):
                return None
        (ticks, first), (others, second) = told
        shorter = min(len(ticks), len(others))
        differ = (first[:shorter] != second[:shorter]).any(axis=1)
        if differ.any():
            return int(ticks[differ.argmax()])
        longer = ticks if len(ticks) > shorter else others
        return int(longer[shorter]) if len(longer) > shorter else None
