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
from orishell.families.parallel_repeating import design_parallel_repeating
from orishell.polylines import Spacing
from orishell.spec.table import Number, Table

Auto = Literal["auto"]


class Pattern(Table):
    """What every family asks for: rows and columns of inner vertices."""

    rows: Annotated[int, Field(ge=1, le=10**15)]
    columns: Annotated[int, Field(ge=2, le=10**15)]

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell that these parameters and two target curves ask for."""
        raise NotImplementedError


class ParallelRepeatingPattern(Pattern):
    """Parameters of the parallel repeating family."""

    flap: Annotated[Number, Field(gt=0)] | Auto = "auto"
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
flap = 0.3                  # width of the locking panels; "auto"
xi_deg = 50                 # angle between the creases of column 1 when locked; "auto"
theta_deg = 0               # turns f in its plane; "auto"
plane_deg = 90              # angle between f's plane and g's tangent

[motion]
frames = 25                 # states written, flat to locked
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
