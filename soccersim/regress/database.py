"""One SQLite file that one process at a time writes, and its errors in our words.

A journal that is rolled back, not a write-ahead log: such a file can be copied as it is, and works
on the shared disks of clusters, where a write-ahead log does not. A commit waits for the disk; a
match takes longer. The lock is SQLite's own and ends with the process that holds it, however that
ends. On POSIX systems it ends too if this process opens and closes the file by other means.
"""

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Self

from soccersim.problems import InputError, MachineError, Problem

FORMAT = 1  # user_version; raised whenever an older soccersim would not understand the tables
APPLICATION = 0x50CCE251  # application_id: the file is a store
FULL = {sqlite3.SQLITE_FULL, sqlite3.SQLITE_IOERR, sqlite3.SQLITE_READONLY, sqlite3.SQLITE_CANTOPEN}
BUSY = {sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED}


class Database:
    """A file that is open, and this process's alone."""

    def __init__(self, path: Path, tables: str) -> None:
        """Opens it, or makes it with these tables.

        InputError where it is in use, or none of this version; MachineError where it cannot be
        written.
        """
        self.path = path
        with self.told():  # autocommit: transactions begin where transaction() says so
            self.base = sqlite3.connect(path.absolute(), timeout=0.0, isolation_level=None)
        try:
            self._take(tables)
        except BaseException:
            self.base.close()
            raise

    def _take(self, tables: str) -> None:
        """Lock it until it is closed, and see that it is one of ours."""
        self.all("PRAGMA locking_mode = EXCLUSIVE")
        self.all("PRAGMA synchronous = FULL")
        with self.transaction():
            kind, version = self._is()
            if not kind and not self.all("SELECT 1 FROM sqlite_master"):
                for statement in tables.split(";")[:-1]:
                    self.all(statement)
                self.all(f"PRAGMA application_id = {APPLICATION}")
                self.all(f"PRAGMA user_version = {FORMAT}")
                kind, version = self._is()
        if kind != APPLICATION:
            raise self._wrong("is a database of something else: name another file")
        if version != FORMAT:
            wrong = f"has format {version}; this soccersim reads format {FORMAT}: name another file"
            raise self._wrong(wrong)

    def all(self, statement: str, values: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
        """All that a statement answers."""
        with self.told():
            return self.base.execute(statement, values).fetchall()

    def each(self, statement: str) -> Iterator[tuple[Any, ...]]:
        """The same, row by row."""
        with self.told():
            yield from self.base.execute(statement)

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """All that is written within, or nothing of it."""
        self.all("BEGIN EXCLUSIVE")
        try:
            yield
            self.all("COMMIT")
        except BaseException:
            with suppress(sqlite3.Error):  # where it has not been rolled back already
                self.base.execute("ROLLBACK")
            raise

    @contextmanager
    def told(self) -> Iterator[None]:
        """SQLite's errors in our words."""
        try:
            yield
        except sqlite3.Error as error:
            code = getattr(error, "sqlite_errorcode", 0) & 0xFF  # without the details
            if code in BUSY:
                wrong = "another run is using it: wait for that, or name another file"
                raise self._wrong(wrong) from error
            if code in FULL:
                wrong = f"{self.path}: cannot be written ({error})"
                raise MachineError(f"{wrong}; what it holds is whole: make room, go on") from error
            raise self._wrong(f"is no store of results, or damaged ({error})") from error

    def close(self) -> None:
        """Let others have it."""
        self.base.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _is(self) -> tuple[int, int]:
        """What kind of file it is, and of which version."""
        (kind,), (version,) = self.all("PRAGMA application_id") + self.all("PRAGMA user_version")
        return int(kind), int(version)

    def _wrong(self, what: str) -> InputError:
        return InputError(Problem(what, str(self.path)))
