"""The table [panel.hinge]: the hinges of whole boards, as they are bought and screwed on."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from orishell.conventions.table import Number, Size, Table

Length = Annotated[Number, Field(gt=0)] | Literal["auto"]

LEAF = 2.0
"""Width of a leaf in thicknesses of its board: its holes then lie one thickness from the edge."""
SCREW_SPACING = 6.0
"""Distance of holes along a hinge in thicknesses: 60 mm in boards of 10 mm, as in piano hinges."""
HOLE = 0.3
"""Diameter of holes in thicknesses, for screws of 3 mm in boards of 10 mm: the edge of the board
is then as far from them as EN 1995-1-1 (8.3.1) asks of nails in wood, three diameters or more."""


class HingeSpec(Table):
    """Hinges of whole boards and what screws them on, lengths in the unit of the curves.

    ``leaf`` is the width of a leaf on its board, ``knuckle`` the radius of the knuckle, by which
    the axis stands off the face that the leaf lies on; 0 where it is let into the boards.
    ``screw_spacing`` is the distance of holes along a hinge, ``hole`` their diameter, and
    ``linear_density`` the mass of a hinge per length (kg/m), 0 if unknown.
    """

    leaf: Length = "auto"
    knuckle: Size = 0.0
    screw_spacing: Length = "auto"
    hole: Length = "auto"
    linear_density: Size = 0.0

    def leaf_on(self, thickness: float) -> float:
        """Width of a leaf on boards of a thickness (length)."""
        return LEAF * thickness if self.leaf == "auto" else self.leaf

    def spacing_on(self, thickness: float) -> float:
        """Distance of holes along a hinge on boards of a thickness (length)."""
        return SCREW_SPACING * thickness if self.screw_spacing == "auto" else self.screw_spacing

    def hole_in(self, thickness: float) -> float:
        """Diameter of holes in boards of a thickness (length)."""
        return HOLE * thickness if self.hole == "auto" else self.hole
