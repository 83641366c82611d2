"""The replay page without a browser: what is packed into it, and what must not stand in it."""

import base64
import hashlib
import html
import json
import re
import zlib
from importlib.resources import files

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from synthetic_match import match
from tape import tape

from soccersim import Recording, Simulation, load_scenario
from soccersim.match.play import play_match
from soccersim.problems import InputError
from soccersim.render import look
from soccersim.render.page import page
from soccersim.render.page.channels import COARSE, FINE, FINEST
from soccersim.render.page.fill import ROOM
from soccersim.render.page.pack import Packer

ATTACK = '</script><img src=x onerror="pwned=1"><!--{{data}}'


def told(text):
    """The document and the channels of a page, read as its own script reads them."""
    data = base64.b64decode(re.search(r'id="data">([^<]*)</script>', text)[1])
    return read(data)


def read(data):
    data = zlib.decompress(data)
    size = int.from_bytes(data[:4], "little")
    document = json.loads(data[4 : 4 + size])
    found, at, rows = {}, 4 + size, document["rows"]
    for channel in document["channels"]:
        table = np.zeros((rows, channel["columns"]))
        for column in range(channel["columns"]):
            for row in range(rows):
                number, at = data[at], at + 1
                if number == 255:
                    number, at = int.from_bytes(data[at : at + 4], "little"), at + 4
                table[row, column] = -(number + 1) // 2 if number % 2 else number // 2
        for _ in range(channel["order"]):
            table = table.cumsum(axis=0)
        below = found[channel["on"]] if channel["on"] else 0.0
        found[channel["key"]] = table * channel["step"] + below
    assert at == len(data)
    for key in list(found):
        if key + "?" in found:
            found[key][found[key + "?"] == 0] = np.nan
    return document, found


numbers = st.floats(-1e4, 1e4) | st.just(np.nan)
tables = st.tuples(st.integers(1, 20), st.integers(1, 3)).flatmap(
    lambda shape: st.tuples(arrays(float, shape, elements=numbers), arrays(float, shape))
)


@given(tables, st.sampled_from((0.001, 0.005, 0.05, 1.0)), st.integers(0, 2))
def test_every_number_comes_back_within_half_a_step(pair, step, order):
    values, below = pair[0], np.nan_to_num(pair[1], posinf=1e3, neginf=-1e3).clip(-1e3, 1e3)
    packer = Packer(len(values))
    packer.add("below", below, 0.25)
    packer.add("values", values, step, order, on="below")
    _, found = read(packer.packed({}))
    assert np.array_equal(np.isnan(found["values"]), np.isnan(values))
    assert np.nanmax(np.abs(found["values"] - values), initial=0) <= step / 2 * 1.001 + 1e-9
    assert np.abs(found["below"] - below).max() <= 0.125


@given(arrays(float, st.tuples(st.integers(1, 6), st.integers(1, 3))))
def test_even_absurd_numbers_are_packed(values):
    packer = Packer(len(values))
    packer.add("values", values, 1e-3)
    _, found = read(packer.packed({}))
    assert np.isfinite(found["values"]).tolist() == np.isfinite(values).tolist()


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
    assert len(base64.b64decode(data)) <= ROOM
