"""From a tree to a validated model: all that is wrong with a file, in our words, each at its place.

Types are never guessed: a text is not a number, true is not 1, and 2.0 is not a whole number.
YAML knows lists and numbers only, so a list serves as a tuple and 3 where a float is wanted.
"""

import json
from collections import defaultdict
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple, TypeVar

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from soccersim.problems import InputError, Problem, one_line
from soccersim.spec.annotations import entries, is_tag
from soccersim.spec.complaints import is_short, words
from soccersim.spec.wording import dotted
from soccersim.spec.yaml12 import Mark, Path, Tree

M = TypeVar("M", bound=BaseModel)

MAX_SHOWN = 20  # problems of one file; the rest is counted


class Fault(ValueError):
    """What a spec's own validator finds wrong; `at` is the place, seen from that validator."""

    def __init__(self, message: str, at: Path = ()) -> None:
        super().__init__(message)
        self.at = at
        self.faults: tuple[Fault, ...] = (self,)

    @classmethod
    def many(cls, faults: Iterable["Fault"]) -> "Fault":
        """Several faults, raised as one."""
        each = tuple(single for fault in faults for single in fault.faults)
        whole = cls("; ".join(map(str, each)))
        whole.faults = each
        return whole


def validate(model: type[M], tree: Tree, context: Any = None) -> M:
    """The tree as a model; InputError with all its problems, in the order of the file."""
    try:
        # as JSON, where strict mode takes a list for a tuple and a text for an enum
        return model.model_validate_json(json.dumps(tree.value), strict=True, context=context)
    except ValidationError as error:
        wrong = [each for each in error.errors(include_url=False) if not is_hollow(each)]
        problems = told(model, tree, wrong)
    except (RecursionError, ArithmeticError) as error:  # from a validator that met odd values
        message = f"these values cannot be worked with ({one_line(str(error))})"
        raise InputError(Problem(message, tree.place(()).file)) from error
    raise InputError(problems)


class Way(NamedTuple):
    """Where a location of pydantic's leads in a tree, and what the model allows there."""

    path: Path
    types: tuple[Any, ...]
    tags: tuple[tuple[Path, str | int], ...]  # steps that only name an alternative of a union


class Finding(NamedTuple):
    """One thing wrong, at its place, not yet in words: those take time, and few are shown."""

    path: Path
    mark: Mark
    types: tuple[Any, ...]
    errors: list[ErrorDetails]  # more than one: no alternative of a union fits


def told(model: type[BaseModel], tree: Tree, errors: list[ErrorDetails]) -> list[Problem]:
    """The problems to show: in the order of the file, those of grafted files after them."""
    file = tree.place(()).file
    found = sorted(findings(model, tree, errors), key=lambda f: (f.mark.file != file, f.mark))
    shown = [
        Problem(words(each.errors, each.types), *each.mark, path=dotted(each.path))
        for each in found[:MAX_SHOWN]
    ]
    if len(found) > MAX_SHOWN:
        shown.append(Problem(f"and {len(found) - MAX_SHOWN} more", file))
    return shown


def findings(model: type[BaseModel], tree: Tree, errors: list[ErrorDetails]) -> Iterator[Finding]:
    """What is wrong; the errors of a union's alternatives at one place are one finding."""
    ways = [follow(model, holder(error), tree.value) for error in errors]
    tags: dict[Path, set[str | int]] = defaultdict(set)
    for path, tag in (step for way in ways for step in way.tags):
        tags[path].add(tag)
    deeper = {way.path[:size] for way in ways for size in range(len(way.path))}
    deeper |= {way.path for way, error in zip(ways, errors, strict=True) if is_about_key(error)}
    joined: dict[Path, Finding] = {}
    for way, error in zip(ways, errors, strict=True):
        ends = not is_about_key(error) and way.tags[-1:] and way.tags[-1][0] == way.path
        alternative = ends and len(tags[way.path]) > 1
        if alternative and way.path in deeper:
            continue  # another alternative fits better: its errors serve
        if alternative or is_short(error):
            finding = Finding(way.path, tree.place(way.path), way.types, [])
            joined.setdefault(way.path, finding).errors.append(error)
        else:
            yield from placed(way, error, tree)
    yield from joined.values()


def placed(way: Way, error: ErrorDetails, tree: Tree) -> Iterator[Finding]:
    """The findings of one error, at their places: several if a validator raised many faults."""
    kind, context = error["type"], error.get("ctx", {})
    path, key = way.path, error["loc"][-1] if error["loc"] else ""
    cause = context.get("error")
    if isinstance(cause, Fault):
        for fault in cause.faults:
            at = path + fault.at
            single: ErrorDetails = {**error, "ctx": {"error": fault}}
            yield Finding(at, tree.place(at), way.types, [single])
    elif kind == "extra_forbidden":
        yield Finding((*path, key), tree.keys.get((*path, key), Mark("")), way.types, [error])
    elif key == "[key]":  # pydantic's word for the key itself
        yield Finding(path, tree.keys.get(path, Mark("")), way.types, [error])
    elif kind == "union_tag_invalid":
        path = (*path, context["discriminator"].strip("'"))
        yield Finding(path, tree.place(path), way.types, [error])
    else:
        yield Finding(path, tree.place(path), way.types, [error])


def holder(error: ErrorDetails) -> tuple[str | int, ...]:
    """The location of the value with the fault; of the mapping, for a missing or unknown key."""
    return error["loc"][:-1] if is_about_key(error) else error["loc"]


def is_hollow(error: ErrorDetails) -> bool:
    """Whether a list only counts as short because pydantic left its wrong entries out."""
    given = error["input"]
    return (
        error["type"] == "too_short"
        and isinstance(given, list)
        and len(given) >= error["ctx"]["min_length"]
    )


def is_about_key(error: ErrorDetails) -> bool:
    """Whether the last step of an error's location is a key too few or too many."""
    return error["type"] in ("missing", "extra_forbidden")


def follow(model: type[BaseModel], location: tuple[str | int, ...], value: Any) -> Way:
    """The way of a location through the value, with the types of the model beside it."""
    way = Way((), (model,), ())
    for step in location:
        tagged = tuple(t for t in way.types if is_tag(step, t)) if len(way.types) > 1 else ()
        if tagged or not holds(value, step):
            way = Way(way.path, tagged or way.types, (*way.tags, (way.path, step)))
        else:
            value = value[step]
            below = tuple(kind for t in way.types for kind in entries(t, step))
            way = Way((*way.path, step), below, way.tags)
    return way


def holds(value: Any, step: str | int) -> bool:
    """Whether a value has the entry (key or index) step."""
    if isinstance(value, list):
        return isinstance(step, int) and step < len(value)
    return isinstance(value, dict) and step in value
