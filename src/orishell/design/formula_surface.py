"""Surfaces by formulas: z(x, y) over a rectangle in plan, or x, y and z of u and v."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.curves import FormulaOfTwo
from orishell.design.piece import Piece
from orishell.design.surface import LOOSE, Lattice
from orishell.motion.quads import area_vectors, grid_corners, lengths
from orishell.numerics.arrays import Array, Booleans

CELLS = 128
"""Cells of a piece each way: distances from it are of third order in their size."""
MOST_EACH = 4_000
"""Cells of a lattice each way, at most."""

Range = tuple[float, float]


@record
class FormulaSurface:
    """A surface with two parameters, its normals to the left of the second seen along the first.

    Places along g of :class:`~orishell.design.Surface` are the second parameter here, so that the
    triangles of lattices are seen from the side of the normals.
    """

    formulas: tuple[FormulaOfTwo, ...]  # z of x and y, or x, y and z of u and v
    first: Range  # x or u, from the least on
    second: Range  # y or v
    # Of z(x, y): where the parameters are 0 in plan (2,), and how the rectangle is turned (radians)
    centre: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    # by which all lengths are multiplied, or those along x, y and z
    scale: float | tuple[float, float, float] = 1.0

    def points(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at the second parameter u (...) and the first parameter v (...)."""
        return self._at(v, u)[0]

    def normals(self, u: Array, v: Array) -> Array:
        """Unit normals (..., 3) at the second parameter u (...) and the first parameter v (...)."""
        _, along, across = self._at(v, u)
        normals = np.cross(along, across)
        return np.asarray(normals / lengths(normals)[..., None])

    def lattice(
        self,
        step: float,
        sagitta: float | None = None,
        longer: float = 1.0,
        *,
        most: int | None = None,
    ) -> Lattice:
        """A lattice of points as close as asked for, even in both parameters.

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
        sagitta = step / LOOSE if sagitta is None else sagitta
        points = self._probe[0]
        # (second, first) parameter: the longest steps of the probe, and how much they bend.
        bends = [lengths(np.diff(points, 2, axis=axis)).max() * CELLS**2 for axis in (0, 1)]
        twist = lengths(np.diff(np.diff(points, axis=0), axis=1)).max() * CELLS**2
        spans = [lengths(np.diff(points, axis=axis)).max() * CELLS for axis in (0, 1)]
        steps = (longer * step, step)
        counts = [max(span / each, 1.0) for span, each in zip(spans, steps, strict=True)]
        counts = [
            max(count, np.sqrt(bend / (4 * sagitta)))
            for count, bend in zip(counts, bends, strict=True)
        ]
        counts = [
            count * max(1.0, np.sqrt(twist / (4 * sagitta * counts[0] * counts[1])))
            for count in counts
        ]
        if most is not None and counts[0] * counts[1] > most:
            counts = [count * np.sqrt(most / (counts[0] * counts[1])) for count in counts]
        cells = [int(np.clip(np.ceil(count - 1e-9), 1, MOST_EACH)) for count in counts]
        u = np.linspace(*self.second, cells[0] + 1)
        v = np.linspace(*self.first, cells[1] + 1)
        return Lattice(u, v, self.points(u[:, None], v[None, :]), 0.0)

    def area(self, step: float | None = None) -> float:
        """Area, of cells with sides of about ``step``; of those of a piece, if none is given."""
        if step is not None:
            return self.lattice(step).area()
        return float(lengths(area_vectors(grid_corners(self._probe[0]))).sum())

    def size(self) -> float:
        """The diagonal of its box."""
        return self.piece.diagonal

    @cached_property
    def piece(self) -> Piece:
        """The piece that it is, its first parameter running to the right and its second up.

        Raises
        ------
        InputError
            If it is not finite, or has no tangent plane, somewhere.
        """
        points, normals = self._probe
        return Piece.of_lattice(points[::-1], normals[::-1])

    @cached_property
    def _probe(self) -> tuple[Array, Array]:
        """Points and unit normals (CELLS + 1, CELLS + 1, 3): second parameter, first parameter."""
        second = np.linspace(*self.second, CELLS + 1)[:, None]
        first = np.linspace(*self.first, CELLS + 1)[None, :]
        points, along, across = self._at(first, second)
        normals = np.cross(along, across)
        size = lengths(normals)
        self._require(np.asarray(np.isfinite(points).all(axis=-1)), "the surface is not finite")
        self._require(
            np.asarray(np.isfinite(size) & (size > 1e-9 * lengths(along) * lengths(across))),
            "the surface has no tangent plane, or an upright one",
        )
        return points, normals / size[..., None]

    def _require(self, good: Booleans, what: str) -> None:
        if good.all():
            return
        row, column = np.argwhere(~good)[0]
        first, second = (
            float(np.linspace(*ends, CELLS + 1)[k])
            for ends, k in ((self.first, column), (self.second, row))
        )
        names = self.formulas[0].variables
        if len(self.formulas) == 1:
            first, second = (float(each) for each in self._plan(first, second))
        raise InputError(
            what,
            keys=("formula",),
            where="formula",
            got=f"at {names[0]} = {first:.4g}, {names[1]} = {second:.4g}",
            remedy="choose smaller ranges",
        )

    def _plan(self, first: Array | float, second: Array | float) -> tuple[Array, Array]:
        """Where parameters of z(x, y) are in plan."""
        c, s = np.cos(self.turn), np.sin(self.turn)
        x, y = self.centre
        return np.asarray(x + first * c - second * s), np.asarray(y + first * s + second * c)

    def _at(self, first: Array, second: Array) -> tuple[Array, Array, Array]:
        """Points (..., 3) and their derivatives by both parameters (...)."""
        first, second = np.broadcast_arrays(np.asarray(first), np.asarray(second))
        if len(self.formulas) == 1:
            x, y = self._plan(first, second)
            z, by_x, by_y = self.formulas[0].slopes(x, y)
            c, s = np.cos(self.turn), np.sin(self.turn)
            ones = np.ones(x.shape)
            points = np.stack([x, y, z], axis=-1)
            with np.errstate(invalid="ignore"):
                along = np.stack([c * ones, s * ones, c * by_x + s * by_y], axis=-1)
                across = np.stack([-s * ones, c * ones, c * by_y - s * by_x], axis=-1)
        else:
            found = [formula.slopes(first, second) for formula in self.formulas]
            points, along, across = (np.stack(each, axis=-1) for each in zip(*found, strict=True))
        scale = np.array(self.scale)
        return scale * points, scale * along, scale * across

    def __repr__(self) -> str:
        texts = ", ".join(formula.text for formula in self.formulas)
        turned = f", turned by {tidy_degrees(self.turn)} deg" if self.turn else ""
        return f"{type(self).__name__}({texts}{turned})"
