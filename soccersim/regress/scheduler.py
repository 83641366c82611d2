"""Where a Dask scheduler is, and whether it goes with what is installed here."""

import json
from pathlib import Path
from typing import Any

from soccersim.problems import InputError, MachineError, Problem, one_line

FILE = "file:"
PACKAGES = ("soccersim", "python", "dask", "distributed")  # that both sides must have alike


def address_of(text: str) -> str:
    """The address that --scheduler names: itself, or what a scheduler file holds."""
    if not text.startswith(FILE):
        if "://" in text and not text.endswith("://"):
            return text
        wrong = f"--scheduler {one_line(text)}: is no address"
        raise InputError(Problem(f"{wrong}: tcp://HOST:PORT or file:PATH would be right"))
    path = Path(text.removeprefix(FILE).removeprefix("//"))
    try:
        told = json.loads(path.read_text("utf-8"))
        return str(told["address"])
    except FileNotFoundError as error:
        wrong = f"there is no such file: `dask scheduler --scheduler-file {path}` writes it"
        raise InputError(Problem(wrong, str(path))) from error
    except OSError as error:
        raise MachineError(f"{path}: {error.strerror or error}") from error
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(Problem("is no scheduler file of Dask", str(path))) from error


def compare(client: Any) -> None:
    """InputError where the scheduler has other versions than this machine."""
    versions = client.get_versions(packages=["soccersim"])
    theirs, ours = (versions[side]["packages"] for side in ("scheduler", "client"))
    differ = [name for name in PACKAGES if release(theirs, name) != release(ours, name)]
    if differ:
        told, here = (
            ", ".join(f"{name} {release(side, name)}" for name in differ) for side in (theirs, ours)
        )
        where = client.scheduler.address
        wrong = f"the Dask scheduler at {where} has {told}; here it is {here}"
        raise InputError(Problem(f"{wrong}: install the same there"))


def release(packages: dict[str, Any], name: str) -> str:
    """A version, of Python the first two numbers."""
    told = str(packages.get(name) or "none")
    return ".".join(told.split(".")[:2]) if name == "python" else told
