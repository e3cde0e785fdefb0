"""The tables [structure] and [[load_case]] of a design file: what the shell bears, and on what."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from orishell.conventions.errors import InputError
from orishell.conventions.faults import Location
from orishell.conventions.table import Number, Table
from orishell.design import PanelBuild
from orishell.design_file.deployment import Vertex
from orishell.design_file.load_case import (
    LoadCaseTable,
    PointTable,
    SnowTable,
    WindTable,
    ZoneTable,
    load_cases,
)
from orishell.structure.settings import LoadCase, Place, Structure, Support, SupportKind

Positive = Annotated[Number, Field(ge=1e-12, le=1e15)]
"""Numbers beyond these are refused: what is computed from them would overflow in the end."""
Stiffness = Annotated[Number, Field(ge=0, le=1e15)] | Literal["free", "rigid"]
OWN_WEIGHT = LoadCase("self-weight", self_weight=True)
"""The only case where the file has none."""


class SupportTable(Table):
    """What holds some vertices."""

    at: Place | Annotated[list[Vertex], Field(min_length=1)]
    kind: SupportKind
    friction: Annotated[Number, Field(ge=0, le=10)] = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.kind == "friction" and not self.friction:
            raise PydanticCustomError(
                "no_friction",
                "a value above 0; ground without friction holds like kind = sliding",
                {"key": "friction", "got": self.friction},
            )
        if self.kind != "friction" and self.friction:
            raise PydanticCustomError(
                "friction",
                'no friction, or kind = "friction"',
                {"key": "friction", "got": self.friction},
            )
        return self

    def settings(self) -> Support:
        """The support."""
        at = self.at if isinstance(self.at, str) else tuple((row, col) for row, col in self.at)
        return Support(at, self.kind, self.friction)


class StructureTable(Table):
    """What the shell is made of as a structure, and what holds it."""

    modulus: Positive
    supports: Annotated[list[SupportTable], Field(min_length=1)]
    poisson: Annotated[Number, Field(ge=0, le=0.5)] = 0.3
    strength: Positive | None = None
    thickness: Positive | None = None
    membrane_modulus: Annotated[Number, Field(ge=0, le=1e15)] = 0.0
    crease_stiffness: (
        Stiffness | Annotated[list[Stiffness], Field(min_length=2, max_length=2)] | None
    ) = None
    crease_strength: Positive | None = None
    tie_stiffness: Positive | None = None
    tie_strength: Positive | None = None
    cells: Annotated[int, Field(ge=1, le=32)] = 4
    refine: Annotated[Number, Field(ge=0, lt=1)] = 0.0

    @model_validator(mode="after")
    def _check(self) -> Self:
        low, high = self._stiffness()
        if low > high:
            raise PydanticCustomError(
                "stiffness_range",
                "the least stiffness first, then the largest",
                {"key": "crease_stiffness", "got": self.crease_stiffness},
            )
        return self

    def settings(self, cases: tuple[LoadCase, ...]) -> Structure:
        """The structure.

        Parameters
        ----------
        cases
            What loads it.
        """
        return Structure(
            modulus=self.modulus,
            poisson=self.poisson,
            supports=tuple(each.settings() for each in self.supports),
            cases=cases,
            thickness=self.thickness,
            strength=self.strength,
            membrane_modulus=self.membrane_modulus,
            crease_stiffness=self._stiffness(),
            crease_strength=self.crease_strength,
            tie_stiffness=math.inf if self.tie_stiffness is None else self.tie_stiffness,
            tie_strength=self.tie_strength,
            cells=self.cells,
            refine=self.refine,
        )

    def _stiffness(self) -> tuple[float, float]:
        given = self.crease_stiffness
        if given is None:
            return 0.0, math.inf
        low, high = given if isinstance(given, list) else (given, given)
        return _in_numbers(low), _in_numbers(high)


def structure_of(
    table: StructureTable | None, cases: Sequence[LoadCaseTable], panel: PanelBuild | None
) -> Structure | None:
    """The structure that a design file asks for; None without the table.

    Parameters
    ----------
    cases
        Its load cases; none for its own weight.
    panel
        What the table [panel] says.

    Raises
    ------
    InputError
        If load cases or the thickness of panels do not fit.
    """
    if table is None:
        if cases:
            raise InputError(
                "load cases need a structure that they load",
                where="[[load_case]]",
                remedy="add the table [structure], or remove the load cases",
            )
        return None
    _require_one_thickness(table, panel)
    return table.settings(load_cases(cases) or (OWN_WEIGHT,))


def table_at(location: Location) -> type[Table]:
    """The table that a key of [structure] or [[load_case]] stands in.

    Parameters
    ----------
    location
        Keys and indices from the outermost table to the key.
    """
    inner: dict[str, type[Table]] = {
        "supports": SupportTable,
        "snow": SnowTable,
        "wind": WindTable,
        "zones": ZoneTable,
        "points": PointTable,
    }
    names = [each for each in location[:-1] if isinstance(each, str)]
    outer = StructureTable if names[0] == "structure" else LoadCaseTable
    return inner.get(names[-1], outer)


def _require_one_thickness(table: StructureTable, panel: PanelBuild | None) -> None:
    if panel is None and table.thickness is None:
        raise InputError(
            "the thickness of panels is not known",
            where="[structure] thickness",
            remedy="write it here, or in [panel] if the motion is to leave room for it",
        )
    if panel is not None and table.thickness is not None:
        raise InputError(
            "panels have a thickness already",
            where="[structure] thickness",
            got=f"{table.thickness:g}, and {panel.thickness:g} in [panel]",
            remedy="remove it here",
        )
    if table.membrane_modulus and (panel is None or panel.construction != "sandwich"):
        raise InputError(
            "there is no membrane between boards",
            where="[structure] membrane_modulus",
            got=f"{table.membrane_modulus:g}",
            expected='a table [panel] with a thickness and construction = "sandwich"',
            remedy="remove it",
        )


def _in_numbers(stiffness: float | str) -> float:
    if isinstance(stiffness, str):
        return 0.0 if stiffness == "free" else math.inf
    return stiffness
