"""The tables [panel] and [panel.hinge]: what panels with a thickness, and their hinges, are."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.table import Number, Size, Table
from orishell.numerics.arrays import Array

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

    SAMPLE: ClassVar = {"knuckle": 0.003}

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


Construction = Literal["sandwich", "bevel", "hinged"]
"""Boards on a membrane that is the hinge, cut square; solid panels about the hinge plane, chamfered
where they close; or whole boards on hinges beside them, of sheets that fold flat.
"""

Sides = Literal["both", "top", "bottom"]
"""The faces of the flat sheet on which a membrane has boards."""

ARM_WIDTH = 0.1
"""Thickness of the fins that carry hinges off the faces, in thicknesses of the boards, where none
is given: sheet metal of 1 mm beside boards of 10 mm. Thicker fins meet other boards sooner."""

HINGED_ONLY = ("largest_arm", "arm_width", "pieces", "arm_density", "hinge")
"""Keys that only whole boards on hinges have."""


class Setback(Table):
    """How far boards may stand back from creases.

    ``share`` is the largest share of the way across a panel that the set-backs at both its sides
    may take, ``length`` the longest set-back.
    """

    SAMPLE: ClassVar = {"share": 0.5}

    share: Annotated[Number, Field(gt=0, lt=1)] = 0.5
    length: Annotated[Number, Field(gt=0)] | None = None


class PanelSpec(Table):
    """What panels are made of, lengths in the unit of the curves; without a thickness of nothing.

    ``thickness`` is that of a panel, boards and membrane together, half of it over the hinge plane;
    of boards on one of the ``sides`` of a membrane, all but half the membrane. ``gap`` is what is
    cut away between two panels where they open; ``stop_deg`` by how much flaps stop short of
    folding flat: half of what their row creases lack to 180 degrees, at the crease that folds most,
    or as little as set-backs allow. Densities are masses per volume, of boards or solid panels, of
    the membrane and of arms; 0 if unknown (kg/m^3).
    """

    thickness: Size = 0.0
    construction: Construction = "sandwich"
    sides: Sides = "both"
    membrane: Size = 0.0
    gap: Size = 0.0
    largest_setback: Setback = Setback()
    stop_deg: Annotated[Number, Field(ge=0, le=45)] | Literal["auto"] = "auto"
    largest_arm: Size | Literal["any"] = "any"
    arm_width: Annotated[Number, Field(gt=0)] | Literal["auto"] = "auto"
    pieces: Annotated[int, Field(ge=2)] | Literal["auto", "whole"] = "whole"
    arm_density: Size = 0.0
    hinge: HingeSpec = HingeSpec()
    density: Size = 0.0
    membrane_density: Size = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        others = self.model_fields_set - {"thickness"}
        if not self.thickness:
            if others:
                raise PydanticCustomError(
                    "no_thickness",
                    "a thickness above 0, because {others} says what thick panels are made of",
                    {"others": ", ".join(sorted(others)), "key": "thickness", "got": 0},
                )
        elif self.construction == "bevel":
            for key in ("membrane", "membrane_density"):
                if getattr(self, key):
                    raise PydanticCustomError(
                        "solid",
                        'no membrane: "bevel" panels are solid. A membrane asks for construction = '
                        '"sandwich"',
                        {"key": key, "got": getattr(self, key)},
                    )
            if not self.gap:
                raise PydanticCustomError(
                    "no_hinge",
                    "a gap above 0: solid panels need room for their hinges. With a membrane "
                    'between boards, construction = "sandwich"',
                    {"key": "gap", "got": self.gap},
                )
        elif self.construction == "hinged":
            self._check_hinged()
        elif not 0 < self.membrane < self.thickness:
            raise PydanticCustomError(
                "no_hinge",
                "the thickness of the membrane between the boards, above 0 and below thickness "
                '({most}): it is their hinge. Without one, construction = "bevel"',
                {"most": self.thickness, "key": "membrane", "got": self.membrane},
            )
        if self.sides != "both" and self.is_solid:
            raise PydanticCustomError(
                "no_sides",
                'construction = "sandwich", because only boards on a membrane may be on one of its '
                "sides alone",
                {"key": "sides", "got": self.sides},
            )
        if self.construction != "hinged":
            for key in HINGED_ONLY:
                if getattr(self, key) != type(self).model_fields[key].default:
                    raise PydanticCustomError(
                        "no_arms",
                        'construction = "hinged", because only whole boards have hinges, arms and '
                        "pieces",
                        {"key": key, "got": _plain(getattr(self, key))},
                    )
        return self

    def _check_hinged(self) -> None:
        """Refuse what whole boards do not have."""
        for key in ("membrane", "membrane_density"):
            if getattr(self, key):
                raise PydanticCustomError(
                    "no_membrane",
                    'no membrane: "hinged" boards are joined by hinges. A membrane asks for '
                    'construction = "sandwich"',
                    {"key": key, "got": getattr(self, key)},
                )
        for key in ("largest_setback", "stop_deg"):
            if key in self.model_fields_set:
                raise PydanticCustomError(
                    "no_setbacks",
                    f'no {key}: "hinged" boards are whole and fold flat',
                    {"key": key, "got": _plain(getattr(self, key))},
                )
        leaf, hole = self.hinge.leaf_on(self.thickness), self.hinge.hole_in(self.thickness)
        if hole > 0.5 * leaf:
            raise PydanticCustomError(
                "hole",
                "at most half the width of a leaf, {most}",
                {"most": f"{0.5 * leaf:.4g}", "key": "hinge.hole", "got": hole},
            )

    @property
    def is_solid(self) -> bool:
        """Whether a panel is one board, and no membrane joins it to others."""
        return self.construction != "sandwich"

    @property
    def longest_arm(self) -> float:
        """How far a hinge may stand off a board, infinite if that is not limited (length)."""
        return math.inf if self.largest_arm == "any" else self.largest_arm

    @property
    def fin(self) -> float:
        """How thick the fins are that carry hinges off the faces (length)."""
        return ARM_WIDTH * self.thickness if self.arm_width == "auto" else self.arm_width

    @property
    def weighs_boards_alone(self) -> bool:
        """Whether whole boards have a density, and not both arms and hinges have."""
        hinged = self.construction == "hinged" and bool(self.density)
        return hinged and not (self.arm_density and self.hinge.linear_density)

    @property
    def one_side(self) -> str:
        """The face of the flat sheet that alone has boards, "top" or "bottom"; empty if both do."""
        return "" if self.sides == "both" else self.sides

    @property
    def heights(self) -> tuple[float, float]:
        """How high a panel stands over its hinge plane on its upper and lower face (length).

        Where there is no board it is as high as half the membrane.
        """
        if self.sides == "both":
            return 0.5 * self.thickness, 0.5 * self.thickness
        low, high = 0.5 * self.membrane, self.thickness - 0.5 * self.membrane
        return (high, low) if self.sides == "top" else (low, high)

    @property
    def height(self) -> float:
        """How high a panel stands over its hinge plane, on the face where that is more (length)."""
        return max(self.heights)

    @property
    def board(self) -> float:
        """How thick each of its boards is (length)."""
        if self.is_solid:
            return self.thickness
        return (self.thickness - self.membrane) / (2 if self.sides == "both" else 1)

    def has_boards(self, face: int) -> bool:
        """Whether there are boards on a face of the flat sheet: 1 for the upper one, -1."""
        return self.sides == "both" or face == (1 if self.sides == "top" else -1)

    def thickness_for(self, heights: Array) -> Array:
        """The thickness with which panels have heights (2, ...) on the upper and the lower face.

        On a face without boards any thickness does whose membrane has room; if it has none, the
        membrane is taken to be thinner in proportion, and panels with it.
        """
        if self.sides == "both":
            return 2 * heights
        half = 0.5 * self.membrane
        bare = np.where(heights >= half, np.inf, heights / half * self.thickness)
        return np.stack(
            [
                high + half if self.has_boards(face) else least
                for face, high, least in zip((1, -1), heights, bare, strict=True)
            ]
        )

    @property
    def share(self) -> float:
        """Largest share of the way across a panel that set-backs may take."""
        return self.largest_setback.share

    @property
    def setback(self) -> float:
        """Longest set-back, infinite if it is not limited (length)."""
        longest = self.largest_setback.length
        return math.inf if longest is None else longest

    @property
    def stop(self) -> float | None:
        """By how much flaps stop short (radians); None for as little as set-backs allow."""
        return None if self.stop_deg == "auto" else float(np.deg2rad(self.stop_deg))


def _plain(value: object) -> object:
    """A value as an error shows it: a table as it stands."""
    return str(value) if isinstance(value, Table) else value
