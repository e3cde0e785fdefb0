"""What the surface that a shell is asked to follow can do, whatever it was made from."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol, runtime_checkable

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.design.surface import Lattice
from orishell.numerics.arrays import Array


@runtime_checkable
class AskedSurface(Protocol):
    """A surface: f swept along g, formulas, or a mesh."""

    def points(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at the two parameters u and v (...)."""

    def normals(self, u: Array, v: Array) -> Array:
        """Unit normals (..., 3) at the two parameters u and v (...)."""

    def lattice(
        self,
        step: float,
        sagitta: float | None = None,
        longer: float = 1.0,
        *,
        most: int | None = None,
    ) -> Lattice:
        """A lattice of points as close as asked for.

        Parameters
        ----------
        step
            Distance of neighbours to the right, at most (length).
        sagitta
            How far cells may leave the surface, about (length); a share of the step if None.
        longer
            Neighbours upwards are at most so many steps apart.
        most
            Cells, at most.
        """

    def area(self, step: float | None = None) -> float:
        """Area, of cells with sides of about ``step``; roughly, if none is given."""

    def size(self) -> float:
        """A length of the order of its diameter."""


@runtime_checkable
class PiecedSurface(AskedSurface, Protocol):
    """A surface by formulas or a mesh: it knows the piece that is to be covered."""

    @property
    def piece(self) -> Piece:
        """The piece to be covered."""


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
