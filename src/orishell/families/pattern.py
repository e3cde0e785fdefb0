"""What every family asks for: its table [pattern], and how it is listed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Generic, Self, TypeVar

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import Remedy
from orishell.conventions.record import record
from orishell.conventions.table import Knob, Number, Table, knobs_of
from orishell.curves import Curve
from orishell.design import Design
from orishell.families.parameters import COLUMNS, FLAP, ROWS, Auto, ColumnCount, RowCount, Width

P = TypeVar("P", bound="Pattern")
T = TypeVar("T")


class Tolerance(Table):
    """The table [tolerance]: how near the shell must come to the surface it is asked for.

    ``surface`` is the largest allowed distance, ``panel_min`` and ``panel_max`` the shortest and
    the longest edge that a panel may have, flaps left out (lengths).
    """

    surface: Annotated[Number, Field(gt=0)]
    panel_min: Annotated[Number, Field(ge=0)] = 0.0
    panel_max: Annotated[float, Field(gt=0)] = math.inf

    @model_validator(mode="after")
    def _check(self) -> Self:
        if not self.panel_min < self.panel_max:
            raise PydanticCustomError(
                "panel_sizes",
                "a value above panel_min ({low})",
                {"low": self.panel_min, "key": "panel_max", "got": self.panel_max},
            )
        return self

    @property
    def limits_edges(self) -> bool:
        """Whether edges may not have any length."""
        return self.panel_min > 0 or self.panel_max < float("inf")


@record
class Variants(Generic[T]):
    """What may be filled in for what a design leaves open.

    Parameters
    ----------
    telling
        What is to be preferred, first, and what differs from it the most: if none of these nearly
        does, no other does.
    others
        Everything else that is tried.
    """

    telling: Sequence[T]
    others: Sequence[T] = ()


class Pattern(Table):
    """What every family asks for: rows and columns of inner vertices, and flaps."""

    rows: Annotated[RowCount, ROWS]
    columns: Annotated[ColumnCount, COLUMNS]

    flap: Annotated[Width | Auto, FLAP] = "auto"

    most: ClassVar[int] = 201
    """The largest number of rows, and of columns, that is tried to meet a tolerance."""
    row_step: ClassVar[int] = 2
    """Numbers of rows that the family makes are 1 and so many more, again and again."""
    ripple: ClassVar[float] = 1.5
    """A shell is farther from its surface than one with fewer columns by such a factor at most."""
    orderly: ClassVar[bool] = False
    """Whether that holds for fewer rows as well, and none is nearer whose column 1 is farther from
    f."""
    closing: ClassVar[Remedy | None] = None
    """A change with which all creases of a shell without flaps may close together."""
    needs_target: ClassVar[bool] = True
    """Whether there is no design without f and g."""

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell that these parameters and the curves f and g ask for."""
        raise NotImplementedError

    def design_without_target(self) -> Design:
        """Design what these parameters alone ask for, in a family that needs no target."""
        raise NotImplementedError

    def arguments(self) -> dict[str, Any]:
        """The keys as the functions take them: angles in radians, one side for each flap."""
        values: dict[str, Any] = {}
        for key in type(self).model_fields:
            value = getattr(self, key)
            if key == "flap_side":
                values["flap_sides"] = (value, value) if isinstance(value, str) else tuple(value)
            elif key.endswith("_deg"):
                found = value if value == "auto" else np.deg2rad(value).tolist()
                values[key.removesuffix("_deg")] = found
            else:
                values[key] = value
        return values

    @classmethod
    def knobs(cls) -> dict[str, Knob]:
        """The knobs of all keys that the studio shows, rows and columns first."""
        return knobs_of(cls)

    def sized(self, rows: int, columns: int) -> Self:
        """The same pattern with other numbers of rows and columns."""
        return self.model_copy(update={"rows": rows, "columns": columns})

    def variants(self, f: Curve, tolerance: Tolerance) -> Variants[Self]:
        """Patterns of as many rows that fill in what the file leaves open.

        Parameters
        ----------
        f
            The swept curve.
        tolerance
            What is to be met.

        Raises
        ------
        DesignError
            If f cannot be followed at all.
        """
        return Variants([self])

    def distance_from_f(self, f: Curve) -> float:
        """A distance (length) at which column 1 is from f at least, however many columns there are.

        0 where none is known before the sheet is made.

        Raises
        ------
        DesignError
            If there is no such column.
        """
        return 0.0

    def distance_from_g(self, g: Curve) -> float:
        """A distance (length) at which the middle row is from g at least, however many rows are.

        0 where none is known before the sheet is made.

        Raises
        ------
        DesignError
            If there is no such row.
        """
        return 0.0


@dataclass(frozen=True, slots=True)
class Family:
    """A family as the design file, the studio and the command line know it.

    Parameters
    ----------
    name
        What the design file calls it.
    pattern
        Its table.
    label
        What headings call it.
    what
        What it makes, in a few words.
    starter
        A design file to begin with.
    """

    name: str
    pattern: type[Pattern]
    label: str
    what: str
    starter: Path


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
