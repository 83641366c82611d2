"""What every spec is: frozen, strict, and of finite numbers."""

from typing import Annotated, TypeVar

from pydantic import BaseModel, ConfigDict, Field

T = TypeVar("T")


class Spec(BaseModel):
    """A frozen model that forbids unknown keys and guesses no types.

    A docstring under a key is its description in the JSON Schema. Numbers are SI (metres,
    kilograms, seconds, radians) unless the key's name ends in another unit.
    """

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        strict=True,
        allow_inf_nan=False,
        use_attribute_docstrings=True,
    )


# far beyond any robot, and near enough to 1 that no product of a few overflows or vanishes
Positive = Annotated[float, Field(ge=1e-9, le=1e6)]
NonNegative = Annotated[float, Field(ge=0, le=1e6)]
Number = Annotated[float, Field(ge=-1e6, le=1e6)]
Share = Annotated[float, Field(ge=0, le=1)]
Rate = Annotated[int, Field(gt=0, le=10_000)]
# a YAML list is a list: strict tuples would refuse it, so these alone are not strict
Point = Annotated[tuple[Number, Number], Field(strict=False)]
Pose = Annotated[tuple[Number, Number, Number], Field(strict=False)]
Name = Annotated[str, Field(min_length=1, max_length=64, pattern=r"^[^\x00-\x1f/\\]+$")]


def per_item(value: float | tuple[float, ...], count: int) -> tuple[float, ...]:
    """One value for each of count items: a single number serves all."""
    return value if isinstance(value, tuple) else (value,) * count
