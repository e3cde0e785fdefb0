"""The families by name: their table ``[pattern]`` and a file to begin with.

The only place that knows them; a further family is a class here and an entry in FAMILIES.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.curves import Curve
from orishell.design import Design, FlapSide
from orishell.errors import InputError
from orishell.families.longitudinal_linear_repeating import (
    Coupling,
    RowKind,
    Sectors,
    design_longitudinal_linear_repeating,
)
from orishell.families.orthodiagonal import design_orthodiagonal
from orishell.families.parallel_repeating import design_parallel_repeating
from orishell.polylines import Spacing
from orishell.spec.table import Number, Table

Auto = Literal["auto"]


class Pattern(Table):
    """What every family asks for: rows and columns of inner vertices, and flaps."""

    rows: Annotated[int, Field(ge=1, le=10**15)]
    columns: Annotated[int, Field(ge=2, le=10**15)]

    flap: Annotated[Number, Field(ge=0)] | Auto = "auto"

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell that these parameters and two target curves ask for."""
        raise NotImplementedError

    def designed(self, f: Curve, g: Curve, flap: float | Auto) -> Design:
        """The same with other curves and flaps of another width."""
        return self.model_copy(update={"flap": flap}).design(f, g)


class ParallelRepeatingPattern(Pattern):
    """Parameters of the parallel repeating family."""

    flap_side: FlapSide | Annotated[list[FlapSide], Field(min_length=2, max_length=2)] = "end"
    xi_deg: Annotated[Number, Field(ge=0.1, le=179.9)] | Auto = "auto"
    theta_deg: Annotated[Number, Field(ge=-360, le=360)] | Auto = 0.0
    plane_deg: Annotated[Number, Field(gt=0, lt=180)] = 90.0
    spacing: Spacing = "curvature"

    @model_validator(mode="after")
    def _check(self) -> Self:
        _require_odd(self.rows)
        return self

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        side = self.flap_side
        return design_parallel_repeating(
            f,
            g,
            rows=self.rows,
            columns=self.columns,
            flap=self.flap,
            flap_sides=(side, side) if isinstance(side, str) else (side[0], side[1]),
            xi=_radians(self.xi_deg),
            theta=_radians(self.theta_deg),
            plane=float(np.deg2rad(self.plane_deg)),
            spacing=self.spacing,
        )


class OrthodiagonalPattern(Pattern):
    """Parameters of the orthodiagonal family."""

    flap_side: (
        FlapSide | Auto | Annotated[list[FlapSide | Auto], Field(min_length=2, max_length=2)]
    ) = "auto"
    depth: Annotated[Number, Field(gt=0)] | Auto = "auto"
    heading_deg: Annotated[Number, Field(ge=0, le=180)] | Auto = 90.0
    spacing: Spacing = "curvature"

    @model_validator(mode="after")
    def _check(self) -> Self:
        _require_odd(self.rows)
        return self

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        side = self.flap_side
        return design_orthodiagonal(
            f,
            g,
            rows=self.rows,
            columns=self.columns,
            depth=self.depth,
            heading=_radians(self.heading_deg),
            flap=self.flap,
            flap_sides=(side, side) if isinstance(side, str) else (side[0], side[1]),
            spacing=self.spacing,
        )


Angle = Annotated[Number, Field(gt=0, lt=180)]
Length = Annotated[Number, Field(gt=0)]


class LongitudinalPattern(Pattern):
    """Parameters of the longitudinal linear repeating family."""

    sector_deg: Annotated[list[Angle], Field(min_length=4, max_length=4)] | Auto
    solution: Annotated[int, Field(ge=0)] = 0
    couplings: list[Coupling] | Literal["periodic"] = "periodic"
    first_row: RowKind = "F"
    row_lengths: list[Length] | Auto = "auto"
    column_lengths: list[Length] | Auto = "auto"
    stage_deg: Annotated[Number, Field(gt=0, le=180)] | Auto = "auto"
    flap: Length | Auto = "auto"

    @model_validator(mode="after")
    def _check(self) -> Self:
        for key, entries, count in (
            ("row_lengths", self.row_lengths, self.columns - 1),
            ("column_lengths", self.column_lengths, self.rows + 1),
            ("couplings", self.couplings, self.columns - 1),
        ):
            if not isinstance(entries, str) and len(entries) != count:
                raise PydanticCustomError(
                    "entries",
                    "{count} entries",
                    {"count": count, "key": key, "got": len(entries)},
                )
        return self

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell."""
        angles = self.sector_deg
        return design_longitudinal_linear_repeating(
            f,
            g,
            rows=self.rows,
            columns=self.columns,
            sectors="auto" if angles == "auto" else Sectors.from_degrees(angles),
            solution=self.solution,
            couplings=self.couplings,
            first_row=self.first_row,
            row_lengths=self.row_lengths,
            column_lengths=self.column_lengths,
            stage=_radians(self.stage_deg),
            flap=self.flap,
        )


@dataclass(frozen=True, slots=True)
class Family:
    """What the design file needs to know of a family: its table and a starter file."""

    pattern: type[Pattern]
    starter: str


FAMILIES: Mapping[str, Family] = {
    "parallel-repeating": Family(
        ParallelRepeatingPattern,
        """\
