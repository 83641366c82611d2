"""The papers' tables: every figure as in the papers' text, and what sums them up recomputed."""

import numpy as np
import paper_text as paper
import pytest

from soccersim.reproduce.tables import OURS, table

with_papers = pytest.mark.skipif(
    not paper.FOLDER.is_dir(), reason="the papers' texts are not beside this checkout"
)
MOTORS = (2, 3, 4)


def printed(name, **where):
    """A table's rows as printed, without our columns; those rows that match."""
    return [
        [text for column, text in row.items() if column not in OURS]
        for row in table(name).printed
        if where.items() <= row.items()
    ]


def summing_up(place, number=None):
    """The figures that sum up one of Idris' tables, or any, as printed in one place."""
    where = {"place": place} | ({"table": str(number)} if number else {})
    return [row[-1] for row in printed("idris-summaries", **where)]


# Not a figure is mistyped


@with_papers
@pytest.mark.parametrize("number", range(1, 8))
def test_idris_tables_are_as_printed(number):
    assert printed(f"idris-table{number}") == paper.idris_table(number)


@with_papers
@pytest.mark.parametrize("number", range(1, 7))
def test_idris_last_rows_are_as_printed(number):
    assert summing_up("table", number) == paper.idris_last_row(number)


@with_papers
def test_idris_text_sums_up_as_printed():
    greatest, mean = paper.idris_text(r"more than (\d+) degrees.*?value is ([\d.]+)%")
    assert summing_up("text", 1) == [mean, greatest]
    sides = r"left wheel is ([\d.]+) cm, .*right wheel is ([\d.]+) cm, .*rear wheel is ([\d.]+) cm"
    assert summing_up("text", 5) == paper.idris_text(sides)


@with_papers
def test_idris_abstract_and_conclusion_sum_up_as_printed():
    x, y, theta = paper.idris_text(r"x = ([\d.]+)%, y = ([\d.]+)%, and Theta = ([\d.]+)%")
    times = paper.idris_text(r"time of (\d)-(\d) seconds")
    assert summing_up("abstract") == [x, y, theta, *times]
    errors = r"x coordinate =([\d.]+)%, y coordinate =([\d.]+)% and theta=([\d.]+)%"
    assert summing_up("conclusion") == paper.idris_text(errors)
    columns = [f"table{row[1]} {row[2]}" for row in printed("idris-summaries", place="abstract")]
    assert columns == ["table6 x", "table6 y", "table6 theta", "table7 time", "table7 time"]
    assert summing_up("conclusion", 6) == summing_up("conclusion")


@with_papers
@pytest.mark.parametrize("number", [1, 2])
def test_the_arms_tables_are_as_printed(number):
    assert printed(f"dasmahapatra-table{number}") == paper.arm_table(number)


@with_papers
@pytest.mark.parametrize(
    ("run", "task"),
    [("defender", "a defense"), ("midfielder", "a midfielder"), ("striker", "a striker")],
)
def test_utamas_points_are_as_printed(run, task):
    *points, headings = paper.utama_run(task)
    if run == "midfielder":
        headings *= 2  # "when it reaches the point B is the same with point C"
    for quantity, as_printed in zip(("commanded", "sensor", "measured"), points, strict=True):
        rows = printed("utama-points", run=run, quantity=quantity)
        assert [row[1] for row in rows] == list("ABC"[: len(rows)])
        assert [row[3:5] for row in rows] == as_printed
        given = {"commanded": ["0"] * len(rows), "sensor": ["", *headings]}
        assert [row[5] for row in rows] == given.get(quantity, [""] * len(rows))


@with_papers
def test_utamas_square_is_as_printed():
    assert [row[2] for row in printed("utama-square")] == paper.utama_square()
    assert [row[0] for row in printed("utama-square")] == list("1234")


@with_papers
def test_garcias_table_is_as_printed():
    as_printed = paper.garcia_table()
    for parameter in ("alpha", "beta", "gamma"):
        rows = printed("garcia-table1", parameter=parameter)
        assert [row[0] for row in rows] == list("123")
        assert [row[2] for row in rows] == as_printed[parameter]
    for parameter in ("delta", "lambda"):
        axes = [printed("garcia-table1", parameter=f"{parameter}_{axis}") for axis in "xyz"]
        found = [[row[2] for row in wheel] for wheel in zip(*axes, strict=True)]
        assert found == [word.strip("()").split(",") for word in as_printed[parameter]]


def test_garcias_values_are_what_is_printed():
    sizes = {"L": 1.0, "L/2": 0.5, "L sqrt(3)/2": 0.75**0.5}
    rows = table("garcia-table1").rows
    assert [row["wheel"] for row in rows] == 9 * [1] + 9 * [2] + 9 * [3]
    for row in rows:
        as_printed, value = row["printed"], row["value"]
        if isinstance(as_printed, str):
            as_printed = sizes[as_printed.strip("-")] * (-1 if as_printed[0] == "-" else 1)
        assert value == pytest.approx(as_printed, abs=1e-15)


# What the papers say of their tables, recomputed


def percent(deviation, reference):
    """|deviation| / reference in %, 0 where the reference is 0, as Idris has it."""
    return 100 * np.divide(deviation, reference, out=np.zeros(len(reference)), where=reference != 0)


def test_idris_gyroscope_errs_by_1_05_percent_not_by_1_24():
    gyro = table("idris-table1")
    real, error = gyro.numbers("real"), gyro.numbers("error")
    ours = percent(np.abs(gyro.numbers("gyro") - real), real)
    assert np.abs(ours - error).max() < 0.005
    assert len(error) == 20
    assert round(ours.mean(), 2) == 1.05


