"""The families by name: their table ``[pattern]`` and a file to begin with.

The only place that knows them; a further family is a class here and an entry in FAMILIES.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, Self, TypeVar

import numpy as np
from pydantic import Field, ValidationError, model_validator
from pydantic_core import PydanticCustomError

from orishell.choosing import Tolerance
from orishell.curves import Curve
from orishell.design import Design, FlapSide
from orishell.errors import InputError, Value
from orishell.families.longitudinal_linear_repeating import (
    Coupling,
    RowKind,
    Sectors,
    design_longitudinal_linear_repeating,
)
from orishell.families.orthodiagonal import design_orthodiagonal
from orishell.families.parallel_repeating import design_parallel_repeating
from orishell.polylines import Placement, Spacing
from orishell.spec import starters
from orishell.spec.table import Number, Table

Auto = Literal["auto"]
P = TypeVar("P", bound="Pattern")


class Pattern(Table):
    """What every family asks for: rows and columns of inner vertices, and flaps."""

    rows: Annotated[int, Field(ge=1, le=10**15)]
    columns: Annotated[int, Field(ge=2, le=10**15)]

    flap: Annotated[Number, Field(ge=0)] | Auto = "auto"

    most: ClassVar[int] = 201
    """Rows and columns that are tried at most to meet a tolerance."""
    needs_target: ClassVar[bool] = True
    """Whether there is no design without f and g."""

    def design(self, f: Curve, g: Curve) -> Design:
        """Design the shell that these parameters and the curves f and g ask for."""
        raise NotImplementedError

    def design_without_target(self) -> Design:
        """Design what these parameters alone ask for, in a family that needs no target."""
        raise NotImplementedError

    def sized(self, rows: int, columns: int) -> Self:
        """The same with other numbers of rows and columns."""
        return self.model_copy(update={"rows": rows, "columns": columns})

    def variants(self, tolerance: Tolerance) -> list[Self]:
        """What the file leaves open, settled in ways that may meet a tolerance with few panels."""
        return [self]

    def changed(self, values: Mapping[str, Value | None]) -> Pattern:
        """The same with other values of its keys, None for a key removed, or of another family.

        Raises
        ------
        InputError
            If a value does not fit.
        """
        table = {**self.model_dump(exclude_unset=True), **values}
        family = table.pop("family", None)
        model = type(self) if family is None else FAMILIES[family].pattern
        try:
            return model.model_validate(
                {key: value for key, value in table.items() if value is not None}
            )
        except ValidationError as error:
            first = error.errors()[0]
            raise InputError(first["msg"], where=".".join(map(str, first["loc"]))) from None


class ParallelRepeatingPattern(Pattern):
    """Parameters of the parallel repeating family."""

    flap_side: FlapSide | Annotated[list[FlapSide], Field(min_length=2, max_length=2)] = "end"
    xi_deg: Annotated[Number, Field(ge=0.1, le=179.9)] | Auto = "auto"
    theta_deg: Annotated[Number, Field(ge=-360, le=360)] | Auto = 0.0
    plane_deg: Annotated[Number, Field(gt=0, lt=180)] = 90.0
    spacing: Spacing = "curvature"
    placement: Placement = "inscribed"

    @model_validator(mode="after")
    def _check(self) -> Self:
        _require_odd(self.rows)
        return self

    def variants(self, tolerance: Tolerance) -> list[Self]:
        """Vertices of g balanced, and if panels may not be long also equally far apart."""
        return _placed(self, tolerance)

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
            placement=self.placement,
        )


class OrthodiagonalPattern(Pattern):
    """Parameters of the orthodiagonal family."""

    flap_side: (
        FlapSide | Auto | Annotated[list[FlapSide | Auto], Field(min_length=2, max_length=2)]
    ) = "auto"
    depth: Annotated[Number, Field(gt=0)] | Auto = "auto"
    heading_deg: Annotated[Number, Field(ge=0, le=180)] | Auto = 90.0
    spacing: Spacing = "curvature"
    placement: Placement = "inscribed"

    @model_validator(mode="after")
    def _check(self) -> Self:
        _require_odd(self.rows)
        return self

    def variants(self, tolerance: Tolerance) -> list[Self]:
        """As for parallel repeating, and shallower zigzags with fewer rows."""
        placed = _placed(self, tolerance)
        if "depth" in self.model_fields_set:
            return placed
        depths = [share * tolerance.surface for share in (0.9, 0.7)]
        return [
            *placed,
            *(each.model_copy(update={"depth": depth}) for each in placed for depth in depths),
        ]

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
            placement=self.placement,
        )


Angle = Annotated[Number, Field(gt=0, lt=180)]
Length = Annotated[Number, Field(gt=0)]


class LongitudinalPattern(Pattern):
    """Parameters of the longitudinal linear repeating family."""

    most: ClassVar[int] = 25
    needs_target: ClassVar[bool] = False

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
        return self._design(f, g)

    def design_without_target(self) -> Design:
        """Design the sheet alone."""
        return self._design(None, None)

    def _design(self, f: Curve | None, g: Curve | None) -> Design:
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
    """What the design file and whoever lists families need to know of one.

    Parameters
    ----------
    pattern
        Its table.
    starter
        A design file to begin with.
    label
        What headings call it.
    what
        What it makes, in a few words.
    """

    pattern: type[Pattern]
    starter: str
    label: str
    what: str


FAMILIES: Mapping[str, Family] = {
    "parallel-repeating": Family(
        ParallelRepeatingPattern,
        starters.PARALLEL_REPEATING,
        "Parallel repeating",
        "Any f along any g, at right angles or oblique",
    ),
    "orthodiagonal": Family(
        OrthodiagonalPattern,
        starters.ORTHODIAGONAL,
        "Orthodiagonal",
        "A wavy cylinder: f along g, in parallel planes",
    ),
    "longitudinal-linear-repeating": Family(
        LongitudinalPattern,
        starters.LONGITUDINAL_LINEAR_REPEATING,
        "Longitudinal",
        "A convex f along a line, growing",
    ),
}


def require_family(name: str, where: str) -> str:
    """The name, if there is such a family."""
    if name not in FAMILIES:
        raise InputError(
            "unknown family",
            where=where,
            got=repr(name[:60]),
            expected="one of " + ", ".join(FAMILIES),
        )
    return name


def starter_file(family: str) -> str:
    """Text of a design file to begin with.

    Parameters
    ----------
    family
        The family's name.

    Raises
    ------
    InputError
        If there is no such family.
    """
    return FAMILIES[require_family(family, "family")].starter + starters.WORKSHOP


def _placed(pattern: P, tolerance: Tolerance) -> list[P]:
    """Patterns whose vertices of g are placed as the file says, or else in the best ways."""
    given = pattern.model_fields_set
    best = {"placement": "balanced", "spacing": "curvature"}
    ways = [{key: value for key, value in best.items() if key not in given}]
    if "spacing" not in given and tolerance.panel_max < np.inf:
        ways.append({**ways[0], "spacing": "equal"})
    return [pattern.model_copy(update=way) for way in ways]


def _radians(degrees: float | Auto) -> float | Auto:
    return "auto" if degrees == "auto" else float(np.deg2rad(degrees))


def _require_odd(rows: int) -> None:
    if rows % 2 == 0:
        raise PydanticCustomError(
            "even_rows",
            "an odd number, so that there is a middle row ({below} or {above})",
            {"below": rows - 1, "above": rows + 1, "key": "rows", "got": rows},
        )
