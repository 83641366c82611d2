"""The replay page without a browser: what is packed into it, and what must not stand in it."""

import base64
import hashlib
import html
import re
from importlib.resources import files

import numpy as np
import pytest
from synthetic_match import match
from tape import tape
from unpacked import told, unspelt

from soccersim import Recording, Simulation, load_scenario
from soccersim.match.play import play_match
from soccersim.problems import InputError
from soccersim.render import look
from soccersim.render.page import page
from soccersim.render.page.channels import COARSE, FINE, FINEST
from soccersim.render.page.fill import ROOM

ATTACK = '</script><img src=x onerror="pwned=1"><!--{{data}}'


@pytest.fixture(scope="module")
def recording():
    return match(30.0)


@pytest.fixture(scope="module")
def shown(recording):
    return page(recording)


def test_poses_are_those_of_the_recording(recording, shown):
    document, found = told(shown)
    records = np.searchsorted(recording.tick, found["tick"][:, 0])
    assert (recording.tick[records] == found["tick"][:, 0]).all()
    assert records[0] == 0
    assert records[-1] == len(recording.tick) - 1
    assert document["rows"] == len(records)
    robots = len(recording.scenario.robots)
    for axis, part in enumerate(("x", "y", "heading")):
        true, believed = recording.body[records, :, axis], recording.estimate[records, :, axis]
        largest = FINE.heading if part == "heading" else FINE.place
        assert np.abs(found[f"robot_{part}"] - true[:, :robots]).max() <= largest / 2 + 1e-5
        assert np.abs(found[f"ball_{part}"][:, 0] - true[:, robots]).max() <= largest / 2 + 1e-5
        largest = FINE.heading if part == "heading" else FINE.believed
        assert np.abs(found[f"believed_{part}"] - believed).max() <= largest / 2 + 1e-5
    step = np.diff(found["tick"][:-1, 0])
    assert (step == recording.meta["physics_hz"] / 25).all()


def test_steps_are_as_fine_as_promised():
    for fine in (FINEST, FINE, COARSE):
        assert fine.hz >= 25
        assert max(fine.place, fine.believed / 2) <= 0.005
        assert np.degrees(fine.heading) <= 0.5 + 1e-9


def test_decisions_and_words_are_those_of_the_recording(recording, shown):
    document, found = told(shown)
    decision = np.searchsorted(recording.arrays["decision_tick"], found["tick"][:, 0], "right") - 1
    orders = recording.arrays["orders"][decision]
    assert np.abs(found["command_x"] - orders[..., 0]).max() <= FINE.speed / 2 + 1e-6
    assert (found["in_play"] == recording.arrays["in_play"][decision]).all()
    assert (found["contact"] == recording.arrays["contact"][decision]).all()
    seen = recording.arrays["ball_believed"][decision]
    assert (np.isnan(found["seen_x"]) == np.isnan(seen[..., 0])).all()
    assert np.nanmax(np.abs(found["seen_x"] - seen[..., 0])) <= 0.0051
    told_labels = [label[1:] for label in document["match"]["labels"]]
    assert told_labels == [label[1:] for label in recording.match["labels"]]


def test_sightings_are_where_cameras_put_the_ball(recording, shown):
    document, found = told(shown)
    rows = len(found["tick"])  # the last has the same decision as the one before
    sighted = np.full((rows, 10, 2), np.nan)
    sighted[:-1] = recording.arrays["ball_sighted"]
    assert (np.isfinite(found["sighted_x"]) == np.isfinite(sighted[..., 0])).all()
    then = np.maximum(np.arange(len(sighted)) - document["late"], 0)
    for axis, part in enumerate(("x", "y")):
        off = found[f"sighted_{part}"] + found[f"ball_{part}"][then] - sighted[..., axis]
        assert np.nanmax(np.abs(off)) <= FINE.sighted / 2 + 1e-5


def test_each_sighting_is_told_once_and_of_several_between_two_rows_the_newest():
    short = match(4.0)
    sighted = short.arrays["ball_sighted"]
    _, found = told(page(short))  # of two rows each decision has here, the first
    assert np.isfinite(found["sighted_x"][::2]).sum() == np.isfinite(sighted[..., 0]).sum()
    assert np.isnan(found["sighted_x"][1::2]).all()
    records = {key: short.arrays[key][::8] for key in ("tick", "chain", "body", "estimate")}
    document, found = told(page(Recording(short.meta, short.arrays | records)))
    newest = sighted[::4]  # of four decisions a row
    then = np.maximum(np.arange(len(newest)) - document["late"], 0)
    shown = found["ball_x"][then] + found["sighted_x"][: len(newest)]
    assert np.nanmax(np.abs(shown - newest[..., 0])) < 0.02
    assert (np.isfinite(shown) >= np.isfinite(newest[..., 0])).all()


def test_recording_that_has_no_sightings_makes_a_page(recording):
    arrays = {key: a for key, a in recording.arrays.items() if key != "ball_sighted"}
    nobody = arrays | {"ball_sighted": np.full((len(arrays["phase"]), 10, 2), np.nan)}
    for kept in (arrays, nobody):
        _, found = told(page(Recording(recording.meta, kept)))
        assert "sighted_x" not in found


def test_notes_are_those_of_the_recording(recording, shown):
    document, found = told(shown)
    decision = np.searchsorted(recording.arrays["decision_tick"], found["tick"][:, 0], "right") - 1
    for slot in (0, 1):
        changes = [row for row in recording.match["notes"] if row[1] == slot]
        for row in (0, 7, 100, 400):
            notes = [notes for at, _, notes in changes if at <= decision[row]][-1]
            kinds = [kinds for at, kinds in document["match"]["notes"][slot] if at <= row][-1]
            assert [kind[0] for kind in kinds] == [note[0] for note in notes]
            numbers = [n for note in notes for n in note[1:] if not isinstance(n, str)]
            assert np.abs(found[f"notes_{slot}"][row, : len(numbers)] - numbers).max() <= 0.0051


