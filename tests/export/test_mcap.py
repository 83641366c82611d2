"""The log for Foxglove, opened with the mcap library's own reader: it is what was recorded."""

import io
import json
import sys
from math import atan2, cos, pi, sin

import jsonschema
import numpy as np
import pytest
from factory import bundled, player, simulate
from logbook import messages, saved
from mcap.reader import make_reader
from tape import event, tape

from soccersim.export.frames import between, ros_names
from soccersim.export.mcap import save_mcap
from soccersim.problems import InputError, MachineError
from soccersim.render import look


@pytest.fixture(scope="module")
def run():
    """Two robots that drive, one of them without a plan, and a ball."""
    driven = player(bundled("utama"), (1, 0.5, 90), name="home-1", start=(0, 0, 0))
    other = player(bundled("garcia"), name="3rd robot", start=(-2, 1, 30), team="away", number=2)
    return simulate(driven, other, ball={"at": [3, 0]}, duration=1.0)


@pytest.fixture(scope="module")
def match():
    """Ten robots, a goal, and a time when away knows of no ball."""
    time = np.arange(0, 2, 0.02)
    robots = np.zeros((len(time), 10, 3))
    robots[..., 0] = np.linspace(-5, 5, 10) + 0.3 * time[:, None]
    robots[..., 2] = 2.0 * time[:, None]
    believed = robots + np.array((0.2, -0.1, 0.05))
    seen = np.zeros((50, 2, 5))
    seen[:, 0, :2] = 1.5
    seen[10:, 1] = np.nan
    ball = np.stack((time, 0 * time), axis=1)
    told = [event(1.0, "goal", "home", "goal by home-4 for home, 1:0")]
    said = {"labels": [[3, 0, "hi"]], "notes": [[4, 0, [["text", 0, 0, "hm"]]]]}
    return tape(robots, ball, believed, events=told, ball_believed=seen, **said)


def planar(transform):
    """x, y and heading; nothing leans or flies."""
    move, turn = transform["translation"], transform["rotation"]
    assert (turn["x"], turn["y"]) == (0.0, 0.0)
    assert turn["z"] ** 2 + turn["w"] ** 2 == pytest.approx(1.0, abs=1e-8)
    return move["x"], move["y"], 2 * atan2(turn["z"], turn["w"])


def after(first, second):
    """The product of two planar transforms."""
    x, y, turn = first
    c, s = cos(turn), sin(turn)
    return x + c * second[0] - s * second[1], y + s * second[0] + c * second[1], turn + second[2]


def same(pose, expected):
    assert pose[:2] == pytest.approx(expected[:2], abs=1e-7)
    assert (pose[2] - expected[2] + pi) % (2 * pi) - pi == pytest.approx(0.0, abs=1e-7)


@pytest.mark.parametrize("which", ["run", "match"])
def test_odom_is_what_the_robot_believes_and_map_is_where_it_truly_is(which, request, tmp_path):
    recording = request.getfixturevalue(which)
    robots = recording.scenario.robots
    names = ros_names(robot.name for robot in robots)
    told = list(messages(saved(recording, tmp_path), "/tf"))
    assert len(told) == len(recording.tick)
    for record, (_, _, message, content) in enumerate(told):
        lies = {each["child_frame_id"]: each for each in content["transforms"]}
        assert message.log_time == recording.tick[record] * 2_000_000
        for robot, name in enumerate(names):
            odom, base = lies[f"{name}/odom"], lies[f"{name}/base_link"]
            assert (odom["parent_frame_id"], base["parent_frame_id"]) == ("map", f"{name}/odom")
            same(planar(base), recording.estimate[record, robot])
            same(after(planar(odom), planar(base)), recording.body[record, robot, :3])
        same(planar(lies["ball"]), recording.ball[record, :3])


def test_belief_that_is_true_leaves_nothing_between_map_and_odom():
    poses = np.array([[1.0, -2.0, 3.0], [0.0, 0.0, -40.0]])
    assert between(poses, poses) == pytest.approx(np.zeros((2, 3)), abs=1e-12)


def test_signs_are_those_of_ros(run, tmp_path):
    """REP-103: x forward, y left, counter-clockwise from above."""
    last = list(messages(saved(run, tmp_path), "/home_1/state"))[-1][3]
    assert last["true"]["x"] > 0.1
    assert last["true"]["y"] > 0.05
    assert last["true"]["heading"] > 0.1
    vx, vy = (last["twist"][key] for key in ("vx", "vy"))
    body = run.body[-1, 0]
    speed = complex(vx, vy) * complex(cos(body[2]), sin(body[2]))  # body to field
    assert (speed.real, speed.imag) == pytest.approx((body[3], body[4]), abs=1e-6)


