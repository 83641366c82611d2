"""Validation of a tree: every complaint in one line, in our words, at the place where it stands."""

from enum import Enum
from typing import Annotated, Literal

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import BaseModel, ConfigDict, Field, field_validator, model_validator

from soccersim.problems import InputError
from soccersim.spec.validate import MAX_SHOWN, Fault, validate
from soccersim.spec.yaml12 import Tree, parse

Positive = Annotated[float, Field(gt=0, lt=1000)]


class Spec(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Encoder(Spec):
    kind: Literal["encoder"]
    pulses: Annotated[int, Field(gt=0)]


class Gyro(Spec):
    kind: Literal["gyro"]
    noise: float = 0.0
    encoder: float = 0.0  # a key named like another sensor's kind


class Colour(Enum):
    CYAN = "cyan"
    MAGENTA = "magenta"


class Robot(Spec):
    name: Annotated[str, Field(min_length=1, max_length=8, pattern="^[a-z]*$")] = "r"
    mass: Positive
    radius: Positive | tuple[Positive, ...] = 0.1
    start: tuple[float, float, float] = (0.0, 0.0, 0.0)
    colour: Colour = Colour.CYAN
    keeper: bool = False
    wheels: Literal[3, 4] = 3
    path: Annotated[list[int], Field(min_length=1, max_length=3)] = [0]
    sensors: list[Annotated[Encoder | Gyro, Field(discriminator="kind")]] = []
    limit: float | Literal["none"] | None = None
    spare: str | Gyro = "none"
    pair: tuple[Encoder, Gyro] | None = None
    named: dict[str, Encoder] = {}

    @field_validator("name")
    @classmethod
    def is_no_ball(cls, name: str) -> str:
        if name == "ball":
            raise ValueError("a ball is not a robot")
        return name

    @model_validator(mode="after")
    def starts_on_the_field(self) -> "Robot":
        if self.start[0] > 9:
            raise Fault("is outside the field", at=("start", 0))
        if self.start[0] == 9:
            raise OverflowError("odd")
        return self


class Match(Spec):
    robots: list[Robot] = []
    gains: dict[Annotated[str, Field(pattern="^k")], float] = {}

    @model_validator(mode="after")
    def names_differ(self) -> "Match":
        seen = {robot.name for robot in self.robots}
        if len(seen) < len(self.robots):
            last = len(self.robots) - 1
            raise Fault.many(
                [
                    Fault("stands twice", at=("robots", last, "name")),
                    Fault.many([Fault("is taken", at=("robots", 0, "name"))]),
                    Fault("names must differ"),
                ]
            )
        return self


def complaints(model: type[BaseModel], text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        validate(model, parse(text, "f.yaml"))
    lines = str(caught.value).split("\n")
    assert len(lines) == len(caught.value.problems)
    assert all(line.isprintable() for line in lines)
    return [line.removeprefix("f.yaml:") for line in lines]


def test_a_right_file_becomes_the_model():
    text = """
robots:
- {mass: 3, start: [1, 2, 3.5], colour: magenta, keeper: true, radius: [1, 2]}
- {name: b, mass: 2.5, wheels: 4, sensors: [{kind: gyro, noise: 1}], limit: none}
gains: {kp: 1}
"""
    match = validate(Match, parse(text, "f.yaml"))
    first, second = match.robots
    assert (first.mass, first.start, first.radius) == (3.0, (1.0, 2.0, 3.5), (1.0, 2.0))
    assert (first.colour, first.keeper, first.limit) == (Colour.MAGENTA, True, None)
    assert second.sensors == [Gyro(kind="gyro", noise=1.0)]
    assert second.limit == "none"
    assert isinstance(first.mass, float)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("mass: abc", '1:7: mass: must be a number, not the text "abc"'),
        ('mass: "1"', '1:7: mass: must be a number, not the text "1"'),
        ("mass: true", "1:7: mass: must be a number, not true"),
        ("mass:", "1:6: mass: must be a number, not nothing (null)"),
        ("mass: [1]", "1:7: mass: must be a number, not a list"),
        ("mass: -3", "1:7: mass: must be greater than 0, not -3"),
        ("mass: 1e3", "1:7: mass: must be less than 1000, not 1000.0"),
        ("{mass: 1, keeper: 1}", "1:19: keeper: must be true or false, not 1"),
        ("{mass: 1, keeper: yes}", '1:19: keeper: must be true or false, not the text "yes"'),
        ("{mass: 1, name: 7}", "1:17: name: must be a text, not 7"),
        ("{mass: 1, name: ''}", '1:17: name: must have at least 1 character, not the text ""'),
        ("{mass: 1, name: aaaaaaaaa}", "1:17: name: must have at most 8 characters, not the text"),
        ("{mass: 1, name: A}", '1:17: name: must match the pattern ^[a-z]*$, not the text "A"'),
        ("{mass: 1, name: ball}", "1:17: name: a ball is not a robot"),
        ("{mass: 1, start: 0}", "1:18: start: must be a list, not 0"),
        ("{mass: 1, start: [0]}", "1:18: start: must have 3 entries, not 1"),
        ("{mass: 1, start: [0, 0, 0, 0]}", "1:18: start: must have 3 entries, not 4"),
        ("{mass: 1, start: [0, x, 0]}", '1:22: start.1: must be a number, not the text "x"'),
        ("{mass: 1, start: [10, 0, 0]}", "1:19: start.0: is outside the field"),
        ("{mass: 1, start: [9, 0, 0]}", " these values cannot be worked with (odd)"),
        ("{mass: 1, path: []}", "1:17: path: must have at least 1 entry, not 0"),
        ("{mass: 1, path: [1, 2, 3, 4]}", "1:17: path: must have at most 3 entries, not 4"),
        ("{mass: 1, path: [2.0]}", "1:18: path.0: must be a whole number, not 2.0: write 2"),
        ("{mass: 1, path: [2.5]}", "1:18: path.0: must be a whole number, not 2.5"),
        (
            "{mass: 1, colour: magneta}",
            '1:19: colour: must be one of `cyan`, `magenta`, not the text "magneta"; '
            "did you mean `magenta`?",
        ),
        ("{mass: 1, wheels: 5}", "1:19: wheels: must be one of `3`, `4`, not 5"),
        ("{mass: 1, limit: x}", '1:18: limit: must be a number or `none`, not the text "x"'),
        ("{mass: 1, radius: x}", '1:19: radius: must be a number or a list, not the text "x"'),
        ("{mass: 1, radius: -1}", "1:19: radius: must be greater than 0, not -1"),
        ("{mass: 1, radius: [1, x]}", '1:23: radius.1: must be a number, not the text "x"'),
        ("{mass: 1, spare: 1}", "1:18: spare: must be a text or a mapping (key: value), not 1"),
        ("{mass: 1, spare: {}}", "1:18: spare: the key `kind` is missing: `gyro`"),
        ("{mass: 1, spare: {kind: gyro, x: 1}}", "1:31: spare.x: unknown key; known: `kind`, `n"),
        ("{mass: 1, spare: {kind: gyro, noise: x}}", "1:38: spare.noise: must be a number, not"),
        (
            "{mass: 1, pair: [{kind: encoder, pulses: 1}, {kind: gyro, pulse: 1}]}",
            "1:59: pair.1.pulse: unknown key; known: `kind`, `noise`, `encoder`",
        ),
        (
            "{mass: 1, named: {left: {kind: encoder, pulses: 1, puls: 1}}}",
            "1:52: named.left.puls: unknown key; did you mean `pulses`?",
        ),
        ("[mass]", "1:1: must be a mapping (key: value), not a list"),
        ("{}", "1:1: the key `mass` is missing"),
        ('{mass: 1, "a\\nb": 2}', "1:11: a\\nb: unknown key"),
        ("{mass: 1, masss: 2}", "1:11: masss: unknown key; did you mean `mass`?"),
    ],
)
def test_a_wrong_robot_is_told_what_would_be_right(text, line):
    (told,) = complaints(Robot, text)
    assert told.startswith(line)


