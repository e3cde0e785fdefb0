"""Which values the parameters of a family may take, and how the studio shows them.

The types stand both in the tables [pattern] and in the signatures of the functions that design, so
that both refuse the same values. Angles are in degrees in the tables, in radians in the functions.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Annotated, Final, Literal, TypedDict, cast

import numpy as np
from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Knob, Number
from orishell.design import FlapSide

Auto = Literal["auto"]


class Limits(TypedDict, total=False):
    """Limits of an angle, as pydantic's ``Field`` takes them."""

    ge: float
    gt: float
    le: float
    lt: float


LIMITED: Final[dict[str, tuple[Callable[[float, float], bool], str]]] = {
    "ge": (operator.ge, "at least"),
    "gt": (operator.gt, "greater than"),
    "le": (operator.le, "at most"),
    "lt": (operator.lt, "less than"),
}


def in_radians(limits: Limits) -> AfterValidator:
    """The check of an angle in radians by limits in degrees: to the last bit the same.

    Parameters
    ----------
    limits
        The limits (degrees).
    """
    degrees = cast("dict[str, float]", limits)

    def check(angle: float) -> float:
        for key, end in degrees.items():
            within, words = LIMITED[key]
            limit = float(np.deg2rad(end))
            if not within(angle, limit):
                meant = ""
                if all(LIMITED[each][0](angle, other) for each, other in degrees.items()):
                    meant = f" ({angle:g} degrees are {np.deg2rad(angle):.4g})"
                raise PydanticCustomError(
                    "radians",
                    "an angle in radians, {words} {limit}{meant}",
                    {"words": words, "limit": f"{limit:g}", "meant": meant},
                )
        return angle

    return AfterValidator(check)


def _require_odd(rows: int) -> int:
    if rows % 2 == 0:
        raise PydanticCustomError(
            "even_rows",
            "an odd number, so that there is a middle row ({below} or {above})",
            {"below": rows - 1, "above": rows + 1},
        )
    return rows


RowCount = Annotated[int, Field(ge=1, le=10**15)]
OddRowCount = Annotated[RowCount, AfterValidator(_require_odd)]
ColumnCount = Annotated[int, Field(ge=2, le=10**15)]
Length = Annotated[Number, Field(gt=0)]
Width = Annotated[Number, Field(ge=0)]
"""A width that may be 0: then there are no flaps."""
FlapSides = Annotated[Sequence[FlapSide], Field(min_length=2, max_length=2)]
"""Where the left and the right flap fold to."""

ROWS: Final = Knob("Rows", "Rows of inner vertices, odd", "integer", slider=(1, 61), step=2)
COLUMNS: Final = Knob("Columns", "Columns of inner vertices", "integer", slider=(2, 61), step=1)
FLAP: Final = Knob("Flap", "Width of the locking flaps; 0 for none", "number", True, "length")
FLAP_SIDE: Final = Knob(
    "Flaps fold to", "End of f to which both flaps fold", "choice", choices=("start", "end")
)
SPACING: Final = Knob(
    "Spacing",
    "Columns closer together where g bends, or equally far apart",
    "choice",
    choices=("curvature", "equal"),
)
PLACEMENT: Final = Knob(
    "Placement",
    "Columns on g, or moved off it to be equally wrong on both sides",
    "choice",
    choices=("inscribed", "balanced"),
)
