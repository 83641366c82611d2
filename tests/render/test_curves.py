"""`soccersim plot`: what it draws of whom, and what it says it leaves out."""

import numpy as np
import pytest
from factory import bundled, player, simulate
from synthetic_match import match

from soccersim.problems import InputError, MachineError
from soccersim.render.curve_plots import curve_figure, plot_kind, save_curves, wheeled
from soccersim.render.curves import curves


@pytest.fixture(scope="module")
def run():
    """One robot with three driven and three dead wheels on its way."""
    return simulate(player(bundled("utama"), (1, 0.5, 90), name="runner"), duration=1.0)


@pytest.fixture(scope="module")
def two():
    """Two robots without plans."""
    return simulate(
        player(bundled("garcia"), name="one"),
        player(bundled("garcia"), name="two", start=(2, 0, 0)),
        duration=0.2,
    )


def labels(figure):
    return [panel.get_ylabel() for panel in figure.axes]


def words(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def panel(figure, label):
    return figure.axes[labels(figure).index(label)]


def test_a_run_shows_pose_errors_wheels_slip_and_pwm_with_their_units(run):
    drawn, told = curves([("run.npz", run)])
    figure = curve_figure(drawn, "run")
    assert labels(figure) == [
        "x (m)",
        "y (m)",
        "heading (deg)",
        "position error (cm)",
        "heading error (deg)",
        "wheel speed (rad/s)",
        "slip (m/s)",
        "PWM (of 255)",
    ]
    assert told == []
    assert words(figure)[:3] == ["true", "believed", "set-point"]
    assert "wheel 4 (no motor)" in words(figure)


def test_lines_are_the_recorded_numbers(run):
    figure = curve_figure(curves([("run.npz", run)])[0], "run")
    commanded, believed, true = panel(figure, "heading (deg)").lines
    assert true.get_ydata() == pytest.approx(np.degrees(run.body[:, 0, 2]))
    assert believed.get_ydata() == pytest.approx(np.degrees(run.estimate[:, 0, 2]))
    assert commanded.get_ydata() == pytest.approx(np.degrees(run.reference[:, 0, 2]), nan_ok=True)
    apart = run.estimate[:, 0, :2] - run.body[:, 0, :2]
    (error,) = panel(figure, "position error (cm)").lines
    assert error.get_ydata() == pytest.approx(100 * np.hypot(*apart.T))
    (turned,) = panel(figure, "heading error (deg)").lines
    off = run.estimate[:, 0, 2] - run.body[:, 0, 2]
    assert turned.get_ydata() == pytest.approx(np.degrees(off))
    slips = [line.get_ydata() for line in panel(figure, "slip (m/s)").lines]
    assert np.array_equal(np.array(slips).T, run.arrays["slip"][:, 0])
    pwms = [line.get_ydata() for line in panel(figure, "PWM (of 255)").lines]
    assert np.array_equal(np.array(pwms).T, run.arrays["pwm"][:, 0, :3])
    assert true.get_xdata()[-1] == run.time[-1]


def test_recordings_lie_over_one_another_under_the_names_of_their_files(run):
    drawn, _ = curves([("a/recording.npz", run), ("b/recording.npz", run)])
    figure = curve_figure(drawn, "two runs")
    assert words(figure)[3:5] == ["a", "b"]
    assert len(panel(figure, "position error (cm)").lines) == 2
    assert len(panel(figure, "PWM (of 255)").lines) == 6


def test_of_several_recordings_the_first_robot_is_shown_and_that_is_said(run, two):
    drawn, told = curves([("run.npz", run), ("two.npz", two)])
    assert [curve.label for curve in drawn] == ["run", "two"]
    assert told == ["two.npz: 2 robots; the first is shown, --robot NAME chooses"]
    chosen, told = curves([("b.npz", two)], robots=("two",))
    assert ([curve.label for curve in chosen], told) == (["two"], [])
    assert chosen[0].true[0, 0] == 2.0


def test_a_robot_that_is_not_there_is_refused_with_those_that_are(two):
    with pytest.raises(InputError) as refused:
        curves([("two.npz", two)], robots=("tow",))
    assert str(refused.value) == "two.npz: has no robot tow: there are one, two"


def test_what_was_not_recorded_is_left_out_and_said():
    bare = simulate(player(bundled("garcia")), duration=0.1, record=["control"])
    drawn, told = curves([("bare.npz", bare)])
    assert told == [
        "bare.npz: holds no wheel speeds and slip: `record` of its scenario lacks wheels"
    ]
    assert labels(curve_figure(drawn, ""))[5:] == ["PWM (of 255)"]


def test_ten_robots_have_a_column_a_side_and_a_colour_each():
    drawn, _ = curves([("match.npz", match(4.0))])
    figure = curve_figure(drawn, "match")
    assert wheeled(drawn) == []
    assert [axes.get_title() for axes in figure.axes[::5]] == ["home", "away"]
    assert [len(axes.lines) for axes in figure.axes] == [5] * 10
    colours = {line.get_color() for axes in figure.axes for line in axes.lines}
    assert len(colours) == 10
    heights = [axes.get_ylim() for axes in figure.axes]
    assert heights[:5] == heights[5:]


def test_headings_of_many_stay_within_half_a_turn_without_strokes_across():
    scene = match(20.0)
    for axes in curve_figure(curves([("m.npz", scene)])[0], "").axes[2::5]:
        for line in axes.lines:
            heading = line.get_ydata()
            assert np.nanmax(np.abs(heading)) <= 180
            steps = np.abs(np.diff(heading))
            assert np.nanmax(steps) < 170


def test_no_words_lie_on_one_another(run, tmp_path):
    long = "a-long-name-of-a-recording" * 2
    several = [(f"{long}{i}.npz", run) for i in range(3)]
    for recordings in ([("a.npz", run)], several, [("m.npz", match(4.0))]):
        figure = curve_figure(curves(recordings)[0], "a title")
        figure.canvas.draw()
        boxes = [legend.get_window_extent() for legend in figure.legends if legend.get_texts()]
        boxes += [text.get_window_extent() for text in figure.texts]
        boxes += [axes.get_tightbbox() for axes in figure.axes]
        frame = figure.bbox
        for i, box in enumerate(boxes):
            assert frame.x0 <= box.x0
            assert box.x1 <= frame.x1
            assert not any(box.overlaps(other) for other in boxes[i + 1 :])


@pytest.mark.parametrize(
    ("kind", "begins"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")]
)
def test_the_ending_names_the_format_and_bytes_come_out_the_same(run, tmp_path, kind, begins):
    drawn, _ = curves([("run.npz", run)])
    for name in ("first", "second"):
        save_curves(drawn, "run", tmp_path / f"{name}.{kind}")
    first = (tmp_path / f"first.{kind}").read_bytes()
    assert first.startswith(begins)
    assert first == (tmp_path / f"second.{kind}").read_bytes()


def test_another_ending_is_refused_in_one_line():
    with pytest.raises(
        InputError, match=r"^run\.jpg: a plot's name ends in \.png, \.svg or \.pdf$"
    ):
        plot_kind("run.jpg")


def test_a_plot_that_cannot_be_written_is_named(run, tmp_path):
    with pytest.raises(MachineError, match="nowhere"):
        save_curves(curves([("r.npz", run)])[0], "", tmp_path / "nowhere" / "run.png")


def test_no_line_leads_to_where_a_robot_is_carried():
    recording = match(1.0)
    recording.body[25:, 1, :2] += 6.0
    (curve,) = curves([("m.npz", recording)], (recording.scenario.robots[1].name,))[0]
    assert np.flatnonzero(np.isnan(curve.true[:, 0])).tolist() == [25]
    assert np.isnan(curve.believed[25]).all()
