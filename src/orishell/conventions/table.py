"""What all tables of the design file share."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, Field
from pydantic_core import PydanticCustomError

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


class Table(BaseModel):
    """A table without unknown keys, whose values have the type they should have."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)