def test_idris_gyroscope_errs_by_more_than_2_degrees_twice():
    gyro = table("idris-table1")
    error = np.abs(gyro.numbers("gyro") - gyro.numbers("real"))
    assert (error > 2).nonzero()[0].tolist() == [9, 18]  # rows 10 and 19
    assert error[[9, 18]] == pytest.approx([2.20, 9.10])


def motor_errors(number):
    """Printed, over the encoder's speed, and over the tachometer's; % each."""
    motor = table(f"idris-table{number}")
    real, encoder = motor.numbers("real"), motor.numbers("encoder")
    deviation = np.abs(encoder - real)
    return motor.numbers("error"), percent(deviation, encoder), percent(deviation, real)


@pytest.mark.parametrize(("number", "mean"), [(2, 0.66), (3, 0.84), (4, 0.53)])
def test_idris_motors_err_by_the_means_printed_over_the_encoders_speed(number, mean):
    error, by_encoder, by_tachometer = motor_errors(number)
    assert len(error) == 27
    assert round(by_encoder.mean(), 2) == mean
    assert round(by_tachometer.mean(), 2) > mean


def test_idris_motors_errors_are_over_the_encoders_speed_in_every_row():
    agree = [
        [(np.abs(error - ours) < 0.005 + 1e-9).sum() for ours in by]
        for error, *by in map(motor_errors, MOTORS)
    ]
    assert np.sum(agree, axis=0).tolist() == [81, 53]  # the encoder's, the tachometer's


def mileage_errors(side):
    """In cm, and in % of the real distance."""
    mileage = table("idris-table5")
    deviation = np.abs(mileage.numbers(side) - mileage.numbers("real"))
    return deviation, percent(deviation, mileage.numbers("real"))


@pytest.mark.parametrize(
    ("side", "centimetres", "share"),
    [("right", 0.052, 0.1124), ("left", 0.046, 0.1017), ("back", 0.039, 0.0832)],
)
def test_idris_mileage_errs_by_percentages_the_paper_does_not_print(side, centimetres, share):
    deviation, error = mileage_errors(side)
    assert deviation.mean() == pytest.approx(centimetres)
    assert error.mean() == pytest.approx(share, abs=5e-5)


def test_idris_mileage_is_whole_pulses_of_0_1164_cm_but_for_two_figures():
    mileage = table("idris-table5")
    figures = np.array([mileage.numbers(side) for side in ("right", "left", "back")])
    pulses = np.round(figures / 0.1164)
    odd = np.abs(pulses * 0.1164 - figures) > 0.005
    assert figures[odd].tolist() == [29.94, 100.02]
    quarters = np.round(figures / 0.0291)
    assert np.abs(quarters * 0.0291 - figures).max() < 0.005 + 1e-9


def forward_kinematic_errors(column):
    """Signed, % of the real value, 0 where that is 0."""
    kinematic = table("idris-table6")
    real = kinematic.numbers(column)
    return percent(kinematic.numbers(f"measured_{column}", corrected=True) - real, real)


def test_idris_x_errs_by_5_371552_percent_exactly():
    assert f"{np.abs(forward_kinematic_errors('x')).sum() / 20:.6f}" == "5.371552"


def test_idris_y_errs_by_5_200101_percent_signed_without_row_1_and_properly_by_5_4601():
    error = forward_kinematic_errors("y")
    assert f"{error[1:].sum() / 20:.6f}" == "5.200101"
    assert f"{np.abs(error).mean():.4f}" == "5.4601"


def test_idris_theta_errs_by_0_38_percent_and_no_rule_gives_0_265778():
    error = forward_kinematic_errors("theta")
    assert np.abs(error).sum() / 20 == pytest.approx(0.38)
    sums = np.array([np.abs(error).sum(), error.sum(), error[1:].sum(), error[:-1].sum()])
    for rows in (15, 16, 19, 20):
        assert np.abs(sums / rows - 0.265778).min() > 1e-3


def test_idris_moves_take_up_to_4_8_s_and_half_of_them_more_than_4():
    time = table("idris-table7").numbers("time")
    assert (time.min(), time.max(), (time > 4).sum(), len(time)) == (3.1, 4.8, 8, 16)


def test_idris_moves_towards_0_are_the_faster_ones_every_time():
    time = table("idris-table7").numbers("time")
    assert (time[1::2] < time[::2]).all()
    assert time[1::2].mean() == pytest.approx(3.7375)
    assert time[::2].mean() == pytest.approx(4.1125)


def test_idris_moves_go_3_m_along_x_and_4_5_m_along_y_against_the_text():
    moves = table("idris-table7")
    assert set(moves.numbers("end_x")) == {0, 300}
    assert set(moves.numbers("end_y")) == {0, 450}


def recomputed(number, column, what):
    """What a figure that sums up one of Idris' tables should have been."""
    rows = table(f"idris-table{number}")
    if number == 1:
        real, gyro = rows.numbers("real"), rows.numbers("gyro")
        error = np.abs(gyro - real)
        return error.max() if what == "greatest error" else percent(error, real).mean()
    if number == 5:
        return mileage_errors(column)[1].mean()
    if number == 6:
        return np.abs(forward_kinematic_errors(column)).mean()
    time = rows.numbers("time")
    return time.min() if what == "shortest" else time.max()


def test_our_corrections_of_what_sums_up_idris_tables_are_what_the_rows_give():
    corrections = [row for row in table("idris-summaries").printed if row["misprint"]]
    assert len(corrections) == 16
    for row in corrections:
        ours = recomputed(int(row["table"]), row["column"], row["what"])
        decimals = len(row["corrected"].partition(".")[2])
        assert row["corrected"] == f"{ours:.{decimals}f}"
        assert row["printed"] != row["corrected"]
