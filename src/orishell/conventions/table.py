"""What all tables of the design file share, and how the studio shows their keys."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal, Self, TypeVar

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError, PydanticKnownError

T = TypeVar("T")

TRACE = 1e-15
"""Smaller sizes and densities are mistakes, and their products vanish."""

Number = Annotated[float, Field(allow_inf_nan=False)]


def misfit(expected: str, got: Any, key: str = "") -> PydanticCustomError:
    """The error about a value that does not fit; ``key`` names it within what is checked."""
    return PydanticCustomError("misfit", expected, {"got": got, **({"key": key} if key else {})})


def _no_trace(value: float) -> float:
    if 0 < value < TRACE:
        raise misfit(f"0, or a value of at least {TRACE}", value)
    return value


Size = Annotated[Number, Field(ge=0), AfterValidator(_no_trace)]
"""0 where there is none."""


def entries(count: int | None = None) -> BeforeValidator:
    """What makes a tuple of a list, whose entries are checked as strictly as any value."""

    def unchangeable(value: Any) -> Any:
        if isinstance(value, list):
            value = tuple(value)
        if count is None or not isinstance(value, tuple) or len(value) == count:
            return value
        few = len(value) < count
        size = {"actual_length": len(value), "min_length" if few else "max_length": count}
        raise PydanticKnownError("too_short" if few else "too_long", {"field_type": "List", **size})

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


Kind = Literal["integer", "number", "choice", "angles4", "switch", "size"]
Measure = Literal["length", "deg", "kg/m", "kg/m²", ""]


@dataclass(frozen=True, slots=True)
class Knob:
    """One parameter, as a control of the studio shows it: metadata of its key in a table.

    A "switch" is on or off, a "size" is a width and a height. The unit "length" is the design's.
    Without a slider it depends on the curves how far it reaches. What is ``advanced`` is folded
    away until it is asked for.
    """

    label: str
    help: str
    kind: Kind
    auto: bool = False
    unit: Measure = ""
    slider: tuple[float, float] | None = None
    step: float | None = None
    choices: tuple[str, ...] = ()
    advanced: bool = False

    @classmethod
    def angle(
        cls,
        label: str,
        help: str,  # noqa: A002 # the field's name
        slider: tuple[float, float],
        *,
        step: float = 0.5,
        auto: bool = True,
        advanced: bool = False,
    ) -> Knob:
        """A knob for an angle in degrees."""
        return cls(label, help, "number", auto, "deg", slider, step, advanced=advanced)


def knobs_of(model: type[BaseModel]) -> dict[str, Knob]:
    """The knobs of all keys of a table that the studio shows, in their order."""
    return {
        key: each
        for key, field in model.model_fields.items()
        for each in field.metadata
        if isinstance(each, Knob)
    }
