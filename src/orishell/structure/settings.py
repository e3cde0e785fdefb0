"""The table [structure]: what a shell is made of, and what holds it.

Lengths are in the design's unit, forces in newtons, wind speeds in metres per second.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Literal, Self

from pydantic import (
    Field,
    ValidationInfo,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from orishell.conventions.asked import PLACE
from orishell.conventions.quantities import conversion
from orishell.conventions.table import Number, Several, Table, misfit
from orishell.structure.combinations import Expression, Factors, arranged, combine
from orishell.structure.grain import Grain, GrainModuli, GrainStrength
from orishell.structure.hinge_lines import LineStrengths
from orishell.structure.load_settings import (
    LOADS,
    NO_CODE,
    OWN_WEIGHT,
    LoadCase,
    Person,
    PointLoad,
    Snow,
    Terrain,
    Wind,
    Zone,
)
from orishell.structure.materials import Duration, ServiceClass, materials
from orishell.structure.mesh.layup import Layup
from orishell.structure.rail_settings import BaseRail
from orishell.structure.sandwich import Sandwich
from orishell.structure.support_settings import Place, Support, SupportKind
from orishell.structure.value_types import DisplacementLimit, Positive, StiffnessRange

__all__ = [
    "LOADS",
    "NO_CODE",
    "OWN_WEIGHT",
    "LoadCase",
    "Person",
    "Place",
    "PointLoad",
    "Snow",
    "Structure",
    "StructureTable",
    "Support",
    "SupportKind",
    "Terrain",
    "Wind",
    "Zone",
    "not_combined",
]


class StructureTable(Table):
    """What a structure is made of, and what holds it."""

    # what panels are made of, by its name in materials.toml: what is not given is taken from there
    material: str | None = None
    # how wet it becomes, the service class of EN 1995: 1 indoors, 2 under a roof, 3 outdoors; for
    # what materials bear by name
    service_class: ServiceClass = 3
    # Young's modulus of panels or boards, of their section as a whole, or of the faces of a
    # sandwich; None if it is that of the material (force per area)
    modulus: Annotated[Positive | None, Field(validate_default=True)] = None
    # what boards are of whose faces are on a core; None if they are solid, or as the material is
    sandwich: Sandwich | None = None
    # which way the grain of the faces runs, of a material that has one: along row creases or along
    # column creases; None if nobody knows, and both ways bear what the weaker does
    grain: Grain | None = None
    supports: Annotated[Several[Support], Field(min_length=1)]  # what holds it
    poisson: Annotated[Number, Field(ge=0, le=0.5)] = 0.3  # Poisson's ratio of panels
    # what panels bear, or the faces of a sandwich, its design value; None if it is that of the
    # material (force per area)
    strength: Positive | None = None
    thickness: Positive | None = None  # of panels, where the design has none; else None (length)
    # Young's modulus of the membrane between boards; 0 if it is not counted (force per area)
    membrane_modulus: Annotated[Number, Field(ge=0, le=1e15)] = 0.0
    # stress that the membrane between boards bears; None if that is not known (force per area)
    membrane_strength: Positive | None = None
    # least and largest moment per length and angle of creases: 0 for free hinges, infinite for
    # rigid ones (force per radian)
    crease_stiffness: StiffnessRange = (0.0, math.inf)
    # what creases bear: moment per length; None if that is not known (force)
    crease_strength: Positive | None = None
    # lever arm of what locks creases, between crease line and where panels meet; None if it is the
    # thickness of panels, half of it where a membrane is their hinge (length)
    crease_lever: Positive | None = None
    # what creases bear as crease lines, by direction; None if that is not known (force per length)
    line_strength: LineStrengths | None = None
    # what holds edges of gussets, and of plates across box girders, bears, by direction; None if
    # that is not known (force per length)
    edge_strength: LineStrengths | None = None
    # Young's modulus of the arms that hinges of whole boards stand on; None for rigid ones (force
    # per area)
    arm_modulus: Positive | None = None
    # stress that these arms bear; None if that is not known (force per area)
    arm_strength: Positive | None = None
    # force by strain of a tie; infinite if it does not stretch (N)
    tie_stiffness: Positive = math.inf
    tie_strength: Positive | None = None  # what a tie bears; None if that is not known (N)
    # bars that join neighbouring feet of a row; None without them
    rail: BaseRail | None = None
    # code whose combinations of cases are made; then cases are combined and not analysed alone
    combinations: Literal["none", "EN 1990"] = "none"
    expression: Expression = "6.10"  # of strength, in EN 1990
    factors: Factors = Factors()  # those of EN 1990
    # how far the shell may be displaced: a length, or a part of its span or height (length)
    displacement_limit: DisplacementLimit | None = None
    # cells along every side of a panel, of two triangles each
    cells: Annotated[int, Field(ge=1, le=32)] = 6
    # cells become finer until displacement, stress and buckling change by less than this share from
    # the next coarser mesh; 0 to leave them as they are
    refine: Annotated[Number, Field(ge=0, lt=1)] = 0.0
    nonlinear: bool = False  # whether large displacements are followed
    # how far the shape is off as built: so much at most, as the first way in which it buckles; only
    # where large displacements are followed; None for what codes allow there where it buckles under
    # less than three times its loads (length)
    imperfection: Annotated[Number, Field(ge=0, le=1e15)] | None = None

    @field_validator("sandwich")
    @classmethod
    def _require_core(cls, sandwich: Sandwich | None, info: ValidationInfo) -> Sandwich | None:
        name = info.data.get("material")
        made = None if name is None else materials()[name]
        if sandwich is None:
            return None
        if made is not None and made.grain is not None:
            raise misfit("no sandwich, or faces of a material without a grain", name)
        missing = sandwich.filled(None if made is None else made.sandwich, "m").missing
        if missing:
            raise misfit(f"also {' and '.join(missing)}", "a sandwich without it")
        return sandwich

    @model_validator(mode="after")
    def _require_one_strength(self) -> Self:
        if self.grain is not None and self.strength is not None:
            raise misfit(
                "no strength, or no grain: strength is taken alike in all directions",
                self.strength,
                "strength",
            )
        return self

    @model_validator(mode="after")
    def _follow_imperfect(self) -> Self:
        if self.imperfection and not self.nonlinear:
            raise misfit(
                "no imperfection, or nonlinear = true: linear theory knows the shell as designed",
                self.imperfection,
                "imperfection",
            )
        return self

    @field_validator("material")
    @classmethod
    def _require_material(cls, material: str | None) -> str | None:
        if material is not None and material not in materials():
            names = ", ".join(f'"{name}"' for name in materials())
            raise misfit(f"one of {names}", material, choices=tuple(materials()))
        return material

    @field_validator("grain")
    @classmethod
    def _require_grain(cls, grain: Grain | None, info: ValidationInfo) -> Grain | None:
        name = info.data.get("material")
        if grain is not None and (name is None or materials()[name].grain is None):
            with_grain = ", ".join(f'"{key}"' for key, made in materials().items() if made.grain)
            raise misfit(f"no grain, or a material that has one: {with_grain}", grain)
        return grain

    @field_validator("modulus")
    @classmethod
    def _require_modulus(cls, modulus: float | None, info: ValidationInfo) -> float | None:
        # A material that is wrong is not in the data: that is said of it alone.
        if modulus is None and info.data.get("material", "") is None:
            raise PydanticCustomError("missing", "Field required")
        return modulus

    def filled(self, unit: str) -> Self:
        """With the values of its material and its crease lines where they are not given."""
        named = {
            key: lines.filled(unit)
            for key in ("line_strength", "edge_strength")
            if (lines := getattr(self, key)) is not None and lines.kind is not None
        }
        return (self.replace_unchecked(**named) if named else self)._of_material(unit)

    def bears(self, duration: Duration, unit: str) -> float | None:
        """What panels bear under loads of a duration, per square of a unit; None if not known."""
        if self.strength is not None or self.material is None:
            return self.strength
        made = materials()[self.material]
        return made.bears(duration, self.service_class) * conversion(unit, "m") ** 2

    @property
    def grain_moduli(self) -> GrainModuli | None:
        """How stiff its boards are by their grain; None if they have none."""
        return None if self.material is None else materials()[self.material].grain_moduli

    @property
    def has_grain(self) -> bool:
        """Whether its boards bear what they do by their grain."""
        named = self.material is not None and materials()[self.material].grain is not None
        return named and self.strength is None

    def grain_strength(self, duration: Duration, unit: str) -> GrainStrength | None:
        """What boards bear by their grain under loads of a duration; None if that is not known.

        What is given as strength is taken as it is, whichever way the grain runs.
        """
        if self.material is None or not self.has_grain:
            return None
        made = materials()[self.material]
        assert made.grain is not None
        bears = made.grain.weaker() if self.grain is None else made.grain
        share = made.design_share(duration, self.service_class)
        return bears.times(share * conversion(unit, "m") ** 2)

    def _of_material(self, unit: str) -> Self:
        """With the values of its material where they are not given, per square of a unit."""
        if self.material is None:
            return self
        made, area = materials()[self.material], conversion(unit, "m") ** 2
        known = {
            "modulus": made.modulus * area,
            "poisson": made.poisson,
        }
        given = {key for key in known if key in self.model_fields_set}
        sandwich = self.sandwich
        if sandwich is not None or made.sandwich is not None:
            sandwich = (sandwich or Sandwich()).filled(made.sandwich, unit)
        return self.replace_unchecked(
            sandwich=sandwich, **{key: each for key, each in known.items() if key not in given}
        )

    def made_of(self, material: str, unit: str) -> Self:
        """The same of another material, by its name, per square of a unit."""
        made, area = materials()[material], conversion(unit, "m") ** 2
        return self.replace_unchecked(
            material=material,
            modulus=made.modulus * area,
            poisson=made.poisson,
            strength=None,
            grain=None,
            sandwich=None if made.sandwich is None else Sandwich().filled(made.sandwich, unit),
        )

    def under(self, cases: tuple[LoadCase, ...]) -> Structure:
        """The structure under load cases; its modulus is known."""
        made = Structure.model_construct(**dict(self), cases=cases)
        vars(made).update({PLACE: vars(self)[PLACE]} if PLACE in vars(self) else {})
        return made


class Structure(StructureTable):
    """A structure as it is analysed: made of the table, under its load cases."""

    modulus: Positive
    cases: Several[LoadCase]

    @property
    def layup(self) -> Layup:
        """What its boards are made of."""
        core = None if self.sandwich is None else self.sandwich.core
        return Layup(self.modulus, self.poisson, core)

    @property
    def arranged(self) -> tuple[LoadCase, ...]:
        """All cases, those of several arrangements in each of them, and what a code combines.

        Raises InputError: If it is not clear what a case is to the code.
        """
        cases = arranged(self.cases)
        if self.combinations == "none":
            return cases
        return (*cases, *combine(self.cases, self.factors, self.expression))

    @property
    def analysed(self) -> tuple[LoadCase, ...]:
        """The cases that are analysed: those that no other combines."""
        return not_combined(self.arranged)


def not_combined(cases: Sequence[LoadCase]) -> tuple[LoadCase, ...]:
    """The cases that no other combines."""
    parts = {name for case in cases for name in case.combine}
    return tuple(case for case in cases if case.name not in parts)
