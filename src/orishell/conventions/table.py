"""What all tables of the design file share."""

from __future__ import annotations

from typing import Annotated, Any, Self, TypeVar

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError, PydanticKnownError

T = TypeVar("T")

TRACE = 1e-15
"""Smaller sizes and densities are mistakes, and their products vanish."""

Number = Annotated[float, Field(allow_inf_nan=False)]


def _no_trace(value: float) -> float:
    if 0 < value < TRACE:
        raise PydanticCustomError(
            "trace", "0, or a value of at least {least}", {"least": TRACE, "got": value}
        )
    return value


Size = Annotated[Number, Field(ge=0), AfterValidator(_no_trace)]
"""0 where there is none."""


def entries(count: int | None = None) -> BeforeValidator:
    """What makes a tuple of a list, whose entries are checked as strictly as any value.

    Parameters
    ----------
    count
        How many there must be; None for any number.
    """

    def unchangeable(value: Any) -> Any:
        if isinstance(value, list):
            value = tuple(value)
        if count is None or not isinstance(value, tuple) or len(value) == count:
            return value
        kind, limit = ("too_short", "min") if len(value) < count else ("too_long", "max")
        size = {"field_type": "List", "actual_length": len(value), f"{limit}_length": count}
        raise PydanticKnownError(kind, size)  # type: ignore[arg-type]

    return BeforeValidator(unchangeable)


Several = Annotated[tuple[T, ...], entries()]
Pair = Annotated[tuple[T, T], entries(2)]


class Table(BaseModel):
    """A table of the design file, which is the settings of its subject.

    It has no unknown keys, and its values have the type they should have.
    """

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)

    def having(self, **values: Any) -> Self:
        """The table with other values, which nobody checks."""
        assert values.keys() <= type(self).model_fields.keys()
        return self.model_copy(update=values)
