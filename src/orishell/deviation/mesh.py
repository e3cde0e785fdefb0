"""Triangles of a surface and of a shell, and how far the former are from their surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.deviation.triangles import Triangles
from orishell.panels import unit_normals
from orishell.pattern import Grid
from orishell.surface import Lattice, Surface

Array = NDArray[np.float64]

FLATNESS = 400.0
"""The mesh of a surface leaves it by about the samples' step over this."""
LONGEST_CELL = 8.0
"""Cells of the mesh are at most this many steps of the samples long."""
FINEST = 200_000
"""Cells of a mesh of a surface at most: 100 MB with its tree."""


def mesh_shell(positions: Array) -> Triangles:
    """The panels of a shell, given by their vertices (rows, columns, 3): two triangles each."""
    faces = Grid(*positions.shape[:2]).faces_vertices()
    corners = faces[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    return Triangles.of(positions, corners)


def mesh_surface(surface: Surface, samples: int) -> tuple[Triangles, float]:
    """A mesh of a surface that suits so many samples, and how far it leaves the surface."""
    step = float(np.sqrt(surface.area() / samples))
    lattice = surface.lattice(LONGEST_CELL * step, step / FLATNESS, most=FINEST)
    triangles = Triangles.of(lattice.points, lattice.triangles())
    return triangles, sagitta(surface, lattice) + lattice.left_out


def sagitta(surface: Surface, lattice: Lattice) -> float:
    """How far a lattice's triangles leave the surface, measured at the middles of their edges."""
    u, v, points = lattice.u, lattice.v, lattice.points
    middle_u, middle_v = 0.5 * (u[1:] + u[:-1]), 0.5 * (v[1:] + v[:-1])
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]
    normals = unit_normals(np.stack([a, b, c, d], axis=-2))
    gaps = (
        surface.points(middle_u[:, None], middle_v[None, :]) - 0.5 * (a + c),
        surface.points(u[:-1, None], middle_v[None, :]) - 0.5 * (a + b),
        surface.points(middle_u[:, None], v[None, :-1]) - 0.5 * (a + d),
    )
    return max(float(np.abs(np.einsum("...i,...i->...", gap, normals)).max()) for gap in gaps)
