"""What teams do wrong, and what it is called: the same in their seat here and in their own process.

What ends a whole process stands in test_team_process.py and test_supervise.py.
"""

import pytest
from play import play
from stand_in import sheet

from soccersim.match.faults import Forfeit, forfeited
from soccersim.problems import InputError

ORDERS = "[Command() for _ in view.robots]"
RAISES = {  # what is raised: the kind it is, and the last line of its traceback
    "1 / 0": ("exception", "ZeroDivisionError: division by zero"),
    "view.robots[7]": ("exception", "IndexError: tuple index out of range"),
    "sys.exit(3)": ("exit", "SystemExit: 3"),
    "raise KeyboardInterrupt": ("exit", "KeyboardInterrupt"),
    "raise GeneratorExit": ("exit", "GeneratorExit"),
    "raise type('Mine', (BaseException,), {})('of my own')": ("exception", "mine.Mine: of my own"),
    "raise MemoryError": ("memory", "MemoryError"),
    "raise type('Mute', (Exception,), {'__str__': lambda self: 1 / 0})": (
        "exception",
        "mine.Mute: <exception str() failed>",
    ),
    "f = lambda n: f(n + 1)\nf(0)": (
        "exception",
        "RecursionError: maximum recursion depth exceeded",
    ),
    "raise ExceptionGroup('two', [ValueError(1), ValueError(2)])": (
        "exception",
        "    +------------------------------------",
    ),
}
ANSWERS = {  # what is returned: what is wrong with it
    "None": "decide() returned None",
    "[]": "decide() returned 0 commands for 5 robots",
    "fine + fine": "decide() returned 10 commands for 5 robots",
    "fine[0]": "a Command, not a list of 5 commands",
    "5": "the number 5",
    "'fine!'": 'the text "fine!"',
    "__import__('numpy').zeros((5, 3))": "a numpy ndarray of shape (5, 3)",
    "[[0.0, 0.0, 0.0]] * 5": "command 1 of decide() is a list, not a Command",
    "fine[:4] + [None]": "command 5 of decide() is None",
    "[Command(float('nan'))] * 5": "vx of command 1 of decide() is nan",
    "[Command(0, float('inf'))] * 5": "vy of command 1 of decide() is inf",
    "[Command(omega='fast')] * 5": 'omega of command 1 of decide() is the text "fast"',
    "[Command(kick=-1.0)] * 5": "kick of command 1 of decide() is -1 m/s",
    "[Command(dribble=None)] * 5": "dribble of command 1 of decide() is None",
    "[Command(label=7)] * 5": "label of command 1 of decide() is the number 7",
    "[Command(notes=[7])] * 5": "one of the notes of command 1 of decide() is the number 7",
    "(command for command in fine)": "a generator, not a list of 5 commands",
}


def played(seat, decisions=5):
    """How many decisions a seat answers, and the forfeit that ends it."""
    told = sheet()
    for decision in range(decisions):
        seat.ask(told)
        try:
            seat.answer()
        except Forfeit as forfeit:
            return decision, forfeit
    return decisions, None


@pytest.mark.parametrize("trick", RAISES)
def test_whatever_a_team_raises_is_its_fault_with_the_lines_where(team, local, trick):
    decision, forfeit = played(local(team(trick)))
    kind, last = RAISES[trick]
    lines = forfeit.detail.splitlines()
    assert (decision, forfeit.kind) == (2, kind)
    assert lines[-1] == last
    assert any("mine.py" in line for line in lines)
    assert not any("soccersim" in line for line in lines)  # our own calls tell it nothing
    assert len(lines) <= 12


@pytest.mark.parametrize("result", ANSWERS)
def test_an_answer_that_is_no_answer_is_told(team, local, result):
    decision, forfeit = played(local(team(f"return {result}")))
    assert (decision, forfeit.kind) == (2, "bad_command")
    assert ANSWERS[result] in forfeit.detail


def test_an_exception_whose_text_ends_the_process_is_only_an_exception(team, local):
    trick = "raise type('E', (Exception,), {'__str__': lambda self: sys.exit()})"
    _, forfeit = played(local(team(trick)))
    assert forfeit.kind == "exception"


