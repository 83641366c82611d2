"""The recordings of a run that are kept: in a folder beside the store, whole or not at all."""

import os
from contextlib import suppress
from pathlib import Path

from soccersim.problems import MachineError
from soccersim.regress.leg import Leg

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
