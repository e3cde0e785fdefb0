"""A surface in a frame beside its own."""

from __future__ import annotations

from dataclasses import replace

from orishell.conventions.record import record
from orishell.design.asked import AskedSurface
from orishell.design.surface import Lattice
from orishell.numerics.arrays import Array


@record
class Shifted:
    """A surface moved by a vector, and otherwise what it was."""

    surface: AskedSurface
    shift: Array  # (3,)

    def points(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at parameters u, v (...)."""
        return self.surface.points(u, v) + self.shift

    def normals(self, u: Array, v: Array) -> Array:
        """Unit normals (..., 3) at parameters u, v (...)."""
        return self.surface.normals(u, v)

    def lattice(
        self,
        step: float,
        sagitta: float | None = None,
        longer: float = 1.0,
        *,
        most: int | None = None,
    ) -> Lattice:
        """A lattice of points as close as asked for."""
        found = self.surface.lattice(step, sagitta, longer, most=most)
        return replace(found, points=found.points + self.shift)

    def area(self, step: float | None = None) -> float:
        """Area of the surface."""
        return self.surface.area(step)

    def size(self) -> float:
        """A length of the order of its diameter."""
        return self.surface.size()
