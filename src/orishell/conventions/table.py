"""What all tables of the design file share."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

Number = Annotated[float, Field(allow_inf_nan=False)]


class Table(BaseModel):
    """A table without unknown keys, whose values have the type they should have."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)
