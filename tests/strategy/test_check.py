"""What a team may answer, and what it is told about every wrong answer."""

import math
from collections import UserList, deque

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccersim.strategy import Circle, Command, Line, Text
from soccersim.strategy.check import (
    FARTHEST,
    FASTEST,
    LONGEST_LABEL,
    LONGEST_TEXT,
    MOST_NOTES,
    answer_of,
)

FINE = Command(1.0, 0.5, -0.2)
finite = st.floats(-900, 900)


@given(
    st.lists(
        st.builds(Command, finite, finite, finite, st.floats(0, 900), st.booleans()),
        min_size=1,
        max_size=6,
    )
)
def test_a_right_answer_arrives_as_it_was_given(commands):
    answer = answer_of(commands, len(commands))
    assert answer.orders == [(c.vx, c.vy, c.omega, c.kick, c.dribble) for c in commands]
    assert answer.labels == [""] * len(commands)
    assert answer.notes == []


@given(st.tuples(finite, finite, finite, st.floats(0, 900)), st.booleans())
def test_numbers_of_numpy_and_whole_numbers_are_as_good(values, dribble):
    vx, vy, omega, kick = values
    for kind in (np.float64, np.float32, int, np.int64):
        command = Command(kind(vx), kind(vy), kind(omega), kind(kick), np.bool_(dribble))
        [order] = answer_of((command,), 1).orders
        assert order == (*(float(kind(value)) for value in values), dribble)
        assert [type(value) for value in order] == [float, float, float, float, bool]


def test_any_sequence_will_do():
    for kind in (tuple, UserList, deque):
        assert len(answer_of(kind([FINE, FINE]), 2).orders) == 2


WRONG = [
    (None, 5, "decide() returned None, not a list of 5 commands"),
    (FINE, 1, "decide() returned a Command, not a list of 1 command: put it into a list"),
    ([FINE] * 4, 5, "decide() returned 4 commands for 5 robots"),
    ([FINE], 5, "decide() returned 1 command for 5 robots"),
    ([], 2, "decide() returned 0 commands for 2 robots"),
    ("ab", 2, 'decide() returned the text "ab", not a list of 2 commands'),
    (b"ab", 2, "decide() returned a bytes, not a list of 2 commands"),
    (7, 2, "decide() returned the number 7, not a list of 2 commands"),
    (True, 2, "decide() returned True, not a list of 2 commands"),
    ({1: FINE}, 1, "decide() returned a dict, not a list of 1 command"),
    ({FINE.vx}, 1, "decide() returned a set, not a list of 1 command"),
    ((FINE for _ in range(2)), 2, "decide() returned a generator, not a list of 2 commands"),
    (
        np.zeros((5, 3)),
        5,
        "decide() returned a numpy ndarray of shape (5, 3), not a list of 5 commands",
    ),
    ([FINE, None], 2, "command 2 of decide() is None, not a Command"),
    ([FINE, (1, 0, 0)], 2, "command 2 of decide() is a tuple, not a Command"),
    ([Command], 1, "command 1 of decide() is the class Command, not a Command"),
    ([np.zeros(3)], 1, "command 1 of decide() is a numpy ndarray of shape (3,), not a Command"),
    ([object()], 1, "command 1 of decide() is an object, not a Command"),
    ([Command(math.nan)], 1, "vx of command 1 of decide() is nan: it must be a finite number"),
    ([Command(0, math.inf)], 1, "vy of command 1 of decide() is inf: it must be a finite number"),
    ([Command(0.0, math.nan)], 1, "vy of command 1 of decide() is nan: it must be a finite number"),
    ([Command(omega=-math.inf)], 1, "omega of command 1 of decide() is -inf: it must be a finite"),
    ([Command(kick=-math.inf)], 1, "kick of command 1 of decide() is -inf: it must be a finite"),
    ([Command(np.float32("nan"))], 1, "vx of command 1 of decide() is nan: it must be a finite"),
    ([FINE, Command(omega="1")], 2, 'omega of command 2 of decide() is the text "1", not a number'),
    ([Command(None)], 1, "vx of command 1 of decide() is None, not a number"),
    ([Command(True)], 1, "vx of command 1 of decide() is True, not a number"),
    ([Command(1j)], 1, "vx of command 1 of decide() is a complex, not a number"),
    (
        [Command(np.zeros(3))],
        1,
        "vx of command 1 of decide() is a numpy ndarray of shape (3,), not a number",
    ),
    ([Command(10**400)], 1, "vx of command 1 of decide() is too large for a number"),
    ([Command(kick=-1)], 1, "kick of command 1 of decide() is -1 m/s: 0 is no kick"),
    (
        [Command(dribble="no")],
        1,
        'dribble of command 1 of decide() is the text "no", not True or False',
    ),
    ([Command(dribble=2)], 1, "dribble of command 1 of decide() is the number 2, not True or Fa"),
    ([Command(dribble=None)], 1, "dribble of command 1 of decide() is None, not True or False"),
    (
        [Command(dribble=np.zeros(2, bool))],
        1,
        "dribble of command 1 of decide() is a numpy ndarray of shape (2,), not True or False",
    ),
    ([Command(label=5)], 1, "label of command 1 of decide() is the number 5, not a text"),
    ([Command(label=None)], 1, "label of command 1 of decide() is None, not a text"),
    ([Command(label=b"a")], 1, "label of command 1 of decide() is a bytes, not a text"),
    (
        [Command(notes=Line(0, 0, 1, 1))],
        1,
        "notes of command 1 of decide() is a Line, not a list of Line, Circle or Text",
    ),
    (
        [Command(notes="line")],
        1,
        'notes of command 1 of decide() is the text "line", not a list of Line, Circle or Text',
    ),
    (
        [Command(notes=[(0, 0)])],
        1,
        "one of the notes of command 1 of decide() is a tuple, not a Line, Circle or Text",
    ),
    ([Command(notes=[Line(0, 0, math.nan, 1)])], 1, "x2 of a Line is nan: it must be a finite num"),
    ([Command(notes=[Circle(0, "a", 1)])], 1, 'y of a Circle is the text "a", not a number'),
    ([Command(notes=[Text(0, 0, 7)])], 1, "text of a Text is the number 7, not a text"),
]


