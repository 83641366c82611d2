"""A paper's table as data: numbers, missing cells, corrections, and what is told of each."""

import numpy as np
import pytest

from soccersim.reproduce.tables import OURS, names, table


@pytest.mark.parametrize("name", names())
def test_a_table_says_what_its_columns_are_and_why_a_figure_is_wrong(name):
    one = table(name)
    assert all((one.paper, one.title, one.source, one.rows))
    assert tuple(one.columns)[-3:] == OURS
    assert all(tuple(row) == tuple(one.columns) for row in one.rows)
    assert set(one.units) <= set(one.columns)
    for row in one.rows:
        assert (row["misprint"] is None) == (row["corrected"] is None)
        assert row["misprint"] is None or (row["misprint"] in one.columns and row["note"])


def test_a_table_gives_numbers_as_printed_and_corrected():
    arm = table("dasmahapatra-table1")
    assert arm.numbers("x")[23] == -13.1118
    assert arm.numbers("x", corrected=True)[23] == -13.11803
    assert (arm.numbers("y") == arm.numbers("y", corrected=True)).sum() == 49
    assert [row["no"] for row in arm.misprints] == [24, 25]
    assert arm.units["x"] == "cm"


def test_a_missing_figure_is_none_in_a_column_and_nan_among_numbers():
    points = table("utama-points")
    assert points.column("heading")[2] is None
    assert np.isnan(points.numbers("heading")[2])


def test_a_column_with_text_is_not_numbers_until_corrected():
    kinematic = table("idris-table6")
    assert kinematic.column("measured_theta")[19] == "1.46t"
    with pytest.raises(
        ValueError, match=r"'measured_theta' of idris-table6 has text in it: '1.46t'"
    ):
        kinematic.numbers("measured_theta")
    assert kinematic.numbers("measured_theta", corrected=True)[19] == 1.46


def test_a_name_that_is_not_there_is_told_with_those_that_are():
    with pytest.raises(ValueError, match=r"no table 'idris-table8': there are .*idris-table7"):
        table("idris-table8")
    with pytest.raises(ValueError, match=r"has no column 'rpm': it has no, real, gyro"):
        table("idris-table1").column("rpm")
