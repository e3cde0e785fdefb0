"""A surface that is a mesh of triangles: one open piece with a rim of four sides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design.mesh_facing import vertex_normals
from orishell.design.open_mesh import OpenMesh, find_corners, open_mesh, require_size
from orishell.design.piece import Facets, Piece
from orishell.design.plan_rectangle import PlanRectangle, mesh_over
from orishell.design.surface import Lattice
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers

MOST_DRAWN = 200
"""Cells of the lattice that is drawn, each way, at most."""


@record
class MeshSurface:
    """A mesh; its lattices, for pictures, lie on the surface with its vertices and normals."""

    piece: Piece
    notes: tuple[str, ...] = ()  # what is to be said of how it was read
    unit: str = ""  # of its file, or as somebody says; "" if nobody does

    @classmethod
    def of(cls, vertices: Array, triangles: Integers, corners: Array | None = None) -> MeshSurface:
        """The surface of triangles (T, 3) of vertices (V, 3), with corners near places (4, 3).

        Raises
        ------
        InputError
            If they are no open piece of surface with one rim.
        """
        mesh = open_mesh(vertices, triangles)
        normals = vertex_normals(mesh.vertices, mesh.triangles)
        return cls._between(mesh, normals, find_corners(mesh, corners))

    @classmethod
    def over(
        cls,
        rectangle: PlanRectangle,
        vertices: Array,
        triangles: Integers,
        scale: Array | float = 1.0,
    ) -> MeshSurface:
        """The part of triangles (T, 3) of vertices (V, 3) over a rectangle in plan.

        Parameters
        ----------
        scale
            What that part is enlarged by, along x, y and z (3,), or as a whole.

        Raises
        ------
        InputError
            If that is no open piece of surface that covers the rectangle once.
        """
        mesh, normals, ends = mesh_over(rectangle, vertices, triangles)
        normals = normals / scale
        normals = normals / lengths(normals)[:, None]
        with np.errstate(over="ignore"):  # what overflows is refused
            scaled = mesh.vertices * scale
        require_size(scaled)
        return cls._between(replace(mesh, vertices=scaled), normals, ends)

    @classmethod
    def _between(cls, mesh: OpenMesh, normals: Array, ends: Integers) -> MeshSurface:
        """A mesh whose rim has its corners at four places in the order of its rim."""
        count = len(mesh.rim)
        top, right, bottom, left = (
            mesh.rim[np.arange(first, first + 1 + (last - first) % count) % count]
            for first, last in zip(ends, np.roll(ends, -1), strict=True)
        )
        return cls(
            Piece(Facets(mesh.vertices, normals, mesh.triangles), (top, right, bottom, left))
        )

    def points(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at shares u (...) from bottom to top and v (...) from left to right.

        Those of the patch that its four sides span (S. A. Coons, Surfaces for computer-aided design
        of space forms, MIT MAC-TR-41, 1967), moved onto the surface.
        """
        u, v = np.broadcast_arrays(np.asarray(u, np.float64), np.asarray(v, np.float64))
        top, right, bottom, left = (self.piece.vertices[side] for side in self.piece.sides)
        low, high = _along(bottom[::-1], v), _along(top, v)
        near, far = _along(left, u), _along(right[::-1], u)
        u, v = u[..., None], v[..., None]
        between = (1 - u) * low + u * high + (1 - v) * near + v * far
        twist = (1 - u) * ((1 - v) * bottom[-1] + v * bottom[0])
        twist = twist + u * ((1 - v) * top[0] + v * top[-1])
        points = (between - twist).reshape(-1, 3)
        for _ in range(3):
            distances, normals = self.piece.nearest(points)
            points = points - distances[:, None] * normals
        return np.asarray(points.reshape(between.shape))

    def normals(self, u: Array, v: Array) -> Array:
        """Unit normals (..., 3) where :meth:`points` at u and v (...) are."""
        points = self.points(u, v)
        return self.piece.nearest(points.reshape(-1, 3))[1].reshape(points.shape)

    def lattice(
        self,
        step: float,
        sagitta: float | None = None,
        longer: float = 1.0,
        *,
        most: int | None = None,
    ) -> Lattice:
        """A lattice of points, even along the sides, for pictures.

        Parameters
        ----------
        step
            Distance of neighbours to the right, about (length).
        sagitta, most
            Not asked for here: its points lie on the surface.
        longer
            Neighbours upwards are about so many steps apart.
        """
        wide, high = self.piece.extents
        rows = int(np.clip(np.ceil(high / (longer * step)), 1, MOST_DRAWN))
        columns = int(np.clip(np.ceil(wide / step), 1, MOST_DRAWN))
        u, v = np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1)
        return Lattice(u, v, self.points(u[:, None], v[None, :]), 0.0)

    def area(self, step: float | None = None) -> float:
        """Area of its triangles, whatever the ``step``."""
        p, q, r = np.moveaxis(self.piece.vertices[self.piece.triangles], 1, 0)
        return float(0.5 * lengths(np.cross(q - p, r - p)).sum())

    def size(self) -> float:
        """The diagonal of its box."""
        return self.piece.diagonal


def lies_on_its_side(piece: Piece) -> bool:
    """Whether its mean normal is along y more than along z."""
    p, q, r = np.moveaxis(piece.vertices[piece.triangles], 1, 0)
    _, y, z = np.abs(np.cross(q - p, r - p).sum(axis=0))
    return bool(y > z)


def _along(line: Array, share: Array) -> Array:
    """Points (..., 3) at shares (...) of the length of a line (K, 3)."""
    arc = np.concatenate([[0.0], np.cumsum(lengths(np.diff(line, axis=0)))])
    return np.stack([np.interp(share * arc[-1], arc, each) for each in line.T], axis=-1)
