"""trajectory.png: it shows what the recording says, in the scenario's frame, with its units."""

from dataclasses import replace
from time import perf_counter

import matplotlib
import numpy as np
import pytest
from gliding import (
    ALL,
    DEFENDER,
    KICKABOUT,
    KRSBI,
    MIRRORED,
    OPEN_LOOP,
    ROLES,
    SQUARE,
    player,
    scenario,
    synthetic,
)
from matplotlib.colors import to_hex
from matplotlib.patches import Polygon
from matplotlib.quiver import Quiver

from soccersim.problems import MachineError
from soccersim.render import markings
from soccersim.render.plots import save_trajectory, trajectory_figure
from soccersim.render.tracks import framed, letter, tracks
from soccersim.spec.field import Field

every_kind = pytest.mark.parametrize("spec", ALL.values(), ids=ALL.keys())


def line(axes, name):
    """The points of the line with this beginning of a label."""
    return next(x for x in axes.get_lines() if str(x.get_label()).startswith(name)).get_xydata()


def labels(axes):
    return axes.get_legend_handles_labels()[1]


def seen(figure):
    """The words in the figure."""
    return " ".join(text.get_text() for text in figure.texts)


@every_kind
def test_the_true_and_believed_paths_end_where_the_recording_says(spec):
    recording = synthetic(spec)
    top_view = trajectory_figure(recording).axes[0]
    at = recording.scenario.coordinates
    for name, pose in (("true", recording.body[-1, 0]), ("believed", recording.estimate[-1, 0])):
        x, y, _ = at.from_field(tuple(pose[:3]))
        assert line(top_view, name)[-1] == pytest.approx((x, y), abs=1e-9)


@every_kind
def test_every_axis_has_a_label_with_its_unit(spec):
    top_view, *panels, drift = trajectory_figure(synthetic(spec)).axes[:6]
    assert (top_view.get_xlabel(), top_view.get_ylabel()) == ("x (m)", "y (m)")
    assert [p.get_ylabel() for p in panels[:3]] == ["x (m)", "y (m)", "heading (deg)"]
    assert panels[3].get_ylabel().endswith("drift (cm)")
    assert panels[3].get_xlabel() == "time (s)"
    assert drift.get_ylabel().endswith("heading drift (deg)")


def test_utamas_defender_is_seen_in_his_own_axes():
    top_view = trajectory_figure(synthetic(DEFENDER)).axes[0]
    assert line(top_view, "commanded") == pytest.approx(np.array([(0, 0), (0, 2), (-2.5, 2)]))


def test_the_papers_points_are_marked_where_it_measured_them():
    top_view = trajectory_figure(synthetic(DEFENDER)).axes[0]
    assert line(top_view, "paper: odometry") == pytest.approx(
        np.array([(0.0202, 2.003), (-2.468, 2.031)])
    )
    measured = line(top_view, "paper: measured")
    assert measured == pytest.approx(np.array([(0.03, 1.981), (-2.301, 2.05)]))


def test_a_paper_that_measured_nothing_leaves_no_marks():
    assert not any("paper" in name for name in labels(trajectory_figure(synthetic(SQUARE)).axes[0]))


def test_a_y_axis_to_the_right_is_drawn_downwards_so_that_we_look_from_above():
    assert trajectory_figure(synthetic(MIRRORED)).axes[0].yaxis_inverted()
    assert not trajectory_figure(synthetic(SQUARE)).axes[0].yaxis_inverted()


@pytest.mark.parametrize("spec", [DEFENDER, MIRRORED])
def test_the_field_lies_in_the_scenarios_frame_like_everything_else(spec):
    recording = synthetic(spec)
    floor = next(p for p in trajectory_figure(recording).axes[0].patches if type(p) is Polygon)
    scenario = recording.scenario
    corners = [scenario.coordinates.to_field((x, y, 0.0))[:2] for x, y in floor.get_xy()]
    board = (scenario.field.half_length + 1.0, scenario.field.half_width + 1.0)
    assert np.abs(corners) == pytest.approx(np.array([board] * len(corners)))


@pytest.mark.parametrize("spec", [DEFENDER, MIRRORED, SQUARE])
def test_arrays_of_poses_are_converted_as_single_poses_are(spec):
    at = synthetic(spec).scenario.coordinates
    poses = np.random.default_rng(1).uniform(-5, 5, (20, 3))
    expected = np.array([at.from_field(tuple(pose)) for pose in poses])
    assert framed(at, poses) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("spec", [DEFENDER, MIRRORED])
def test_the_arrows_point_where_the_robot_faces(spec):
    recording = synthetic(spec)
    at = recording.scenario.coordinates
    arrows = next(
        c for c in trajectory_figure(recording).axes[0].collections if isinstance(c, Quiver)
    )
    x, y, heading = recording.body[0, 0, :3]
    ahead = at.from_field((x + np.cos(heading), y + np.sin(heading), heading))
    here = at.from_field((x, y, heading))
    assert (arrows.U[0], arrows.V[0]) == pytest.approx(np.subtract(ahead, here)[:2], abs=1e-9)


def test_headings_go_on_beyond_half_a_turn_without_a_jump():
    recording = synthetic(SQUARE)
    wrapped = {
        name: np.where(
            np.arange(array.shape[-1]) == 2, (array + np.pi) % (2 * np.pi) - np.pi, array
        )
        for name, array in recording.arrays.items()
        if name in ("body", "estimate")
    }
    figure = trajectory_figure(replace(recording, arrays=recording.arrays | wrapped))
    for name in ("true", "believed"):
        heading = line(figure.axes[3], name)[:, 1]
        assert heading[-1] == pytest.approx(270, abs=5)
        assert np.abs(np.diff(heading)).max() < 10


