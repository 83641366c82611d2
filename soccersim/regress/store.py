"""The store of a run: what came out, leg by leg, each in a transaction of its own."""

import json
import time
import zlib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from soccersim.regress.bundle import Bundle
from soccersim.regress.database import Database
from soccersim.regress.row import Row

TABLES = """
CREATE TABLE legs (
    key TEXT PRIMARY KEY, pair INTEGER, leg INTEGER, seed INTEGER, home TEXT, away TEXT,
    home_goals INTEGER, away_goals INTEGER, digest TEXT, duration REAL, faults TEXT, events BLOB,
    seconds REAL, overhead REAL, again TEXT, void TEXT, recording TEXT
) WITHOUT ROWID;
CREATE TABLE contradictions (
    key TEXT, pair INTEGER, leg INTEGER, first TEXT, digest TEXT, PRIMARY KEY (key, digest)
) WITHOUT ROWID;
CREATE TABLE bundles (sha TEXT PRIMARY KEY, name TEXT, data BLOB);
CREATE TABLE notes (name TEXT PRIMARY KEY, text TEXT);
"""
ORDER = "ORDER BY pair, leg, key"


class Contradiction(NamedTuple):
    """A leg that was played twice and came out differently."""

    key: str
    pair: int
    leg: int
    first: str  # digest of the row that is kept
    digest: str  # the other one


class Store(Database):
    """A store that is open, and this process's alone.

    >>> with Store(path) as store:
    ...     store.add(row)
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path, TABLES)
        self.seconds = 0.0  # that the last add() took
        self.added = 0  # legs, since it was opened

    def add(self, *rows: Row) -> None:
        """Keep rows, all or none. One that is there stays; if it came out otherwise, that is kept.

        What was void gives way to what is not.
        """
        start = time.perf_counter()
        with self.transaction():
            added = sum(self._add(row, self.row(row.key)) for row in rows)
        self.added += added
        self.seconds = time.perf_counter() - start

    def _add(self, row: Row, there: Row | None) -> bool:
        """Whether it is one more."""
        if there is None or (there.void and not row.void):
            self.all(f"REPLACE INTO legs VALUES ({', '.join('?' * 17)})", packed(row))
        elif contradicts(row, there):
            found = Contradiction(row.key, row.pair, row.leg, there.digest, row.digest)
            self.all("INSERT OR IGNORE INTO contradictions VALUES (?, ?, ?, ?, ?)", found)
        return there is None

    def record(self, key: str, recording: str) -> None:
        """Note the recording of a leg that is there."""
        with self.transaction():
            self.all("UPDATE legs SET recording = ? WHERE key = ?", (recording, key))

    def row(self, key: str) -> Row | None:
        """The row of a leg; None where it has not been played."""
        found = self.all("SELECT * FROM legs WHERE key = ?", (key,))
        return unpacked(found[0]) if found else None

    def rows(self) -> Iterator[Row]:
        """All rows, by pair and leg."""
        yield from map(unpacked, self.each(f"SELECT * FROM legs {ORDER}"))

    def count(self) -> int:
        """How many legs are kept."""
        return int(self.all("SELECT COUNT(*) FROM legs")[0][0])

    def contradictions(self) -> list[Contradiction]:
        """The legs that came out differently when they were played again."""
        return [Contradiction(*row) for row in self.all(f"SELECT * FROM contradictions {ORDER}")]

    def keep_contradictions(self, found: Iterable[Contradiction]) -> None:
        """Keep those that another store has found."""
        with self.transaction():
            for each in found:
                self.all("INSERT OR IGNORE INTO contradictions VALUES (?, ?, ?, ?, ?)", each)

    def forget_void(self) -> None:
        """Forget the legs that the machine failed to play, so that they are played after all."""
        with self.transaction():
            self.all("DELETE FROM legs WHERE void != ''")

    def keep_bundles(self, bundles: Iterable[Bundle]) -> None:
        """Keep the code of the teams, so that what was played can be looked at later."""
        with self.transaction():
            for bundle in bundles:
                values = (bundle.sha, bundle.name, bundle.data)
                self.all("INSERT OR IGNORE INTO bundles VALUES (?, ?, ?)", values)

    def bundles(self) -> dict[str, Bundle]:
        """The teams that have played, by their SHA-256."""
        found = self.all("SELECT sha, name, data FROM bundles")
        return {sha: Bundle(name, data) for sha, name, data in found}

    def note(self, name: str, text: str) -> None:
        """Keep a text under a name: the command, say."""
        with self.transaction():
            self.all("REPLACE INTO notes VALUES (?, ?)", (name, text))

    def noted(self, name: str) -> str:
        """The text of this name; "" where there is none."""
        found = self.all("SELECT text FROM notes WHERE name = ?", (name,))
        return str(found[0][0]) if found else ""


def contradicts(row: Row, other: Row) -> bool:
    """Whether one match came out in two ways: void ones and doubtful faults say nothing of it."""
    sure = not any(each.void or each.is_doubtful for each in (row, other))
    return sure and row.digest != other.digest


def packed(row: Row) -> tuple[Any, ...]:
    """A row as the table has it."""
    return (
        *(row.key, row.pair, row.leg, row.seed, row.home, row.away, *row.score),
        *(row.digest, row.duration, json.dumps(row.faults)),
        zlib.compress(json.dumps(row.events).encode()),
        *(row.seconds, row.overhead, row.again, row.void, row.recording),
    )


def unpacked(found: tuple[Any, ...]) -> Row:
    """The row that packed was given."""
    key, pair, leg, seed, home, away, ours, theirs, digest, duration, faults, events, *rest = found
    told = tuple(json.loads(zlib.decompress(events)))
    score, wrongs = (ours, theirs), tuple(json.loads(faults))
    return Row(key, pair, leg, seed, home, away, score, digest, duration, wrongs, told, *rest)
