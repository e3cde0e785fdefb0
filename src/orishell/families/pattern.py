"""What every family asks for: its table [pattern], and how it is listed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Self, TypeVar

import numpy as np

from orishell.conventions.table import Table
from orishell.curves import Curve
from orishell.design import Design
from orishell.errors import Remedy
from orishell.families.parameters import (
    COLUMNS,
    FLAP,
    ROWS,
    Auto,
    ColumnCount,
    Knob,
    RowCount,
    Width,
    knobs_of,
)

P = TypeVar("P", bound="Pattern")


@dataclass(frozen=True, slots=True)
class Tolerance:
    """How near the shell must come to the surface, and how long panels' edges may be.

    Parameters
    ----------
    surface
        Largest allowed distance between shell and target surface (length).
    panel_min, panel_max
        Shortest and longest edge that a panel may have, flaps left out (length).
    """

    surface: float
    panel_min: float = 0.0
    panel_max: float = float("inf")


class Pattern(Table):
    """What every family asks for: rows and columns of inner vertices, and flaps."""

    rows: Annotated[RowCount, ROWS]
    columns: Annotated[ColumnCount, COLUMNS]

    flap: Annotated[Width | Auto, FLAP] = "auto"

    most: ClassVar[int] = 201
    """The largest number of rows, and of columns, that is tried to meet a tolerance."""
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

    def variants(self, tolerance: Tolerance) -> list[Self]:
        """Patterns that fill in what the file leaves open so as to need few panels."""
        return [self]


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
    ways = [{key: value for key, value in best.items() if key not in given}]
    if "spacing" not in given and tolerance.panel_max < np.inf:
        ways.append({**ways[0], "spacing": "equal"})
    return [pattern.model_copy(update=way) for way in ways]
