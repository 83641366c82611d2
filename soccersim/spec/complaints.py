"""What pydantic finds wrong, in our words: what would be right, and what stands there instead."""

import re
from collections.abc import Iterable
from typing import Any

from pydantic_core import ErrorDetails

from soccersim.problems import one_line
from soccersim.spec.annotations import keys, lengths, literals
from soccersim.spec.wording import instead_of, listed, near, show

LONGEST = 300  # characters of a message that is not ours

KINDS = {  # what is needed where another type stands; the key, less _type or _parsing
    "float": "a number",
    "finite_number": "a finite number",
    "int": "a whole number",
    "bool": "true or false",
    "string": "a text",
    "path": "a text",
    "list": "a list",
    "tuple": "a list",
    "set": "a list",
    "frozen_set": "a list",
    "dict": "a mapping (key: value)",
    "model": "a mapping (key: value)",
    "model_attributes": "a mapping (key: value)",
    "dataclass": "a mapping (key: value)",
    "none_required": "null",
}
LIMITS = {  # what is needed of a value of the right type
    "greater_than": "must be greater than {gt}",
    "greater_than_equal": "must be at least {ge}",
    "less_than": "must be less than {lt}",
    "less_than_equal": "must be at most {le}",
    "multiple_of": "must be a multiple of {multiple_of}",
    "string_too_short": "must have at least {min_length} characters",
    "string_too_long": "must have at most {max_length} characters",
    "string_pattern_mismatch": "must match the pattern {pattern}",
    "too_short": "must have at least {min_length} entries",
    "too_long": "must have at most {max_length} entries",
}


def words(errors: list[ErrorDetails], kinds: Iterable[Any]) -> str:
    """One message: of the error at a place, or of all the alternatives that do not fit there."""
    fitting = [error for error in errors if not is_other(error)] or errors
    said = [complaint(error, tuple(kinds)) for error in fitting]
    first, *others = dict.fromkeys(right for right, _ in said)
    needed = " or ".join((first, *(right.removeprefix("must be ") for right in others)))
    return needed + max((wrong for _, wrong in said), key=len)


def stem(error: ErrorDetails) -> str:
    """What an error is about: float for float_type and float_parsing."""
    return re.sub("_(type|parsing|from_float|parsing_size)$", "", error["type"])


def is_other(error: ErrorDetails) -> bool:
    """Whether a value is another kind of thing altogether, so that no limit was even looked at."""
    return stem(error) in KINDS or error["type"] in ("literal_error", "enum")


def complaint(error: ErrorDetails, kinds: tuple[Any, ...]) -> tuple[str, str]:
    """What would be right, and what to add about what stands there."""
    kind, value, context = error["type"], error["input"], error.get("ctx", {})
    if stem(error) in KINDS:
        return f"must be {KINDS[stem(error)]}", f", not {show(value)}{rounded(value, stem(error))}"
    if is_short(error) or (kind == "too_long" and lengths(kinds)):
        return f"must have {max(lengths(kinds), default='more')} entries", f", not {len(value)}"
    if kind in LIMITS:
        limit = {name: number(bound) for name, bound in context.items()}
        stands = context.get("actual_length", show(value))
        right = LIMITS[kind].format(**limit)
        return singular(right), f", not {stands}"
    if kind in ("literal_error", "enum"):
        return choice(context["expected"], value)
    if kind == "union_tag_invalid":
        return choice(context["expected_tags"], context["tag"])
    if kind == "union_tag_not_found":
        return missing(context["discriminator"].strip("'"), kinds), ""
    if kind == "missing":
        return missing(str(error["loc"][-1]), kinds), ""
    if kind == "extra_forbidden":
        known = [name for each in kinds for name, _ in keys(each)]
        return "unknown key" + instead_of(str(error["loc"][-1]), known), ""
    message = str(context["error"]) if "error" in context else error["msg"]
    return one_line(message, LONGEST), ""


def is_short(error: ErrorDetails) -> bool:
    """Whether an error is one of the missing entries of a list."""
    return error["type"] == "missing" and isinstance(error["loc"][-1], int)


def choice(expected: str, value: object) -> tuple[str, str]:
    """The complaint of a value that is none of the expected, given as pydantic lists them."""
    choices = [each.strip("'") for each in re.split(", | or ", expected)]
    one_of = "one of " if len(choices) > 1 else ""
    hint = near(value, choices) if isinstance(value, str) else ""
    return f"must be {one_of}{listed(choices)}", f", not {show(value)}{hint}"


def missing(key: str, kinds: tuple[Any, ...]) -> str:
    """The complaint of a key that is not there, with its choices if it has some."""
    known = (annotation for each in kinds for name, annotation in keys(each) if name == key)
    choices = [value for annotation in known for value in literals(annotation)]
    return f"the key `{one_line(key)}` is missing" + (f": {listed(choices)}" if choices else "")


def rounded(value: object, needed: str) -> str:
    """The remedy for 2.0 where 2 is needed."""
    whole = needed == "int" and isinstance(value, float) and value.is_integer()
    return f": write {int(value)}" if whole and isinstance(value, float) else ""


def number(bound: Any) -> Any:
    """A bound as one would write it: 0 for 0.0."""
    return int(bound) if isinstance(bound, float) and bound.is_integer() else bound


def singular(text: str) -> str:
    """A text in which one of a thing is not called by its plural."""
    return text.replace(" 1 entries", " 1 entry").replace(" 1 characters", " 1 character")
