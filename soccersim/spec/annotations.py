"""What a model allows at a place: the annotations of pydantic models, walked beside the data."""

from collections.abc import Iterable, Iterator, Mapping
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel


def is_model(kind: Any) -> bool:
    """Whether a type is a model."""
    return isinstance(kind, type) and issubclass(kind, BaseModel)


def alternatives(kind: Any) -> Iterator[Any]:
    """The types that an annotation allows, null left out."""
    origin = get_origin(kind)
    if origin is Annotated:
        yield from alternatives(get_args(kind)[0])
    elif origin in (Union, UnionType):
        for argument in get_args(kind):
            yield from alternatives(argument)
    elif kind is not NoneType:
        yield kind


def entries(kind: Any, step: str | int) -> Iterator[Any]:
    """The types that may stand at an entry (key or index) of a value of this type."""
    if is_model(kind):
        for name, annotation in keys(kind):
            if name == step:
                yield from alternatives(annotation)
        return
    origin, arguments = get_origin(kind), get_args(kind)
    if origin in (dict, Mapping):
        arguments = arguments[1:]
    elif origin is tuple and isinstance(step, int) and ... not in arguments:
        arguments = arguments[step:]
    for argument in arguments[:1]:
        yield from alternatives(argument)


def keys(kind: Any) -> Iterator[tuple[str, Any]]:
    """The keys of a model as they are written, each with its annotation."""
    if is_model(kind):
        for name, field in kind.model_fields.items():
            yield field.alias or name, field.annotation


def is_tag(step: str | int, kind: Any) -> bool:
    """Whether a step names this model among those of a union, by the value of a literal key."""
    return any(step in literals(annotation) for _, annotation in keys(kind))


def literals(kind: Any) -> tuple[Any, ...]:
    """The values of a Literal; none of another type."""
    return get_args(kind) if get_origin(kind) is Literal else ()


def lengths(kinds: Iterable[Any]) -> list[int]:
    """How many entries the lists of a fixed length among these types have."""
    tuples = (get_args(kind) for kind in kinds if get_origin(kind) is tuple)
    return [len(entry) for entry in tuples if ... not in entry]
