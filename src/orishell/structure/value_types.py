"""Values of the table [structure] that are numbers or words: their bounds, and what words mean."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Pair, misfit

Positive = Annotated[Number, Field(ge=1e-12, le=1e15)]
"""Numbers beyond these are refused: what is computed from them would overflow in the end."""


def _as_range(given: Any) -> tuple[float, float]:
    """The least and the largest stiffness of creases."""
    words = {"free": 0.0, "rigid": math.inf}
    both = given if isinstance(given, tuple) else (given, given)
    least, most = (words[each] if isinstance(each, str) else each for each in both)
    if least > most:
        raise PydanticCustomError(
            "stiffness_range", "the least stiffness first, then the largest", {"got": given}
        )
    return least, most


if TYPE_CHECKING:
    StiffnessRange = tuple[float, float]
else:
    Stiffness = Annotated[Number, Field(ge=0, le=1e15)] | Literal["free", "rigid"]
    StiffnessRange = Annotated[Stiffness | Pair[Stiffness], AfterValidator(_as_range)]


def _as_limit(given: Any) -> Any:
    """A length, or a part of the span or the height of a shell."""
    if not isinstance(given, str):
        return given
    of, _, parts = given.partition("/")
    if of not in {"span", "height"} or not parts.isdigit() or not 1 <= int(parts) <= 100_000:
        raise misfit('a length, or "span/100" or "height/100" with any whole number', given)
    return given


if TYPE_CHECKING:
    DisplacementLimit = float | str
else:
    DisplacementLimit = Annotated[Positive | str, BeforeValidator(_as_limit)]