def test_belief_that_began_a_whole_turn_away_is_told_beside_the_truth():
    robots = np.zeros((20, 10, 3))
    believed = robots + np.array((0.1, 0.0, 4 * np.pi))
    _, found = told(page(tape(robots, np.zeros((20, 2)), believed)))
    assert np.abs(found["believed_heading"] - found["robot_heading"]).max() < 0.01


def test_page_asks_for_nothing_from_anywhere(shown):
    assert "http:" not in shown
    assert "https:" not in shown
    assert "//cdn" not in shown
    assert re.findall(r'(?:src|href)="([^"]*)"', shown) == ["data:,"]
    assert "default-src 'none'" in shown


def test_policy_lets_the_pages_own_script_and_style_run_and_no_other(shown):
    for tag in ("script", "style"):
        own = re.search(f"<{tag}>(.*?)</{tag}>", shown, re.DOTALL)[1]
        digest = base64.b64encode(hashlib.sha256(own.encode()).digest()).decode()
        assert f"{tag}-src 'sha256-{digest}'" in shown
    assert "unsafe" not in shown.partition("<style>")[0]


def test_nothing_that_a_team_wrote_is_html():
    hostile = match(
        1.0,
        home=ATTACK,
        talk=False,
        labels=[[0, 0, ATTACK]],
        notes=[[0, 1, [["text", 0.0, 0.0, ATTACK]]]],
        events=[],
        settings=(),
    )
    text = page(hostile, title=ATTACK)
    assert "<img" not in text
    assert text.count("</script>") == 2
    assert html.unescape(re.search("<title>(.*)</title>", text)[1]) == ATTACK
    document, _ = told(text)
    assert document["title"] == ATTACK
    assert document["match"]["labels"][0][2] == ATTACK
    assert document["match"]["notes"][1] == [[0, [["text", ATTACK]]]]


def test_colours_are_those_of_the_frames(shown):
    document, _ = told(shown)
    assert (
        document["look"]["teams"]
        == ["#2678d6", "#f3861f"]
        == ["#" + "".join(f"{part:02x}" for part in colour) for colour in look.TEAMS.values()]
    )
    assert f"--page:#{''.join(f'{part:02x}' for part in look.PAGE)};" in shown


def test_run_tells_its_plan_its_legs_and_its_wheels():
    run = Simulation(load_scenario("defender")).run()
    document, found = told(page(run))
    assert document["match"] is None
    assert document["title"] == "defender"
    assert [event["kind"] for event in document["events"]] == ["reached", "reached"]
    assert "leg 1 reached, off by" in document["events"][0]["text"]
    assert np.allclose(document["robots"][0]["targets"][0], run.legs[0][0]["target"])
    assert found["pwm"].shape == (document["rows"], 6)
    assert np.abs(found["pwm"][-1] - run.arrays["pwm"][-1, 0]).max() == 0
    assert found["leg"][-1, 0] == run.leg[-1, 0]


def test_run_of_arms_tells_of_their_poses_and_of_shots():
    run = Simulation(load_scenario("keeper-arm", settings=["duration=7"])).run()
    document, _ = told(page(run))
    times = [event["time"] for event in document["events"] if event["kind"] == "shot"]
    assert times == [0.0, *(shot.time for shot in run.scenario.ball.shots if shot.time < 7)]
    run = Simulation(load_scenario("arm-table2", settings=["duration=1.5"])).run()
    document, _ = told(page(run))
    texts = [event["text"] for event in document["events"]]
    assert len(texts) == sum(map(len, run.meta["arms"])) > 0
    assert all("pose 1 held, off by" in text for text in texts)


@pytest.mark.parametrize("name", ["keeper-arm", "positioning", "linear"])
def test_any_scenario_makes_a_page(name):
    run = Simulation(load_scenario(name, settings=["duration=0.3"])).run()
    document, found = told(page(run))
    assert len(document["robots"]) == len(run.scenario.robots)
    assert ("link_x" in found) == bool(run.scenario.arms)
    assert ("ball_x" in found) == (run.scenario.ball is not None)


def test_recording_without_a_record_is_told_so():
    with pytest.raises(InputError, match="empty"):
        page(tape(np.zeros((0, 10, 3)), np.zeros((0, 2))))


def test_recording_of_one_record_makes_a_page():
    document, _ = told(page(tape(np.zeros((1, 10, 3)), np.zeros((1, 2)))))
    assert document["rows"] == 1


def own_files(*endings):
    return [
        part for part in files("soccersim.render.page").iterdir() if part.name.endswith(endings)
    ]


def test_short_match_makes_a_small_page(shown):
    own = sum(len(part.read_bytes()) for part in own_files(".js", ".css", ".html"))
    assert own < 90_000
    assert len(shown.encode()) < own + 30.0 / 600.0 * 1_000_000 + 20_000


def test_no_script_outgrows_a_reader():
    parts = own_files(".js", ".css")
    assert len(parts) > 10
    assert [part.name for part in parts if len(part.read_text().splitlines()) > 300] == []


@pytest.mark.slow
@pytest.mark.parametrize("teams", [("roles", "chaser"), ("positioning", "roles")], ids="-".join)
def test_ten_minutes_of_a_match_take_less_than_a_megabyte(teams, tmp_path):
    path = tmp_path / "match.npz"
    play_match(*teams, recording=path)
    text = page(Recording.load(path))
    assert len(text.encode()) < 1_000_000
    data = re.search(r'id="data">([^<]*)</script>', text)[1]
    assert len(unspelt(data)) <= ROOM
