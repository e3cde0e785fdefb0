"""The table [deployment] of a design file."""

from __future__ import annotations

from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Table
from orishell.deployment import Attachment, Deployment, Start

Index = Annotated[int, Field(ge=0)]
Vertex = Annotated[list[Index], Field(min_length=2, max_length=2)]
Pair = Annotated[list[Vertex], Field(min_length=2, max_length=2)]


class DeploymentTable(Table):
    """How the shell is deployed; what is not given follows from where it comes from."""

    start: Annotated[Start, Field(alias="from")] = "flat"
    flap_attachment: Attachment | None = None
    largest_fold_deg: Annotated[Number, Field(gt=0, le=180)] = 180.0
    ties: Literal["none", "feet"] | list[Pair] = "none"

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.start == "pack" and self.flap_attachment == "folded":
            raise PydanticCustomError(
                "flaps_in_the_way",
                '"clipped", because flaps that are part of the sheet keep it from closing beyond '
                "its target into a pack",
                {"key": "flap_attachment", "got": self.flap_attachment},
            )
        return self

    def settings(self) -> Deployment:
        """The settings."""
        ties = self.ties
        return Deployment(
            start=self.start,
            flap_attachment=self.flap_attachment
            or ("clipped" if self.start == "pack" else "folded"),
            largest_fold=float(np.deg2rad(self.largest_fold_deg)),
            ties=ties
            if isinstance(ties, str)
            else tuple(((a[0], a[1]), (b[0], b[1])) for a, b in ties),
        )
