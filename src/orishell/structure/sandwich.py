"""The table [structure.sandwich]: boards of two faces on a core."""

from __future__ import annotations

from typing import Annotated, ClassVar, Self

from pydantic import Field

from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.conventions.table import Number, Table
from orishell.structure.mesh.layup import Core

Size = Annotated[Number | None, Field(ge=1e-12, le=1e15)]


@record
class MadeSandwich:
    """Faces and core of a material."""

    face: float  # thickness of each face (m)
    core_shear_modulus: float  # (N/m2)
    core_modulus: float  # (N/m2)
    core_shear_strength: float  # (N/m2)
    face_density: float  # (kg/m3)
    core_density: float  # (kg/m3)

    def density(self, thickness: float) -> float:
        """Mass by volume (kg/m3) of boards as thick (m)."""
        faces = min(1.0, 2 * self.face / thickness)
        return faces * self.face_density + (1 - faces) * self.core_density


class Sandwich(Table):
    """Faces and core of boards."""

    REPORTED: ClassVar = ("face", "core_shear_modulus", "core_modulus", "core_shear_strength")

    # what is None is that of the material
    face: Size = None  # thickness of each face (length)
    core_shear_modulus: Size = None  # of the core (force per area)
    # Young's modulus of the core across the board (force per area)
    core_modulus: Size = None
    # what the core bears in shear, its design value; None if that is not known (force per area)
    core_shear_strength: Size = None

    def filled(self, made: MadeSandwich | None, unit: str) -> Self:
        """With the values of a material where they are not given, in a unit of length."""
        if made is None:
            return self
        area = conversion(unit, "m") ** 2
        known = {key: area * getattr(made, key) for key in self.REPORTED if key != "face"}
        known["face"] = made.face * conversion("m", unit)
        return self.replace_unchecked(
            **{key: each for key, each in known.items() if getattr(self, key) is None}
        )

    @property
    def missing(self) -> tuple[str, ...]:
        """Keys without which nothing can be found."""
        needed = ("face", "core_shear_modulus", "core_modulus")
        return tuple(key for key in needed if getattr(self, key) is None)

    @property
    def core(self) -> Core:
        """What is between the faces."""
        assert self.face is not None
        assert self.core_shear_modulus is not None
        assert self.core_modulus is not None
        return Core(self.face, self.core_shear_modulus, self.core_modulus)