@pytest.mark.parametrize(
    ("sensor", "line"),
    [
        ("kind: encoder", "1:21: sensors.0: the key `pulses` is missing"),
        ("kind: gyro, pulses: 1", "1:34: sensors.0.pulses: unknown key; known: `kind`, `noise`"),
        ("kind: gyro, encoder: x", "1:43: sensors.0.encoder: must be a number, not the text"),
        ("kind: encoder, pulses: 0", "1:45: sensors.0.pulses: must be greater than 0, not 0"),
        ("kind: encodr", "1:28: sensors.0.kind: must be one of `encoder`, `gyro`, not the text"),
        ("noise: 1", "1:21: sensors.0: the key `kind` is missing: `encoder`, `gyro`"),
    ],
)
def test_the_alternatives_of_a_union_leave_no_trace_in_the_path(sensor, line):
    (told,) = complaints(Robot, "{mass: 1, sensors: [{" + sensor + "}]}")
    assert told.startswith(line)


def test_all_that_is_wrong_is_told_at_once_in_the_order_of_the_file():
    text = "gain: 1\nrobots:\n- mass: x\n  name: 1\n- start: [0, y]\ngains: {kp: 1, x: 1}\n"
    assert complaints(Match, text) == [
        "1:1: gain: unknown key; did you mean `gains`?",
        '3:9: robots.0.mass: must be a number, not the text "x"',
        "4:9: robots.0.name: must be a text, not 1",
        "5:3: robots.1: the key `mass` is missing",
        "5:10: robots.1.start: must have 3 entries, not 2",
        '5:14: robots.1.start.1: must be a number, not the text "y"',
        '6:16: gains.x: must match the pattern ^k, not the text "x"',
    ]


