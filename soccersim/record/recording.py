"""A run as it is kept: arrays over time, and a JSON document that says what they are."""

import json
from dataclasses import dataclass
from errno import ENOENT
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np
from numpy.typing import NDArray

from soccersim.problems import InputError, MachineError, Problem
from soccersim.record.compact import packed, unpacked

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario

FORMAT = 2
LEVEL = 4  # of compression: a fifth of the time that 6 takes, for files 4 % larger
Array = NDArray[Any]
# which arrays go to the file with which word of the scenario's `record`
GROUPS = {
    "poses": ("tick", "chain", "body", "estimate", "reference", "leg"),
    "wheels": ("wheel_angle", "wheel_speed", "slip", "load"),
    "sensors": ("counts", "gyro", "joint"),
    "control": ("command", "wheel_setpoint", "pwm"),
}
PLANS = ("reference", "leg")  # what a match has not
MATCH = (  # D decisions of a match
    "decision_tick",
    "orders",
    "in_play",
    "contact",
    "kicked",
    "ball_believed",
    "ball_sighted",
    "phase",
    "whose",
    "started",
    "score",
    "direction",
)


@dataclass(frozen=True)
class Recording:
    """T records of R robots with up to W wheels, A arms, and B bodies.

    The bodies are the robots, then the ball, then each arm's three links.

    Field frame: origin at the centre spot, x along the length, y left; metres, radians,
    counter-clockwise. Body frame: x forward, y left. Wheels: the driven ones, then the dead
    ones; columns a robot does not have are 0. docs/recording.md tells each array.
    """

    meta: dict[str, Any]
    arrays: dict[str, Array]

    @property
    def tick(self) -> Array:
        """(T,) int64: the physics tick of each record."""
        return self.arrays["tick"]

    @property
    def time(self) -> Array:
        """(T,) s."""
        return self.arrays["tick"] / float(self.meta["physics_hz"])

    @property
    def body(self) -> Array:
        """(T, B, 6): x, y, heading, vx, vy, omega as they truly are; field frame."""
        return self.arrays["body"]

    @property
    def estimate(self) -> Array:
        """(T, R, 3): x, y, heading as each robot believes; field frame."""
        return self.arrays["estimate"]

    @property
    def reference(self) -> Array:
        """(T, R, 3): the set-point x, y, heading; field frame; NaN where there is none."""
        return self.arrays["reference"]

    @property
    def leg(self) -> Array:
        """(T, R) int64: number of the leg or phase each robot is on."""
        return self.arrays["leg"]

    @property
    def ball(self) -> Array | None:
        """(T, 6): the ball's row of body; None where there is no ball."""
        if self.scenario.ball is None:
            return None
        ball: Array = self.body[:, len(self.scenario.robots)]
        return ball

    @property
    def links(self) -> Array:
        """(T, A, 3, 6): the arms' links, each with the pose of its middle."""
        arms = len(self.scenario.arms)
        rows: Array = self.body[:, self.body.shape[1] - 3 * arms :]
        return rows.reshape(len(rows), arms, 3, 6)

    @property
    def digest(self) -> str:
        """SHA-256 chain over the whole run."""
        return str(self.meta["digest"])

    @property
    def duration(self) -> float:
        """Seconds simulated."""
        return float(self.meta["ticks"]) / float(self.meta["physics_hz"])

    @property
    def match(self) -> dict[str, Any] | None:
        """Of a match: teams, score, events, faults, labels, notes (see docs/recording.md)."""
        return self.meta.get("match")

    @property
    def legs(self) -> list[list[dict[str, Any]]]:
        """For each robot its legs, in the field frame (see docs/recording.md)."""
        return list(self.meta["legs"])

    @cached_property
    def scenario(self) -> "Scenario":
        """The scenario that was run, everything in it expanded."""
        from pydantic import ValidationError

        from soccersim.spec.scenario import Scenario

        try:
            return Scenario.model_validate(self.meta["scenario"])
        except ValidationError as error:
            made = f"a recording of soccersim {self.meta.get('soccersim')}"
            raise InputError(Problem(f"{made}, whose scenario this one cannot read")) from error

    def save(self, path: str | PathLike[str]) -> None:
        """Write one .npz without pickles; MachineError where it cannot be written."""
        groups = ("poses", *self.meta["scenario"]["record"])
        names = [*MATCH, *(key for group in groups for key in GROUPS[group])]
        text = json.dumps(self.meta, allow_nan=False).encode()
        kept = {"meta": np.frombuffer(text, np.uint8)}
        kept |= {key: self.arrays[key] for key in names if key in self.arrays}
        pack = packed if self.match is not None else (lambda _, array: array)
        try:
            with ZipFile(path, "w", ZIP_DEFLATED, compresslevel=LEVEL) as file:
                for key, array in kept.items():  # one at a time: as packed they take much room
                    with file.open(f"{key}.npy", "w", force_zip64=True) as entry:
                        np.lib.format.write_array(entry, pack(key, array), allow_pickle=False)
        except OSError as error:
            raise MachineError(f"{path}: {error.strerror or error}") from error

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "Recording":
        """Read what save wrote; InputError where it is not a recording or a newer one."""
        name = fspath(path)
        damaged = InputError(Problem("is not a soccersim recording, or damaged", file=name))
        try:
            if not Path(path).is_file():  # np.load would wait for a pipe
                raise FileNotFoundError(ENOENT, "is not a file")
            with open(path, "rb") as data, np.load(data, allow_pickle=False) as file:
                meta = json.loads(bytes(file["meta"]))
                arrays = {key: file[key] for key in file.files if key != "meta"}
        except OSError as error:
            raise InputError(Problem(f"cannot be read: {error.strerror or error}", name)) from error
        except Exception as error:  # numpy and zipfile raise a dozen kinds over wrong bytes
            raise damaged from error
        if not isinstance(meta, dict):
            raise damaged
        if meta.get("format") != FORMAT:
            wrong = f"has format {meta.get('format')}; this soccersim reads format {FORMAT}"
            raise InputError(Problem(wrong, file=name))
        if not {"tick", "chain", "body", "estimate"} <= arrays.keys():
            raise damaged
        if meta.get("match") is not None:
            arrays = {key: unpacked(key, array) for key, array in arrays.items()}
        return cls(meta, arrays)