@pytest.mark.parametrize(("result", "count", "message"), WRONG, ids=[w[2][:60] for w in WRONG])
def test_a_wrong_answer_is_told_in_one_line(result, count, message):
    with pytest.raises(ValueError) as error:  # noqa: PT011
        answer_of(result, count)
    assert str(error.value).startswith(message)
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 200


@given(st.text(), st.integers(0, 3))
def test_a_message_is_one_printable_line_whatever_the_answer(text, which):
    wrong = [text, [text], [Command(text)], [Command(dribble=text)]][which]
    with pytest.raises(ValueError) as error:  # noqa: PT011
        answer_of(wrong, 1)
    assert str(error.value).isprintable()


def test_a_list_that_claims_to_be_endless_is_not_read():
    class Endless(list):
        def __len__(self):
            return 10**12

        def __iter__(self):
            while True:
                yield FINE

    with pytest.raises(ValueError, match="returned 1000000000000 commands for 5 robots"):
        answer_of(Endless(), 5)


def test_more_than_any_robot_can_is_taken_as_much():
    [order] = answer_of([Command(1e300, -1e300, 1e300, 1e300)], 1).orders
    assert order == (FASTEST, -FASTEST, FASTEST, FASTEST, False)


def test_a_minus_zero_kick_is_no_kick():
    assert answer_of([Command(kick=-0.0)], 1).orders[0][3] == 0.0


@given(st.text(max_size=200))
def test_labels_are_cut_and_printable(text):
    [label] = answer_of([Command(label=text)], 1).labels
    assert len(label) <= LONGEST_LABEL
    assert label.isprintable()
    label.encode("utf-8")
    if len(text) <= LONGEST_LABEL and text.isprintable():
        assert label == text


def test_megabytes_of_label_and_notes_are_cut():
    notes = [Text(0, 0, "n" * 10**6)] * 10**5
    answer = answer_of([Command(label="l" * 10**7, notes=notes)] * 5, 5)
    assert answer.labels == ["l" * (LONGEST_LABEL - 3) + "..."] * 5
    assert len(answer.notes) == MOST_NOTES
    assert all(len(note[3]) == LONGEST_TEXT for note in answer.notes)


def test_notes_become_plain_numbers_and_stay_near():
    notes = (Line(0, 1, 2, 1e9), Circle(np.float64(1), 2, 3), Text(-1e9, 2, "press"))
    assert answer_of([FINE, Command(notes=notes)], 2).notes == [
        ("line", 0.0, 1.0, 2.0, FARTHEST),
        ("circle", 1.0, 2.0, 3.0),
        ("text", -FARTHEST, 2.0, "press"),
    ]