@pytest.mark.parametrize("which", ["run", "match"])
def test_every_message_is_as_its_schema_says_and_in_order_of_time(which, request, tmp_path):
    before, kinds = 0, {}
    recording = request.getfixturevalue(which)
    before_last = int(recording.tick[-2]) * 2_000_000  # to check all of them takes half a minute
    for schema, channel, message, content in messages(saved(recording, tmp_path)):
        assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
        if channel.topic not in kinds or message.log_time == before_last:
            document = json.loads(schema.data)
            assert document["title"] == schema.name
            jsonschema.Draft202012Validator(document).validate(content)
        if "timestamp" in content:
            at = content["timestamp"]
            assert at["sec"] * 10**9 + at["nsec"] == message.log_time
        assert message.log_time >= before
        before = message.log_time
        kinds[channel.topic] = schema.name
    expected = {
        "/tf": "foxglove.FrameTransforms",
        "/field": "foxglove.SceneUpdate",
        "/robots": "foxglove.SceneUpdate",
        "/believed": "foxglove.PosesInFrame",
        "/ball": "foxglove.PoseInFrame",
        "/home_1/state": "soccersim.Robot",
    }
    if which == "match":
        expected |= {
            "/game": "soccersim.Game",
            "/log": "foxglove.Log",
            "/home/ball": "foxglove.PoseInFrame",
            "/labels": "foxglove.SceneUpdate",
            "/home/notes": "foxglove.SceneUpdate",
        }
    assert expected.items() <= kinds.items()


def test_the_scene_stands_in_frames_that_there_are_in_our_colours(run, tmp_path):
    data = saved(run, tmp_path)
    tf = next(messages(data, "/tf"))[3]["transforms"]
    frames = {"map", *(each["child_frame_id"] for each in tf)}
    (_, _, _, field), (_, _, _, robots) = (
        next(messages(data, "/field")),
        next(messages(data, "/robots")),
    )
    assert {each["frame_id"] for each in field["entities"]} == {"map"}
    assert {each["id"]: each["frame_id"] for each in robots["entities"]} == {
        "home_1": "home_1/base_link",
        "robot_3rd_robot": "robot_3rd_robot/base_link",
        "ball": "ball",
    }
    assert {each["frame_id"] for each in robots["entities"]} <= frames
    body = robots["entities"][0]["cylinders"][0]
    assert body["size"]["x"] == 2 * run.scenario.robots[0].model.radius
    shade = [round(255 * body["color"][part]) for part in "rgb"]
    assert tuple(shade) == look.TEAMS["home"]


def test_goals_are_told_in_the_log_and_the_score_in_the_game(match, tmp_path):
    data = saved(match, tmp_path)
    lines = [content for *_, content in messages(data, "/log")]
    assert [(line["message"], line["level"]) for line in lines] == [
        ("goal by home-4 for home, 1:0", 2)
    ]
    assert lines[0]["timestamp"] == {"sec": 1, "nsec": 0}
    game = next(messages(data, "/game"))[3]
    assert (game["phase"], game["whose"], game["score"]) == ("play", "", {"home": 0, "away": 0})


def test_a_ball_that_a_team_does_not_know_of_is_not_told(match, tmp_path):
    data = saved(match, tmp_path)
    home, away = (len(list(messages(data, f"/{side}/ball"))) for side in ("home", "away"))
    assert (home, away) == (100, 20)


def test_wheels_and_commands_are_told_where_they_were_recorded(run, tmp_path):
    told = list(messages(saved(run, tmp_path), "/home_1/state"))
    for record in (0, 10, len(told) - 1):
        content = told[record][3]
        for key in ("wheel_speed", "slip", "pwm", "counts"):
            table = run.arrays[key][record, 0, : len(content[key])]
            assert content[key] == pytest.approx(table, abs=1e-8)
        command = [content["command"][key] for key in ("vx", "vy", "omega")]
        assert command == pytest.approx(run.arrays["command"][record, 0], abs=1e-8)


def test_the_same_recording_gives_the_same_bytes(match, tmp_path):
    assert saved(match, tmp_path) == saved(match, tmp_path)


def test_a_part_holds_its_records_alone(match, tmp_path):
    times = [
        m.log_time for _, _, m, _ in messages(saved(match, tmp_path, start=0.5, end=1.0), "/tf")
    ]
    assert (times[0], times[-1], len(times)) == (500_000_000, 1_000_000_000, 26)


def test_the_file_names_its_scenario(run, tmp_path):
    reader = make_reader(io.BytesIO(saved(run, tmp_path)))
    (about,) = reader.iter_metadata()
    assert about.metadata == {"scenario": "test", "seed": "0", "digest": run.digest}
    assert reader.get_header().library.startswith("soccersim ")


def test_a_match_that_never_began_has_a_log_without_records(tmp_path):
    empty = tape(np.zeros((0, 10, 3)), np.zeros((0, 2)))
    topics = {channel.topic for _, channel, *_ in messages(saved(empty, tmp_path))}
    assert topics == {"/field", "/robots"}


def test_without_mcap_it_says_how_to_get_it(run, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "mcap.writer", None)
    with pytest.raises(InputError, match=r"pip install 'soccersim\[log\]'"):
        save_mcap(run, tmp_path / "run.mcap")
    assert list(tmp_path.iterdir()) == []


def test_a_log_that_cannot_be_written_is_named(run, tmp_path):
    with pytest.raises(MachineError, match="nowhere"):
        save_mcap(run, tmp_path / "nowhere" / "run.mcap")


def test_names_are_such_as_ros_allows_and_none_comes_twice():
    assert ros_names(["home-1", "home_1", "3", "Bö b", ""]) == [
        "home_1",
        "home_1_2",
        "robot_3",
        "B__b",
        "robot_",
    ]
