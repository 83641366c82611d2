"""The folder that --out names: files that are whole or not there, and nothing written over."""

import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryFile
from types import TracebackType
from typing import Self

from soccersim.problems import InputError, MachineError, Problem

PART = ".part"  # ends the name of a file that is not whole yet


class Results:
    """A folder for these files. Used as a context it leaves no empty folder behind.

    >>> with Results(out, ("report.json",), force) as results:
    ...     with results.new("report.json") as path:
    ...         path.write_text("{}")
    """

    def __init__(self, folder: Path, names: tuple[str, ...], force: bool = False) -> None:
        self.folder = folder
        self.names = names
        self.written: list[Path] = []
        self._made: list[Path] = []
        if not all(names):  # as Path(".") has none
            raise InputError(Problem("is no name of a file", file=str(folder)))
        try:
            there = [name for name in names if (folder / name).exists()]
        except OSError as error:  # a name too long
            raise failed(folder, error) from error
        if there and not force:
            wrong = f"holds {', '.join(there)} already: choose another folder, or add --force"
            raise InputError(Problem(wrong, file=str(folder)))
        for name in there:
            if (folder / name).is_dir() and not is_of_frames(folder / name):
                wrong = "holds more than frames: move it away, or choose another folder"
                raise InputError(Problem(wrong, file=str(folder / name)))

    def __enter__(self) -> Self:
        """Make the folder and try it, before the work that shall fill it."""
        missing = [path for path in (self.folder, *self.folder.parents) if not path.exists()]
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self._made = missing
            with TemporaryFile(dir=self.folder):
                pass
        except (OSError, ValueError) as error:  # ValueError: a NUL in the name
            self._tidy()
            raise failed(self.folder, error) from error
        return self

    @contextmanager
    def new(self, name: str) -> Iterator[Path]:
        """A path to write to, in place of an older file or folder of this name once it is whole."""
        path, part = self.folder / name, self.folder / (name + PART)
        try:
            remove(part)
            yield part
            remove(path)
            part.replace(path)
        except OSError as error:
            raise failed(path, error) from error
        except MachineError as error:
            raise MachineError(str(error).replace(str(part), str(path))) from error
        finally:
            remove(part)
        self.written.append(path)

    def done(self) -> None:
        """Take away what an earlier run left and this one has not written: it is of another run."""
        for name in self.names:
            if self.folder / name not in self.written:
                remove(self.folder / name)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if not self.written:
            self._tidy()

    def _tidy(self) -> None:
        """Take the folders away that were made for nothing."""
        for path in self._made:
            try:
                path.rmdir()
            except OSError:
                return


def remove(path: Path) -> None:
    """Delete a file, or a folder of frames; a folder with anything else in it stays, with that."""
    try:
        if not path.is_dir():
            path.unlink(missing_ok=True)
        elif is_of_frames(path):
            shutil.rmtree(path)
    except OSError as error:
        raise failed(path, error) from error


def is_of_frames(folder: Path) -> bool:
    """Whether a folder holds nothing but frames."""
    return all(re.fullmatch(r"\d{6}\.png", entry.name) for entry in folder.iterdir())


def failed(path: Path, error: Exception) -> MachineError:
    """What the machine would not do, with the path it would not do it to."""
    if isinstance(error, FileExistsError):
        return MachineError(f"{path}: is a file, and a folder is needed")
    return MachineError(f"{path}: {getattr(error, 'strerror', None) or error}")