[shell]
family = "parallel-repeating"
unit = "m"                  # mm, cm, m, in, ft

[target.f]                  # the curve that is swept, in its own plane
formula = "-x**2"           # y(x); or a pair, x(t) and y(t): ["t", "-t**2"]
range = [-1, 1]
# points = "profile.csv"    # instead of formula and range: points, one "x, y" a line
# smooth = true             # a spline through the points, or false: the polyline itself
# scale = 1.0               # enlarges the curve about its origin

[target.g]                  # the curve that it is swept along
formula = "5*sin(pi*x/10)"
range = [0, 20]

[pattern]
rows = 9                    # rows of inner vertices, odd
columns = 11                # columns of inner vertices
flap = 0.3                  # width of the locking panels; "auto"; 0: none, then it does not lock
xi_deg = 50                 # angle between the creases of column 1 when locked; "auto"
theta_deg = 0               # turns f in its plane; "auto"
plane_deg = 90              # angle between f's plane and g's tangent

[motion]
frames = 25                 # states written, flat to locked
""",
    ),
    "orthodiagonal": Family(
        OrthodiagonalPattern,
        """\
[shell]
family = "orthodiagonal"
unit = "m"                  # mm, cm, m, in, ft

[target.f]                  # the curve that is swept, in its own plane
formula = "-x**2"           # y(x); or a pair, x(t) and y(t): ["t", "-t**2"]
range = [-1, 1]
# points = "profile.csv"    # instead of formula and range: points, one "x, y" a line
# smooth = true             # a spline through the points, or false: the polyline itself
# scale = 1.0               # enlarges the curve about its origin

[target.g]                  # the curve that it is swept along
formula = "0.25*sin(pi*x/2)"
range = [0, 4]

[pattern]
rows = 9                    # rows of inner vertices, odd
columns = 13                # columns of inner vertices
flap = 0.15                 # width of the locking panels; "auto"; 0: none, then it does not lock
depth = 0.12                # of the corrugation: vertices this far from f on both sides; "auto"
heading_deg = 90            # angle between f's plane and g's x axis; "auto"

[motion]
frames = 25                 # states written, flat to locked
""",
    ),
    "longitudinal-linear-repeating": Family(
        LongitudinalPattern,
        """\
[shell]
family = "longitudinal-linear-repeating"
unit = "m"                  # mm, cm, m, in, ft

[target.f]                  # the curve that is swept, in its own plane: convex
formula = ["cos(t)", "sin(t)"]  # x(t), y(t); or y(x): "-x**2"
range = [0.3, 2.8416]
# points = "profile.csv"    # instead of formula and range: points, one "x, y" a line
# smooth = true             # a spline through the points, or false: the polyline itself
# scale = 1.0               # enlarges the curve about its origin

[target.g]                  # the line that it is swept along: straight
formula = "0*x"
range = [0, 2.93]

[pattern]
rows = 7                    # rows of inner vertices
columns = 9                 # columns of inner vertices
sector_deg = [85, 80, 95, 100]  # alpha, beta, gamma, delta of column 1; "auto"
solution = 0                # which one of those that orishell solve lists
first_row = "F"             # kind of the first row: "F" or "S"
row_lengths = "auto"        # the most even ones; or 8 ratios, along the middle row
column_lengths = "auto"     # those that follow f; or 8 ratios, down column 1
stage_deg = "auto"          # fold angle of column 1 at which the shell meets f
flap = "auto"               # length of the row creases at the left and right border
couplings = "periodic"      # or 8 times "solve" or "parallel": columns without the period

[motion]
frames = 25                 # states written, flat to the stage
""",
    ),
}


def require_family(name: str, where: str) -> str:
    """The name, if there is such a family."""
    if name not in FAMILIES:
        raise InputError(
            "unknown family", where=where, got=repr(name), expected="one of " + ", ".join(FAMILIES)
        )
    return name


def starter_file(family: str) -> str:
    """Text of a design file to begin with."""
    return FAMILIES[require_family(family, "family")].starter


def _radians(degrees: float | Auto) -> float | Auto:
    return "auto" if degrees == "auto" else float(np.deg2rad(degrees))


def _require_odd(rows: int) -> None:
    if rows % 2 == 0:
        raise PydanticCustomError(
            "even_rows",
            "an odd number, so that there is a middle row ({below} or {above})",
            {"below": rows - 1, "above": rows + 1, "key": "rows", "got": rows},
        )