def test_a_sequence_that_raises_while_it_is_read_is_the_teams_fault(team, local):
    trick = """\
    class Late(list):
        def __getitem__(self, index):
            raise LookupError("late")
        def __len__(self):
            return 5
    return Late()
    """
    _, forfeit = played(local(team(trick)))
    assert forfeit.kind in ("bad_command", "exception")


@pytest.mark.parametrize("seat", ["local", "apart"])
@pytest.mark.parametrize(
    ("code", "kind", "line", "last"),
    [
        ("x = 1\nimport nothing_of_this_name", "import", 'mine.py", line 2', "No module named"),
        ("def decide(self:", "import", 'mine.py", line 1', "SyntaxError: "),
        ("import sys\nsys.exit()", "exit", 'mine.py", line 2', "SystemExit"),
        (
            "class T:\n    def __init__(self, rng):\n        self.x = rng.no()\n"
            "    def decide(self, view): pass",
            "init",
            'mine.py", line 3, in __init__',
            "has no attribute 'no'",
        ),
    ],
)
def test_a_team_that_cannot_be_made_forfeits(team, request, seat, code, kind, line, last):
    with pytest.raises(Forfeit) as caught:
        request.getfixturevalue(seat)(team(code, whole=True))
    assert caught.value.kind == kind
    assert line in caught.value.detail
    assert last in caught.value.detail.splitlines()[-1]
    assert "importlib" not in caught.value.detail


@pytest.mark.parametrize("seat", ["local", "apart"])
def test_a_name_that_no_strategy_has_is_bad_input_and_no_forfeit(team, request, seat):
    with pytest.raises(InputError, match=r"mine\.py: defines no class with a method decide"):
        request.getfixturevalue(seat)(team("x = 1", whole=True))
    lie = "from soccersim.problems import *\nraise InputError(Problem('not mine'))"
    with pytest.raises(Forfeit) as caught:
        request.getfixturevalue(seat)(team(lie, whole=True))
    assert caught.value.kind == "import"


def test_options_that_a_class_does_not_take_are_told_with_the_nearest_one(team, local):
    with pytest.raises(Forfeit) as caught:
        local(team("return fine"), pres=1)
    assert caught.value.kind == "init"
    assert caught.value.detail == "TypeError: Team has no option `pres`: it takes none"


def test_the_rest_of_the_world_is_not_hurt_by_a_view_that_is_changed(team, local):
    trick = """\
    object.__setattr__(view, "robots", ())
    object.__setattr__(view.ball, "x", 99.0)
    object.__setattr__(view.field, "length", -1.0)
    return fine
    """
    mine, theirs = local(team(trick)), local(team("return [Command(view.ball.x)] * 5", "b.py"), 1)
    assert played(mine) == (5, None)
    told = sheet()
    for _ in range(3):
        theirs.ask(told)
        answer = theirs.answer()
    assert answer.orders[0][0] == told[9] == 0.5


def test_a_decision_that_took_too_long_is_told_with_its_time(team, local):
    trick = "end = time.thread_time() + 1.05\nwhile time.thread_time() < end: pass\nreturn fine"
    decision, forfeit = played(local(team(trick)))
    assert (decision, forfeit.kind) == (2, "deadline")
    assert forfeit.detail.startswith("a decision took 1.")


def test_a_forfeit_counts_three_to_none_or_what_is_worse():
    assert forfeited((0, 0), 0) == (0, 3)
    assert forfeited((5, 1), 0) == (0, 3)
    assert forfeited((0, 3), 0) == (0, 3)
    assert forfeited((1, 6), 0) == (1, 6)
    assert forfeited((2, 1), 1) == (3, 0)
    assert forfeited((7, 2), 1) == (7, 2)


def test_two_teams_that_fail_at_one_decision_are_both_at_fault_and_neither_wins(team):
    wrong = team("1 / 0")
    result = play(wrong, wrong, "duration=2")
    assert [(fault.side, fault.kind) for fault in result.faults] == [
        ("home", "exception"),
        ("away", "exception"),
    ]
    assert result.score == (0, 0)
