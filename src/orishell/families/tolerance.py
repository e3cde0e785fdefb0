"""How near a shell must come, and what is filled in for what a design leaves open to get there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, ClassVar, Generic, Self, TypeVar

import numpy as np
from pydantic import Field, model_validator

from orishell.conventions.record import record
from orishell.conventions.table import Number, Table, misfit

P = TypeVar("P", bound=Table)
T = TypeVar("T")


class Tolerance(Table):
    """The table [tolerance]: how near the shell must come to the surface it is asked for.

    ``surface`` is the largest allowed distance, ``panel_min`` and ``panel_max`` the shortest and
    the longest edge that a panel may have, flaps left out (lengths). ``least_share`` is the least
    share of a panel that a board covers, ``steepest_chamfer_deg`` how far a chamfer leans from a
    square cut at most, in the report's sense.
    """

    SAMPLE: ClassVar = {"surface": 0.1}

    surface: Annotated[Number, Field(gt=0)]
    panel_min: Annotated[Number, Field(ge=0)] = 0.0
    panel_max: Annotated[float, Field(gt=0)] = math.inf
    least_share: Annotated[Number, Field(ge=0, lt=1)] = 0.0
    steepest_chamfer_deg: Annotated[Number, Field(gt=0, lt=90)] | None = None

    @model_validator(mode="after")
    def _check(self) -> Self:
        if not self.panel_min < self.panel_max:
            raise misfit(f"a value above panel_min ({self.panel_min})", self.panel_max, "panel_max")
        return self

    def allows(self, shortest: float, longest: float) -> bool:
        """Whether edges from the shortest to the longest (lengths) are allowed."""
        return self.panel_min <= shortest and longest <= self.panel_max

    @property
    def limits_edges(self) -> bool:
        """Whether edges may not have any length."""
        return self.panel_min > 0 or self.panel_max < float("inf")

    @property
    def limits_boards(self) -> bool:
        """Whether boards may not take any share of panels, or have any chamfers."""
        return self.least_share > 0 or self.steepest_chamfer_deg is not None


@record
class Variants(Generic[T]):
    """What may be filled in for what a design leaves open."""

    # what is to be preferred, first, and what differs from it the most: if none of these nearly
    # does, no other does
    telling: Sequence[T]
    others: Sequence[T] = ()  # everything else that is tried


def placement_variants(pattern: P, tolerance: Tolerance) -> list[P]:
    """Patterns whose vertices of g are placed as the file says, or else in the best ways.

    Parameters
    ----------
    pattern
        What the file says.
    """
    given = pattern.model_fields_set
    best = {"placement": "balanced", "spacing": "curvature"}
    ways = [best]
    if tolerance.panel_max < np.inf:
        ways.append({**best, "spacing": "equal"})
    ways.append({**best, "placement": "inscribed"})
    left_open = [{key: way[key] for key in way if key not in given} for way in ways]
    distinct = [way for k, way in enumerate(left_open) if way not in left_open[:k]]
    return [pattern.model_copy(update=way) for way in distinct]
