"""Labels, notes and sightings in the log for Foxglove."""

import numpy as np
import pytest
from logbook import messages, saved
from tape import tape

from soccersim.record import Recording


@pytest.fixture
def spoken():
    """Home's first robot says a, then b, then nothing; its third says c; away draws, then rests."""
    labels = [[0, 0, "a"], [0, 2, "c"], [20, 0, "b"], [40, 0, " "]]
    drawn = [["line", 0, 1, 2, 3], ["circle", 1, -1, 0.5], ["text", 4, 2, "here"]]
    notes = [[10, 1, drawn], [30, 1, []]]
    still = np.zeros((100, 10, 3)), np.zeros((100, 2))
    return tape(*still, labels=labels, notes=notes)


def said(data):
    """Seconds, and the words of each robot from then on."""
    for _, _, message, content in messages(data, "/labels"):
        (gone,) = content["deletions"]
        assert gone == {"timestamp": content_time(message), "type": 1, "id": ""}
        words = {each["frame_id"]: each["texts"][0]["text"] for each in content["entities"]}
        assert all(each["timestamp"] == content_time(message) for each in content["entities"])
        yield message.log_time / 1e9, words


def content_time(message):
    return {"sec": message.log_time // 10**9, "nsec": message.log_time % 10**9}


def test_labels_ride_with_their_robots_and_each_message_tells_them_all(spoken, tmp_path):
    first, third = "home_1/base_link", "home_3/base_link"
    whole = list(said(saved(spoken, tmp_path)))
    assert whole == [
        (0.0, {first: "a", third: "c"}),
        (0.8, {first: "b", third: "c"}),
        (1.6, {third: "c"}),
    ]
    assert list(said(saved(spoken, tmp_path, start=1.0, end=1.5))) == [(1.0, whole[1][1])]
    states = [
        content["label"] for *_, content in messages(saved(spoken, tmp_path), "/home_1/state")
    ]
    assert states == ["a"] * 40 + ["b"] * 40 + [" "] * 20


def test_notes_are_drawn_on_the_field_until_the_team_draws_others(spoken, tmp_path):
    (begun, drawn), (ended, nothing) = (
        (message.log_time / 1e9, content["entities"])
        for _, _, message, content in messages(saved(spoken, tmp_path), "/away/notes")
    )
    assert (begun, ended, nothing) == (0.4, 1.2, [])
    (entity,) = drawn
    assert entity["frame_id"] == "map"
    line, circle = ([(p["x"], p["y"]) for p in way["points"]] for way in entity["lines"])
    assert line == [(0, 1), (2, 3)]
    assert [np.hypot(x - 1, y + 1) for x, y in circle] == pytest.approx([0.5] * len(circle))
    assert circle[0] == pytest.approx(circle[-1])
    (text,) = entity["texts"]
    where = text["pose"]["position"]
    assert (text["text"], where["x"], where["y"]) == ("here", 4, 2)


def test_a_sighting_of_the_ball_is_a_dot_in_the_teams_colour_for_a_second(spoken, tmp_path):
    seen = np.full((50, 10, 2), np.nan, np.float32)
    seen[5, 0], seen[5, 9], seen[25, 3] = (1, 2), (-3, 0.5), (0, 0)
    data = saved(Recording(spoken.meta, {**spoken.arrays, "ball_sighted": seen}), tmp_path)
    told = [(m.log_time / 1e9, content) for _, _, m, content in messages(data, "/sightings")]
    assert [time for time, _ in told] == [0.2, 1.0]
    ((first,), (second,)) = (content["entities"] for _, content in told)
    assert (first["frame_id"], first["lifetime"]["sec"]) == ("map", 1)
    assert first["id"] != second["id"]  # else the second would take the place of the first
    places = [
        (dot["pose"]["position"]["x"], dot["pose"]["position"]["y"]) for dot in first["spheres"]
    ]
    assert places == [(1, 2), (-3, 0.5)]
    home, away = (dot["color"] for dot in first["spheres"])
    assert home["b"] > home["r"]
    assert away["r"] > away["b"]
