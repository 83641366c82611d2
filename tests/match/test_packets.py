"""What a team's process sends is read as if an enemy had written it."""

import json
import struct
from math import inf, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim.match.packets import (
    HEAD,
    ORDERS,
    WORDS,
    Reader,
    Writer,
    fault,
    mark,
    pitch_document,
    pitch_from,
)
from soccersim.match.pitch import pitch_of
from soccersim.strategy.api import Circle, Command, Line, Text
from soccersim.strategy.check import answer_of

numbers = st.floats(-1000, 1000)
commands = st.builds(
    Command,
    numbers,
    numbers,
    numbers,
    st.floats(0, 1000),
    st.booleans(),
    st.text(max_size=40),
    st.lists(
        st.one_of(
            st.builds(Line, numbers, numbers, numbers, numbers),
            st.builds(Circle, numbers, numbers, numbers),
            st.builds(Text, numbers, numbers, st.text(max_size=60)),
        ),
        max_size=3,
    ),
)


def read(reader, packet):
    kind, length = HEAD.unpack_from(packet)
    assert len(packet) == HEAD.size + length
    return reader.answer(kind, packet[HEAD.size :])


@given(st.lists(st.lists(commands, min_size=3, max_size=3), max_size=6))
def test_answers_come_through_the_pipe_to_the_last_bit(decisions):
    writer, reader = Writer(3), Reader(3)
    for decision in decisions:
        answer = answer_of(decision, 3)
        assert read(reader, writer.packet(answer)) == answer


def test_words_are_sent_only_when_they_change():
    writer = Writer(2)
    silent, said = [Command(), Command()], [Command(label="mine"), Command()]
    sizes = [len(writer.packet(answer_of(d, 2))) for d in (silent, said, said, silent, silent)]
    assert sizes[0] == sizes[2] == sizes[4] == HEAD.size + 2 * 5 * 8
    assert min(sizes[1], sizes[3]) > sizes[0]


@given(st.integers(0, 255), st.binary(max_size=200))
def test_whatever_bytes_come_they_are_an_answer_or_none(kind, body):
    try:
        answer = Reader(2).answer(kind, body)
    except ValueError:
        return
    assert len(answer.orders) == 2


def packed(*orders):
    return struct.pack(f"<{5 * len(orders)}d", *(number for order in orders for number in order))


@pytest.mark.parametrize("place", range(5))
@pytest.mark.parametrize("number", [nan, inf, -inf, 1001.0, -1001.0, -0.5])
def test_no_order_beyond_its_bounds_gets_in(place, number):
    order = [0.0, 0.0, 0.0, 0.0, 0.0]
    order[place] = number
    fine = number == -0.5 and place < 3
    reader = Reader(2)
    if fine:
        assert reader.answer(ORDERS, packed([0.0] * 5, order)).orders[1][place] == number
        return
    with pytest.raises(ValueError, match="orders that no robot can be given"):
        reader.answer(ORDERS, packed([0.0] * 5, order))


WRONG_WORDS = [
    [],
    {},
    [["a", "b"]],
    [["a"], []],
    [["a", 7], []],
    [["a", "b\nc"], []],
    [["a", "b" * 25], []],
    [["a", "b"], [["circle", 1.0, 1.0]]],
    [["a", "b"], [["line", 1.0, 1.0, 1.0, 1e300]]],
    [["a", "b"], [["text", 1.0, 1.0, "x" * 49]]],
    [["a", "b"], [["text", 1.0, 1.0, 7]]],
    [["a", "b"], [[["text"], 1.0, 1.0, "x"]]],
    [["a", "b"], [["circle", True, 1.0, 1.0]]],
    [["a", "b"], [["circle", 1.0, 1.0, nan]]],
    [["a", "b"], [["circle", 1.0, 1.0, 1.0]] * 25],
]


@pytest.mark.parametrize("words", WRONG_WORDS, ids=range(len(WRONG_WORDS)))
def test_no_label_or_note_gets_in_that_no_team_could_have_made(words):
    with pytest.raises(ValueError, match=r"\w"):
        Reader(2).answer(WORDS, packed([0.0] * 5, [0.0] * 5) + json.dumps(words).encode())


def test_json_that_is_a_bomb_is_only_wrong():
    for bomb in (b"[" * 60_000, b"1" * 60_000, b"\xff", b"{", b'"' + b"\\ud800" * 9 + b'"'):
        with pytest.raises(ValueError, match=r"\w"):
            Reader(1).answer(WORDS, packed([0.0] * 5) + bomb)
        with pytest.raises(ValueError, match=r"\w"):
            fault(bomb)


def test_a_fault_is_told_cut_and_in_known_words():
    kind, detail = fault(json.dumps(["crash", "line\x1b[31m\n" * 100]).encode())
    assert kind == "crash"
    assert len(detail.splitlines()) == 12
    assert "\x1b" not in detail
    with pytest.raises(ValueError, match="a fault of no kind"):
        fault(json.dumps(["rudeness", "x"]).encode())


def test_a_note_is_what_the_game_knows_it_as():
    assert mark(["line", 0.0, 1.0, 2.0, 3.0]) == ("line", 0.0, 1.0, 2.0, 3.0)
    assert mark(["text", 0.0, 1.0, "x"]) == ("text", 0.0, 1.0, "x")


def test_the_pitch_comes_through_whole(friendly):
    pitch = pitch_of(friendly, 0)
    assert pitch_from(json.loads(json.dumps(pitch_document(pitch)))) == pitch