def test_the_drift_is_how_far_truth_and_belief_lie_apart():
    recording = synthetic(DEFENDER)
    *_, panel, right = trajectory_figure(recording).axes[:6]
    x, y, heading = (recording.body[-1, 0, :3] - recording.estimate[-1, 0]).T
    assert panel.get_lines()[0].get_ydata()[-1] == pytest.approx(100 * np.hypot(x, y))
    assert right.get_lines()[0].get_ydata()[-1] == pytest.approx(abs(np.degrees(heading)))


def test_a_drift_of_less_than_a_centimetre_is_told_in_millimetres():
    figure = trajectory_figure(synthetic(SQUARE, slip=0.999, turned=0.0))
    assert figure.axes[4].get_ylabel().endswith("drift (mm)")


def test_a_place_has_one_letter_however_often_it_is_visited():
    recording = synthetic(SQUARE, laps=2)
    run = tracks(recording)[0]
    assert "".join(letter(end.place) for end in run.ends) == "BCDABCDA"
    assert [letter(place) for place in (0, 25, 26, 52)] == ["A", "Z", "A1", "A2"]


def test_a_leg_that_timed_out_is_marked_and_counted():
    figure = trajectory_figure(synthetic(MIRRORED, lost={1}))
    assert "true end, timed out" in labels(figure.axes[0])
    assert "2 of 3 legs reached" in seen(figure)
    assert "true end, timed out" not in labels(trajectory_figure(synthetic(MIRRORED)).axes[0])


def test_open_loop_driving_has_no_commanded_path():
    figure = trajectory_figure(synthetic(OPEN_LOOP))
    assert "commanded path" not in labels(figure.axes[0])
    assert np.isnan(line(figure.axes[1], "commanded")[:, 1]).all()
    assert "legs reached" not in seen(figure)


def test_the_ball_is_followed_where_there_is_one():
    ball = line(trajectory_figure(synthetic(ROLES)).axes[0], "ball")
    assert ball[0] == pytest.approx((0.5, 0.0))
    assert not any("ball" in name for name in labels(trajectory_figure(synthetic(SQUARE)).axes[0]))


def test_ten_robots_have_ten_colours_the_same_in_every_panel():
    figure = trajectory_figure(synthetic(KICKABOUT))
    seen = [
        [to_hex(x.get_color()) for x in axes.get_lines() if str(x.get_label()).startswith("true")]
        for axes in figure.axes[:4]
    ]
    assert len(set(seen[0])) == 10
    assert seen[1:] == seen[:1] * 3


def test_of_more_than_ten_robots_it_says_that_ten_are_shown():
    many = [
        player(f"robot {i}", [i - 10.5, (-1) ** i * 5, 90], [[i - 10, 0, 0]]) for i in range(22)
    ]
    figure = trajectory_figure(synthetic(KICKABOUT | {"robots": many}))
    assert "22 robots (10 shown)" in seen(figure)


@every_kind
def test_everything_that_moves_stays_in_view(spec):
    top_view = trajectory_figure(synthetic(spec)).axes[0]
    low, high = np.sort([top_view.get_xlim(), top_view.get_ylim()], axis=1).T
    for name in ("true", "believed"):
        points = line(top_view, name)
        assert (points > low).all()
        assert (points < high).all()


def test_every_marking_lies_within_the_boards():
    field = Field.model_validate(KRSBI)
    for drawn in [*markings.lines(field), *markings.goals(field), markings.spots(field)]:
        assert (np.abs(drawn) <= (field.half_length + 1, field.half_width + 1)).all()


def test_a_bare_field_has_its_outline_and_its_halfway_line():
    assert len(markings.lines(Field(length=9.0, width=6.0, goal={"width": 2.0}))) == 2


@every_kind
def test_a_picture_is_written(spec, tmp_path):
    save_trajectory(synthetic(spec), tmp_path / "trajectory.png")
    assert (tmp_path / "trajectory.png").read_bytes().startswith(b"\x89PNG")


def test_any_name_can_be_drawn(tmp_path):
    robots = player("_$x_7 机器人", [0, 0, 0], [[1, 0, 0]]), player("$", [0, 2, 0])
    spec = scenario(*robots, name="$frac{")
    save_trajectory(synthetic(spec), tmp_path / "trajectory.png")


def test_a_run_of_a_single_record_can_be_drawn(tmp_path):
    recording = synthetic(DEFENDER)
    first = {name: array[:1] for name, array in recording.arrays.items()}
    short = replace(recording, meta=recording.meta | {"ticks": 0}, arrays=first)
    save_trajectory(short, tmp_path / "trajectory.png")


def test_the_same_recording_gives_the_same_bytes_whatever_the_users_taste(tmp_path):
    first, second = tmp_path / "first.png", tmp_path / "second.png"
    save_trajectory(synthetic(ROLES), first)
    with matplotlib.rc_context({"font.size": 30.0, "axes.facecolor": "red", "savefig.dpi": 50}):
        save_trajectory(synthetic(ROLES), second)
    assert first.read_bytes() == second.read_bytes()


def test_a_folder_that_is_not_there_is_named(tmp_path):
    path = tmp_path / "nowhere" / "trajectory.png"
    with pytest.raises(MachineError, match=str(path)):
        save_trajectory(synthetic(OPEN_LOOP), path)


@pytest.mark.benchmark
def test_a_minute_of_ten_robots_is_drawn_within_a_second_and_a_half(tmp_path):
    recording = synthetic(KICKABOUT, leg_seconds=15)
    save_trajectory(recording, tmp_path / "warm.png")
    begin = perf_counter()
    save_trajectory(recording, tmp_path / "trajectory.png")
    assert perf_counter() - begin < 1.5
