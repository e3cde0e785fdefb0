"""The table [deployment]: what a shell is opened or folded up from, and what holds it."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import Discriminator, Field, Tag, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Pair, Several, Table

Start = Literal["flat", "pack"]
"""What a shell is folded up or opened from."""
Attachment = Literal["folded", "clipped"]
"""Whether flaps are part of the folding sheet, whose motion they end at the target; or boards that
are clipped on there, so that the sheet can be closed further."""
Index = Annotated[int, Field(ge=0)]
TableVertex = Pair[Index]
"""Row and column of a vertex of the folding sheet."""


def _usual_attachment(given: dict[str, Any]) -> Attachment:
    return "clipped" if given.get("start") == "pack" else "folded"


class FoldTies(Table):
    """Ties across the folds at some rows only, beside those between the feet.

    ``folds`` are rows of inner vertices, counted from 0 in the folding sheet: a tie joins the
    vertices above and below every one of them.
    """

    folds: Annotated[Several[Index], Field(min_length=1)]


Ties = Annotated[
    Annotated[FoldTies, Tag("by rows")]
    | Annotated[Literal["none", "feet", "folds"] | Several[Pair[TableVertex]], Tag("others")],
    Discriminator(lambda value: "by rows" if isinstance(value, dict | FoldTies) else "others"),
]
"""What keeps a shell from opening beyond its target."""


class Deployment(Table):
    """How a shell is deployed; flaps are clipped on where it is opened from its pack.

    ``largest_fold_deg`` is how far hinges close. ``ties`` keep the shell from opening beyond its
    target: none; ties between the feet of every column; these, and across the folds between the
    vertices above and below every inner one, or every one of some rows; or between pairs of
    vertices.
    """

    start: Annotated[Start, Field(alias="from")] = "flat"
    flap_attachment: Attachment = Field(default_factory=_usual_attachment)
    largest_fold_deg: Annotated[Number, Field(gt=0, le=180)] = 180.0
    ties: Ties = "none"

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

    @property
    def largest_fold(self) -> float:
        """How far hinges close (radians)."""
        return float(np.deg2rad(self.largest_fold_deg))


FROM_FLAT = Deployment()
"""As in the paper: folded up from the flat sheet until its flaps stop it."""
