"""The first tick at which two matches differ, from their recordings' chains of digests."""

from dataclasses import replace

import numpy as np
import pytest

from soccersim.regress.recordings import Recordings
from soccersim.regress.row import Row

ROW = Row("key", 0, 0, 1, "a", "b", (0, 0), "one", 60.0, (), ())


@pytest.fixture
def recordings(tmp_path):
    """Writes chains of one number a record, ten ticks apart; gives the rows."""
    kept = Recordings(tmp_path / "results.db")
    kept.folder.mkdir()

    def write(*chains):
        rows = []
        for name, chain in zip("abc", chains, strict=False):
            links = np.repeat(np.array(chain, np.uint8)[:, None], 4, axis=1)
            np.savez(
                kept.folder / f"{name}.npz", tick=10 * np.arange(1, len(chain) + 1), chain=links
            )
            rows.append(replace(ROW, digest=repr(chain), recording=f"{name}.npz"))
        return kept, rows

    return write


def test_it_is_that_of_the_first_record_that_differs(recordings):
    kept, rows = recordings([1, 2, 3, 4], [1, 2, 9, 9])
    assert kept.parting(*rows) == 30


def test_one_that_ends_early_parts_where_the_other_goes_on(recordings):
    kept, rows = recordings([1, 2], [1, 2, 3])
    assert kept.parting(*rows) == kept.parting(*rows[::-1]) == 30


def test_the_same_match_parts_nowhere(recordings):
    kept, rows = recordings([1, 2], [1, 2])
    assert kept.parting(*rows) is None


def test_it_is_not_known_where_a_recording_is_missing_or_damaged(recordings):
    kept, (one, two) = recordings([1, 2], [1, 3])
    assert kept.parting(one, replace(two, recording="")) is None
    assert kept.parting(one, replace(two, recording="gone.npz")) is None
    (kept.folder / "b.npz").write_bytes(b"PK damaged")
    assert kept.parting(one, two) is None