def test_a_validator_may_find_many_faults_each_at_its_own_place():
    assert complaints(Match, "robots:\n- {mass: 1, name: a}\n- mass: 2\n  name: a\n") == [
        "1:1: names must differ",
        "2:19: robots.0.name: is taken",
        "4:9: robots.1.name: stands twice",
    ]
    # the name is not written, so the robot is the place
    assert complaints(Match, "robots:\n- mass: 1\n- mass: 2\n")[1:] == [
        "2:3: robots.0.name: is taken",
        "3:3: robots.1.name: stands twice",
    ]


def test_faults_of_a_part_are_told_within_the_whole():
    assert complaints(Match, "robots: [{mass: 1, start: [10, 0, 0]}]") == [
        "1:28: robots.0.start.0: is outside the field"
    ]


def test_known_keys_are_listed_only_where_they_are_few():
    assert complaints(Robot, "{mass: 1, zzz: 2}") == ["1:11: zzz: unknown key"]
    assert complaints(Match, "zzz: 2") == ["1:1: zzz: unknown key; known: `robots`, `gains`"]


def test_only_the_first_of_many_problems_are_shown():
    lines = complaints(Robot, "mass: 1\n" + "".join(f"key{n}: 1\n" for n in range(30)))
    assert len(lines) == MAX_SHOWN + 1
    assert lines[0].startswith("2:1: key0: ")
    assert lines[-1] == " and 10 more"


def test_what_a_user_wrote_is_quoted_in_short():
    (told,) = complaints(Robot, "mass: " + "long " * 1000)
    assert len(told) < 120
    (told,) = complaints(Robot, "mass: 1\n? " + "k" * 5000 + "\n: 1\n")
    assert len(told) < 400


def test_a_grafted_file_and_a_setting_are_named_as_the_place():
    match = parse("robots:\n- {}\n- {}\n- {mass: 1}\n", "s.yaml")
    match.graft(("robots", 0), parse("# my robot\nmass: -1\n", "robot.yaml"))
    match.set("robots.1.mass", "heavy")
    match.set("robots.2.mas", "2")
    with pytest.raises(InputError) as caught:
        validate(Match, match)
    assert str(caught.value).split("\n") == [
        '--set robots.1.mass=heavy: robots.1.mass: must be a number, not the text "heavy"',
        "--set robots.2.mas=2: robots.2.mas: unknown key; did you mean `mass`?",
        "robot.yaml:2:7: robots.0.mass: must be greater than 0, not -1",
    ]


def test_a_validator_sees_the_context():
    class Scaled(Spec):
        size: float

        @field_validator("size")
        @classmethod
        def scale(cls, size, info):
            return size * info.context["scale"]

    assert validate(Scaled, parse("size: 2", "f.yaml"), context={"scale": 3}).size == 6


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text() | st.just("gyro"),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from([*Robot.model_fields, "robots", "gains", "kind", "x\n"]), inner
        )
    ),
    max_leaves=20,
)


@settings(deadline=None)
@given(value=values)
@pytest.mark.parametrize("model", [Robot, Match])
def test_no_value_does_worse_than_a_refusal(model, value):
    try:
        validate(model, Tree({"robots": [value]} if model is Match else value))
    except InputError as error:
        assert all(map(str.isprintable, str(error).split("\n")))  # noqa: PT017
